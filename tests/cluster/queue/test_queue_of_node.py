"""What one node reads of the queue of all, and when."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping, Sequence
from typing import Any, cast

import msgspec
import pytest

from reference_server.cluster import shared_queue
from reference_server.cluster.node_connections import NodeConnections
from reference_server.cluster.requests import node_requests
from reference_server.cluster.shared_queue import SharedQueue
from reference_server.rules.capacity import WaitingRun
from reference_server.runs.admission.run_admission import RunAdmission
from reference_server.storage.node_store import Node, NodeStore, OwnedRun, StoredQueue
from reference_server.storage.runs.run_store import StoreFailed
from tests.support.waiting import wait_in_loop

OTHER = Node("other", "http://other", "secret")
LIMIT_S = 20.0


def waiting(number: int, owner: str = "other", until: float = 0.0) -> OwnedRun:
    run = WaitingRun(f"run_{number}", number, "alice", until)
    return OwnedRun(run, owner, 7)


class FakeNode:
    """All that the queue of a node meets: its lease, the other nodes, its runs."""

    def __init__(self) -> None:
        self.node_id, self.claims, self.secret = "me", True, "mine"
        self.queued: list[OwnedRun] = []
        self.reads, self.is_reached, self.let_go_ids = 0, True, list[str]()
        self.places_there = {"alice": 3}
        self.posted: list[dict[str, Any]] = []
        self.noted: asyncio.Queue[tuple[list[str], Mapping[str, int]]] = asyncio.Queue()
        self.taken: list[tuple[str, int]] = []
        self.held = list[str]()
        self.reading = asyncio.Event()
        self.reading.set()

    @property
    def membership(self) -> FakeNode:
        return self

    def others(self) -> list[Node]:
        return [OTHER]

    async def ensure_lease(self) -> None:
        return None

    async def take(self, run_id: str, fence: int) -> bool:
        self.taken.append((run_id, fence))
        return True

    async def post(self, _node: Node, path: str, body: bytes) -> bytes | None:
        assert path == shared_queue.PATH
        self.posted.append(msgspec.json.decode(body))
        return msgspec.json.encode({"places": self.places_there})

    async def queue(self, _known: Sequence[str]) -> StoredQueue:
        self.reads += 1
        await self.reading.wait()
        if not self.is_reached:
            raise StoreFailed("not now")
        return StoredQueue(self.queued, [])

    async def let_go(self, run_ids: Sequence[str], node_id: str) -> None:
        assert node_id == self.node_id
        self.let_go_ids += run_ids

    def queued_ids(self) -> list[str]:
        return []

    def places_of_accounts(self) -> dict[str, int]:
        return {"bob": 1}

    def share_queue(self, _queue: SharedQueue) -> None:
        """As RunAdmission does it, whose runs wait in it from then on."""

    def held_no_more(self) -> list[str]:
        return self.held

    def note_queue(self, _seen: StoredQueue) -> None:
        return None

    def note_waiting_elsewhere(
        self, runs: Sequence[WaitingRun], places: Mapping[str, int]
    ) -> None:
        self.noted.put_nowait(([run.run_id for run in runs], places))

    def queue_of(self) -> SharedQueue:
        return SharedQueue(
            cast("NodeStore", self),
            cast("NodeConnections", self),
            cast("RunAdmission", self),
        )


async def test_one_read_is_for_all_who_ask_before_it_begins() -> None:
    node = FakeNode()
    queue = node.queue_of()
    node.reading.clear()
    first = asyncio.ensure_future(queue.refresh())
    await wait_in_loop(lambda: node.reads == 1)
    later = [asyncio.ensure_future(queue.refresh()) for _ in range(20)]
    later[0].cancel()  # who leaves takes nothing from the others
    await asyncio.sleep(0)
    node.reading.set()
    await asyncio.wait_for(asyncio.gather(first, *later[1:]), LIMIT_S)
    assert node.reads == 2
    await queue.close()


async def test_a_long_queue_is_not_read_all_the_time(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(shared_queue, "LONG_QUEUE", 0)
    monkeypatch.setattr(shared_queue, "RESTS_AFTER_READ", 1e9)
    slept: list[float] = []
    sleep = asyncio.sleep

    async def note_sleep(delay_s: float) -> None:
        slept.append(delay_s)
        await sleep(0)

    node = FakeNode()
    node.queued = [waiting(1)]
    queue = node.queue_of()
    monkeypatch.setattr(asyncio, "sleep", note_sleep)
    for _ in range(2):
        await queue.refresh()
    assert slept[0] <= 0 < slept[1] <= shared_queue.LOOK_S


async def test_a_database_that_is_away_hides_no_run() -> None:
    node = FakeNode()
    node.is_reached = False
    await node.queue_of().refresh()
    assert node.reads == 1


async def test_a_look_is_due_when_another_node_says_so(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Expect it without waiting for the next one in time."""
    monkeypatch.setattr(shared_queue, "LOOK_S", 1e6)
    monkeypatch.setattr(node_requests, "is_from_node", lambda _scope, _member: True)
    node = FakeNode()
    node.queued = [waiting(1), waiting(2, "me"), waiting(3, until=9e9)]
    queue = node.queue_of()
    await queue.open()
    try:
        answer = await said_to(queue, has_changed=True)
        assert answer == {"places": {"bob": 1}}
        async with asyncio.timeout(LIMIT_S):
            seen, places = await node.noted.get()
        assert (seen, places) == (["run_1"], {"alice": 3})
        assert node.posted == [{"has_changed": False}]
        assert await queue.take("run_1")
        assert not await queue.take("run_1")
        assert not await queue.take("run_3")
        assert node.taken == [("run_1", 7)]
    finally:
        await queue.close()


async def said_to(queue: SharedQueue, *, has_changed: bool) -> dict[str, Any]:
    """The answer to another node."""
    sent: list[Any] = []

    async def receive() -> Any:
        body = msgspec.json.encode({"has_changed": has_changed})
        return {"type": "http.request", "body": body, "more_body": False}

    async def send(message: Any) -> None:
        sent.append(message)

    scope = {"type": "http", "method": "POST", "headers": [], "path": ""}
    await queue.endpoint()(scope, receive, send)
    return dict(msgspec.json.decode(sent[1]["body"]))


async def test_other_nodes_hear_of_a_change_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(shared_queue, "LOOK_S", 1e6)
    node = FakeNode()
    queue = node.queue_of()
    await queue.open()
    for _ in range(5):
        queue.announce()
    await wait_in_loop(lambda: node.posted)
    await queue.close()
    assert node.posted == [{"has_changed": True}]


async def test_what_is_held_no_more_is_let_go_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(shared_queue, "LOOK_S", 0.001)
    monkeypatch.setattr(shared_queue, "PAUSE_S", 0.001)
    node = FakeNode()
    node.held = ["run_1"]
    queue = node.queue_of()
    await queue.open()
    async with asyncio.timeout(LIMIT_S):
        for _ in range(3):
            await node.noted.get()
        node.held = []
    await wait_in_loop(lambda: node.reads > 5)
    await queue.close()
    assert node.let_go_ids == ["run_1"]


async def test_a_node_that_ends_looks_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shared_queue, "LOOK_S", 0.001)
    monkeypatch.setattr(shared_queue, "PAUSE_S", 0.001)
    node = FakeNode()
    node.claims = False
    queue = node.queue_of()
    await queue.open()
    await asyncio.sleep(0.05)  # what is tested is that nothing happens
    await queue.close()
    assert node.reads == 0
