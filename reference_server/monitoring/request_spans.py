"""The span of every request, and the trace that it belongs to.

This is a layer between the application and its routes, there only where traces are
recorded. Clients are not trusted with traces: a `traceparent` is read only in its one
exact form, and the operator decides whether it has any effect. The span is named by the
route and never by the path.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NamedTuple, Protocol

from starlette.types import ASGIApp, Message, Receive, Scope, Send

from reference_server.http.dispatch import OPERATION, PATH_PATTERNS
from reference_server.telemetry.log_output import REQUEST_ID
from reference_server.telemetry.spans import Span

_TRACEPARENT = re.compile(rb"00-([0-9a-f]{32})-([0-9a-f]{16})-([0-9a-f]{2})")
# Balancers ask every second.
_PROBES = ("/livez", "/readyz")
# Any other is a word of the client's choice.
_METHODS = frozenset({"DELETE", "GET", "HEAD", "OPTIONS", "PATCH", "POST", "PUT"})


class TraceParent(NamedTuple):
    """The trace that a request names as its own, by its header `traceparent`."""

    trace_id: int
    span_id: int
    is_recorded: bool


class RequestRecorder(Protocol):
    """The recorder that receives the spans of requests."""

    def request(self, parent: TraceParent | None, *, is_trusted: bool) -> Span:
        """The span of a request that came with this parent.

        is_trusted: the trace of the parent goes on, recorded if it was so far.
        """


class RequestSpans:
    """trusts: whether the sender of a request decides about its trace."""

    def __init__(
        self,
        app: ASGIApp,
        recorder: RequestRecorder,
        trusts: Callable[[Scope], bool],
    ) -> None:
        self._app, self._recorder, self._trusts = app, recorder, trusts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http" or scope["path"] in _PROBES:
            await self._app(scope, receive, send)
            return
        parent = read_traceparent(scope)
        is_trusted = parent is not None and self._trusts(scope)
        span = self._recorder.request(parent, is_trusted=is_trusted)
        if not span.is_recorded:  # as most are
            await self._app(scope, receive, send)
            return
        with span:
            await self._answer(span, scope, receive, send)

    async def _answer(
        self, span: Span, scope: Scope, receive: Receive, send: Send
    ) -> None:
        async def send_and_note(message: Message) -> None:
            if message["type"] == "http.response.start":
                span.set("http.response.status_code", message["status"])
            await send(message)

        try:
            await self._app(scope, receive, send_and_note)
        finally:
            _describe(span, scope)


def read_traceparent(scope: Scope) -> TraceParent | None:
    """The trace parent of the request; None unless it has exactly one valid header."""
    header = None
    for name, value in scope["headers"]:
        if name == b"traceparent":
            if header is not None:
                return None
            header = value
    if header is None or (match := _TRACEPARENT.fullmatch(header)) is None:
        return None
    trace_id, span_id, flags = (int(digits, 16) for digits in match.groups())
    if trace_id == 0 or span_id == 0:
        return None
    return TraceParent(trace_id, span_id, is_recorded=bool(flags & 1))


def _describe(span: Span, scope: Scope) -> None:
    """Set the name and the members of the span, once its route is known."""
    method = scope["method"] if scope["method"] in _METHODS else "_OTHER"
    route = getattr(scope.get("route"), "path", None)
    span.set("http.request.method", method)
    span.set("name", method if route is None else f"{method} {route}")
    if route is not None:
        span.set("http.route", route)
    if operation := scope.get(OPERATION):
        span.set("proctor.operation", operation)
    span.set("proctor.request_id", REQUEST_ID.get() or "")
    run_id = scope.get("path_params", {}).get("run_id", "")
    if re.fullmatch(PATH_PATTERNS["run_id"][0], run_id):
        span.set("proctor.run_id", run_id)
