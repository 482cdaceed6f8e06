"""The runs in memory: one object each, and no client sees more than is stored."""

import asyncio
import gc
import time
from pathlib import Path

import pytest

from reference_server.process.backoff import Backoff
from reference_server.rules.manifest import Submission
from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import Attach
from reference_server.rules.runs.run import Run
from reference_server.storage.runs.run_store import StoreFailed
from tests.support.server.server_parts import (
    BlockedCall,
    ServerParts,
    assert_no_error_logged,
    calibration_run,
    expect_refusal,
    fail_writes,
    open_server_parts,
    predict_command,
    record_score,
)
from tests.support.servers import TIMEOUT_S

# --- a new start ---


async def test_the_age_of_the_queue_needs_no_database(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def age(parts: ServerParts) -> float:
        with monkeypatch.context() as patch:
            patch.setattr("time.time", lambda: 5000.0)
            return parts.registry.admission.oldest_queued_s()

    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=1) as parts:
        assert age(parts) == 0.0
        for number, updated in enumerate((500.0, 1000.0, 2000.0)):
            run = calibration_run(run_id=f"run_{number}", updated_at_wall=updated)
            await parts.registry.add(run, None, "")
        assert age(parts) == 4000.0, "run_0 is not queued"
    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=1) as parts:
        assert (await parts.registry.get("run_1")).state == "ready"
        assert age(parts) == 3000.0
        await parts.service.stop_run("alice", "run_2", "abort")
        assert age(parts) == 0.0


# --- writes that fail ---


async def test_a_submit_that_cannot_be_stored_makes_no_run(parts: ServerParts) -> None:
    with (
        parts.database.reject_writes(),
        pytest.raises(StoreFailed, match="disk is full"),
    ):
        await parts.registry.add(calibration_run(), "key", "body")
    assert parts.database.count("runs") == 0
    run = await parts.registry.add(calibration_run(), "key", "body")
    assert run.number == 1


async def test_an_unreadable_database_is_reported(parts: ServerParts) -> None:
    await parts.store.insert(calibration_run(), None, "")
    parts.database.execute("ALTER TABLE runs RENAME TO elsewhere")
    with pytest.raises(StoreFailed):
        await parts.registry.get("run_1")
    with pytest.raises(StoreFailed):
        await parts.registry.reader.page("alice", None, 10, lambda run: run)
    parts.database.execute("ALTER TABLE elsewhere RENAME TO runs")
    assert (await parts.registry.get("run_1")).run_id == "run_1"


async def test_an_unstored_result_is_not_answered(parts: ServerParts) -> None:
    run = await parts.registry.add(calibration_run("score", "score"), None, "")
    other = await parts.registry.add(calibration_run(run_id="run_2"), None, "")
    a = await parts.executor.attach(run, Attach("a", "key"))
    b = await parts.executor.attach(run, Attach("b", "key"))
    elsewhere = await parts.executor.attach(other, Attach("w", "key"))
    waiting = asyncio.create_task(
        parts.registry.wait_for_change(
            parts.registry.change_event(run.run_id), TIMEOUT_S
        )
    )
    with parts.database.reject_writes(), expect_refusal("unavailable"):
        await parts.executor.predict(run, predict_command(a, "a", score=1, end=1))
    assert await waiting, "every caller that waits for a change is woken"
    # The run is as the store has it: in no session's hands, with nothing scored.
    found = await parts.registry.get(run.run_id)
    assert found is not run
    assert (found.state, found.scored, found.live_sessions) == ("ready", 0, [])
    assert [e.attempt for e in found.episodes] == [1, 1]
    for worker_id, turn in (("a", a), ("b", b)):
        with expect_refusal("session_ended", ended_by="unknown"):
            await parts.executor.predict(found, predict_command(turn, worker_id))
    # Nothing else is lost.
    await parts.executor.predict(other, predict_command(elsewhere, score=1))
    turn = await parts.executor.attach(found, Attach("a", "again"))
    while not turn["done"]:
        turn = await parts.executor.predict(
            found, predict_command(turn, "a", score=1, end=1)
        )
    stored = await parts.store.load(run.run_id)
    assert stored is not None
    assert stored.scored == 2


async def test_a_clock_that_is_set_back_does_not_set_a_run_back(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """RUN-021. Each change is later than the one before, if by less than is shown."""
    run = await parts.registry.add(calibration_run(), None, "")
    seen = []
    for now in (5000.0, 4000.0, 6000.0):
        monkeypatch.setattr("time.time", lambda now=now: now)
        await parts.registry.writer.commit(run)
        seen.append(run.updated_at_wall)
    assert 5000.0 == seen[0] < seen[1] < 5000.0001
    assert seen[2] == 6000.0


@pytest.mark.parametrize("error", [StoreFailed("full"), OSError("gone"), KeyError(1)])
async def test_any_failed_write_reloads_the_run(
    monkeypatch: pytest.MonkeyPatch, error: Exception, parts: ServerParts
) -> None:
    run = await parts.registry.add(calibration_run(), None, "")
    fail_writes(monkeypatch, parts, {run.run_id}, error)
    record_score(run, 0)
    with expect_refusal("unavailable"):
        await parts.registry.writer.commit(run)
    found = await parts.registry.get(run.run_id)
    assert (found is run, found.scored) == (False, 0)


async def test_a_queued_run_whose_write_failed_keeps_its_turn(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All places are taken. Expect it in the queue when it is read again."""
    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=1) as parts:
        for number in (1, 2, 3):
            await parts.registry.add(calibration_run(run_id=f"run_{number}"), None, "")
        fail_writes(monkeypatch, parts, {"run_3"}, StoreFailed("full"))
        with expect_refusal("unavailable"):
            await parts.service.stop_run("alice", "run_3")
        run = await parts.registry.get("run_3")
        assert (run.state, parts.registry.admission.queue_position(run)) == (
            "queued",
            2,
        )


async def test_a_damaged_run_does_not_keep_others_in_the_queue(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    for number in (1, 2, 3):
        run = calibration_run(run_id=f"run_{number}")
        await parts.store.insert(run, None, "")
    load = parts.store.load

    async def load_others(run_id: str) -> Run | None:
        if run_id == "run_1":
            raise ValueError("a row that cannot be read")
        return await load(run_id)

    monkeypatch.setattr(parts.store, "load", load_others)
    await parts.registry.open()
    for run_id in ("run_2", "run_3"):
        change = parts.registry.change_event(run_id)
        while (await parts.store.heads([run_id]))[run_id].state != "ready":
            await change.wait()
            change = parts.registry.change_event(run_id)


@pytest.mark.parametrize("readable", [True, False])
async def test_a_run_whose_admission_failed_is_admitted_later(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, readable: bool
) -> None:
    """No client requests it; it keeps its place, and the rest of the queue waits on."""
    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=1) as parts:
        first = await parts.registry.add(calibration_run(), None, "")
        for number in (2, 3):
            await parts.registry.add(calibration_run(run_id=f"run_{number}"), None, "")
        await parts.registry.writer.is_stored(first)
        broken = {"run_2"}
        done = fail_writes(monkeypatch, parts, broken, StoreFailed("full"))
        load, unread = parts.store.load, [] if readable else [StoreFailed("gone")]

        async def load_at_last(run_id: str) -> Run | None:
            if unread:
                raise unread.pop()
            return await load(run_id)

        monkeypatch.setattr(parts.store, "load", load_at_last)
        monkeypatch.setattr(Backoff, "next_s", lambda _: 0.001)
        effects.stop(first, "abort", 0.0)
        await parts.registry.writer.commit(first)
        while "run_2" not in parts.registry.writer._reload_timers:
            await asyncio.wait(parts.registry.work._tasks)
        assert (await parts.registry.get("run_3")).state == "queued"
        broken.clear()
        assert await done("run_2") == "ready"
        assert (await parts.registry.get("run_3")).state == "queued"
        assert (
            parts.registry.admission.queue_position(await parts.registry.get("run_3"))
            == 1
        )
        assert unread == []


# --- the clock ---


async def wait_until_admitted(parts: ServerParts, run: Run) -> None:
    async with asyncio.timeout(TIMEOUT_S):
        change = parts.registry.change_event(run.run_id)
        if run.state == "queued":
            await parts.registry.wait_for_change(change, TIMEOUT_S)
        assert run.state == "ready"


@pytest.mark.parametrize("jump_s", [-1e6, 1e6])
async def test_a_set_clock_changes_no_wait_in_the_queue(
    monkeypatch: pytest.MonkeyPatch, jump_s: float, parts: ServerParts
) -> None:
    async def submit(parts: ServerParts, queue_s: float) -> Run:
        submission: Submission = {
            "benchmark_id": "calibration",
            "policy": {"name": "p"},
            "options": {"tasks": ["score"], "queue_s": queue_s},
        }
        return await parts.service.submit_run("alice", submission)

    held, now = await submit(parts, 60.0), time.time()
    short = await submit(parts, 0.05)
    monkeypatch.setattr(time, "time", lambda: now + jump_s)
    await submit(parts, 0.0)
    await wait_until_admitted(parts, short)
    assert held.state == "queued"


async def test_a_clock_set_back_before_a_restart_holds_no_run_longer(
    tmp_path: Path,
) -> None:
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        submission = {"options": {"queue_s": 0.05}}
        run = calibration_run(queue_until_wall=1e11, submission=submission)
        await parts.store.insert(run, None, "")
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        await wait_until_admitted(parts, await parts.registry.get("run_1"))


@pytest.mark.parametrize("is_stored", [True, False])
async def test_a_submit_whose_caller_is_cancelled_is_counted_as_it_is_stored(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    is_stored: bool,
) -> None:
    """It was stored, and counted as if it were not: it waited for ever in the queue."""

    async def fail(_: object) -> None:
        raise StoreFailed("full")

    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        if not is_stored:
            monkeypatch.setattr(parts.store.transactions, "write_at_once", fail)
        blocked = BlockedCall(monkeypatch, parts.store, "insert", after=is_stored)
        adding = parts.registry.add(calibration_run(), "key", "body")
        leaving = asyncio.create_task(adding)
        await blocked.wait_until_reached()
        leaving.cancel()
        await asyncio.wait([leaving])
        assert leaving.cancelled()
        blocked.open()
        await parts.registry.close()
        assert (await parts.store.find_key("alice", "key") is not None) is is_stored
        assert parts.registry.usage.count_open() == int(is_stored)
        assert parts.registry.has("run_1") is is_stored
        assert ("run_1" in parts.registry.admission.places) is is_stored
    gc.collect()
    assert_no_error_logged(caplog)


async def test_a_timer_that_fires_early_is_set_again(parts: ServerParts) -> None:
    """By the resolution of the loop's clock. Expect the next one, and an admission."""
    # Longer than storing it may take: no timer would be left after that.
    until = time.time() + 5.0
    held = calibration_run(run_id="run_3", queue_until_wall=until)
    await parts.registry.add(held, None, "")
    parts.registry.admission._admission._admit_in_time()
    timer = parts.registry.admission._admission._timer
    assert timer is not None
    assert not timer.cancelled()
    while held.state == "queued":
        await parts.registry.wait_for_change(
            parts.registry.change_event(held.run_id), TIMEOUT_S
        )
    assert held.state == "ready"


# --- one object per run ---


async def test_a_new_run_is_one_object(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """Between the commit of its row and our hearing of it, a list may show it."""
    blocked = BlockedCall(monkeypatch, parts.store, "insert", after=True)
    adding = asyncio.create_task(parts.registry.add(calibration_run(), None, ""))
    await blocked.wait_until_reached()
    (found,) = await parts.registry.reader.page("alice", None, 9, lambda run: run)
    blocked.open()
    assert found is await adding


async def test_a_slow_read_does_not_replace_a_newer_state(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A second reader is slow; meanwhile the run changes and falls out of memory."""
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        await parts.registry.add(calibration_run("score", "score"), None, "")
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        blocked = BlockedCall(monkeypatch, parts.store, "load", after=True)
        slow = asyncio.create_task(parts.registry.get("run_1"))
        await blocked.wait_until_reached()
        monkeypatch.undo()
        quick = asyncio.create_task(parts.registry.get("run_1"))
        await asyncio.sleep(0)
        blocked.open()
        assert await quick is await slow


# --- timers ---
