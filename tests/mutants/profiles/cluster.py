"""Mutants of services of several nodes: what one does, and another does not see."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Awaitable, Callable
from contextvars import ContextVar
from typing import Any

from starlette.types import Message, Receive, Scope, Send

from reference_server.cluster import forwarding, node_connections, node_headers
from reference_server.cluster.membership import Membership
from reference_server.cluster.node_connections import NodeConnections
from reference_server.http.dispatch import OperationCall
from reference_server.http.handlers import Handlers
from reference_server.rules.runs import lifecycle
from reference_server.rules.runs.lifecycle import Attach, Verdict
from reference_server.rules.runs.run import Run, Session
from reference_server.runs.sessions.session_executor import SessionExecutor
from reference_server.storage.node_store import Node
from reference_server.storage.runs.run_store import Store
from tests.mutants import instead_of, mutant, put
from tests.mutants.server_changes import replace_guard

# Longer than the kit waits for a change, shorter than its long polls.
LATE_S = 3.0
Answer = Callable[[Send], Awaitable[None]]
IS_FORWARDED: ContextVar[bool] = ContextVar("IS_FORWARDED", default=False)


def note_forwarded_requests() -> None:
    """Let `IS_FORWARDED` say whether another node forwarded the current request."""
    right = node_headers.is_from_node

    def noting(scope: Scope, membership: Membership) -> bool:
        is_forwarded = right(scope, membership)
        IS_FORWARDED.set(is_forwarded)
        return is_forwarded

    put(forwarding, "is_from_node", noting)


def change_forwarding(
    change: Callable[[Scope], bool],
    wrong: Callable[[Answer, Scope, Send], Awaitable[None]],
) -> None:
    """Replace how the requests for other nodes that `change` chooses are answered.

    wrong: is called with what sends the right answer to where it is given.
    """
    right = NodeConnections.pass_on

    async def pass_on(
        self: NodeConnections, node: Node, scope: Scope, receive: Receive, send: Send
    ) -> None:
        def answer(send: Send) -> Awaitable[None]:
            return right(self, node, scope, receive, send)

        await (wrong(answer, scope, send) if change(scope) else answer(send))

    put(NodeConnections, "pass_on", pass_on)


@mutant("CLU-001", "CLU-002", "CLU-006")
def shows_a_run_of_another_node_as_it_was() -> None:
    """A reader at a node that does not play the run sees a state long past."""
    seen: dict[str, list[Message]] = {}

    def is_plain_read(scope: Scope) -> bool:
        is_run = scope["path"].removeprefix("/v1/runs/").count("/") == 0
        names = {name for name, _ in scope["headers"]}
        return is_run and scope["method"] == "GET" and b"prefer" not in names

    async def wrong(answer: Answer, scope: Scope, send: Send) -> None:
        kept = seen.get(scope["path"])
        if kept is None:
            kept = []

            async def keep(message: Message) -> None:
                kept.append(message)

            await answer(keep)
            if b'"state":"queued"' not in b"".join(m.get("body", b"") for m in kept):
                seen[scope["path"]] = kept
        for message in kept:
            await send(message)

    change_forwarding(is_plain_read, wrong)


@mutant("CLU-002", through=instead_of(Handlers, "base_url"))
def shows_the_address_of_each_node(
    _right: Any, _self: Handlers, call: OperationCall
) -> Any:
    """A policy plays at the node that it asked last; caches keep a run twice."""
    return f"http://{call.request.headers['host']}"


@mutant("CLU-003")
def keeps_the_keys_of_submissions_on_each_node() -> None:
    """A submission whose answer was lost, repeated over a balancer, runs twice."""
    insert, find_key = Store.insert, Store.find_key

    def own(key: str) -> str:
        return f"{key[:100]}.{os.getpid()}"

    async def wrong_insert(
        self: Store, run: Run, key: str | None, body_sha256: str, check: Any = None
    ) -> bool:
        return await insert(self, run, key and own(key), body_sha256, check)

    async def wrong_find(self: Store, account: str, key: str) -> tuple[str, str] | None:
        return await find_key(self, account, own(key))

    put(Store, "insert", wrong_insert)
    put(Store, "find_key", wrong_find)


@mutant("CLU-004")
def counts_the_workers_of_each_node() -> None:
    """A run with a limit of its workers gets as many as there are nodes."""
    note_forwarded_requests()
    right = lifecycle._below_worker_limit

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        return None if IS_FORWARDED.get() else right(run, command, now)

    replace_guard(right, wrong)


@mutant("CLU-005")
def hears_heartbeats_of_its_own_clients_alone() -> None:
    """A slow policy behind a balancer loses its session, and its episode."""
    note_forwarded_requests()
    right = SessionExecutor._extend_lease

    def wrong(self: SessionExecutor, session: Session) -> None:
        if not IS_FORWARDED.get():
            right(self, session)

    put(SessionExecutor, "_extend_lease", wrong)


@mutant("CLU-006")
def answers_late_who_waits_at_another_node() -> None:
    """A script that waits for its run to begin begins later than it could."""

    async def wrong(answer: Answer, _scope: Scope, send: Send) -> None:
        async def send_late(message: Message) -> None:
            if message["type"] == "http.response.start":
                await asyncio.sleep(LATE_S)
            await send(message)

        await answer(send_late)

    change_forwarding(lambda scope: b"prefer" in dict(scope["headers"]), wrong)


@mutant("CLU-007", through=instead_of(node_connections, "request_headers"))
def loses_the_place_of_a_reader_of_another_node(
    right: Any, scope: Scope, node: Node
) -> Any:
    """A dashboard that reconnects over a balancer shows episodes twice."""
    headers = right(scope, node)
    return [pair for pair in headers if pair[0] != b"last-event-id"]
