"""The ASGI application: what holds for every response, and for every path.

It decides no rule, and knows no operation.
"""

from __future__ import annotations

import logging
import re
import time
from collections.abc import Awaitable, Callable, Mapping
from contextlib import AbstractAsyncContextManager
from functools import partial
from typing import Any, Protocol

from starlette.datastructures import Headers
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from reference_record.generated.protocol_version import PROTOCOL_VERSION
from reference_server.http.auth import Tokens
from reference_server.http.dispatch import (
    ACCOUNT,
    OPERATION,
    Operation,
    WholeRequests,
    check_caller,
    operation_name,
    perform,
)
from reference_server.http.pages.page_sessions import PATH as PAGES_PATH
from reference_server.http.problems import problem_response
from reference_server.http.tokens.open_requests import OpenRequests
from reference_server.process.lifespan import run_lifespan
from reference_server.rules.refusal import Refused
from reference_server.settings.allowed_hosts import AllowedHosts
from reference_server.telemetry.counters import COUNTERS
from reference_server.telemetry.log_output import (
    ACCESS_LOG,
    REQUEST_ID,
    log_event,
    request_id_of,
)

log = logging.getLogger("proctor.app")
access_log = logging.getLogger(ACCESS_LOG)

# Where the scope of a direct request has its WholeRequests.
_WHOLE = "proctor.whole"
_VERSION_HEADER = (b"proctor-version", PROTOCOL_VERSION.encode())
# A turn's path in the form that every client sends; any other is the router's.
_TURN_URL = re.compile(
    rb"/v1/runs/([A-Za-z0-9_.-]+)/workers/([A-Za-z0-9_.~-]+)/predict"
)


class _ServerRequest(Request):
    """A request whose headers are looked up by name, and not one after another."""

    @property
    def headers(self) -> Headers:
        """The headers; the first of a name counts, as Starlette has it."""
        if not hasattr(self, "_headers"):
            self._headers: Headers = _HeadersByName(raw=self.scope["headers"])
        return self._headers


class _HeadersByName(Headers):
    def __init__(self, raw: list[tuple[bytes, bytes]]) -> None:
        super().__init__(raw=raw)
        self._first = {
            name.decode("latin-1"): value.decode("latin-1")
            for name, value in reversed(raw)
        }

    def get(self, key: str, default: Any = None) -> Any:
        return self._first.get(key, default)  # every caller writes it in lower case


class Endpoint:
    """One path for every method, so that a 405 (ERR-010) can name those of the path.

    ERR-022: it does so in the header Allow.
    """

    def __init__(
        self,
        operations: Mapping[str, Operation],
        tokens: Tokens,
        max_body: int,
        hosts: AllowedHosts,
        open_requests: OpenRequests,
    ) -> None:
        self._open_requests = open_requests
        self._operations = operations
        self._names = {
            method: operation_name(operation)
            for method, operation in operations.items()
        }
        self._tokens = tokens
        self._max_body = max_body
        self._hosts = hosts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        operation = self._operations.get(scope["method"])
        if operation is None:
            response = self._not_allowed(scope["method"])
        else:
            scope[OPERATION] = self._names[scope["method"]]
            request = _ServerRequest(scope, receive)
            if operation.may_last(scope["method"]):
                return await self._answer_while_allowed(request, operation, send)
            response = await self._perform(request, operation)
        await response(scope, receive, send)
        return None

    async def _answer_while_allowed(
        self, request: Request, operation: Operation, send: Send
    ) -> None:
        """A revoked token ends a wait with a refusal, and a stream where it is."""
        await self._open_requests.answer(
            request,
            partial(check_caller, request, operation, self._tokens),
            partial(self._perform, request, operation),
            operation.refusal_response or problem_response,
            send,
        )

    def has_run(self, _run_id: str) -> bool:
        """Every run is of this server."""
        return True

    async def perform_whole(self, scope: Scope, method: str, body: bytes) -> Response:
        """Answer a request whose body is complete, with a response to be sent whole.

        scope: that of an earlier request where the heads are equal.
        """
        scope[OPERATION] = self._names[method]
        whole: WholeRequests | None = scope.get(_WHOLE)
        if whole is None:
            whole = scope[_WHOLE] = WholeRequests(_ServerRequest(scope))
        whole.body = body
        try:
            return await self._perform(whole.request, self._operations[method], whole)
        finally:
            whole.body = b""  # a connection keeps no body between two turns

    def _perform(
        self,
        request: Request,
        operation: Operation,
        whole: WholeRequests | None = None,
    ) -> Awaitable[Response]:
        return perform(
            request, operation, self._tokens, self._max_body, self._hosts, whole=whole
        )

    def _not_allowed(self, method: str) -> Response:
        detail = f"{method} is not a method of this path."
        allowed = {"Allow": ", ".join(sorted(self._operations))}
        return problem_response(Refused("method_not_allowed", detail), allowed)


class WholeEndpoint(Protocol):
    """One path, whose requests are answered without ASGI once their body is there."""

    def has_run(self, run_id: str) -> bool:
        """Whether requests for the run are answered so."""

    async def perform_whole(self, scope: Scope, method: str, body: bytes) -> Response:
        """See Endpoint."""


class Application:
    """Adds the protocol's version to every response, and answers a defect as a problem.

    One layer around the router, not a framework's stack of them: a turn passes every
    layer three times.

    lifespan: the parts, open while it is entered. begin_drain: to be called when the
    server begins to end; ends waiting requests, and from then on nothing new begins.
    turns_in_progress: how many turns are to be finished then. turns: answers turns
    without the router; None if the router has to see every request.
    """

    def __init__(
        self,
        app: ASGIApp,
        lifespan: Callable[[], AbstractAsyncContextManager[None]],
        begin_drain: Callable[[], Awaitable[None]],
        turns_in_progress: Callable[[], int],
        turns: WholeEndpoint | None = None,
    ) -> None:
        self._app, self._lifespan = app, lifespan
        self.begin_drain, self.turns_in_progress = begin_drain, turns_in_progress
        self.direct = None if turns is None else DirectTurns(turns)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":  # no web sockets: it is the lifespan
            await run_lifespan(self._lifespan(), receive, send)
            return
        answered = _AnsweredRequest(scope)

        async def send_versioned(message: Message) -> None:
            if message["type"] == "http.response.start":
                answered.begin(message["status"], message["headers"])
            await send(message)

        try:
            await self._app(scope, receive, send_versioned)
        except Exception:
            if answered.status:  # too late for a problem; the connection is closed
                raise
            log.exception("a request failed")
            await _defect_response()(scope, receive, send_versioned)
        finally:
            answered.end()


class DirectTurns:
    """Turns without ASGI and router: the same checks, the same operation."""

    def __init__(self, endpoint: WholeEndpoint) -> None:
        self._endpoint = endpoint

    def path_of(self, method: bytes, url: bytes) -> Mapping[str, str] | None:
        """See DirectAnswers; an unusual URL goes the general way."""
        match = _TURN_URL.fullmatch(url) if method == b"POST" else None
        if match is None:
            return None
        run_id, worker_id = (part.decode() for part in match.groups())
        if not self._endpoint.has_run(run_id):
            return None
        return {"run_id": run_id, "worker_id": worker_id}

    async def answer(self, scope: Scope, body: bytes) -> Response:
        """See DirectAnswers."""
        scope["method"], scope["query_string"] = "POST", b""
        answered = _AnsweredRequest(scope)
        try:
            response = await self._endpoint.perform_whole(scope, "POST", body)
        except Exception:
            log.exception("a request failed")
            response = _defect_response()
        answered.begin(response.status_code, response.raw_headers)
        answered.end()
        return response


class _AnsweredRequest:
    """One request: its answer gets two headers more, and is counted and logged."""

    def __init__(self, scope: Scope) -> None:
        self.status = 0
        self._scope, self._started = scope, time.perf_counter()
        self._request_id = request_id_of(_header(scope, b"x-request-id"))
        REQUEST_ID.set(self._request_id)

    def begin(self, status: int, headers: list[tuple[bytes, bytes]]) -> None:
        """Its answer begins; headers: of it, to which those of every answer come."""
        self.status = status
        headers.append(_VERSION_HEADER)  # VER-001
        headers.append((b"x-request-id", self._request_id.encode()))

    def end(self) -> None:
        """Its answer is complete, or cut off."""
        took_s, scope = time.perf_counter() - self._started, self._scope
        operation = scope.get(OPERATION) or _other(scope["path"])
        COUNTERS.requests[operation, self.status // 100].add(took_s)
        if access_log.isEnabledFor(logging.INFO):
            log_event(
                access_log,
                "request",
                method=scope["method"],
                path=scope["path"],
                status=self.status,
                ms=round(1000 * took_s, 1),
                account=scope.get(ACCOUNT),
                client=(scope.get("client") or ("-",))[0],
            )


def _defect_response() -> Response:
    return problem_response(Refused("internal_error", "Internal server error."))


def _other(path: str) -> str:
    """The label in the metrics of a request that does not match an operation."""
    return "pages" if path.startswith(PAGES_PATH) else "other"


def _header(scope: Scope, name: bytes) -> bytes | None:
    for key, value in scope["headers"]:
        if key == name:
            return bytes(value)
    return None
