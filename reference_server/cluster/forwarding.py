"""Requests for a run of another node are passed on to it: any node answers any request.

Bodies are streamed in both directions, so that event streams and records pass. A
request is passed on once: what comes from a node is answered here. If the other node
was not reached before anything was sent, does not answer, or ends meanwhile, the answer
is `unavailable`: by the rules of the specification a repeat is safe. It decides nothing
about runs.
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import logging
import re
import time
from collections.abc import AsyncIterator, Callable
from typing import Any

import httpcore
from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from reference_server.cluster.followed_stream import FollowedStream
from reference_server.cluster.membership import Membership
from reference_server.cluster.reachability import Reachability
from reference_server.http.dispatch import OPERATION, PATH_PATTERNS
from reference_server.http.pages.page_sessions import needs_session, node_of_session
from reference_server.http.problems import MOVED_HEADER, problem_response
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import RENEWALS_PER_LEASE, OwnedElsewhere
from reference_server.storage.node_store import Node
from reference_server.storage.store import StoreFailed
from reference_server.system.counters import COUNTERS
from reference_server.system.log_output import REQUEST_ID
from reference_server.system.repeated_failures import RepeatedFailures
from reference_server.system.spans import span, traceparent

log = logging.getLogger("proctor.cluster")

SECRET_HEADER, CLIENT_HEADER = b"proctor-node-secret", b"proctor-node-client"
# Of one connection each (RFC 9110, section 7.6.1), or added anew to every answer.
_HOP_BY_HOP = {
    *(b"connection", b"keep-alive", b"proxy-connection", b"te", b"trailer"),
    *(b"transfer-encoding", b"upgrade", b"expect"),
}
_ADDED_ANEW = {b"date", b"proctor-version", b"x-request-id"}
_OURS = {SECRET_HEADER, CLIENT_HEADER, b"x-request-id"}
# Of another node they are believed, so those of clients are not passed on.
_OF_TRACES = {b"traceparent", b"tracestate"}
_NOT_PASSED_ON = _HOP_BY_HOP | _OURS | _OF_TRACES
_NOT_REACHED = (
    httpcore.NetworkError,
    httpcore.TimeoutException,
    httpcore.ProtocolError,
)
# A node closes a connection that is unused for 5 s.
KEEPALIVE_S = 3.0
CONNECT_TIMEOUT_S = 2.0
# How often a request follows a run that moves, and how much of it is kept for that.
MOVES_MAX, REPEATED_BYTES_MAX = 3, 2**16
# Between two tries to go on with an event stream.
FOLLOW_PAUSE_S = 0.2
_MOVED, _REFUSED = MOVED_HEADER.lower().encode(), 503
CONNECTIONS_MAX = 1000
# What a request that is passed on counts as in the metrics of its first node.
PASSED_ON = "passed_on"
# At least so long, and for a lease, a busy node may be silent and is still waited for.
SILENT_S = 5.0
# A node is asked twice whether it lives, over connections of their own: what all
# requests share may be used up, or one connection lost.
QUESTIONS = 2
QUESTIONS_AT_ONCE_MAX = 100
# Of what was not answered: over a new connection, a repeat may reach another node,
# which may reach the owner or be it.
_GO_ELSEWHERE = {"Connection": "close"}


class NodeConnections:
    """Connections to the other nodes; open while the server runs."""

    def __init__(self, membership: Membership) -> None:
        self.membership = membership
        self.failures = RepeatedFailures(log)
        self._pool = httpcore.AsyncConnectionPool(
            max_connections=CONNECTIONS_MAX,
            max_keepalive_connections=CONNECTIONS_MAX,
            keepalive_expiry=KEEPALIVE_S,
        )
        self._questions = httpcore.AsyncConnectionPool(
            max_connections=QUESTIONS_AT_ONCE_MAX, max_keepalive_connections=0
        )
        self._reachability = Reachability(
            self._answers,
            lambda node: membership.gone(node).is_set(),
            membership.lease_s / RENEWALS_PER_LEASE,
        )

    async def close(self) -> None:
        await self._reachability.close()
        await self._pool.aclose()
        await self._questions.aclose()

    async def _answers(self, node: Node) -> bool:
        """Whether it answers anything before it would have lost its lease."""
        limit_s = max(self.membership.lease_s, SILENT_S)
        asked = [
            asyncio.ensure_future(self._ask(node, number * limit_s / QUESTIONS))
            for number in range(QUESTIONS)
        ]
        try:
            async with asyncio.timeout(limit_s):
                for answer in asyncio.as_completed(asked):
                    if await answer:
                        return True
        except TimeoutError:
            return False
        finally:
            for one in asked:
                one.cancel()
            await asyncio.wait(asked)
        return False

    async def _ask(self, node: Node, after_s: float) -> bool:
        """Whether it answers one question."""
        await asyncio.sleep(after_s)
        with contextlib.suppress(*_NOT_REACHED, OSError):
            await self._questions.request("GET", node.url + "/livez")
            return True
        return False

    async def pass_on(
        self, node: Node, scope: Scope, receive: Receive, send: Send
    ) -> None:
        """Answer a request with what that node answers.

        Raises Refused if it does not answer. An answer that breaks off stays
        incomplete: the server closes its connection then.
        """
        scope[OPERATION] = PASSED_ON
        exchange = _Exchange(self._pool, node, scope, receive, send)
        try:
            with span("pass on to owner", is_call=True):
                await self._carry_out(exchange, node)
        except _ClientLeft:
            return
        except (*_NOT_REACHED, OSError) as error:
            self.failures.report("a request could not be passed on", repr(error))
            with contextlib.suppress(StoreFailed):  # it is looked for again at once
                await self.membership.forget_owner(_run_id(scope) or "")
        if not exchange.is_begun and not exchange.has_no_reader:
            raise Refused("unavailable", "The node that has the run does not answer.")

    async def _carry_out(self, exchange: _Exchange, node: Node) -> None:
        """Returns also if nothing more is to be waited for."""
        started = time.perf_counter()
        try:
            with self._reachability.waiting(node) as lost:
                if not lost.is_set():
                    await _first_of(
                        exchange.answer(),
                        exchange.wait_until_client_left(),
                        self.membership.gone(node).wait(),
                        lost.wait(),
                    )
        finally:
            is_ok = exchange.is_answered or exchange.has_no_reader
            took_s = time.perf_counter() - started
            COUNTERS.passed_on["ok" if is_ok else "failed"].add(took_s)

    async def post(self, node: Node, path: str, body: bytes) -> bytes | None:
        """What a node answers to a request of this one; None if it ends."""
        headers = [(b"host", b"node"), (SECRET_HEADER, node.secret.encode())]
        answers: list[httpcore.Response] = []

        async def ask() -> None:
            url = node.url + path
            answers.append(
                await self._pool.request("POST", url, headers=headers, content=body)
            )

        try:
            with span("read from node", is_call=True):
                headers += _of_trace()
                await _first_of(ask(), self.membership.gone(node).wait())
        except (*_NOT_REACHED, OSError) as error:
            self.failures.report("a node was not reached", repr(error))
            return None
        return next((one.content for one in answers if one.status == 200), None)


class _ClientLeft(Exception):
    """The client left before its request was complete."""


class _Exchange:
    """One request to another node, and its answer."""

    def __init__(
        self,
        pool: httpcore.AsyncConnectionPool,
        node: Node,
        scope: Scope,
        receive: Receive,
        send: Send,
    ) -> None:
        self._pool, self._node, self._scope = pool, node, scope
        self._receive, self._send = receive, send
        self._body_read = asyncio.Event()
        self.is_begun = self.is_answered = self.has_no_reader = False

    async def answer(self) -> None:
        """Send the whole answer, part by part."""
        headers, has_body = _request_headers(self._scope, self._node)
        if not has_body:
            self._body_read.set()
        target = self._scope.get("raw_path") or self._scope["path"].encode()
        if query := self._scope["query_string"]:
            target += b"?" + query
        base = httpcore.URL(self._node.url)
        url = httpcore.URL(
            scheme=base.scheme, host=base.host, port=base.port, target=target
        )
        async with self._pool.stream(
            self._scope["method"],
            url,
            headers=headers,
            content=self._read_body() if has_body else None,
            extensions={"timeout": {"connect": CONNECT_TIMEOUT_S}},
        ) as response:
            await self._start(response)
            async for part in response.aiter_stream():
                await self._send(_body(part, more=True))
        await self._send(_body(b"", more=False))
        self.is_answered = True

    async def _start(self, response: httpcore.Response) -> None:
        dropped = _HOP_BY_HOP | _ADDED_ANEW
        headers = [
            (name.lower(), value)
            for name, value in response.headers
            if name.lower() not in dropped
        ]
        self.is_begun = True
        await self._send(
            {
                "type": "http.response.start",
                "status": response.status,
                "headers": headers,
            }
        )

    async def _read_body(self) -> AsyncIterator[bytes]:
        more = True
        while more:
            message = await self._receive()
            if message["type"] == "http.disconnect":
                self.has_no_reader = True
                raise _ClientLeft
            more = message.get("more_body", False)
            if part := message.get("body", b""):
                yield part
        self._body_read.set()

    async def wait_until_client_left(self) -> None:
        """No answer is needed any more; what the other node has begun goes on there."""
        await self._body_read.wait()
        while (await self._receive())["type"] != "http.disconnect":
            pass
        self.has_no_reader = True


class _LeaseLost(Exception):
    """Others removed this node while it carried out a request."""


class _RunMoved(Exception):
    """Another node has the run by now; nothing was done, and nothing answered."""


class RepeatableRequest:
    """A request that can be read again from its beginning, while it is short.

    has_no_reader: whether the client has left, as far as that was received.
    """

    def __init__(self, receive: Receive) -> None:
        self._receive = receive
        self._messages: list[Message] = []
        self._size, self.is_short = 0, True
        self.has_no_reader = False

    def read(self) -> Receive:
        """What receives all of it, once more."""
        at = 0

        async def receive() -> Message:
            nonlocal at
            if at < len(self._messages):
                at += 1
                return self._messages[at - 1]
            message = await self._receive()
            self._keep(message)
            at = len(self._messages)
            return message

        return receive

    def _keep(self, message: Message) -> None:
        if message["type"] == "http.disconnect":
            self.has_no_reader = True
        self._size += len(message.get("body", b""))
        self.is_short = self._size <= REPEATED_BYTES_MAX
        if self.is_short:
            self._messages.append(message)
        else:
            self._messages.clear()


def _unless_moved(send: Send, may_repeat: Callable[[], bool]) -> Send:
    """Send an answer, unless it is that the run has moved; then raise _RunMoved."""

    async def send_or_raise(message: Message) -> None:
        if message["type"] == "http.response.start" and message["status"] == _REFUSED:
            headers = [one for one in message["headers"] if one[0].lower() != _MOVED]
            if len(headers) < len(message["headers"]) and may_repeat():
                raise _RunMoved
            message["headers"] = headers
        await send(message)

    return send_or_raise


class RunForwarding:
    """One path of runs: its requests are answered here, or passed on (CLU-001).

    All requests for a run are decided by its one owner: a repeat is known there,
    wherever it arrived (CLU-003), requests at the same moment come one after the other
    (CLU-004), a lease is extended (CLU-005), and long polls and event streams wait
    where changes are made (CLU-006), with the client's Last-Event-ID (CLU-007).

    A run that waits may move to a node that has room while it is asked for: then the
    request is repeated there.

    has_run: whether a run is in the memory of this node for good; most turns need no
    more.
    """

    def __init__(
        self,
        app: ASGIApp,
        connections: NodeConnections,
        has_run: Callable[[str], bool],
    ) -> None:
        self._app, self._connections, self._has_run = app, connections, has_run

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        membership = self._connections.membership
        try:
            is_passed_on = is_from_node(scope, membership)
        except Refused as refused:
            await problem_response(refused, _GO_ELSEWHERE)(scope, receive, send)
            return
        if is_passed_on:  # the node that did that repeats it
            await self._answer(scope, receive, send, is_passed_on=True)
            return
        request, stream = RepeatableRequest(receive), FollowedStream(send)
        await self._answer_or_repeat(scope, request, stream.send)
        if stream.can_go_on and request.is_short:  # else it cannot be sent again
            await self._follow(scope, request, stream)
        await stream.end()

    async def _follow(
        self, scope: Scope, request: RepeatableRequest, stream: FollowedStream
    ) -> None:
        """Send what follows an event stream that can go on.

        Its next node may not be known before a lease has ended.
        """
        membership = self._connections.membership
        sent_at = _now()
        while not request.has_no_reader and membership.claims:
            began, last_id = _now(), stream.last_id
            behind = stream.scope_behind(scope)
            await self._answer_or_repeat(behind, request, stream.send)
            if not stream.can_go_on:  # a comment would end an event that is cut off
                return
            is_long = not stream.is_refused and _now() - began > FOLLOW_PAUSE_S
            if is_long or stream.last_id != last_id:
                sent_at = _now()
            elif _now() - sent_at > 2 * membership.lease_s + SILENT_S:
                return
            else:
                await stream.keep_alive()
                await asyncio.sleep(FOLLOW_PAUSE_S)

    async def _answer_or_repeat(
        self, scope: Scope, request: RepeatableRequest, send: Send
    ) -> None:
        """Answer a request; if its run moves meanwhile, by its new node."""
        run_id, moves = _run_id(scope), 0

        def may_repeat() -> bool:
            return run_id is not None and request.is_short and moves < MOVES_MAX

        while True:
            try:
                send_here = _unless_moved(send, may_repeat)
                await self._answer(scope, request.read(), send_here)
            except _RunMoved:
                moves += 1
                self._connections.membership.note_moved(run_id or "")
            else:
                return

    async def _answer(
        self, scope: Scope, receive: Receive, send: Send, *, is_passed_on: bool = False
    ) -> None:
        try:
            await self._connections.membership.ensure_lease()
            node = await self._find_node(scope)
            if node is not None and is_passed_on:
                # What this node remembers may be older than what that one read.
                self._connections.membership.note_moved(_run_id(scope) or "")
                raise OwnedElsewhere(_run_id(scope) or "")
            if node is not None:
                await self._connections.pass_on(node, scope, receive, send)
                return
            app: ASGIApp = self._answer_here
        except Refused as refused:
            if not is_passed_on:  # its owner is not found now
                refused = Refused(refused.code, refused.detail)
            app = problem_response(refused, _GO_ELSEWHERE)
        except StoreFailed as error:
            self._connections.failures.report("no database", str(error))
            text = "The database is not available."
            app = problem_response(Refused("unavailable", text), _GO_ELSEWHERE)
        await app(scope, receive, send)

    async def _answer_here(self, scope: Scope, receive: Receive, send: Send) -> None:
        try:
            await self._app(scope, receive, self._while_valid(send))
        except _LeaseLost:
            text = "The lease of the node ended before it could answer."
            refused = Refused("unavailable", text)
            await problem_response(refused, _GO_ELSEWHERE)(scope, receive, send)

    def _while_valid(self, send: Send) -> Send:
        """Begins no answer after the lease: others may have gone on with the run.

        A node that was paused in a turn would answer what is in no recording.
        """
        membership = self._connections.membership
        node_id = membership.node_id

        async def send_while_valid(message: Message) -> None:
            if message["type"] == "http.response.start":
                try:
                    await membership.ensure_lease()
                except StoreFailed as error:
                    raise _LeaseLost from error
                if membership.node_id != node_id:
                    raise _LeaseLost
            await send(message)

        return send_while_valid

    async def _find_node(self, scope: Scope) -> Node | None:
        """The other node that has the run: one that passed a request on may be late."""
        run_id = _run_id(scope)
        if run_id is None or self._has_run(run_id):
            return None
        if not re.fullmatch(PATH_PATTERNS["run_id"][0], run_id):
            return None
        reads = scope["method"] in ("GET", "HEAD")
        return await self._connections.membership.find_other(run_id, only_reads=reads)


class PageForwarding:
    """The pages: those of a reader are answered by the node of the sign-in.

    If that node has ended, the reader signs in at this one.

    away: answers in place of a node that does not answer.
    """

    def __init__(
        self, app: ASGIApp, away: ASGIApp, connections: NodeConnections
    ) -> None:
        self._app, self._away, self._connections = app, away, connections

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        app = self._app
        try:
            node = await self._find_node(scope)
            if node is not None:
                await self._connections.pass_on(node, scope, receive, send)
                return
        except Refused:
            app = self._away
        await app(scope, receive, send)

    async def _find_node(self, scope: Scope) -> Node | None:
        membership = self._connections.membership
        if scope["type"] != "http" or is_from_node(scope, membership):
            return None
        if not needs_session(scope["path"]):
            return None
        node_id = node_of_session(Request(scope))
        if node_id in ("", membership.node_id):
            return None
        with contextlib.suppress(StoreFailed):
            return await membership.find_node(node_id)
        return None


def _now() -> float:
    return time.monotonic()


def _run_id(scope: Scope) -> str | None:
    found: str | None = scope.get("path_params", {}).get("run_id")
    return found


def is_from_node(scope: Scope, membership: Membership) -> bool:
    """Whether a node passed it on; then the address of its client is what it says.

    What any other sender says of that is taken out. Raises Refused for what was sent to
    another node: passed on again, it might come back without end.
    """
    headers: list[tuple[bytes, bytes]] = scope["headers"]
    sent = {name: value for name, value in headers if name in _OURS}
    if SECRET_HEADER not in sent and CLIENT_HEADER not in sent:
        return False
    kept = (SECRET_HEADER, CLIENT_HEADER)
    scope["headers"] = [pair for pair in headers if pair[0] not in kept]
    secret = sent.get(SECRET_HEADER, b"")
    is_node = hmac.compare_digest(secret, membership.secret.encode())
    if not is_node and membership.is_secret_of_other(secret):
        text = "The request was sent to another node: its node_url leads to this one."
        raise Refused("unavailable", text)
    if is_node:
        scope["client"] = (sent.get(CLIENT_HEADER, b"-").decode("latin-1"), 0)
    return is_node


def has_secret_of(membership: Membership, scope: Scope) -> bool:
    """Whether a node passed it on to this one; changes nothing, as `is_from_node`."""
    secret = membership.secret.encode()
    return any(
        name == SECRET_HEADER and hmac.compare_digest(value, secret)
        for name, value in scope["headers"]
    )


def _request_headers(
    scope: Scope, node: Node
) -> tuple[list[tuple[bytes, bytes]], bool]:
    """What is sent to the other node, and whether a body follows."""
    headers = [
        (name, value) for name, value in scope["headers"] if name not in _NOT_PASSED_ON
    ]
    names = {name for name, _ in scope["headers"]}
    is_chunked = b"transfer-encoding" in names
    if is_chunked:
        headers.append((b"transfer-encoding", b"chunked"))
    client = (scope.get("client") or ("-",))[0]
    headers += [
        (SECRET_HEADER, node.secret.encode()),
        (CLIENT_HEADER, str(client).encode("latin-1", "replace")),
        (b"x-request-id", (REQUEST_ID.get() or "").encode()),
        *_of_trace(),
    ]
    return headers, is_chunked or b"content-length" in names


def _of_trace() -> list[tuple[bytes, bytes]]:
    sent = traceparent()
    return [] if sent is None else [(b"traceparent", sent.encode())]


def _body(part: bytes, *, more: bool) -> Message:
    return {"type": "http.response.body", "body": part, "more_body": more}


async def _first_of(answer: Any, *ends: Any) -> None:
    """Until the answer is sent or one of the others ends; raises what ended it."""
    tasks = [asyncio.ensure_future(one) for one in (answer, *ends)]
    try:
        done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        for task in tasks:
            if task in done:
                task.result()
    finally:
        for task in tasks:
            task.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await asyncio.wait(tasks)
