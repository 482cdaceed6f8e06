"""Requests for a run of another node are passed on to it: any node answers any request.

This file chooses the node; `node_connections.py` sends the request there, and its
answer back. A request is passed on once: what comes from a node is answered here. If
the other node has ended, the request waits until this one, or a third, may go on with
the run, if it is safe to send it again. Otherwise the answer is `unavailable`: by the
rules of the specification a repeat is safe. It decides nothing about runs.
"""

from __future__ import annotations

import asyncio
import contextlib
import re
import time
from collections.abc import Callable

from starlette.requests import Request
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from reference_server.cluster.followed_stream import FollowedStream
from reference_server.cluster.membership import Membership
from reference_server.cluster.node_connections import (
    PASSED_ON,
    SILENT_S,
    NodeAway,
    NodeConnections,
    run_id_of,
)
from reference_server.cluster.node_headers import is_from_node
from reference_server.http.application import WholeEndpoint
from reference_server.http.dispatch import OPERATION, PATH_PATTERNS
from reference_server.http.pages.page_sessions import needs_session, node_of_session
from reference_server.http.problems import MOVED_HEADER, problem_response
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.storage.node_store import Node
from reference_server.storage.runs.run_store import StoreFailed

# How often a request follows a run that moves, and how much of it is kept for that.
MOVES_MAX, REPEATED_BYTES_MAX = 3, 2**16
# Between two tries to go on with an event stream.
FOLLOW_PAUSE_S = 0.2
_MOVED, _REFUSED = MOVED_HEADER.lower().encode(), 503
# Headers of a request that was not answered: over a new connection, a repeat may reach
# another node, which may reach the owner or be it.
_GO_ELSEWHERE = {"Connection": "close"}
# Where the scope of a turn has whether a node passed it on.
_PASSED_ON = "proctor.passed_on"


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
        """A `receive` that delivers the request from its beginning."""
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
            headers = [
                header for header in message["headers"] if header[0].lower() != _MOVED
            ]
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
        await self.answer(scope, receive, send, is_passed_on=is_passed_on)

    async def answer(
        self, scope: Scope, receive: Receive, send: Send, *, is_passed_on: bool
    ) -> None:
        """Answer a request, whose headers say nothing of nodes any more."""
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
        run_id, moves = run_id_of(scope), 0

        def may_repeat() -> bool:
            return run_id is not None and request.is_short and moves < MOVES_MAX

        while True:
            try:
                send_here = _unless_moved(send, may_repeat)
                await self._answer(scope, request.read(), send_here)
            except _RunMoved:
                moves += 1
                self._connections.membership.note_moved(run_id or "")
            except NodeAway as away:
                can_repeat = may_repeat() and (not away.was_sent or _is_safe(scope))
                if not (can_repeat and await self._has_ended(away, request)):
                    refused = problem_response(away, _GO_ELSEWHERE)
                    await refused(scope, request.read(), send)
                    return
                moves += 1
            else:
                return

    async def _has_ended(self, away: NodeAway, request: RepeatableRequest) -> bool:
        """Wait until the run of a node that has ended can be claimed.

        False if the node lives, and is only not reached from here: its clients may
        reach it another way.
        """
        membership = self._connections.membership
        if request.has_no_reader or not membership.claims:
            return False
        try:
            return await membership.has_ended(away.node)
        except StoreFailed:
            return False

    async def _answer(
        self, scope: Scope, receive: Receive, send: Send, *, is_passed_on: bool = False
    ) -> None:
        try:
            await self._connections.membership.ensure_lease()
            node = await self._find_node(scope)
            if node is not None and is_passed_on:
                # The other node may have read the owner after this one did.
                self._connections.membership.note_moved(run_id_of(scope) or "")
                raise OwnedElsewhere(run_id_of(scope) or "")
            if node is not None:
                await self._connections.pass_on(node, scope, receive, send)
                return
            app: ASGIApp = self._answer_here
        except NodeAway:
            raise
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
            refused = problem_response(_lease_lost(), _GO_ELSEWHERE)
            await refused(scope, receive, send)

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
        run_id = run_id_of(scope)
        if run_id is None or self._has_run(run_id):
            return None
        if not re.fullmatch(PATH_PATTERNS["run_id"][0], run_id):
            return None
        reads = scope["method"] in ("GET", "HEAD")
        return await self._connections.membership.find_other(run_id, only_reads=reads)


class TurnForwarding:
    """Turns without ASGI, as those of a server without other nodes (DirectTurns).

    own: answers a turn of a run of this node. forwarding: answers any other one, and
    one whose run moves meanwhile.
    """

    def __init__(
        self,
        own: WholeEndpoint,
        forwarding: RunForwarding,
        membership: Membership,
        has_run: Callable[[str], bool],
    ) -> None:
        self._own, self._forwarding = own, forwarding
        self._membership, self._has_run = membership, has_run

    def has_run(self, run_id: str) -> bool:
        """Whether a turn of the run is answered here; others are passed on in parts."""
        return self._has_run(run_id)

    async def perform_whole(self, scope: Scope, method: str, body: bytes) -> Response:
        """Answer a turn whose body is complete.

        scope: that of an earlier request where the heads are equal.
        """
        try:
            is_passed_on = self._is_passed_on(scope)
        except Refused as refused:
            return problem_response(refused, _GO_ELSEWHERE)
        membership, run_id = self._membership, scope["path_params"]["run_id"]
        if membership.has_lease and self._has_run(run_id):
            node_id = membership.node_id
            response = await self._own.perform_whole(scope, method, body)
            if not await self._is_valid(node_id):
                return problem_response(_lease_lost(), _GO_ELSEWHERE)
            if is_passed_on or not _has_moved(response):
                return response
            membership.note_moved(run_id)
        return await self._forward(scope, body, is_passed_on=is_passed_on)

    def _is_passed_on(self, scope: Scope) -> bool:
        """The headers that say so are removed from the head when it is first seen."""
        seen: bool | Refused | None = scope.get(_PASSED_ON)
        if seen is None:
            try:
                seen = is_from_node(scope, self._membership)
            except Refused as refused:
                seen = refused
            scope[_PASSED_ON] = seen
        if isinstance(seen, Refused):
            raise seen
        return seen

    async def _is_valid(self, node_id: str) -> bool:
        """Whether this node has acted for its runs all the while."""
        if not self._membership.has_lease:
            try:
                await self._membership.ensure_lease()
            except StoreFailed:
                return False
        return self._membership.node_id == node_id

    async def _forward(
        self, scope: Scope, body: bytes, *, is_passed_on: bool
    ) -> Response:
        answer = _CollectedAnswer(body)
        forwarded = {**scope, OPERATION: PASSED_ON}  # unless it is answered here
        await self._forwarding.answer(
            forwarded, answer.receive, answer.send, is_passed_on=is_passed_on
        )
        scope[OPERATION] = forwarded[OPERATION]
        return answer.response()


class _CollectedAnswer:
    """One request whose body is there, and its answer."""

    def __init__(self, body: bytes) -> None:
        self._body: bytes | None = body
        self._start: Message = {}
        self._parts: list[bytes | memoryview] = []
        self._is_complete = False

    async def receive(self) -> Message:
        if self._body is None:  # the client stays
            await asyncio.Event().wait()
        body, self._body = self._body, None
        return {"type": "http.request", "body": body, "more_body": False}

    async def send(self, message: Message) -> None:
        if message["type"] == "http.response.start":
            self._start = message
            return
        if part := message.get("body", b""):
            self._parts.append(part)
        self._is_complete = not message.get("more_body", False)

    def response(self) -> Response:
        if not self._is_complete:
            text = "The node that has the run does not answer."
            return problem_response(Refused("unavailable", text), _GO_ELSEWHERE)
        response = Response(status_code=self._start["status"])
        response.body = b"".join(self._parts)
        # The framing is of what is written here, however the other node has sent it.
        framing = (b"content-length", b"transfer-encoding")
        headers = [h for h in self._start["headers"] if h[0].lower() not in framing]
        headers.append((b"content-length", b"%d" % len(response.body)))
        response.raw_headers = headers
        return response


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


def _lease_lost() -> Refused:
    text = "The lease of the node ended before it could answer."
    return Refused("unavailable", text)


def _has_moved(response: Response) -> bool:
    return response.status_code == _REFUSED and any(
        name == _MOVED for name, _ in response.raw_headers
    )


def _is_safe(scope: Scope) -> bool:
    """Whether a request that may have been carried out is answered so once more."""
    is_of_worker = "worker_id" in scope.get("path_params", {})
    return scope["method"] in ("GET", "HEAD") or is_of_worker


def _now() -> float:
    return time.monotonic()
