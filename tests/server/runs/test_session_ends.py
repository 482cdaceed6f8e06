"""A session ends while its turn is carried out: by a stop, a detach, the end."""

import asyncio
from pathlib import Path
from typing import Any

import pytest

from reference_server.rules.runs.lifecycle import Attach
from reference_server.storage.runs.run_store import Store
from reference_sim.process.pool import SimulatorHandle, SimulatorPool
from tests.support.server.server_parts import (
    BlockedCall,
    ServerParts,
    assert_no_error_logged,
    assert_no_simulator_lent,
    calibration_run,
    expect_refusal,
    open_server_parts,
    predict_command,
    start_task,
    stop_run,
)

# --- a run meets another server ---


SUBMITTED = {"benchmark_id": "calibration", "policy": {"name": "p"}}


@pytest.mark.parametrize(
    ("what", "change"),
    [
        ("is no longer offered", {"submission": SUBMITTED | {"benchmark_id": "gone"}}),
        ("has changed", {"manifest_sha256": "0" * 64}),
        ("has changed", {"submission": SUBMITTED | {"options": {"gone": 1}}}),
    ],
)
async def test_a_run_is_not_played_on_another_benchmark(
    what: str, change: dict[str, Any], parts: ServerParts
) -> None:
    """A score is of one manifest. Nothing is counted, and the run stays as it is."""
    restarted = change | {"created_at_wall": 0.0, "reason": "Restarted."}
    run = await parts.registry.add(calibration_run("count", **restarted), None, "")
    view = await parts.service.view_run(run.account, run.run_id, "")
    assert view["state"] == "ready"
    assert view["reason"] is not None
    assert what in view["reason"]
    with expect_refusal("benchmark_unavailable") as refused:
        await parts.executor.attach(run, Attach("w", "key"))
    assert what in refused.value.detail
    await assert_no_simulator_lent(parts)
    assert (run.state, run.episodes[0].attempt) == ("ready", 1)
    await parts.service.stop_run(run.account, run.run_id)
    with expect_refusal("benchmark_unavailable"):
        await parts.service.resume_run(run.account, run.run_id)
    assert run.state == "stopped"


# --- a stop meets a turn ---


async def test_a_stop_after_the_last_action_and_before_the_result_is_stored(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """The result stands, although the turn that brought it is not answered."""
    run = await parts.registry.add(calibration_run("score", "score"), None, "")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    blocked = BlockedCall(monkeypatch, parts.store, "save")
    last = start_task(
        parts.executor.predict(run, predict_command(turn, score=1, end=1))
    )
    await blocked.wait_until_reached()
    stop_run(parts, run)
    blocked.open()
    with expect_refusal("session_ended", ended_by="run_stopped"):
        await last
    await parts.registry.writer.commit(run)
    stored = await parts.store.load(run.run_id)
    assert stored is not None
    assert (stored.state, stored.scored) == ("stopped", 1)
    await assert_no_simulator_lent(parts)


# --- a detach, a loss or the end of the server meets a turn ---


@pytest.mark.parametrize(
    ("owner", "method"),
    [
        (SimulatorHandle, "play"),
        (SimulatorHandle, "begin"),
        (SimulatorPool, "acquire"),
        (Store, "save"),
    ],
)
async def test_a_shutdown_during_work_logs_no_error(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    owner: type,
    method: str,
) -> None:
    """Sessions end uncounted, whatever is executed for them; then nothing is left."""
    work: list[asyncio.Task[Any]] = []
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        run = await parts.registry.add(calibration_run("score", "score"), None, "")
        if method in ("acquire", "begin"):
            blocked = BlockedCall(monkeypatch, owner, method)
            work.append(start_task(parts.executor.attach(run, Attach("w", "key"))))
        else:
            turn = await parts.executor.attach(run, Attach("w", "key"))
            blocked = BlockedCall(monkeypatch, owner, method)
            command = predict_command(turn, score=1, end=1)
            work.append(start_task(parts.executor.predict(run, command)))
        await blocked.wait_until_reached()
        await parts.executor.close()
        blocked.open()
        with expect_refusal("session_ended", ended_by="unknown"):
            await work[0]
        await assert_no_simulator_lent(parts)
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        run = await parts.registry.get("run_1")
        assert (run.state, [e.attempt for e in run.episodes]) == ("ready", [1, 1])
        assert run.scored == (method == "save")
    assert_no_error_logged(caplog)
