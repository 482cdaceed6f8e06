"""One queue of all nodes: what waits anywhere goes to a node that has room.

Each node reads once a second what waits, and at once when another node says that the
queue has changed. Who is next is decided as one server decides it
(`rules/capacity.py`), by what waits and by the places of each account, at all nodes.
A node with a place for a run of another one takes it, as it claims the run of a node
that has ended: the database gives it to one node, and nothing that its earlier owner
does is stored. That a message is lost delays it, and makes nothing wrong.
"""

from __future__ import annotations

import asyncio
import contextlib
import contextvars
import logging
import time
from collections import Counter
from collections.abc import Awaitable, Callable

import msgspec
from starlette.types import ASGIApp

from reference_server.cluster.node_connections import NodeConnections
from reference_server.cluster.requests.node_requests import NodeRequests
from reference_server.process.background_work import shielded
from reference_server.runs.admission.run_admission import RunAdmission
from reference_server.storage.node_store import Node, NodeStore, StoredQueue
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.telemetry.repeated_failures import RepeatedFailures

log = logging.getLogger("proctor.cluster")

PATH = "/node/queue"
# The queue is read at least this often, whether another node sent a message or not.
LOOK_S = 1.0
# Pause after each work for the queue: other nodes may ask for it at any moment.
PAUSE_S = 0.02
# After a read of a longer queue than this a node rests so many times as long as the
# read took, however many ask for it.
LONG_QUEUE, RESTS_AFTER_READ = 200, 4
# A node that does not answer within this time keeps the places that it reported last.
TIMEOUT_S = 0.5

Work = Callable[[], Awaitable[None]]


class _Announced(msgspec.Struct):
    """A message of one node to another. has_changed: whether its queue has changed."""

    has_changed: bool


class _Places(msgspec.Struct):
    """The answer: how many places each account has at that node."""

    places: dict[str, int]


class SharedQueue:
    """The part of this node in the shared queue, from `open` to `close`.

    admission: of this node's runs; from now on they wait in the queue of all nodes.
    """

    def __init__(
        self,
        nodes: NodeStore,
        connections: NodeConnections,
        admission: RunAdmission,
    ) -> None:
        self._nodes, self._admission = nodes, admission
        self._membership = connections.membership
        self._requests = NodeRequests(
            connections,
            PATH,
            question_type=_Announced,
            answer_type=_Places,
            timeout_s=TIMEOUT_S,
        )
        self._fences: dict[str, int] = {}  # of runs that wait elsewhere
        self._places: dict[str, dict[str, int]] = {}  # of accounts, by node
        self._let_go: set[str] = set()  # runs that others may take since then
        self._look_is_due, self._announce_is_due = asyncio.Event(), asyncio.Event()
        self._read_lock, self._read_not_before = asyncio.Lock(), 0.0
        self._next_read: asyncio.Task[StoredQueue] | None = None
        self._tasks: list[asyncio.Task[None]] = []
        self._failures = RepeatedFailures(log)
        admission.share_queue(self)

    def endpoint(self) -> ASGIApp:
        """Answers other nodes."""
        return self._requests.answered_by(self._answer)

    async def open(self) -> None:
        """Follow the queue until `close`."""
        follow = self._repeat(self._look, self._look_is_due, LOOK_S)
        announce = self._repeat(self._announce, self._announce_is_due, None)
        self._tasks = [asyncio.create_task(work) for work in (follow, announce)]

    async def close(self) -> None:
        for task in self._tasks:
            task.cancel()
        if self._tasks:
            await asyncio.wait(self._tasks)
        if self._next_read is not None:
            await asyncio.wait([self._next_read])

    # --- calls of RunAdmission ---

    async def refresh(self) -> None:
        """Pass the queue of all nodes to RunAdmission."""
        try:
            await self._read()
        except StoreFailed as error:  # a shown place in the queue may be out of date
            self._failures.report("a node cannot read the queue", str(error))

    async def take(self, run_id: str) -> bool:
        """Whether a run that waited elsewhere is let in here. Raises StoreFailed.

        If it is not, the next look shows what became of it.
        """
        fence = self._fences.pop(run_id, None)
        is_taken = fence is not None and await self._membership.take(run_id, fence)
        if not is_taken:
            self.look()
        return is_taken

    def announce(self) -> None:
        """Report soon to the other nodes that this node's stored queue has changed."""
        self._announce_is_due.set()

    def look(self) -> None:
        """Look soon for runs of other nodes, because there is a free place here."""
        self._look_is_due.set()

    # --- the queue ---

    async def _read(self) -> StoredQueue:
        """Read the queue; one read serves all callers that ask before it begins."""
        if self._next_read is None:
            # Nothing that it logs belongs to the request that began it.
            self._next_read = asyncio.get_running_loop().create_task(
                self._read_next(), context=contextvars.Context()
            )
        return await shielded(self._next_read)

    async def _read_next(self) -> StoredQueue:
        async with self._read_lock:
            await asyncio.sleep(self._read_not_before - time.monotonic())
            self._next_read = None
            admission, began = self._admission, time.monotonic()
            queue = await self._nodes.queue(admission.queued_ids())
            admission.note_queue(queue)
            if len(queue.queued) > LONG_QUEUE:
                took_s = time.monotonic() - began
                rest_s = min(LOOK_S, RESTS_AFTER_READ * took_s)
                self._read_not_before = time.monotonic() + rest_s
            return queue

    async def _look(self) -> None:
        """Give free places of this node to runs that wait at other nodes."""
        if not self._membership.claims:
            return
        await self._membership.ensure_lease()
        admission, me = self._admission, self._membership.node_id
        await self._let_others_take(admission.held_no_more())
        queue = await self._read()
        elsewhere = [
            owned
            for owned in queue.queued
            if owned.owner != me and owned.run.queue_until_wall <= 0 and owned.is_new
        ]
        self._fences = {owned.run.run_id: owned.fence for owned in elsewhere}
        waiting = {owned.run.account for owned in queue.queued}
        if waiting and len(waiting | admission.places_of_accounts().keys()) > 1:
            await self._ask_for_places()
        places = sum(map(Counter, self._places.values()), Counter[str]())
        admission.note_waiting_elsewhere([owned.run for owned in elsewhere], places)

    async def _let_others_take(self, run_ids: list[str]) -> None:
        """Runs whose submitters hold them no more in the queue."""
        if new := [run_id for run_id in run_ids if run_id not in self._let_go]:
            await self._nodes.let_go(new, self._membership.node_id)
            self._announce_is_due.set()
        self._let_go = set(run_ids)

    # --- what nodes send each other ---

    async def _announce(self) -> None:
        await self._post_to_all(_Announced(has_changed=True))

    async def _ask_for_places(self) -> None:
        await self._post_to_all(_Announced(has_changed=False))

    async def _post_to_all(self, announced: _Announced) -> None:
        others = self._membership.others()
        await asyncio.gather(*(self._post(node, announced) for node in others))
        there = {node.node_id for node in others}
        self._places = {n: of for n, of in self._places.items() if n in there}

    async def _post(self, node: Node, announced: _Announced) -> None:
        answer = await self._requests.ask(node, announced)
        if answer is not None:
            self._places[node.node_id] = answer.places

    async def _answer(self, announced: _Announced) -> _Places:
        """The answer to another node."""
        if announced.has_changed:
            self._look_is_due.set()
        return _Places(self._admission.places_of_accounts())

    async def _repeat(
        self, work: Work, is_due: asyncio.Event, every_s: float | None
    ) -> None:
        """Do the work whenever it is due, and at least every `every_s` seconds."""
        while True:
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(every_s):
                    await is_due.wait()
            is_due.clear()
            try:
                await work()
            except StoreFailed as error:
                self._failures.report("a node cannot follow the queue", str(error))
            except Exception:
                log.exception("a node failed in what it does for the queue")
            await asyncio.sleep(PAUSE_S)
