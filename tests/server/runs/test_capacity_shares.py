"""What one account may hold of the server while others wait, and for how long."""

from __future__ import annotations

import asyncio
import gc
from pathlib import Path

import pytest

from reference_server.process.backoff import Backoff
from reference_server.rules.capacity import Quota
from reference_server.rules.refusal import Refused
from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import Attach, Heartbeat
from reference_server.rules.runs.run import Run, RunHead
from reference_server.runs import run_reader
from reference_server.runs.admission import places
from reference_server.storage.runs.run_store import Store, StoreFailed
from tests.support.server.server_parts import (
    ServerParts,
    calibration_run,
    expect_refusal,
    open_server_parts,
    predict_command,
    start_task,
)


async def submit(parts: ServerParts, run_id: str, account: str = "alice") -> Run:
    run = calibration_run(run_id=run_id, account=account)
    return await parts.registry.add(run, None, "")


async def insert(parts: ServerParts, state: str, *run_ids: str) -> None:
    for run_id in run_ids:
        await parts.store.insert(calibration_run(run_id=run_id, state=state), None, "")


async def until(parts: ServerParts, run_id: str, state: str) -> Run:
    """The run, when it is in that state; no request loads it before."""
    while True:
        change = parts.registry.change_event(run_id)
        if (await parts.store.heads([run_id]))[run_id].state == state:
            return await parts.registry.get(run_id)
        await change.wait()


def let_unused_time_pass(parts: ServerParts) -> None:
    parts.registry.admission.places._unused_s = 0.0
    parts.registry.admission.places._settled_until = 0.0
    parts.registry.admission._admission.admit()


# --- places ---


async def test_unplayed_runs_of_one_account_do_not_keep_out_another(
    tmp_path: Path,
) -> None:
    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=4) as parts:
        runs = [await submit(parts, f"run_{n}") for n in range(6)]
        assert [run.state for run in runs] == ["ready"] * 4 + ["queued"] * 2
        other = await submit(parts, "other", "bob")
        assert other.state == "ready"
        # What lost its place can still be attached to, when there is one for it.
        assert runs[0].state == "ready"
        with expect_refusal("no_capacity"):
            await parts.executor.attach(runs[0], Attach("w", "key"))
        effects.stop(runs[1], "abort", 0.0)
        await parts.registry.writer.commit(runs[1])
        turn = await parts.executor.attach(runs[0], Attach("w", "key"))
        await parts.executor.predict(runs[0], predict_command(turn, score=1))
        assert [run.state for run in runs[4:]] == ["queued"] * 2


async def test_a_timer_ends_the_wait_for_an_unplayed_place(parts: ServerParts) -> None:
    parts.registry.admission._admission.places = places.Places(1, 0.05)
    await submit(parts, "run_1")
    await submit(parts, "run_2")
    await until(parts, "run_2", "ready")


async def test_unplayed_runs_hold_nothing_after_a_restart(tmp_path: Path) -> None:
    """What was played has its place again; what no worker played has none."""
    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=2) as parts:
        await insert(parts, "ready", "unplayed_1", "unplayed_2")
        await insert(parts, "running", "played")
        await insert(parts, "queued", "queued_1", "queued_2")
    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=2) as parts:
        await until(parts, "queued_1", "ready")
        second = await parts.registry.get("queued_2")
        assert second.state == "queued"
        played = await parts.registry.get("played")
        await parts.executor.attach(played, Attach("w", "key"))
        unplayed = await parts.registry.get("unplayed_1")
        with expect_refusal("no_capacity"):
            await parts.executor.attach(unplayed, Attach("w", "key"))
        let_unused_time_pass(parts)
        await parts.executor.attach(unplayed, Attach("w", "key"))
        assert second.state == "queued"


# --- a long queue ---


async def test_a_restart_loads_no_run_of_the_queue(tmp_path: Path) -> None:
    names = [f"run_{number:02}" for number in range(20)]
    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=2) as parts:
        await insert(parts, "queued", *names)
    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=2) as parts:
        for run_id in names[:2]:
            await until(parts, run_id, "ready")
        while parts.registry.work._tasks:
            await asyncio.wait(parts.registry.work._tasks)
        gc.collect()
        loaded = set(parts.registry.cache._in_memory)
        assert loaded <= set(names[:2])

        def view(run: RunHead) -> tuple[str, str, int | None]:
            position = parts.registry.admission.queue_position(run)
            return run.run_id, run.state, position

        shown = await parts.registry.reader.page("alice", None, 99, view)
        queued = [(name, "queued", n) for n, name in enumerate(names[2:], 1)]
        ready = [(name, "ready", None) for name in names[:2]]
        assert shown == (ready + queued)[::-1]
        gc.collect()
        assert set(parts.registry.cache._in_memory) == loaded
        assert (await parts.registry.get("run_19")).state == "queued"


async def test_a_queued_run_that_cannot_be_loaded_is_admitted_later(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=2) as parts:
        await insert(parts, "queued", "run_1", "run_2", "run_3")
        load, unread = Store.load, [StoreFailed("gone")]

        async def load_at_last(store: Store, run_id: str) -> Run | None:
            if unread:
                raise unread.pop()
            return await load(store, run_id)

        monkeypatch.setattr(Store, "load", load_at_last)
        monkeypatch.setattr(Backoff, "next_s", lambda _: 0.001)
    async with open_server_parts(tmp_path / "proctor.sqlite", active_max=2) as parts:
        await until(parts, "run_2", "ready")
        await until(parts, "run_1", "ready")
        assert (await parts.registry.get("run_3")).state == "queued"


# --- simulators ---


async def hold_all_simulators(parts: ServerParts, account: str) -> list[Run]:
    runs = []
    for number in range(4):
        run = await submit(parts, f"{account}_{number}", account)
        turn = await parts.executor.attach(run, Attach("w", "key"))
        await parts.executor.predict(run, predict_command(turn, score=0.5))
        runs.append(run)
    return runs


async def test_heartbeats_do_not_hold_all_simulators(parts: ServerParts) -> None:
    runs = await hold_all_simulators(parts, "alice")
    ids = [run.workers["w"].session_id for run in runs]
    waiting = [await submit(parts, f"bob_{n}", "bob") for n in range(3)]
    with expect_refusal("no_capacity"):
        await parts.executor.attach(waiting[0], Attach("w", "key"))
    parts.executor._resources._unused_s = 0.0
    for run, session_id in zip(runs, ids, strict=True):
        parts.executor.heartbeat(run, Heartbeat("w", session_id))
    for run in waiting[:2]:
        await parts.executor.attach(run, Attach("w", "key"))
    with expect_refusal("no_capacity", limit="at_once"):  # each has its share
        await parts.executor.attach(waiting[2], Attach("w", "key"))
    # Those that were longest without a turn; no attempt is counted.
    assert [len(run.live_sessions) for run in runs] == [0, 0, 1, 1]
    assert [run.state for run in runs] == ["ready", "ready", "running", "running"]
    assert [run.episodes[0].attempt for run in runs] == [1, 1, 1, 1]
    with expect_refusal("session_ended", ended_by="unknown"):
        parts.executor.heartbeat(runs[0], Heartbeat("w", ids[0]))


async def test_an_account_reads_which_of_its_runs_hold_the_simulators(
    parts: ServerParts,
) -> None:
    """Its policies failed in the middle of episodes, and sessions wait for leases."""
    runs = await hold_all_simulators(parts, "alice")
    late = await submit(parts, "late", "alice")
    with expect_refusal("no_capacity") as before:
        await parts.executor.attach(late, Attach("w", "key"))
    assert before.value.detail == "all 4 simulators are in use."
    parts.executor._resources._unused_s = 0.0
    with expect_refusal("no_capacity", limit="at_once") as after:
        await parts.executor.attach(late, Attach("w", "key"))
    assert after.value.detail == (
        "all 4 simulators are in use, 4 of them by sessions of this account without a "
        "turn for 0 s, of the runs: alice_0, alice_1, alice_2 and 1 more. Each is free "
        "when the lease of its session ends, or its run is stopped."
    )
    await parts.service.stop_run("alice", runs[0].run_id)
    await parts.executor.attach(late, Attach("w", "key"))


async def test_no_session_ends_whose_simulator_would_not_serve(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """On Ray, where what it took may not be what another benchmark declares."""
    runs = await hold_all_simulators(parts, "alice")
    parts.executor._resources._unused_s = 0.0
    waiting = await submit(parts, "bob", "bob")
    with monkeypatch.context() as patch:
        patch.setattr(parts.pool, "makes_room", lambda _lent, _world: False)
        with expect_refusal("no_capacity"):
            await parts.executor.attach(waiting, Attach("w", "key"))
    assert [len(run.live_sessions) for run in runs] == [1, 1, 1, 1]
    await parts.executor.attach(waiting, Attach("w", "key"))
    assert [len(run.live_sessions) for run in runs] == [0, 1, 1, 1]


# --- quotas ---


def set_quota(parts: ServerParts, **quota: int) -> None:
    parts.registry.usage.quota = Quota(**quota)


async def test_an_account_may_have_so_many_open_runs(tmp_path: Path) -> None:
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        set_quota(parts, open_runs=2)
        first = await parts.registry.add(calibration_run(), "key", "body")
        second = await submit(parts, "run_2")
        with expect_refusal("quota_exceeded"):
            await submit(parts, "run_3")
        again = calibration_run(run_id="again")
        assert await parts.registry.add(again, "key", "body") is first
        with expect_refusal("quota_exceeded"):
            await parts.registry.add(calibration_run(run_id="run_3"), "new", "body")
        assert await parts.registry.find_by_key("alice", "new") is None  # RUN-027
        await submit(parts, "other", "bob")
        await parts.service.stop_run("alice", "run_2")
        await submit(parts, "run_3")
        with expect_refusal("quota_exceeded"):
            await parts.service.resume_run("alice", "run_2")
        assert [run.state for run in (first, second)] == ["ready", "stopped"]
        await parts.service.stop_run("alice", "run_3")
        await parts.service.resume_run("alice", "run_2")
        assert [run.state for run in (first, second)] == ["ready", "ready"]
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        set_quota(parts, open_runs=2)
        with expect_refusal("quota_exceeded"):
            await submit(parts, "run_4")
        # Keys and bytes of an account are counted across restarts, too.
        for limit in ("keys", "stored_bytes"):
            set_quota(parts, **{limit: 1})
            with expect_refusal("quota_exceeded", limit=limit):
                await parts.registry.add(calibration_run(run_id="run_5"), "k", "body")


async def test_runs_that_are_opened_at_once_count_each_other(
    parts: ServerParts,
) -> None:
    set_quota(parts, open_runs=2)
    submitted = [submit(parts, f"run_{n}") for n in range(4)]
    found = await asyncio.gather(*submitted, return_exceptions=True)
    assert [type(one) for one in found] == [Run, Run, Refused, Refused]
    for number in (0, 1):
        await parts.service.stop_run("alice", f"run_{number}")
    set_quota(parts, open_runs=1)
    resumed = [parts.service.resume_run("alice", f"run_{n}") for n in (0, 1)]
    found = await asyncio.gather(*resumed, return_exceptions=True)
    assert [type(one) for one in found] == [Run, Refused]


# --- the event loop ---


class OtherTask:
    """Counts how often it was continued."""

    def __init__(self) -> None:
        self.continued = 0
        self._task = start_task(self._be_served())

    async def _be_served(self) -> None:
        while True:
            self.continued += 1
            await asyncio.sleep(0)

    def end(self) -> None:
        self._task.cancel()


async def test_a_comparison_of_many_runs_leaves_the_loop_to_others(
    parts: ServerParts,
) -> None:
    """Sixteen runs of a thousand episodes held it for a sixth of a second."""
    run = await submit(parts, "run_1")
    other = OtherTask()
    await parts.service.compare_runs("alice", [run.run_id] * 16)
    other.end()
    assert other.continued > 2 * 15


async def test_a_long_page_of_runs_leaves_the_loop_to_others(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """A thousand runs in memory are shown without a wait."""
    monkeypatch.setattr(run_reader, "VIEWS_AT_ONCE", 2)
    for number in range(9):
        await submit(parts, f"run_{number}")
    other = OtherTask()
    seen = await parts.registry.reader.page("alice", None, 9, lambda _: other.continued)
    other.end()
    assert seen[-1] - seen[0] >= 4
