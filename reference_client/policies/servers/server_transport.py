"""How a policy server is reached, and how often a request to it is repeated.

Proxies and certificates are those of every other connection (transport/ of the Python
client): one rule for the evaluation server and for policy servers. A request may be
repeated, because it contains all that the server needs.
"""

from __future__ import annotations

import base64
import contextlib
import math
import ssl
import time
from collections.abc import Callable, Iterator
from contextvars import ContextVar
from datetime import UTC, datetime, timedelta
from typing import Any, Protocol, TypeVar
from urllib.parse import quote, urlsplit

import urllib3
from proctor_client import Configuration, ProxyFault, find_route
from proctor_client.transport.fault_texts import (
    describe_proxy_fault,
    is_refusal,
    who_answered,
)
from proctor_client.transport.proxy_route import ProxyRoute
from proctor_client.transport.server_address import without_user
from proctor_client.transport.tls_trust import client_context, proxy_context

from reference_client.errors import NOT_TRUSTED, from_failure, innermost_reason
from reference_client.policies.servers.bounded_answers import with_whole_limits
from reference_client.policies.servers.server_faults import failed, scheme_hint
from reference_client.policies.servers.wire_settings import (
    FIRST_CONTACT_S,
    LONGEST_PAUSE_S,
    PAUSE_S,
)
from reference_client.protocol.connection_advice import (
    causes_of,
    fault_of_proxy,
    is_of_first_hop,
    out_of_files,
)

Answer = TypeVar("Answer")
_HTTP = {"ws": "http", "wss": "https"}
_MAY_COUNT_TWICE = (
    "The same request is sent again, and a policy with a memory may count it twice."
)


class RepeatReporter(Protocol):
    """Is called when a request is sent again, and with None when that is over."""

    def __call__(self, waiting: str | None, warning: str = "") -> None:
        """waiting: the fault, and until when it is tried. warning: what follows."""


class Unreached(Exception):
    """An attempt failed, and the next one may not.

    Its text says what the server did. explain: adds to the text of the last attempt,
    where that takes time. was_sent: whether the server may have the request.
    """

    def __init__(
        self, what: str, explain: Callable[[], str] = str, *, was_sent: bool = True
    ) -> None:
        super().__init__(what)
        self.explain = explain
        self.was_sent = was_sent


class Silent(Exception):
    """A request was sent, and no answer came in its time.

    The connection may be dead without a sign of it, as when a router forgets it.
    """


_report: ContextVar[RepeatReporter | None] = ContextVar("_report", default=None)
_begin: ContextVar[Callable[[str], None] | None] = ContextVar("_begin", default=None)
_purpose: ContextVar[str] = ContextVar("_purpose", default="")
_sent: ContextVar[str] = ContextVar("_sent", default="the request")


@contextlib.contextmanager
def reporting_repeats(
    report: RepeatReporter,
    begin: Callable[[str], None] | None = None,
    purpose: str = "",
) -> Iterator[None]:
    """Report the repeats of this thread's requests to policy servers.

    begin: is called with what the thread waits for from then on. purpose: what the
    requests are for.
    """
    tokens = _report.set(report), _begin.set(begin), _purpose.set(purpose)
    try:
        yield
    finally:
        _report.reset(tokens[0])
        _begin.reset(tokens[1])
        _purpose.reset(tokens[2])


def report_request_sent(place: str, size: int) -> None:
    """This thread waits for the server at `place`, asked in so many bytes."""
    purpose = _purpose.get()
    sent = f"a request of {_in_kilobytes(size)}" + (purpose and f" for {purpose}")
    _sent.set(sent)
    _wait_for(f"the answer of {_name(place)} to {sent}")


def report_answer_read(place: str, size: int) -> None:
    """The answer has come; to read it can take long, too."""
    read = _in_kilobytes(size)
    _wait_for(f"this program, which reads the {read} that {_name(place)} sent")


def _wait_for(what: str) -> None:
    if (begin := _begin.get()) is not None:
        begin(what)


def _name(place: str) -> str:
    return f"the policy server at {without_user(place)}"


def _in_kilobytes(size: int) -> str:
    return f"{math.ceil(size / 1000)} kB"


def warn(text: str) -> None:
    """Report a warning about the policy of this thread; it is said once."""
    if (report := _report.get()) is not None:
        report(None, text)


def repeat_until_reached(
    attempt: Callable[[], Answer],
    place: str,
    retry_timeout_s: float,
    *,
    is_counted_once: bool = False,
) -> Answer:
    """The result of `attempt`, which is repeated, ever more rarely, after Unreached.

    After Silent it is repeated once, but not for a first contact. is_counted_once:
    whether the server knows a repeat, and executes nothing again. Raises ProctorError
    `policy_failed` when the server at `place` stays unreached or silent.
    """
    began_at, pause_s = time.monotonic(), PAUSE_S
    may_be_silent = retry_timeout_s > FIRST_CONTACT_S
    report, fault = _report.get(), ""
    try:
        while True:
            try:
                return attempt()
            except Silent as error:
                if not may_be_silent:
                    raise failed(place, _last(error, began_at, fault)) from error
                may_be_silent, began_at = False, time.monotonic()
                said, was_sent = f"{error}; it was sent {_sent.get()}", True
                trying = "It is asked once more, on a new connection …"
            except Unreached as error:
                left_s = began_at + retry_timeout_s - time.monotonic()
                if left_s < 0:
                    last = _last(error, began_at, fault)
                    raise failed(place, last) from error.__cause__
                said, was_sent = f"{error}", error.was_sent
                trying = f"Trying again until {time_after(left_s)} …"
            if report is not None and fault != said:
                detail = failed(place, said.rstrip(":; ")).detail
                may_count = was_sent and not is_counted_once
                warning = f"{detail} {_MAY_COUNT_TWICE}" if may_count else ""
                report(f"{detail} {trying}", warning)
            fault = said
            time.sleep(pause_s)
            pause_s = min(2 * pause_s, LONGEST_PAUSE_S)
    finally:
        if report is not None and fault:
            report(None)


def _last(error: Silent | Unreached, began_at: float, earlier: str) -> str:
    """The fault of the last attempt; earlier: the one before it, or empty."""
    if isinstance(error, Silent):
        explained = f"; it was sent {_sent.get()}"
    else:
        explained = error.explain()
    last = f"{error}{explained}".rstrip(".:; ")
    tried_s = time.monotonic() - began_at
    return f"{last}. It was tried again for {tried_s:.0f} s" if earlier else last


def time_after(seconds: float) -> str:
    """The time of day when they are over."""
    return f"{datetime.now(UTC) + timedelta(seconds=seconds):%H:%M:%S} UTC"


@contextlib.contextmanager
def reporting_wait(place: str) -> Iterator[Callable[[str], None]]:
    """Yields a function that reports what the server at `place` does.

    The reported wait is over after the block.
    """
    report = _report.get()

    def say(what: str) -> None:
        if report is not None:
            report(failed(place, what).detail)

    try:
        yield say
    finally:
        if report is not None:
            report(None)


@contextlib.contextmanager
def first_contact(place: str) -> Iterator[None]:
    """Report the server at `place` as one that has yet to answer, during the block."""
    with reporting_wait(place) as say:
        say("has not answered yet")
        yield


def route_to(url: str) -> ProxyRoute:
    """The route to a policy server. Raises ProctorError if it cannot be taken."""
    try:
        _ = urlsplit(url).port
    except ValueError as error:
        text = "has an invalid port: it is a number up to 65535"
        raise failed(url, text) from error
    try:
        return find_route(_as_http(url))
    except ValueError as error:
        raise failed(url, f"is unreachable: {error}") from error


def http_connections(url: str, maxsize: int) -> urllib3.PoolManager:
    """The connections to the server of `url`. Raises ProctorError."""
    parts = urlsplit(url)
    route_to(url)
    try:
        settings = Configuration(
            host=f"{parts.scheme}://{parts.netloc.rpartition('@')[2]}",
            retries=False,
            connection_pool_maxsize=maxsize,
            ssl_context=client_context() if parts.scheme == "https" else None,
            proxy_ssl_context=proxy_context(url),
        )
        return with_whole_limits(settings.pool_manager())
    except ValueError as error:
        raise failed(url, f"is unreachable: {error}") from error


def websocket_options(url: str) -> dict[str, Any]:
    """The options of `connect` that decide how a server is reached.

    A WebSocket is opened through a tunnel, also without TLS. Raises ProctorError.
    """
    route = route_to(url)
    try:
        return {
            "proxy": _with_user(route) if route.url else None,
            "proxy_ssl": proxy_context(_as_http(url)),
            "ssl": client_context() if urlsplit(url).scheme == "wss" else None,
        }
    except ValueError as error:
        raise failed(url, f"is unreachable: {error}") from error


def fault_of(url: str, error: Exception) -> Exception:
    """Why the server of `url` gave no answer: Unreached, or a ProctorError if the next
    attempt will meet the same.
    """
    route = route_to(url)
    failure = from_failure(error, _as_http(url))
    if failure.code == NOT_TRUSTED:
        return failed(url, f"is not trusted: {failure.detail}")
    if (fault := fault_of_proxy(error)) is not None:
        return fault_on_the_way(url, fault)
    if (text := out_of_files(error)) is not None:
        return Unreached(f"was not reached: {text}", was_sent=False)
    reason, was_sent = innermost_reason(error), may_have_been_sent(error)
    if route.url:
        return Unreached(
            f"is unreachable through the proxy {route.url} of {route.variable} "
            f"({reason}). Correct {route.variable}; {route.advice}",
            was_sent=was_sent,
        )
    way = f"; {route.how}" if route.how else ""
    advice = f". {route.advice}" if route.advice else ""
    if any(isinstance(cause, ssl.SSLError) for cause in causes_of(error)):
        reason = f"it ended the TLS connection{scheme_hint(url)}"
    elif any(isinstance(cause, ConnectionResetError) for cause in causes_of(error)):
        reason += scheme_hint(url)
    return Unreached(f"is unreachable ({reason}{way}){advice}", was_sent=was_sent)


def may_have_been_sent(error: Exception) -> bool:
    """Whether a connection was made, on which a request may have been sent."""
    is_refused = any(isinstance(e, ConnectionRefusedError) for e in causes_of(error))
    return not is_refused and not is_of_first_hop(error)


def in_its_place(url: str) -> str:
    """That a proxy may have given an answer over HTTP, and not the server."""
    route = route_to(url)
    if who_answered(url, route) == url:
        return ""
    proxy = f"the proxy {route.url} of {route.variable}"
    return f"; {proxy} may have answered in its place ({route.advice})"


def fault_on_the_way(url: str, fault: ProxyFault) -> Exception:
    """The same for a proxy that opened no way."""
    what = describe_no_way(url, fault)
    return failed(url, what) if is_refusal(fault.status) else Unreached(what)


def describe_no_way(url: str, fault: ProxyFault) -> str:
    """The words of every program for a proxy that opened no way."""
    text = describe_proxy_fault(
        without_user(url), route_to(url), fault.phrase, fault.status, fault.challenges
    )
    return f"was not reached: {text[:1].lower()}{text[1:]}"


def past_proxies(place: str) -> str:
    """Words for a connection that no HTTP proxy carries, where one is set."""
    with contextlib.suppress(ValueError):
        if variable := find_route(f"http://{place}").variable:
            return f"; ZeroMQ goes past the proxy of {variable}"
    return ""


def _as_http(url: str) -> str:
    scheme, separator, rest = url.partition("://")
    return f"{_HTTP.get(scheme, scheme)}{separator}{rest}"


def _with_user(route: ProxyRoute) -> str:
    """The URL of the proxy as websockets takes it, with its user and password."""
    value = route.headers.get("Proxy-Authorization", "").removeprefix("Basic ")
    if not value:
        return route.url
    user, _, password = base64.b64decode(value).decode().partition(":")
    secret = f"{quote(user, safe='')}:{quote(password, safe='')}@"
    return route.url.replace("://", f"://{secret}", 1)
