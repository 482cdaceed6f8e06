"""Why a server gave no answer, or another one than a server of Proctor, in a sentence.

Names the proxy on the way, the fault of a certificate, and the place that a redirection
names, each with the cure. Sends nothing and judges nothing.
"""

import ssl
from collections.abc import Mapping

import httpx

from conformance.client.connections.connection_faults import causes_of
from conformance.client.connections.kept_connection import (
    EndlessAnswer,
    UnreadableAnswer,
)
from conformance.client.connections.transport.fault_texts import (
    NO_PASSWORD,
    cure_of_page,
    cure_of_password,
    describe_http2,
    describe_page,
    describe_proxy_fault,
    describe_tls_fault,
    describe_unreachable_proxy,
    is_of_proctor,
    who_answered,
)
from conformance.client.connections.transport.proxy_route import ProxyRoute, find_route
from conformance.client.connections.transport.server_address import (
    place_of_redirection,
)
from conformance.client.connections.transport.tls_trust import certificate_cure

# Errors that only the connection to a proxy can have, where there is one.
PROXY_ERRORS = (httpx.ProxyError, httpx.ConnectError, httpx.ConnectTimeout)
# Statuses by which such a proxy refuses, or says that it reached no server.
_OF_PROXY = (NO_PASSWORD, 502, 504)


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
        return _in_a_line(describe_tls_fault(tls[0], f"{url}{way}"))
    received = error.received if isinstance(error, UnreadableAnswer) else ""
    if (http2 := describe_http2(url, received)) is not None:
        return _in_a_line(http2)
    text = f"{type(error).__name__}: {error}"
    if isinstance(error, EndlessAnswer):
        return f"{url}{way} sends what cannot be read: {error}; is it a Proctor server?"
    if route.url and isinstance(error, PROXY_ERRORS):
        return _in_a_line(_describe_proxy(error, url, route))
    hint = "start the server or correct --url"
    if isinstance(error, httpx.ReadTimeout):
        hint = "something takes the request there, and does not answer it"
    elif isinstance(error, httpx.DecodingError):
        hint = "something answers there, with a body that its headers describe wrongly"
    elif isinstance(error, httpx.RemoteProtocolError | httpx.ReadError):
        hint = "something takes the request there, and gives no whole answer"
        hint += "; correct --url"
        hint += " (https:// if it speaks TLS)" if url.startswith("http:") else ""
    observed = "; ".join(filter(None, [text, route.how]))
    cure = "; ".join(filter(None, [hint, route.advice]))
    return f"no response from {url} ({observed}): {cure}"


def proxy_in_between(status: int, headers: Mapping[str, str], url: str) -> str | None:
    """Name the proxy of the environment if an answer is its own, with the cure."""
    if status not in _OF_PROXY or "proctor-version" in headers:
        return None
    route = find_route(url)
    if not route.url:
        return None
    challenges = [headers.get("proxy-authenticate", "")]
    cure = f" ({cure_of_password(route, challenges)})" if status == NO_PASSWORD else ""
    return f"the proxy {route.url} of {route.variable}{cure}"


def _describe_proxy(error: BaseException, url: str, route: ProxyRoute) -> str:
    """Describe a proxy that opened no way, in the words of every program."""
    reason = str(error)
    if not isinstance(error, httpx.ProxyError):
        return describe_unreachable_proxy(url, route, reason)
    status = int(reason[:3]) if reason[:3].isdecimal() else 0
    return describe_proxy_fault(url, route, reason, status)


def _in_a_line(text: str) -> str:
    """The sentences as a part of the line `not decided: …`."""
    return f"{text[:1].lower()}{text[1:]}".rstrip(".")


def describe_other_answer(
    status: int, headers: Mapping[str, str], body: bytes, url: str
) -> str | None:
    """Describe an answer that no server of Proctor gives at its base URL; else None."""
    route, location = find_route(url), headers.get("location")
    if 300 <= status < 400 and location:
        place, is_base = place_of_redirection(url, location)
        what = f": the server is at {place}; give that URL"
        if not is_base:
            what = (
                f", and points to {place}; the kit follows no redirection: let GET /v1 "
                "itself be answered, or give the URL of the server behind it"
            )
        return f"{who_answered(url, route)} answers {status}{what}"
    if status >= 500 and route.url:
        return f"{who_answered(url, route)} answers {status}"
    if not is_of_proctor(headers) and (page := describe_page(headers)) is not None:
        cure = cure_of_page(route).rstrip(".")
        return f"{who_answered(url, route)} answers {status} with {page}. {cure}"
    if status == 400 and url.startswith("http:") and b"HTTPS" in body:
        cure = "it speaks TLS; begin --url with https://"
    elif status == 404 and url.endswith("/v1"):
        cure = "give --url without /v1, which is added to it"
    else:
        return None
    return f"{url} answers {status}: {cure}"
