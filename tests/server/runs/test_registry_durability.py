"""What memory shows of a run: never more than the disk has, and every change."""

import asyncio
import gc

import pytest

from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Attach, Resume
from reference_server.rules.runs.run import RunHead
from reference_server.storage.runs.run_store import StoreFailed
from tests.support.server.server_parts import (
    BlockedCall,
    ServerParts,
    calibration_run,
    expect_refusal,
    fail_writes,
    predict_command,
    record_score,
)
from tests.support.servers import TIMEOUT_S

# --- what is shown is stored ---


def shown_score(run: RunHead) -> int:
    return run.scored


async def test_a_run_shows_its_number_once_it_is_stored_as_played(
    parts: ServerParts,
) -> None:
    """The write gives the number that a reader waits for (DEL-006)."""
    run = await parts.registry.add(calibration_run(played_number=None), None, "")
    await parts.registry.writer.is_stored(run)
    run.is_played = True
    parts.registry.writer.commit_later(run)
    shown = await parts.registry.reader.render_when_stored(
        run, lambda head: (head.is_played, head.played_number)
    )
    assert shown == (True, 1)


async def test_a_read_does_not_wait_for_later_writes(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """A run whose workers never pause can be looked at, and shows no more than then."""
    run = await parts.registry.add(calibration_run(), None, "")
    await parts.registry.writer.is_stored(run)
    record_score(run, 0)
    parts.registry.writer.commit_later(run)
    looking = asyncio.create_task(
        parts.registry.reader.render_when_stored(run, shown_score)
    )
    await asyncio.sleep(0)
    blocked = BlockedCall(monkeypatch, parts.store, "save")
    record_score(run, 1)
    parts.registry.writer.commit_later(run)
    await blocked.wait_until_reached()
    assert await looking == 1
    blocked.open()
    assert await parts.registry.reader.render_when_stored(run, shown_score) == 2


@pytest.mark.parametrize("is_lost", [False, True])
async def test_a_refusal_states_only_stored_states(
    monkeypatch: pytest.MonkeyPatch, is_lost: bool, parts: ServerParts
) -> None:
    run = await parts.registry.add(calibration_run("score", state="ready"), None, "")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    broken = {run.run_id} if is_lost else set[str]()
    fail_writes(monkeypatch, parts, broken, StoreFailed("full"))
    blocked = BlockedCall(monkeypatch, parts.store, "save")
    last = asyncio.create_task(
        parts.executor.predict(run, predict_command(turn, score=1, end=1))
    )
    await blocked.wait_until_reached()
    assert run.state == "completed"
    resuming = asyncio.create_task(
        parts.service._run_accepting("alice", run.run_id, Resume())
    )
    blocked.open()
    await asyncio.wait([last])
    assert isinstance(last.exception(), Refused) == is_lost
    if is_lost:
        found = await resuming
        assert (found is run, found.state) == (False, "ready")
    else:
        with expect_refusal("illegal_transition", state="completed"):
            await resuming


# --- changes ---


async def test_no_change_between_read_and_wait_is_missed(parts: ServerParts) -> None:
    run = await parts.registry.add(calibration_run(), None, "")
    await parts.registry.writer.is_stored(run)
    change = parts.registry.change_event(run.run_id)
    parts.registry.notify(run)
    assert await parts.registry.wait_for_change(change, TIMEOUT_S)
    assert not await parts.registry.wait_for_change(
        parts.registry.change_event(run.run_id), 0.001
    )
    del change
    await asyncio.sleep(0)  # Python 3.13 holds what has timed out until the next turn
    gc.collect()
    assert len(parts.registry._changes) == 0, (
        "an event without waiting callers is not kept"
    )


async def test_waiting_is_refused_during_shutdown(parts: ServerParts) -> None:
    run = await parts.registry.add(calibration_run(), None, "")
    await parts.registry.writer.is_stored(run)
    waiting = asyncio.create_task(
        parts.registry.wait_for_change(
            parts.registry.change_event(run.run_id), TIMEOUT_S
        )
    )
    await asyncio.sleep(0)
    parts.registry.begin_ending()
    for _ in range(2):
        with expect_refusal("unavailable"):
            await waiting
        waiting = asyncio.create_task(
            parts.registry.wait_for_change(
                parts.registry.change_event(run.run_id), TIMEOUT_S
            )
        )
    with expect_refusal("unavailable"):
        await waiting
