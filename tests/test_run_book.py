"""The runs in memory: one object each, and never ahead of the disk for a stranger."""

import asyncio
import contextlib
import gc
import sqlite3
from pathlib import Path

import pytest

from reference_server.rules import effects
from reference_server.rules.lifecycle import Attach, Detach
from reference_server.rules.run import Run
from reference_server.runs import registry
from reference_server.storage.store import StoreFailed
from tests.conftest import PATIENCE_S
from tests.parts import (
    Gate,
    Parts,
    calibration,
    failing,
    predict,
    refusal,
    rows,
    score,
    tell,
)

# --- the key of a submit ---


def test_a_key_makes_one_run_however_many_ask_at_once(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        runs = [calibration(run_id=f"run_{number}") for number in range(8)]
        made = await asyncio.gather(
            *(parts.registry.add(r, "key", "same") for r in runs)
        )
        assert len({id(run) for run in made}) == 1
        assert rows(parts.path, "runs") == 1
        other = await parts.registry.add(
            calibration(run_id="b", account="bob"), "key", "x"
        )
        assert other.run_id == "b"
        with refusal("idempotency_conflict"):
            await parts.registry.add(calibration(run_id="c"), "key", "another")
        assert rows(parts.path, "runs") == 2

    async def afterwards(parts: Parts) -> None:
        again = await parts.registry.add(calibration(run_id="d"), "key", "same")
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
        found = {state: (await parts.registry.get(state)).state for state in states}
        ended = {"running": "ready", "stopping": "stopped"}
        assert found == {state: ended.get(state, state) for state in states}
        assert parts.registry.queue_position(await parts.registry.get("queued")) == 1

    tell(tmp_path, before, after)


def test_a_start_admits_as_many_as_there_is_room_for(tmp_path: Path) -> None:
    async def before(parts: Parts) -> None:
        for number in range(3):
            run = calibration(run_id=f"run_{number}")
            await parts.store.insert(run, None, "")

    async def after(parts: Parts) -> None:
        runs = [await parts.registry.get(f"run_{number}") for number in range(3)]
        assert [run.state for run in runs] == ["ready", "ready", "queued"]

    tell(tmp_path, before, after, active_max=2)


def test_what_a_client_was_told_survives(tmp_path: Path) -> None:
    async def before(parts: Parts) -> None:
        run = await parts.registry.add(calibration(), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        turn = await parts.executor.predict(run, predict(turn, score=0.25, end=1))
        assert turn["episode_result"]["score"] == 0.25
        await parts.executor.predict(run, predict(turn, score=0.5))
        # Nothing is said to the store of how this ends: as if the process were killed.
        stored = await parts.store.load(run.run_id)
        assert stored is not None
        assert [e.result is not None for e in stored.episodes] == [True, False]
        assert stored.episodes[1].attempt == 1  # CRASH-002

    tell(tmp_path, before)


# --- writes that fail ---


def test_a_submit_that_cannot_be_stored_makes_no_run(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        with parts.unwritable(), pytest.raises(StoreFailed, match="disk is full"):
            await parts.registry.add(calibration(), "key", "body")
        assert rows(parts.path, "runs") == 0
        run = await parts.registry.add(calibration(), "key", "body")
        assert run.number == 1

    tell(tmp_path, story)


def test_a_database_that_cannot_be_read_is_said_to_be_so(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        await parts.store.insert(calibration(), None, "")
        with contextlib.closing(sqlite3.connect(parts.path)) as database:
            database.execute("ALTER TABLE runs RENAME TO elsewhere")
        with pytest.raises(StoreFailed):
            await parts.registry.get("run_1")
        with pytest.raises(StoreFailed):
            await parts.registry.page("alice", None, 10, lambda run: run)
        with contextlib.closing(sqlite3.connect(parts.path)) as database:
            database.execute("ALTER TABLE elsewhere RENAME TO runs")
        assert (await parts.registry.get("run_1")).run_id == "run_1"

    tell(tmp_path, story)


def test_a_result_that_cannot_be_stored_was_never_told(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("score", "score"), None, "")
        other = await parts.registry.add(calibration(run_id="run_2"), None, "")
        a = await parts.executor.attach(run, Attach("a", "key"))
        b = await parts.executor.attach(run, Attach("b", "key"))
        elsewhere = await parts.executor.attach(other, Attach("w", "key"))
        waiting = asyncio.create_task(
            parts.registry.wait_for_change(
                parts.registry.change_event(run.run_id), PATIENCE_S
            )
        )
        with parts.unwritable(), refusal("unavailable"):
            await parts.executor.predict(run, predict(a, "a", score=1, end=1))
        assert await waiting, "whoever waits for a change is woken"
        # The run is as the store has it: in no session's hands, with nothing scored.
        found = await parts.registry.get(run.run_id)
        assert found is not run
        assert (found.state, found.scored, found.live_sessions) == ("ready", 0, [])
        assert [e.attempt for e in found.episodes] == [1, 1]
        for worker_id, turn in (("a", a), ("b", b)):
            with refusal("session_ended", ended_by="unknown"):
                await parts.executor.predict(found, predict(turn, worker_id))
        # Nothing else is lost.
        await parts.executor.predict(other, predict(elsewhere, score=1))
        turn = await parts.executor.attach(found, Attach("a", "again"))
        while not turn["done"]:
            turn = await parts.executor.predict(
                found, predict(turn, "a", score=1, end=1)
            )
        stored = await parts.store.load(run.run_id)
        assert stored is not None
        assert stored.scored == 2

    tell(tmp_path, story)


def test_a_resume_that_cannot_be_stored_has_not_happened(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration(state="stopped"), None, "")
        run.state = "queued"
        with parts.unwritable(), refusal("unavailable"):
            await parts.registry.commit(run)
        with refusal("unavailable"):  # nor does it happen later, by the lost object
            await parts.registry.commit(run)
        found = await parts.registry.get(run.run_id)
        assert (found is run, found.state) == (False, "stopped")
        assert parts.registry.queue_position(found) is None
        # It holds no place among the active ones either.
        for number in (2, 3):
            await parts.registry.add(calibration(run_id=f"run_{number}"), None, "")
        later = [(await parts.registry.get(f"run_{n}")).state for n in (2, 3)]
        assert later == ["ready", "ready"]

    tell(tmp_path, story, active_max=2)


@pytest.mark.parametrize("error", [StoreFailed("full"), OSError("gone"), KeyError(1)])
def test_a_write_that_fails_in_any_way_loses_the_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration(), None, "")
        failing(monkeypatch, parts, {run.run_id}, error)
        score(run, 0)
        with refusal("unavailable"):
            await parts.registry.commit(run)
        found = await parts.registry.get(run.run_id)
        assert (found is run, found.scored) == (False, 0)

    tell(tmp_path, story)


@pytest.mark.parametrize("readable", [True, False])
def test_a_run_whose_admission_failed_is_admitted_later(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, readable: bool
) -> None:
    """Nobody asks for it; it keeps its place, and the rest of the queue waits on."""

    async def story(parts: Parts) -> None:
        first = await parts.registry.add(calibration(), None, "")
        for number in (2, 3):
            await parts.registry.add(calibration(run_id=f"run_{number}"), None, "")
        await parts.registry.is_stored(first)
        broken = {"run_2"}
        done = failing(monkeypatch, parts, broken, StoreFailed("full"))
        load, unread = parts.store.load, [] if readable else [StoreFailed("gone")]

        async def load_at_last(run_id: str) -> Run | None:
            if unread:
                raise unread.pop()
            return await load(run_id)

        monkeypatch.setattr(parts.store, "load", load_at_last)
        monkeypatch.setattr(registry, "RELOAD_S", 0.001)
        effects.stop(first, "abort", 0.0)
        await parts.registry.commit(first)
        while "run_2" not in parts.registry._reload_timers:
            await asyncio.wait(parts.registry._tasks)
        assert (await parts.registry.get("run_3")).state == "queued"
        broken.clear()
        assert await done("run_2") == "ready"
        assert (await parts.registry.get("run_3")).state == "queued"
        assert parts.registry.queue_position(await parts.registry.get("run_3")) == 1
        assert unread == []

    tell(tmp_path, story, active_max=1)


def test_a_caller_that_leaves_does_not_take_the_write_with_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration(), None, "")
        await parts.registry.is_stored(run)
        gate = Gate(monkeypatch, parts.store, "save")
        score(run, 0)
        leaving = asyncio.create_task(parts.registry.commit(run))
        await gate.reached()
        leaving.cancel()
        await asyncio.wait([leaving])
        assert leaving.cancelled()
        gate.open()
        await parts.registry.close()
        stored = await parts.store.load(run.run_id)
        assert stored is not None
        assert stored.scored == 1

    tell(tmp_path, story)


def test_the_end_waits_for_what_the_last_writes_begin(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A write ends, its run leaves room; nothing is admitted by a server that ends."""

    async def before(parts: Parts) -> None:
        held = calibration(run_id="run_3", queue_until_wall=1e11)
        await parts.registry.add(held, None, "")
        first = await parts.registry.add(calibration(), None, "")
        await parts.registry.add(calibration(run_id="run_2"), None, "")
        gate = Gate(monkeypatch, parts.store, "save")
        effects.stop(first, "abort", 0.0)
        parts.registry.commit_later(first)

        async def one_more() -> None:
            await parts.registry.is_stored(first)
            parts.registry.commit_later(held)

        parts.registry.run_in_background(one_more())
        closing = asyncio.create_task(parts.registry.close())
        await gate.reached()
        gate.open()
        await closing
        assert parts.registry._tasks == set()
        timer = parts.registry._admission_timer
        assert timer is not None
        assert timer.cancelled()
        stored = [await parts.store.load(f"run_{n}") for n in (1, 2)]
        assert [run and run.state for run in stored] == ["stopped", "queued"]

    tell(tmp_path, before, active_max=1)


# --- one object per run ---


def test_a_run_is_loaded_once_however_many_ask(tmp_path: Path) -> None:
    async def before(parts: Parts) -> None:
        await parts.registry.add(calibration(), None, "")

    async def after(parts: Parts) -> None:
        found = await asyncio.gather(*(parts.registry.get("run_1") for _ in range(8)))
        assert len({id(run) for run in found}) == 1
        with refusal("not_found"):
            await parts.registry.get("run_1", "bob")

    tell(tmp_path, before, after)


def test_a_new_run_is_the_one_that_others_find(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between the commit of its row and our hearing of it, a list may show it."""

    async def story(parts: Parts) -> None:
        gate = Gate(monkeypatch, parts.store, "insert", after=True)
        adding = asyncio.create_task(parts.registry.add(calibration(), None, ""))
        await gate.reached()
        (found,) = await parts.registry.page("alice", None, 9, lambda run: run)
        gate.open()
        assert found is await adding

    tell(tmp_path, story)


def test_a_run_read_twice_at_a_time_is_not_adopted_in_an_old_state(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A second reader is slow; meanwhile the run changes and falls out of memory."""

    async def before(parts: Parts) -> None:
        await parts.registry.add(calibration("score", "score"), None, "")

    async def after(parts: Parts) -> None:
        gate = Gate(monkeypatch, parts.store, "load", after=True)
        slow = asyncio.create_task(parts.registry.get("run_1"))
        await gate.reached()
        monkeypatch.undo()
        quick = asyncio.create_task(parts.registry.get("run_1"))
        await asyncio.sleep(0)
        gate.open()
        assert await quick is await slow

    tell(tmp_path, before, after)


def test_a_run_that_nobody_uses_is_read_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A finished run falls out of memory; what plays stays, whatever else is read."""
    monkeypatch.setattr(registry, "CACHED_RUNS_MAX", 2)

    async def story(parts: Parts) -> None:
        for number in range(5):
            run = calibration("score", run_id=f"run_{number}")
            turn = await parts.executor.attach(
                await parts.registry.add(run, None, ""), Attach("w", "key")
            )
            if number != 1:
                await parts.executor.predict(run, predict(turn, score=1, end=1))
                await parts.executor.detach(run, Detach("w", turn["session_id"]))
            del run
        await parts.registry.close()
        gc.collect()
        assert sorted(parts.registry._in_memory) == ["run_1", "run_3", "run_4"]
        again = await parts.registry.get("run_0")
        assert (again.state, again.scored, again.live_sessions) == ("completed", 1, [])
        assert len((await parts.registry.get("run_1")).live_sessions) == 1

    tell(tmp_path, story)


@pytest.mark.parametrize("how", ["it is stopped", "it is admitted"])
def test_a_place_in_the_queue_moves_up_audibly(tmp_path: Path, how: str) -> None:
    async def story(parts: Parts) -> None:
        first = calibration(queue_until_wall=1e11)
        second = calibration(run_id="run_2", queue_until_wall=1e11)
        for run in (first, second):
            await parts.registry.add(run, None, "")
        assert parts.registry.queue_position(second) == 2
        waiting = asyncio.create_task(
            parts.registry.wait_for_change(
                parts.registry.change_event(second.run_id), PATIENCE_S
            )
        )
        await asyncio.sleep(0)
        if how == "it is stopped":
            first.state = "stopped"
        else:
            first.queue_until_wall = 0.0
        await parts.registry.commit(first)
        assert await waiting
        assert parts.registry.queue_position(second) == 1

    tell(tmp_path, story)
