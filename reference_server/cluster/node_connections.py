"""Connections to the other nodes, and what is sent over them.

Requests of clients are passed on, bodies streamed in both directions, so that event
streams and records pass; other requests are of this node. It chooses no node, and
decides nothing about runs.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import time
from collections.abc import Callable, Coroutine
from functools import partial
from typing import Any, TypeVar

import httpcore
from starlette.types import Receive, Scope, Send

from reference_server.cluster.membership import Membership
from reference_server.cluster.node_headers import (
    NOT_SENT_BACK,
    SECRET_HEADER,
    request_headers,
    trace_headers,
)
from reference_server.cluster.reachability import Reachability
from reference_server.http.dispatch import OPERATION
from reference_server.outgoing.outgoing_streams import OutgoingBackend
from reference_server.outgoing.reused_connections import ReusedConnections
from reference_server.outgoing.streamed_exchange import (
    NOT_REACHED,
    ClientLeft,
    StreamedExchange,
)
from reference_server.outgoing.unanswered_requests import why_no_answer
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import RENEWALS_PER_LEASE
from reference_server.storage.node_store import Node
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.telemetry.counters import COUNTERS
from reference_server.telemetry.repeated_failures import RepeatedFailures
from reference_server.telemetry.spans import span

log = logging.getLogger("proctor.cluster")
T = TypeVar("T")

# Far less than the time after which a node closes a connection without a request.
KEEPALIVE_S = 3.0
CONNECT_TIMEOUT_S = 2.0
CONNECTIONS_MAX = 1000
_NOT_CONNECTED = (
    httpcore.ConnectError,
    httpcore.ConnectTimeout,
    httpcore.PoolTimeout,
)
# Label of a forwarded request in the metrics of the node that received it first.
PASSED_ON = "passed_on"
# How long only the answer to a request is waited for: nearly every turn ends before.
_PROMPT_S = 0.1
# A busy node may be silent for at least this long, and for a lease, before it is given
# up.
SILENT_S = 5.0
# A node is asked twice whether it lives, over connections of their own: what all
# requests share may be used up, or one connection lost.
QUESTIONS = 2
QUESTIONS_AT_ONCE_MAX = 100


class NodeAway(Refused):
    """A node was not reached, or its answer never began: it may have ended.

    node: that one. was_sent: it may have carried the request out.
    """

    def __init__(self, node: Node, *, was_sent: bool) -> None:
        text = "The node that has the run does not answer."
        super().__init__("unavailable", text)
        self.node, self.was_sent = node, was_sent


class NodeConnections:
    """Connections to the other nodes; open while the server runs."""

    def __init__(self, membership: Membership) -> None:
        self.membership = membership
        self.failures = RepeatedFailures(log)
        self._reused = ReusedConnections(CONNECTIONS_MAX, KEEPALIVE_S)
        self._stream = partial(self._reused.stream, connect_timeout_s=CONNECT_TIMEOUT_S)
        self._questions = httpcore.AsyncConnectionPool(
            max_connections=QUESTIONS_AT_ONCE_MAX,
            max_keepalive_connections=0,
            network_backend=OutgoingBackend(),
        )
        self._reachability = Reachability(
            self._answers,
            lambda node: membership.gone(node).is_set(),
            membership.lease_s / RENEWALS_PER_LEASE,
        )

    async def close(self) -> None:
        await self._reachability.close()
        self._reused.close()
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
            for question in asked:
                question.cancel()
            await asyncio.wait(asked)
        return False

    async def _ask(self, node: Node, after_s: float) -> bool:
        """Whether it answers one question."""
        await asyncio.sleep(after_s)
        with contextlib.suppress(*NOT_REACHED, OSError):
            await self._questions.request("GET", node.url + "/livez")
            return True
        return False

    async def pass_on(
        self, node: Node, scope: Scope, receive: Receive, send: Send
    ) -> None:
        """Answer a request with what that node answers.

        Raises NodeAway if its connection fails, and Refused if it does not answer. An
        answer that breaks off stays
        incomplete: the server closes its connection then.
        """
        scope[OPERATION] = PASSED_ON
        exchange = StreamedExchange(scope, receive, send)
        away: NodeAway | None = None
        try:
            with span("pass on to owner", is_call=True):
                await self._carry_out(exchange, node, scope)
        except ClientLeft:
            return
        except (*NOT_REACHED, OSError) as error:
            self.failures.report(
                "a request could not be passed on", why_no_answer(error)
            )
            is_sent = not isinstance(error, _NOT_CONNECTED)
            away = NodeAway(node, was_sent=is_sent)
            with contextlib.suppress(StoreFailed):  # it is looked for again at once
                await self.membership.forget_owner(run_id_of(scope) or "")
        if away is None and self.membership.gone(node).is_set():
            away = NodeAway(node, was_sent=True)
        if not exchange.is_begun and not exchange.has_no_reader:
            text = "The node that has the run does not answer."
            raise away or Refused("unavailable", text)

    async def _carry_out(
        self, exchange: StreamedExchange, node: Node, scope: Scope
    ) -> None:
        """Returns also if nothing more is to be waited for."""
        started = time.perf_counter()
        try:
            with self._reachability.waiting(node) as lost:
                if not lost.is_set():
                    await _first_of(
                        exchange.answer(
                            self._stream,
                            httpcore.URL(node.url),
                            request_headers(scope, node),
                            kept_back=NOT_SENT_BACK,
                        ),
                        exchange.wait_until_client_left,
                        self.membership.gone(node).wait,
                        lost.wait,
                    )
        finally:
            is_ok = exchange.is_answered or exchange.has_no_reader
            took_s = time.perf_counter() - started
            COUNTERS.passed_on["ok" if is_ok else "failed"].add(took_s)

    async def post(self, node: Node, path: str, body: bytes) -> bytes | None:
        """Send a request to a node; returns the body of its answer, None if it ends."""
        headers = [
            (b"host", b"node"),
            (SECRET_HEADER, node.secret.encode()),
        ]

        async def ask() -> bytes | None:
            url = httpcore.URL(node.url + path)
            request = self._reused.stream("POST", url, headers=headers, content=body)
            async with request as response:
                return await response.aread() if response.status == 200 else None

        try:
            with span("read from node", is_call=True):
                headers += trace_headers()
                return await _first_of(ask(), self.membership.gone(node).wait)
        except (*NOT_REACHED, OSError) as error:
            self.failures.report("a node was not reached", why_no_answer(error))
            return None


def run_id_of(scope: Scope) -> str | None:
    """The run that the path of a request names."""
    run_id: str | None = scope.get("path_params", {}).get("run_id")
    return run_id


async def _first_of(
    answer: Coroutine[Any, Any, T], *ends: Callable[[], Coroutine[Any, Any, object]]
) -> T | None:
    """The result of `answer`; None if one of `ends` is done before. Raises as these.

    An answer that comes at once takes no task. It stays in the task of the caller:
    timeouts of what it awaits belong to that.
    """
    loop, limit = asyncio.get_running_loop(), asyncio.timeout(None)
    tasks: list[asyncio.Future[Any]] = []

    def give_up(_end: asyncio.Future[Any]) -> None:
        with contextlib.suppress(RuntimeError):  # the answer has ended meanwhile
            limit.reschedule(loop.time())

    def watch_ends() -> None:
        for end in ends:
            tasks.append(loop.create_task(end()))
            tasks[-1].add_done_callback(give_up)

    timer = loop.call_later(_PROMPT_S, watch_ends)
    try:
        async with limit:
            return await answer
    except TimeoutError:
        if not limit.expired():  # it was raised by the answer
            raise
        for task in tasks:
            if task.done():
                task.result()
        return None
    finally:
        timer.cancel()
        for task in tasks:
            task.cancel()
        if tasks:
            with contextlib.suppress(asyncio.CancelledError):
                await asyncio.wait(tasks)
