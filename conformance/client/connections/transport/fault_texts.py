"""Why a server gave no answer, or another one than a server of Proctor: the sentences.

They are the same in every program. What is known decides which one it is: whether a
proxy was used, whether it opened a tunnel, and whether an answer has the protocol's
mark. Nothing here is sent.
"""

from __future__ import annotations

import re
import ssl
from collections.abc import Mapping, Sequence

from .proxy_route import ProxyRoute

NO_PASSWORD = 407  # of a proxy that wants a user and a password, or others
_VERSION, _PROBLEM = "proctor-version", "application/problem+json"
_HTML = ("text/html", "application/xhtml+xml")
_SIGN_IN = (
    "A network that wants a sign-in answers so, too: open any page of the web in a "
    "browser on this machine"
)
# The frame SETTINGS, with which a server of HTTP/2 begins: size, kind, flags, stream 0.
_HTTP2 = re.compile(r"\A\0[\s\S]{2}\x04[\s\S]\0\0\0\0")
# Parts of the names that OpenSSL gives to alerts, and their sentences.
_ALERTS = {
    "CERTIFICATE_REQUIRED": "wants a certificate of the client, which this program "
    "cannot give. Ask its operator for an address that takes a token alone.",
    "PROTOCOL_VERSION": "speaks other versions of TLS than this program, which knows "
    "1.2 and 1.3. Ask its operator for one of these.",
}
_ALERTS["UNSUPPORTED_PROTOCOL"] = _ALERTS["PROTOCOL_VERSION"]


def is_of_proctor(headers: Mapping[str, str]) -> bool:
    """Whether a server of Proctor has sent an answer, by its headers."""
    lines = {name.lower(): value for name, value in headers.items()}
    kind = lines.get("content-type", "").lower()
    return _VERSION in lines or kind.startswith(_PROBLEM)


def who_answered(url: str, route: ProxyRoute) -> str:
    """Who may have sent an answer that has no mark of Proctor."""
    if not route.url or url.startswith("https:"):  # nothing changes what a tunnel has
        return url
    return f"{url}, or the proxy {route.url} of {route.variable} in its place,"


def describe_page(headers: Mapping[str, str]) -> str | None:
    """Name the page in HTML that came in place of a message, and its likely cause."""
    lines = {name.lower(): value for name, value in headers.items()}
    kind = lines.get("content-type", "").partition(";")[0].strip().lower()
    return f"a page, {kind}" if kind in _HTML else None


def cure_of_page(route: ProxyRoute) -> str:
    """What to do about an answer of something else, in sentences."""
    advice = f"; {route.advice}" if route.url else ""
    return f"Check that the URL is that of a Proctor server{advice}. {_SIGN_IN}."


# A proxy answers so by itself while the server behind it is away, or is late.
WITHOUT_SERVER = (502, 503, 504)


def is_refusal(status: int) -> bool:
    """Whether a proxy answers so for good, and not because it reached no server."""
    return 0 < status < 500


def describe_proxy_fault(
    url: str,
    route: ProxyRoute,
    reason: str,
    status: int = 0,
    challenges: Sequence[str] = (),
) -> str:
    """Describe a proxy that opened no way: no request has reached the server.

    status: of its answer; 0 without one. challenges: its Proxy-Authenticate.
    """
    proxy, cure = f"The proxy {route.url} of {route.variable}", route.advice
    if is_refusal(status):
        if status == NO_PASSWORD:
            cure = f"{cure_of_password(route, challenges)}; {cure}"
        return f"{proxy} refused the way to {url} ({reason}). {cure}."
    if status:
        return (
            f"{proxy}, on the way to {url}, did not reach it ({reason}). Check the "
            f"URL, and that the server runs; {cure}."
        )
    return (
        f"{proxy}, on the way to {url}, opened no connection to it ({reason}). The "
        f"server was not asked. Correct {route.variable}; {cure}."
    )


def cure_of_password(route: ProxyRoute, challenges: Sequence[str]) -> str:
    """What to do about a proxy that did not let the user in."""
    kinds = [text.split()[0] for text in challenges if text.strip()]
    example = f"{route.variable}=http://USER:PASSWORD@HOST:PORT"
    if kinds and "basic" not in map(str.lower, kinds):
        wanted = " or ".join(dict.fromkeys(kinds))
        return f"It asks for {wanted}, and this program speaks Basic alone"
    if route.headers:
        return (
            f"It did not accept the user and the password that {route.variable} has; "
            f"correct them: {example}"
        )
    return f"Give it in {example}"


def describe_unreachable_proxy(url: str, route: ProxyRoute, reason: str) -> str:
    """Describe a proxy to which no connection was made."""
    return (
        f"The proxy {route.url} of {route.variable}, on the way to {url}, is "
        f"unreachable ({reason}). Correct {route.variable}; {route.advice}."
    )


def describe_tls_fault(error: ssl.SSLError, who: str) -> str:
    """Describe a fault of TLS that is not one of a certificate."""
    reason = str(getattr(error, "reason", None) or error)
    for part, text in _ALERTS.items():
        if part in reason.upper().replace(" ", "_"):
            return f"{who} {text}"
    return (
        f"{who} does not speak TLS as this program does ({reason}). Check the port, "
        "and whether the URL begins with http:// instead."
    )


def describe_http2(who: str, text: str) -> str | None:
    """Describe a server of HTTP/2 by the bytes that are no answer of HTTP/1.1."""
    if not _HTTP2.match(text):
        return None
    return (
        f"{who} speaks HTTP/2 alone, and this program HTTP/1.1. Ask its operator for "
        "HTTP/1.1 at this address."
    )
