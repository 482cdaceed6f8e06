"""The runs in memory of one node: what it claims is loaded, what it lost is not."""

from __future__ import annotations

import asyncio
import gc
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path

import pytest
import sqlalchemy as sa

from reference_server.process.backoff import Backoff
from reference_server.rules.capacity import WaitingRun
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.rules.runs import effects
from reference_server.rules.runs.run import Run, State
from reference_server.runs import steady_clock
from reference_server.runs.memory.run_events import RunFollower
from reference_server.runs.registry import RunRegistry
from reference_server.storage.node_store import NodeStore, OwnedRun, StoredQueue
from reference_server.storage.runs.run_store import Store, StoreFailed
from reference_server.telemetry.counters import COUNTERS
from tests.support.server.databases import UsedDatabase
from tests.support.server.server_parts import BlockedCall, calibration_run
from tests.support.servers import TIMEOUT_S


class Ownership:
    """A node that claims every run that it is asked for."""

    node_id = "first"

    claims = True

    may_have_been_undone = False

    async def claim(self, _run_id: str) -> bool:
        return self.claims

    async def confirm(self) -> None:
        if self.may_have_been_undone:
            raise StoreFailed("this node has lost its runs meanwhile")


class ChangedRuns(RunFollower):
    """Puts each run that was loaded or has changed into a queue."""

    def __init__(self, changed: asyncio.Queue[Run]) -> None:
        self._changed = changed

    def loaded(self, run: Run, stored: State) -> None:
        self.changed(run)

    def changed(self, run: Run) -> None:
        self._changed.put_nowait(run)


@dataclass
class NodeRuns:
    """Store and registry of one node."""

    store: Store
    registry: RunRegistry
    ownership: Ownership
    changed: asyncio.Queue[Run] = field(default_factory=asyncio.Queue)


@asynccontextmanager
async def opened(
    where: Path | UsedDatabase, others: OtherQueues | None = None
) -> AsyncIterator[NodeRuns]:
    """where: a folder for an SQLite file, or a database."""
    used = (
        UsedDatabase.of_file(where / "d.sqlite") if isinstance(where, Path) else where
    )
    store = Store(used.url, is_shared=True)
    ownership = Ownership()

    registry = RunRegistry(store, 4, ownership=ownership)
    if others is not None:
        registry.admission.share_queue(others)
    runs = NodeRuns(store, registry, ownership)
    registry.subscribe(ChangedRuns(runs.changed))
    await store.open()
    await registry.open()
    try:
        yield runs
    finally:
        await registry.close()
        await store.close()


@pytest.fixture
async def runs(tmp_path: Path) -> AsyncIterator[NodeRuns]:
    """Those of a node that is alone, over an SQLite database."""
    async with opened(tmp_path) as runs:
        yield runs


async def change_rows(runs: NodeRuns, change: str) -> None:
    """As another node does."""
    await runs.store.transactions.write_in_turn(lambda c: c.execute(sa.text(change)))


async def insert_own(runs: NodeRuns) -> Run:
    """A run of this node that is stored, and not in its memory."""
    run = calibration_run()
    run.owner, run.fence = runs.ownership.node_id, 1
    assert await runs.store.insert(run, None, "")
    return run


async def test_a_run_that_was_read_is_used_when_it_is_known_to_last(
    runs: NodeRuns,
) -> None:
    """Else a result that no standby had could be shown, and lost by its promotion."""
    run = await insert_own(runs)
    runs.ownership.may_have_been_undone = True
    with pytest.raises(StoreFailed, match="lost its runs"):
        await runs.registry.get(run.run_id)
    assert not runs.registry.has(run.run_id)
    runs.ownership.may_have_been_undone = False
    assert (await runs.registry.get(run.run_id)).run_id == run.run_id


async def test_what_was_claimed_is_loaded_though_the_database_fails_first(
    monkeypatch: pytest.MonkeyPatch, runs: NodeRuns
) -> None:
    run = await insert_own(runs)
    right, calls = runs.store.load, 0

    async def load(run_id: str) -> Run | None:
        nonlocal calls
        calls += 1
        if calls == 1:
            raise StoreFailed("not now")
        return await right(run_id)

    monkeypatch.setattr(runs.store, "load", load)
    monkeypatch.setattr(Backoff, "next_s", lambda _: 0.01)
    runs.registry.writer.load_in_background(run.run_id)
    async with asyncio.timeout(TIMEOUT_S):  # a push run is driven from then on
        assert (await runs.changed.get()).run_id == run.run_id
    assert calls == 2


async def test_a_run_that_the_node_loses_while_it_is_stored_is_not_kept(
    monkeypatch: pytest.MonkeyPatch, runs: NodeRuns
) -> None:
    """The submit is refused; who asks again gets the run as it is stored."""
    blocked = BlockedCall(monkeypatch, runs.store, "insert")
    run = calibration_run()
    adding = asyncio.ensure_future(runs.registry.add(run, "key", "sha"))
    await blocked.wait_until_reached()
    runs.ownership.node_id = "again"
    runs.registry.admission.drop_all()
    blocked.open()
    with pytest.raises(Refused) as refused:
        await adding
    assert refused.value.code == "unavailable"
    assert not runs.registry.has(run.run_id)
    assert runs.registry.count_open()["ready"] == 0
    change = "UPDATE runs SET owner = 'again', fence = 2"
    await change_rows(runs, change)
    loaded = await runs.registry.get(run.run_id)
    assert (loaded.owner, loaded.lost) == ("again", False)


async def test_a_lost_run_is_loaded_again(runs: NodeRuns) -> None:
    run = calibration_run()
    await runs.registry.add(run, None, "")
    run.lost = True
    assert not (await runs.registry.get(run.run_id)).lost


class OtherQueues:
    """The queues of other nodes; `stored` is what is taken there, or why not."""

    def __init__(self) -> None:
        self.asked: asyncio.Queue[str] = asyncio.Queue()
        self.announced, self.looked = 0, asyncio.Event()
        self.take_now: Callable[[str], Awaitable[bool]] | None = None

    async def refresh(self) -> None:
        return None

    async def take(self, run_id: str) -> bool:
        self.asked.put_nowait(run_id)
        return self.take_now is not None and await self.take_now(run_id)

    def announce(self) -> None:
        self.announced += 1

    def look(self) -> None:
        self.looked.set()


def waiting(run: Run, *, queue_until_wall: float = 0.0) -> WaitingRun:
    return WaitingRun(run.run_id, run.number, run.account, queue_until_wall)


def taken(run: Run) -> StoredQueue:
    """The run as another node has taken it, and let it in."""
    return StoredQueue([], [OwnedRun(waiting(run), "other", run.fence + 1)])


async def add_full(runs: NodeRuns) -> Run:
    """The first run that waits, behind four that have the places."""
    for number in range(4):
        await runs.registry.add(calibration_run(run_id=f"run_{number}"), None, "")
    run = calibration_run(run_id="run_waiting")
    await runs.registry.add(run, None, "")
    assert run.state == "queued"
    return run


async def forget_what_waits(runs: NodeRuns, run_id: str) -> None:
    """Until it is only in the queue, as those that nothing uses are."""
    while run_id in runs.registry.cache._in_memory:
        while not runs.changed.empty():
            runs.changed.get_nowait()
        await asyncio.sleep(0)
        gc.collect()


async def test_a_run_that_another_node_has_taken_is_forgotten(runs: NodeRuns) -> None:
    """Who asks for it is sent there; a view of what was stored here is still right."""
    run = await add_full(runs)
    change = runs.registry.change_event(run.run_id)
    runs.registry.admission.note_queue(taken(run))
    with pytest.raises(OwnedElsewhere):
        await runs.registry.wait_for_change(change, 5)
    view = await runs.registry.reader.render_when_stored(run, lambda run: run.state)
    assert view == "queued"
    assert run.lost
    assert runs.registry.admission.queued_ids() == []
    run.reason = "too late"
    with pytest.raises(OwnedElsewhere):
        await runs.registry.writer.commit(run)


async def test_a_run_that_is_not_in_memory_is_forgotten_when_it_is_taken(
    runs: NodeRuns,
) -> None:
    run = await add_full(runs)
    seen, run_id = taken(run), run.run_id
    change = runs.registry.change_event(run_id)
    del run
    await forget_what_waits(runs, run_id)
    assert runs.registry.admission.queued_ids() == [run_id]
    runs.registry.admission.note_queue(seen)
    with pytest.raises(OwnedElsewhere):
        await runs.registry.wait_for_change(change, 5)
    assert runs.registry.admission.queued_ids() == []
    assert runs.registry.count_open()["queued"] == 0


async def test_what_was_read_before_a_run_came_does_not_remove_it(
    runs: NodeRuns,
) -> None:
    run = await add_full(runs)
    old = OwnedRun(waiting(run), "other", run.fence - 1)
    runs.registry.admission.note_queue(StoredQueue([old], []))
    assert not run.lost
    assert runs.registry.admission.queue_position(run) == 1


async def test_a_run_of_this_node_that_waits_in_the_database_alone_is_loaded(
    runs: NodeRuns,
) -> None:
    """A claim whose answer was lost, or a look that came at the wrong moment."""
    run = await insert_own(runs)
    seen = OwnedRun(waiting(run), run.owner, run.fence)
    runs.registry.admission.note_queue(StoredQueue([seen], []))
    async with asyncio.timeout(TIMEOUT_S):
        assert (await runs.changed.get()).state == "ready"


async def test_a_place_for_a_run_that_another_node_took_goes_to_the_next(
    tmp_path: Path,
) -> None:
    others = OtherQueues()
    async with opened(tmp_path, others) as runs:
        gone, next_one = (
            calibration_run(run_id=f"run_{n}", number=n, owner="other", fence=1)
            for n in (1, 2)
        )
        assert await runs.store.insert(gone, None, "")
        assert await runs.store.insert(next_one, None, "")

        async def take(run_id: str) -> bool:
            if run_id == gone.run_id:
                return False
            change = (
                "UPDATE runs SET owner = 'first', fence = 2, state = 'ready' "
                "WHERE number = 2"
            )
            await change_rows(runs, change)
            return True

        others.take_now = take
        both = [waiting(gone), waiting(next_one)]
        runs.registry.admission.note_waiting_elsewhere(both, {})
        async with asyncio.timeout(TIMEOUT_S):
            run = await runs.changed.get()
            assert await runs.registry.writer.is_stored(run)
        assert (run.run_id, run.state, run.fence) == ("run_2", "ready", 2)
        assert runs.registry.admission.places_of_accounts() == {"alice": 1}
        assert others.announced == 1


async def test_a_place_for_a_run_that_was_taken_meanwhile_goes_to_the_next(
    tmp_path: Path,
) -> None:
    """It waited here and is not in memory; this node finds out when it loads it."""
    others = OtherQueues()
    async with opened(tmp_path, others) as runs:
        runs.ownership.claims = False
        run_ids = [f"run_{number}" for number in range(6)]
        for run_id in run_ids:
            await runs.registry.add(calibration_run(run_id=run_id), None, "")
        await forget_what_waits(runs, "run_4")
        change = "UPDATE runs SET owner = 'other', fence = 2 WHERE run_id = 'run_4'"
        await change_rows(runs, change)
        first = await runs.registry.get("run_0")
        effects.stop(first, "abort", 0.0)
        await runs.registry.writer.commit(first)
        async with asyncio.timeout(TIMEOUT_S):
            await others.looked.wait()
            assert runs.registry.admission.places_of_accounts() == {"alice": 3}
            runs.registry.admission.note_waiting_elsewhere([], {})
            others.looked.clear()
            await others.looked.wait()  # the run was another node's by then
            runs.registry.admission.note_waiting_elsewhere([], {})
            while (changed := await runs.changed.get()).run_id != "run_5" or (
                changed.state != "ready"
            ):
                pass


async def test_only_what_is_not_held_may_be_taken_by_other_nodes(
    tmp_path: Path,
) -> None:
    async with opened(tmp_path, OtherQueues()) as runs:
        submission = calibration_run().submission
        assert runs.registry.admission.queue_until(submission) == 0
        submission["options"] = {"queue_s": 9}
        later = runs.registry.admission.queue_until(submission)
        assert later > steady_clock.now_wall()
        for number in range(4):
            await runs.registry.add(calibration_run(run_id=f"run_{number}"), None, "")
        for name, until in (("past", 1.0), ("free", 0.0), ("held", later)):
            run = calibration_run(run_id=name, queue_until_wall=until)
            await runs.registry.add(run, None, "")
        assert runs.registry.admission.held_no_more() == ["past"]


async def test_a_resumed_run_is_known_though_the_clock_was_set_back(
    database: UsedDatabase, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its owner alone knows what ended its sessions: no other node takes it."""
    async with opened(database, OtherQueues()) as runs:
        monkeypatch.setattr("time.time", lambda: 5000.0)
        times = {"created_at_wall": 5000.0, "updated_at_wall": 5000.0}
        for number in range(4):
            name = f"run_{number}"
            await runs.registry.add(calibration_run(run_id=name), None, "")
        new = calibration_run(run_id="run_new", **times)
        resumed = calibration_run(run_id="run_resumed", **times)
        for run in (new, resumed):
            assert (await runs.registry.add(run, None, "")).state == "queued"
        monkeypatch.setattr("time.time", lambda: 4000.0)
        effects.stop(resumed, "abort", 4000.0)
        await runs.registry.writer.commit(resumed)
        effects.resume(resumed, 0.0)
        await runs.registry.commit_opened(resumed)
        queue = await NodeStore(runs.store, 60.0).queue([])
        seen = {one.run.run_id: one.is_new for one in queue.queued}
        assert seen == {"run_new": True, "run_resumed": False}


@pytest.mark.parametrize("write", ["commit", "delete"])
async def test_a_write_after_another_node_has_claimed_the_run_is_counted(
    write: str, runs: NodeRuns
) -> None:
    run = calibration_run()
    await runs.registry.add(run, None, "")
    await runs.registry.writer.commit(run)
    before = COUNTERS.fenced_writes
    await change_rows(runs, "UPDATE runs SET fence = 7")
    with pytest.raises((Refused, StoreFailed)):
        await getattr(runs.registry.writer, write)(run)
    assert COUNTERS.fenced_writes == before + 1
    assert not runs.registry.has(run.run_id)
