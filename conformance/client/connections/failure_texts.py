"""Why a server gave no answer, or another one than a server of Proctor, in a sentence.

Names the proxy on the way, the fault of a certificate, and the place that a redirection
names, each with the cure. Sends nothing and judges nothing.
"""

import ssl
from collections.abc import Mapping

import httpx

from conformance.client.connections.connection_faults import causes_of
from conformance.client.connections.kept_connection import EndlessAnswer
from conformance.client.connections.transport.proxy_route import ProxyRoute, find_route
from conformance.client.connections.transport.server_address import (
    place_of_redirection,
)
from conformance.client.connections.transport.tls_trust import certificate_cure

# Errors that only the connection to a proxy can have, where there is one.
PROXY_ERRORS = (httpx.ProxyError, httpx.ConnectError, httpx.ConnectTimeout)
_NO_PASSWORD = 407
# Statuses by which such a proxy refuses, or says that it reached no server.
_OF_PROXY = (_NO_PASSWORD, 502, 504)


def describe_failure(error: BaseException, url: str) -> str:
    """Describe why there was no answer, and what to do."""
    route = find_route(url)
    tls = [cause for cause in causes_of(error) if isinstance(cause, ssl.SSLError)]
    way = f" ({route.how})" if route.url else ""
    if tls and isinstance(tls[0], ssl.SSLCertVerificationError):
        reason = tls[0].verify_message.rstrip(".")
        cure = certificate_cure(tls[0]).replace("PROCTOR_CA,", "--ca, PROCTOR_CA,")
        return f"the certificate of {url}{way} is not accepted: {reason}. {cure}"
    if tls and not isinstance(tls[0], ssl.SSLEOFError | ssl.SSLZeroReturnError):
        return (
            f"{url}{way} does not speak TLS ({tls[0].reason}): check the port, and "
            "whether --url begins with http:// instead"
        )
    text = f"{type(error).__name__}: {error}"
    if isinstance(error, EndlessAnswer):
        return f"{url}{way} sends what cannot be read: {error}; is it a Proctor server?"
    if route.url and isinstance(error, PROXY_ERRORS):
        return _describe_proxy(text, isinstance(error, httpx.ProxyError), url, route)
    hint = "start the server or correct --url"
    if isinstance(error, httpx.RemoteProtocolError | httpx.ReadError):
        hint += " (https:// if it speaks TLS)" if url.startswith("http:") else ""
    observed = "; ".join(filter(None, [text, route.how]))
    cure = "; ".join(filter(None, [hint, route.advice]))
    return f"no response from {url} ({observed}): {cure}"


def proxy_in_between(status: int, headers: Mapping[str, str], url: str) -> str | None:
    """Name the proxy of the environment if an answer is its own, with the cure."""
    if status not in _OF_PROXY or "proctor-version" in headers:
        return None
    route = find_route(url)
    wants = f" (USER:PASSWORD@ in {route.variable})" if status == _NO_PASSWORD else ""
    return f"the proxy {route.url} of {route.variable}{wants}" if route.url else None


def _describe_proxy(text: str, is_refusal: bool, url: str, route: ProxyRoute) -> str:
    what = "refused the way to" if is_refusal else "is unreachable, on the way to"
    return (
        f"the proxy {route.url} of {route.variable} {what} {url} ({text}): correct "
        f"{route.variable}, with USER:PASSWORD@ if it wants them; {route.advice}"
    )


def describe_other_answer(
    status: int, headers: Mapping[str, str], body: bytes, url: str
) -> str | None:
    """Describe an answer that no server of Proctor gives at its base URL; else None."""
    route, location = find_route(url), headers.get("location")
    if 300 <= status < 400 and location:
        place, is_base = place_of_redirection(url, location)
        new = f": the server is at {place}; give that URL"
        return f"{url} answers {status}{new if is_base else f', and points to {place}'}"
    if status == _NO_PASSWORD and route.url:
        return _describe_proxy(str(status), True, url, route)
    if status >= 500 and route.url:
        return f"{url}, or {route.how[8:]} in its place, answers {status}"
    if status == 400 and url.startswith("http:") and b"HTTPS" in body:
        cure = "it speaks TLS; begin --url with https://"
    elif status == 404 and url.endswith("/v1"):
        cure = "give --url without /v1, which is added to it"
    else:
        return None
    return f"{url} answers {status}: {cure}"
