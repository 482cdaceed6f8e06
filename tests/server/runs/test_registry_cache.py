"""Runs at rest: read for each request, not held in memory, no older than shown."""

import asyncio
import gc
from collections.abc import Sequence
from typing import Any

import pytest

from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import (
    RESTING_STATES,
    Attach,
    Detach,
    Heartbeat,
)
from reference_server.rules.runs.run import Episode, Run, RunHead
from reference_server.runs.memory import recent_runs
from reference_server.runs.sessions import session_resources
from reference_server.views import run_views
from tests.support.server.server_parts import (
    BlockedCall,
    ServerParts,
    assert_no_simulator_lent,
    calibration_run,
    expect_refusal,
    predict_command,
    record_score,
    start_task,
    stop_run,
)
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_in_loop

RunSummary = tuple[str, int, list[str]]


def run_summary(run: RunHead, episodes: Sequence[Episode]) -> RunSummary:
    return run.state, run.scored, [e.episode_id for e in episodes if e.result]


async def insert_runs(parts: ServerParts, *runs: Run) -> None:
    """Runs in the database and nowhere else."""
    for run in runs:
        changed, run.changed = run.changed, set()
        assert await parts.store.insert(run, None, "")
        run.changed = changed
        await parts.store.save(run)


def finished_run(run_id: str = "run_1", state: str = "completed") -> Run:
    run = calibration_run("score", "echo", "count", run_id=run_id, state=state)
    for index in range(len(run.episodes)):
        record_score(run, index)
    return run


def runs_in_memory(parts: ServerParts) -> list[str]:
    gc.collect()
    return sorted(parts.registry.cache._in_memory)


async def expect_in_memory(parts: ServerParts, *run_ids: str) -> None:
    """Wait until exactly these are: a task that ends may hold a run a moment longer."""
    await wait_in_loop(lambda: runs_in_memory(parts) == list(run_ids))


@pytest.fixture
def one_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """One run that nothing uses stays in memory; a session that is done leaves soon."""
    monkeypatch.setattr(recent_runs, "CACHED_RUNS_MAX", 1)
    monkeypatch.setattr(session_resources, "DONE_LOOK_S", 0.01)


def end_lease(parts: ServerParts) -> None:
    """End the lease of the one session, which is done, without the wait for it."""
    (session,) = parts.executor._resources._by_session
    assert session.done
    session.expires_at = 0.0


def held_turns(parts: ServerParts) -> list[Any]:
    """Last turns that sessions hold as they were answered, which takes most memory."""
    sessions = parts.executor._resources._by_session
    return [session.turn for session in sessions if session.turn is not None]


# --- a look ---


@pytest.mark.parametrize("state", sorted(RESTING_STATES))
async def test_reading_a_stable_run_does_not_load_it(
    state: str, parts: ServerParts
) -> None:
    await insert_runs(parts, finished_run(state=state))
    look = parts.registry.reader.read_view
    assert await look("run_1", "alice", run_summary) == (state, 3, [])
    page = await look("run_1", "alice", run_summary, 1, 2)
    assert page == (state, 3, ["e0001"])
    assert await look("run_1", "alice", run_summary, 2, 9) == (state, 3, ["e0002"])
    assert await look("run_1", "alice", run_summary, 3, 9) == (state, 3, [])
    everything = await look("run_1", "alice", run_views.score_view, end=None)
    assert await parts.registry.reader.page(
        "alice", None, 9, lambda run: run.scored
    ) == [3]
    await expect_in_memory(parts)
    run = await parts.registry.get("run_1")
    assert run_views.score_view(run, run.episodes) == everything
    assert await look("run_1", "alice", run_summary, 1, 2) == page


async def test_views_from_memory_and_store_are_equal(parts: ServerParts) -> None:
    def whole(run: RunHead, episodes: Sequence[Episode]) -> list[object]:
        shown_state = [run_views.episode_view(episode) for episode in episodes]
        return [run_views.run_view(run, "http://x", None), shown_state]

    run = calibration_run("score", "echo", "count", state="stopped")
    run.episodes[0].attempt = run.episodes[0].faults = 2
    run.changed = {0}
    record_score(run, 1)
    await insert_runs(parts, run)
    read = await parts.registry.reader.read_view("run_1", "alice", whole, end=None)
    run = await parts.registry.get("run_1")
    assert (
        await parts.registry.reader.read_view("run_1", "alice", whole, end=None) == read
    )


@pytest.mark.parametrize(
    ("row", "shown_state"), [("running", "ready"), ("queued", "ready")]
)
async def test_an_unstable_row_is_loaded_first(
    row: str, shown_state: str, parts: ServerParts
) -> None:
    """Its sessions were lost with a write, or it waits to be admitted."""
    await insert_runs(parts, calibration_run(state=row))
    found = await parts.registry.reader.read_view("run_1", "alice", run_summary)
    assert found == (shown_state, 0, [])


async def test_a_run_loaded_meanwhile_is_shown_in_its_new_state(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    runs = [calibration_run("score", "score", run_id=f"run_{n}") for n in (1, 2)]
    for run in runs:
        run.state = "stopped"
    await insert_runs(parts, *runs)
    read_window = BlockedCall(monkeypatch, parts.store, "read_window", after=True)
    heads = BlockedCall(monkeypatch, parts.store, "heads", after=True)
    looking = start_task(
        parts.registry.reader.read_view("run_1", "alice", run_summary, end=None)
    )
    paging = start_task(
        parts.registry.reader.page("alice", None, 9, lambda run: run.state)
    )
    await read_window.wait_until_reached()
    await heads.wait_until_reached()
    run = await parts.registry.get("run_1")
    effects.resume(run, 0.0)
    await parts.registry.writer.commit(run)
    record_score(run, 1)
    await parts.registry.writer.commit(run)
    read_window.open()
    heads.open()
    assert await looking == ("ready", 1, ["e0001"])
    assert await paging == ["stopped", "ready"]


# --- leaving memory ---


@pytest.mark.usefixtures("one_kept")
async def test_a_run_in_use_stays_one_object(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """The run leaves the kept ones while its reader has not had its turn."""
    await insert_runs(parts, *(finished_run(f"run_{number}") for number in range(4)))
    blocked = BlockedCall(monkeypatch, parts.store, "load", after=True)
    asking = [start_task(parts.registry.get(f"run_{number}")) for number in (0, 1, 2)]
    asking.append(start_task(parts.registry.get("run_0")))
    await blocked.wait_until_reached()
    blocked.open()
    first, *_, again = await asyncio.gather(*asking)
    assert first is again
    await parts.registry.get("run_3")
    assert await parts.registry.get("run_0") is first
    del first, again, asking, _
    await parts.registry.get("run_3")
    await expect_in_memory(parts, "run_3")


@pytest.mark.usefixtures("one_kept")
async def test_waiters_are_notified_of_evicted_runs(parts: ServerParts) -> None:
    """It waits for the id: the run is loaded again by the caller that changes it."""
    await insert_runs(parts, calibration_run(state="stopped"), finished_run("run_2"))
    await parts.registry.get("run_1")
    waiting = start_task(
        parts.registry.wait_for_change(parts.registry.change_event("run_1"), TIMEOUT_S)
    )
    await asyncio.sleep(0)
    await parts.registry.get("run_2")
    await expect_in_memory(parts, "run_2")
    assert not waiting.done()
    run = await parts.registry.get("run_1")
    effects.resume(run, 0.0)
    await parts.registry.writer.commit(run)
    assert await waiting


async def test_waiting_keeps_no_run_in_memory(parts: ServerParts) -> None:
    await insert_runs(parts, calibration_run(state="ready"))
    change = parts.registry.change_event("run_1")
    await parts.registry.reader.read_view("run_1", "alice", run_summary)
    waiting = start_task(parts.registry.wait_for_change(change, TIMEOUT_S))
    await asyncio.sleep(0)
    await expect_in_memory(parts)
    run = await parts.registry.get("run_1")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    assert await waiting
    assert turn["seq"] == 0


@pytest.mark.usefixtures("one_kept")
async def test_a_lease_ends_without_requests(parts: ServerParts) -> None:
    """What is played stays in memory; after its lease it is stored, and may leave."""
    await insert_runs(parts, finished_run("run_2"))
    run = calibration_run("count", idle_timeout_s=2.0)
    run = await parts.registry.add(run, None, "")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    await parts.executor.predict(run, predict_command(turn))
    del run
    await parts.registry.get("run_2")
    change = parts.registry.change_event("run_1")
    while (await parts.registry.reader.read_view("run_1", "alice", run_summary))[
        0
    ] == "running":
        assert await parts.registry.wait_for_change(change, TIMEOUT_S)
        change = parts.registry.change_event("run_1")
    await parts.registry.get("run_2")
    await parts.registry.close()
    await expect_in_memory(parts, "run_2")

    def attempt(run: RunHead, episodes: Sequence[Episode]) -> tuple[str, int]:
        return run.state, episodes[0].attempt

    found = await parts.registry.reader.read_view("run_1", "alice", attempt, end=1)
    assert found == ("ready", 2)


@pytest.mark.usefixtures("one_kept")
@pytest.mark.parametrize(
    ("end", "is_done"),
    [
        ("lease_ended", False),
        ("lease_ended", True),
        ("detached", False),
        ("detached", True),
        ("run_stopped", False),
    ],
)
async def test_why_a_session_ended_outlives_its_run_in_memory(
    end: str, is_done: bool, parts: ServerParts
) -> None:
    """DET-005: other runs are used meanwhile, so that its run leaves memory."""
    await insert_runs(parts, finished_run("run_2"))
    lease_s = 0.2 if end == "lease_ended" and not is_done else 60.0
    run = calibration_run("count", idle_timeout_s=lease_s)
    run = await parts.registry.add(run, None, "")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    if is_done:
        turn = await parts.executor.predict(run, predict_command(turn, end=1))
    session_id = turn["session_id"]
    if end == "detached":
        await parts.executor.detach(run, Detach("w", session_id))
    elif end == "run_stopped":
        stop_run(parts, run)
        await parts.registry.writer.commit(run)
    elif is_done:
        end_lease(parts)
    del run
    await parts.registry.get("run_2")
    await wait_in_loop(lambda: not parts.executor.sessions)
    await parts.registry.close()
    await expect_in_memory(parts, "run_2")
    run = await parts.registry.get("run_1")
    with expect_refusal("session_ended", ended_by=end):
        parts.executor.heartbeat(run, Heartbeat("w", session_id))


@pytest.mark.usefixtures("one_kept")
async def test_a_session_that_is_done_keeps_no_run_in_memory(
    parts: ServerParts,
) -> None:
    """A client may end a thousand runs within one lease, and repeat each last turn."""
    await insert_runs(parts, finished_run("run_2"))
    run = await parts.registry.add(calibration_run("score", "score"), None, "")
    attach = Attach("w", "key")
    turn = await parts.executor.attach(run, attach)
    turn = await parts.executor.predict(run, predict_command(turn, end=1))
    command = predict_command(turn, end=1)
    last = await parts.executor.predict(run, command)
    assert last["done"]
    for again in (command, attach, Heartbeat("w", last["session_id"])):
        del run
        await parts.registry.get("run_2")
        await expect_in_memory(parts, "run_2")
        await wait_in_loop(lambda: not any(held_turns(parts)))
        run = await parts.registry.get("run_1")
        match again:
            case Attach():
                assert await parts.executor.attach(run, again) == last
            case Heartbeat():
                assert parts.executor.heartbeat(run, again).done
            case _:
                assert await parts.executor.predict(run, again) == last
    with expect_refusal("no_episode"):
        await parts.executor.predict(run, predict_command(last, end=1))
    await parts.executor.detach(run, Detach("w", last["session_id"]))
    with expect_refusal("session_ended", ended_by="detached"):
        await parts.executor.predict(run, command)
    assert parts.executor.sessions == 0


@pytest.mark.parametrize(
    "change",
    [
        {"observations": [{"images": {"front": b"pixels"}}]},
        {"rewards": (0.5, 1.0)},
        {"rewards": [2**64]},
        {"rewards": [object()]},
    ],
    ids=["with pictures", "a tuple", "too large", "of no form"],
)
async def test_a_last_turn_that_is_not_packed_is_kept_as_it_is(
    change: Any, parts: ServerParts
) -> None:
    run = await parts.registry.add(calibration_run("score"), None, "")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    last = await parts.executor.predict(run, predict_command(turn, end=1))
    last.update(change)
    resources = parts.executor._resources.find(run.workers["w"])
    assert resources is not None
    resources.pack()
    assert resources.session.turn is last
    resources.unpack()
    assert resources.session.turn is last


@pytest.mark.usefixtures("one_kept")
async def test_a_lease_ends_that_has_no_run_in_memory(parts: ServerParts) -> None:
    await insert_runs(parts, finished_run("run_2"))
    run = await parts.registry.add(calibration_run("score"), None, "")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    command = predict_command(turn, end=1)
    assert (await parts.executor.predict(run, command))["done"]
    end_lease(parts)
    del run
    await parts.registry.get("run_2")
    await wait_in_loop(lambda: not parts.executor.sessions)
    await expect_in_memory(parts, "run_2")
    run = await parts.registry.get("run_1")
    with expect_refusal("session_ended", ended_by="lease_ended"):
        await parts.executor.predict(run, command)
    assert run.state == "completed"


@pytest.mark.usefixtures("one_kept")
async def test_closing_ends_sessions_that_have_no_run_in_memory(
    parts: ServerParts,
) -> None:
    await insert_runs(parts, finished_run("run_2"))
    run = await parts.registry.add(calibration_run("score"), None, "")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    await parts.executor.predict(run, predict_command(turn, end=1))
    del run
    await parts.registry.get("run_2")
    await expect_in_memory(parts, "run_2")
    await parts.executor.close()
    await assert_no_simulator_lent(parts)


@pytest.mark.usefixtures("one_kept")
async def test_eviction_does_not_repeat_episodes(parts: ServerParts) -> None:
    await insert_runs(parts, calibration_run(*["score"] * 4, state="ready"))
    await insert_runs(parts, finished_run("run_2"))
    for number in range(4):
        run = await parts.registry.get("run_1")
        assert (run.scored, run.pending[0]) == (number, number)
        turn = await parts.executor.attach(run, Attach("w", f"key-{number}"))
        value = (number + 1) / 8
        turn = await parts.executor.predict(
            run, predict_command(turn, score=value, end=1)
        )
        session_id = turn["session_id"]
        await parts.executor.detach(run, Detach("w", session_id))
        del run
        await parts.registry.get("run_2")
        await expect_in_memory(parts, "run_2")
        counted = await parts.registry.reader.read_view(
            "run_1", "alice", run_summary, end=None
        )
        assert counted[1] == len(counted[2]) == number + 1
    body = await parts.registry.reader.read_view(
        "run_1", "alice", run_views.score_view, end=None
    )
    assert (body["state"], body["score"]) == ("completed", 10 / 32)


# --- the queue ---


async def test_only_later_queue_positions_change(parts: ServerParts) -> None:
    runs = [calibration_run(run_id=f"run_{n}", queue_until_wall=1e11) for n in range(4)]
    for run in runs:
        await parts.registry.add(run, None, "")
    positions = [parts.registry.admission.queue_position(run) for run in runs]
    assert positions == [1, 2, 3, 4]
    changes = [parts.registry.change_event(run.run_id) for run in runs]
    effects.stop(runs[1], "abort", 0.0)
    await parts.registry.writer.commit(runs[1])
    assert [event.is_set() for event in changes] == [False, True, True, True]
    positions = [parts.registry.admission.queue_position(run) for run in runs]
    assert positions == [1, None, 2, 3]
    changes = [parts.registry.change_event(run.run_id) for run in runs]
    effects.resume(runs[1], 1e11)  # an old number: it comes before newer runs
    await parts.registry.writer.commit(runs[1])
    assert [event.is_set() for event in changes] == [False, True, True, True]
    positions = [parts.registry.admission.queue_position(run) for run in runs]
    assert positions == [1, 2, 3, 4]
