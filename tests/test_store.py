"""What outlives the process, and what happens when it cannot be written."""

import asyncio
import contextlib
import sqlite3
import threading
import time
import types
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from contextlib import asynccontextmanager, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from reference_server import stage as stage_module
from reference_server.problems import Refused
from reference_server.protocol import Attach, Heartbeat, Predict
from reference_server.run_book import RunBook
from reference_server.run_state import Episode, Result, Run
from reference_server.stage import Stage
from reference_server.store import Store, StoreFailed
from reference_sim import catalog
from reference_sim.runners.local import SimulatorPool
from tests.conftest import PATIENCE_S, a_run

Story = Callable[["Parts"], Awaitable[None]]


@dataclass
class Parts:
    """The server without HTTP, over a database in a file."""

    path: Path
    store: Store
    book: RunBook
    pool: SimulatorPool
    stage: Stage

    @contextmanager
    def unwritable(self) -> Iterator[None]:
        """While it lasts the database takes no write and can still be read."""
        events = [("UPDATE", "runs"), ("INSERT", "runs"), ("INSERT", "episodes")]
        with contextlib.closing(sqlite3.connect(self.path)) as database:
            for event, table in events:
                database.execute(
                    f"CREATE TRIGGER full_{event}_{table} BEFORE {event} ON {table} "
                    "BEGIN SELECT RAISE(ABORT, 'the disk is full'); END"
                )
            yield
            for event, table in events:
                database.execute(f"DROP TRIGGER full_{event}_{table}")


@asynccontextmanager
async def server(path: Path, active_max: int = 10) -> AsyncIterator[Parts]:
    store = Store(f"sqlite+aiosqlite:///{path}")
    book, pool = RunBook(store, active_max), SimulatorPool(4, 0, PATIENCE_S)
    parts = Parts(path, store, book, pool, Stage(book, pool, 64))
    await store.open()
    await book.open()
    try:
        yield parts
    finally:
        await parts.stage.close()
        await book.close()
        await pool.close()
        await store.close()


def tell(path: Path, *stories: Story, active_max: int = 10) -> None:
    """Each story with a server of its own, over the same database."""

    async def run() -> None:
        for story in stories:
            async with asyncio.timeout(PATIENCE_S):
                async with server(path / "proctor.sqlite", active_max) as parts:
                    await story(parts)

    asyncio.run(run())


def calibration(*tasks: str, run_id: str = "run_1", **changes: Any) -> Run:
    options = {"tasks": list(tasks) or ["score", "count"]}
    found = catalog.resolve("calibration", options)
    submission = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    plans = found.manifest["episodes"]
    fields = {
        "run_id": run_id,
        "state": "queued",
        "manifest": found.manifest,
        "submission": submission | {"options": options},
        "images": found.images,
        "episodes": [Episode(i, **plan) for i, plan in enumerate(plans)],
    }
    return a_run(**fields | changes)


def predict(turn: dict[str, Any], worker_id: str = "w", **values: float) -> Predict:
    sizes = {"vector": 8, "clipped": 2}
    names = ("score", "success", "end", "delay_s", "fault", "vector", "clipped")
    action = {n: [float(values.get(n, 0))] * sizes.get(n, 1) for n in names}
    return Predict(worker_id, turn["session_id"], turn["seq"] + 1, [action])


@contextmanager
def refusal(code: str, **members: Any) -> Iterator[None]:
    with pytest.raises(Refused) as caught:
        yield
    assert caught.value.code == code, caught.value.detail
    assert caught.value.members == members


def rows(path: Path, table: str) -> int:
    with contextlib.closing(sqlite3.connect(path)) as database:
        (count,) = database.execute(f"SELECT count(*) FROM {table}").fetchone()  # noqa: S608
    return int(count)


# --- rows ---


def test_a_run_is_loaded_as_it_was_saved(tmp_path: Path) -> None:
    result = Result("failure", 0.1 + 0.2, 2, 7, False, True, 5e-324, 1e9 + 1 / 3)

    async def save(parts: Parts) -> None:
        run = calibration("score", "echo", "count", queue_until_wall=0.1)
        assert await parts.store.insert(run, None, "")
        run.episodes[1].result = result
        run.episodes[2].attempt = run.episodes[2].faults = 2
        run.episodes[2].faults_forgiven = 1
        run.changed = {1, 2}
        run.state, run.reason, run.retryable = "failed", "é\x00💥", True
        await parts.store.save(run)
        assert run.changed == set()

    async def load(parts: Parts) -> None:
        run = await parts.store.load("run_1")
        assert run is not None
        assert run.episodes[1].result == result
        plain = run.episodes[0]
        assert (plain.attempt, plain.faults, plain.result) == (1, 0, None)
        touched = run.episodes[2]
        kept = (touched.attempt, touched.faults, touched.faults_forgiven)
        assert kept == (2, 2, 1)
        assert (run.state, run.reason, run.retryable) == ("failed", "é\x00💥", True)
        assert (run.pending, run.scored, run.workers) == ([0, 2], 1, {})
        same = calibration("score", "echo", "count")
        for name in ("manifest", "submission", "images", "max_workers", "account"):
            assert getattr(run, name) == getattr(same, name)
        assert (run.queue_until_wall, run.created_at_wall) == (0.1, 1000.0)
        assert await parts.store.load("run_2") is None

    tell(tmp_path, save, load)


def test_a_manifest_is_stored_once(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        for number in range(3):
            await parts.store.insert(calibration(run_id=f"run_{number}"), None, "")
        assert (rows(parts.path, "manifests"), rows(parts.path, "runs")) == (1, 3)

    tell(tmp_path, story)


def test_numbers_grow_and_pages_go_back(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        for number in range(5):
            account = "bob" if number == 2 else "alice"
            run = calibration(run_id=f"run_{number}", account=account)
            await parts.store.insert(run, None, "")
        page = await parts.store.page("alice", None, 3)
        assert [run_id for _, run_id in page] == ["run_4", "run_3", "run_1"]
        rest = await parts.store.page("alice", page[-1][0], 3)
        assert [run_id for _, run_id in rest] == ["run_0"]
        queued = await parts.store.in_states("queued", "ready")
        assert queued == [f"run_{number}" for number in range(5)]

    tell(tmp_path, story)


# --- the key of a submit ---


def test_a_key_makes_one_run_however_many_ask_at_once(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        runs = [calibration(run_id=f"run_{number}") for number in range(8)]
        made = await asyncio.gather(*(parts.book.add(r, "key", "same") for r in runs))
        assert len({id(run) for run in made}) == 1
        assert rows(parts.path, "runs") == 1
        other = await parts.book.add(calibration(run_id="b", account="bob"), "key", "x")
        assert other.run_id == "b"
        with refusal("idempotency_conflict"):
            await parts.book.add(calibration(run_id="c"), "key", "another")
        assert rows(parts.path, "runs") == 2

    async def afterwards(parts: Parts) -> None:
        again = await parts.book.add(calibration(run_id="d"), "key", "same")
        assert again.run_id.startswith("run_")

    tell(tmp_path, story, afterwards)


# --- a new start ---


def test_a_start_ends_what_was_in_play(tmp_path: Path) -> None:
    states = [
        "queued",
        "ready",
        "running",
        "stopping",
        "stopped",
        "failed",
        "completed",
    ]

    async def before(parts: Parts) -> None:
        for state in states:
            run = calibration(run_id=state, state=state, queue_until_wall=1e11)
            await parts.store.insert(run, None, "")

    async def after(parts: Parts) -> None:
        found = {state: (await parts.book.get(state)).state for state in states}
        ended = {"running": "ready", "stopping": "stopped"}
        assert found == {state: ended.get(state, state) for state in states}
        assert parts.book.queue_position(await parts.book.get("queued")) == 1

    tell(tmp_path, before, after)


def test_a_start_admits_as_many_as_there_is_room_for(tmp_path: Path) -> None:
    async def before(parts: Parts) -> None:
        for number in range(3):
            run = calibration(run_id=f"run_{number}")
            await parts.store.insert(run, None, "")

    async def after(parts: Parts) -> None:
        runs = [await parts.book.get(f"run_{number}") for number in range(3)]
        assert [run.state for run in runs] == ["ready", "ready", "queued"]

    tell(tmp_path, before, after, active_max=2)


def test_what_a_client_was_told_survives(tmp_path: Path) -> None:
    async def before(parts: Parts) -> None:
        run = await parts.book.add(calibration(), None, "")
        turn = await parts.stage.attach(run, Attach("w", "key"))
        turn = await parts.stage.predict(run, predict(turn, score=0.25, end=1))
        assert turn["episode_result"]["score"] == 0.25
        await parts.stage.predict(run, predict(turn, score=0.5))
        # Nothing is said to the store of how this ends: as if the process were killed.
        stored = await parts.store.load(run.run_id)
        assert stored is not None
        assert [e.result is not None for e in stored.episodes] == [True, False]
        assert stored.episodes[1].attempt == 1  # CRASH-002

    tell(tmp_path, before)


# --- writes that fail ---


@pytest.mark.parametrize(
    "url",
    [
        "nonsense",
        "nonsense://x",
        "sqlite:///x",  # a driver that would block everybody
        "sqlite+aiosqlite:////proc/nowhere/x",
        f"sqlite+aiosqlite:///{Path(__file__).parent}",
        f"sqlite+aiosqlite:///{Path(__file__)}",
    ],
)
def test_a_database_that_is_none_is_said_to_be_so(url: str) -> None:
    async def open_in_vain() -> None:
        store = Store(url)
        try:
            await store.open()
        finally:
            # The driver's thread ends by itself, and has to find its loop until then.
            for thread in set(threading.enumerate()) - {threading.main_thread()}:
                await asyncio.to_thread(thread.join, PATIENCE_S)
            await store.close()

    with pytest.raises(StoreFailed) as caught:
        asyncio.run(open_in_vain())
    assert "\n" not in str(caught.value)


def test_a_failed_write_loses_nothing_that_is_tried_again(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = calibration()
        await parts.store.insert(run, None, "")
        run.episodes[0].faults, run.changed, run.reason = 1, {0}, "new"
        with parts.unwritable(), pytest.raises(StoreFailed, match="disk is full"):
            await parts.store.save(run)
        stored = await parts.store.load("run_1")
        assert stored is not None
        assert (stored.reason, stored.episodes[0].faults) == (None, 0)
        assert run.changed == {0}
        await parts.store.save(run)
        stored = await parts.store.load("run_1")
        assert stored is not None
        assert (stored.reason, stored.episodes[0].faults) == ("new", 1)

    tell(tmp_path, story)


def test_a_submit_that_cannot_be_stored_makes_no_run(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        with parts.unwritable(), pytest.raises(StoreFailed, match="disk is full"):
            await parts.book.add(calibration(), "key", "body")
        assert rows(parts.path, "runs") == 0
        run = await parts.book.add(calibration(), "key", "body")
        assert run.number == 1

    tell(tmp_path, story)


def test_a_database_that_cannot_be_read_is_said_to_be_so(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        await parts.store.insert(calibration(), None, "")
        with contextlib.closing(sqlite3.connect(parts.path)) as database:
            database.execute("ALTER TABLE runs RENAME TO elsewhere")
        with pytest.raises(StoreFailed):
            await parts.book.get("run_1")
        with pytest.raises(StoreFailed):
            await parts.book.page("alice", None, 10)
        with contextlib.closing(sqlite3.connect(parts.path)) as database:
            database.execute("ALTER TABLE elsewhere RENAME TO runs")
        assert (await parts.book.get("run_1")).run_id == "run_1"

    tell(tmp_path, story)


def test_a_result_that_cannot_be_stored_was_never_told(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.book.add(calibration("score", "score"), None, "")
        other = await parts.book.add(calibration(run_id="run_2"), None, "")
        a = await parts.stage.attach(run, Attach("a", "key"))
        b = await parts.stage.attach(run, Attach("b", "key"))
        elsewhere = await parts.stage.attach(other, Attach("w", "key"))
        waiting = asyncio.create_task(parts.book.changed(run, PATIENCE_S))
        with parts.unwritable(), refusal("unavailable"):
            await parts.stage.predict(run, predict(a, "a", score=1, end=1))
        assert await waiting, "whoever waits for a change is woken"
        # The run is as the store has it: in no session's hands, with nothing scored.
        found = await parts.book.get(run.run_id)
        assert found is not run
        assert (found.state, found.scored, found.live) == ("ready", 0, [])
        assert [e.attempt for e in found.episodes] == [1, 1]
        for worker_id, turn in (("a", a), ("b", b)):
            with refusal("session_ended", ended_by="unknown"):
                await parts.stage.predict(found, predict(turn, worker_id))
        # Nothing else is lost.
        await parts.stage.predict(other, predict(elsewhere, score=1))
        turn = await parts.stage.attach(found, Attach("a", "again"))
        while not turn["done"]:
            turn = await parts.stage.predict(found, predict(turn, "a", score=1, end=1))
        stored = await parts.store.load(run.run_id)
        assert stored is not None
        assert stored.scored == 2

    tell(tmp_path, story)


def test_who_waits_for_a_turn_that_is_lost_is_told(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.book.add(calibration("delay"), None, "")
        turn = await parts.stage.attach(run, Attach("w", "key"))
        command = predict(turn, delay_s=0.2, end=1)
        with parts.unwritable():
            work = [
                parts.stage.predict(run, command),
                parts.stage.predict(run, command),
                parts.stage.attach(run, Attach("w", "another", takeover=True)),
            ]
            tasks = [asyncio.create_task(one) for one in work]
            await asyncio.wait(tasks)
        with refusal("unavailable"):
            await tasks[0]
        with pytest.raises(Refused, match=r"has ended|newer session"):
            await tasks[1]
        # The successor plays the run as it is stored, not the one that was lost.
        successor = await tasks[2]
        found = await parts.book.get(run.run_id)
        assert found is not run
        assert list(found.workers) == ["w"]
        assert successor["episode"]["step"] == 0

    tell(tmp_path, story)


def test_a_resume_that_cannot_be_stored_has_not_happened(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.book.add(calibration(state="stopped"), None, "")
        run.state = "queued"
        with parts.unwritable(), refusal("unavailable"):
            await parts.book.commit(run)
        with refusal("unavailable"):  # nor does it happen later, by the lost object
            await parts.book.commit(run)
        found = await parts.book.get(run.run_id)
        assert (found is run, found.state) == (False, "stopped")
        assert parts.book.queue_position(found) is None
        # It holds no place among the active ones either.
        for number in (2, 3):
            await parts.book.add(calibration(run_id=f"run_{number}"), None, "")
        later = [(await parts.book.get(f"run_{n}")).state for n in (2, 3)]
        assert later == ["ready", "ready"]

    tell(tmp_path, story, active_max=2)


# --- one object per run ---


def test_a_run_is_loaded_once_however_many_ask(tmp_path: Path) -> None:
    async def before(parts: Parts) -> None:
        await parts.book.add(calibration(), None, "")

    async def after(parts: Parts) -> None:
        found = await asyncio.gather(*(parts.book.get("run_1") for _ in range(8)))
        assert len({id(run) for run in found}) == 1
        with refusal("not_found"):
            await parts.book.get("run_1", "bob")

    tell(tmp_path, before, after)


@pytest.mark.parametrize("how", ["it is stopped", "it is admitted"])
def test_a_place_in_the_queue_moves_up_audibly(tmp_path: Path, how: str) -> None:
    async def story(parts: Parts) -> None:
        first = calibration(queue_until_wall=1e11)
        second = calibration(run_id="run_2", queue_until_wall=1e11)
        for run in (first, second):
            await parts.book.add(run, None, "")
        assert parts.book.queue_position(second) == 2
        waiting = asyncio.create_task(parts.book.changed(second, PATIENCE_S))
        await asyncio.sleep(0)
        if how == "it is stopped":
            first.state = "stopped"
        else:
            first.queue_until_wall = 0.0
        await parts.book.commit(first)
        assert await waiting
        assert parts.book.queue_position(second) == 1

    tell(tmp_path, story)


# --- the stage ---


def test_the_last_turn_is_answered_although_a_successor_is_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.book.add(calibration("score", "score"), None, "")
        await parts.stage.attach(run, Attach("other", "key"))
        turn = await parts.stage.attach(run, Attach("w", "key"))
        saving, release, save = asyncio.Event(), asyncio.Event(), parts.store.save

        async def slow_save(run: Run) -> None:
            saving.set()
            await release.wait()
            await save(run)

        monkeypatch.setattr(parts.store, "save", slow_save)
        last = asyncio.create_task(
            parts.stage.predict(run, predict(turn, score=1, end=1))
        )
        await saving.wait()
        successor = asyncio.create_task(parts.stage.attach(run, Attach("w", "another")))
        await asyncio.sleep(0)
        release.set()
        assert (await last)["done"]
        assert (await successor)["done"]

    tell(tmp_path, story)


def test_a_takeover_of_a_dead_simulator_is_a_fault(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.book.add(calibration("count"), None, "")
        turn = await parts.stage.attach(run, Attach("w", "key"))
        await parts.stage.predict(run, predict(turn))
        for process in list(parts.pool._processes):
            process.end("was killed by the test")
        turn = await parts.stage.attach(run, Attach("w", "another", takeover=True))
        assert turn["fault"]["faults"] == 1
        assert turn["episode"]["step"] == 0
        assert turn["episode"]["attempt"] == 1
        assert turn["observation"]["state"]["count"] == [0.0]

    tell(tmp_path, story)


def test_a_lease_ends_at_one_moment_for_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between two looks at the clock a lease ended: then it ended for both or none."""

    async def story(parts: Parts) -> None:
        run = await parts.book.add(calibration("count", "count"), None, "")
        turn = await parts.stage.attach(run, Attach("w", "key"))
        await parts.stage.predict(run, predict(turn))
        expires_at = run.workers["w"].expires_at
        moments = iter([expires_at])  # the first look; all others are too late

        def monotonic() -> float:
            return next(moments, expires_at + 0.001)

        clock = types.SimpleNamespace(**vars(time))
        clock.monotonic = monotonic
        monkeypatch.setattr(stage_module, "time", clock)
        with refusal("worker_busy"):
            await parts.stage.attach(run, Attach("w", "another"))
        turn = await parts.stage.attach(run, Attach("w", "another"))
        assert turn["episode"]["attempt"] == 2
        assert parts.pool.busy == 1
        monkeypatch.undo()
        parts.stage.heartbeat(run, Heartbeat("w", turn["session_id"]))

    tell(tmp_path, story)
