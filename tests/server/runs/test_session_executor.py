"""Sessions and their simulators: what may happen while a turn is carried out."""

import asyncio
import itertools
import time
import types
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Attach, Heartbeat
from reference_server.runs.sessions import episode_beginnings, session_executor
from reference_server.telemetry.slow_waits import LongWait
from reference_sim.process.pool import (
    Begin,
    LastingFault,
    SimulatorFault,
    SimulatorHandle,
)
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

# --- a successor meets a turn ---


@pytest.mark.parametrize("then", ["goes on", "is stopped", "fails"])
async def test_a_takeover_with_a_dead_simulator_restarts_the_episode(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    then: str,
) -> None:
    """The fault is recorded; while it is stored anything may happen to the run."""
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        run = await parts.registry.add(calibration_run("count"), None, "")
        if then == "fails":
            run.manifest = {**run.manifest, "max_faults": 1}
        turn = await parts.executor.attach(run, Attach("w", "key"))
        await parts.executor.predict(run, predict_command(turn))
        for process in list(parts.pool._processes):
            process.end("was killed by the test")
        blocked = BlockedCall(monkeypatch, parts.store, "save")
        taking = start_task(
            parts.executor.attach(run, Attach("w", "another", takeover=True))
        )
        await blocked.wait_until_reached()
        if then == "is stopped":
            stop_run(parts, run)
        blocked.open()
        if then == "goes on":
            successor = await taking
            assert successor["fault"]["faults"] == 1
            assert successor["episode"]["step"] == 0
            assert successor["episode"]["attempt"] == 1
            assert successor["observation"]["state"]["count"] == [0.0]
            return
        ended_by = {"is stopped": "run_stopped", "fails": "run_failed"}[then]
        with expect_refusal("session_ended", ended_by=ended_by):
            await taking
        await assert_no_simulator_lent(parts)
        assert (run.episodes[0].attempt, run.episodes[0].faults) == (1, 1)
    assert_no_error_logged(caplog)


async def test_waiters_for_a_lost_turn_are_refused(parts: ServerParts) -> None:
    run = await parts.registry.add(calibration_run("delay"), None, "")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    command = predict_command(turn, delay_s=0.2, end=1)
    with parts.database.reject_writes():
        work = [
            parts.executor.predict(run, command),
            parts.executor.predict(run, command),
            parts.executor.attach(run, Attach("w", "another", takeover=True)),
        ]
        tasks = [asyncio.create_task(one) for one in work]
        await asyncio.wait(tasks)
    with expect_refusal("unavailable"):
        await tasks[0]
    with pytest.raises(Refused, match=r"has ended|newer session"):
        await tasks[1]
    # The successor plays the run as it is stored, not the one that was lost.
    successor = await tasks[2]
    found = await parts.registry.get(run.run_id)
    assert found is not run
    assert list(found.workers) == ["w"]
    assert successor["episode"]["step"] == 0


async def test_commands_for_a_lost_run_object_are_refused(parts: ServerParts) -> None:
    """Its caller found the run, awaited something else, and another's write failed."""
    run = await parts.registry.add(calibration_run("count", "count"), None, "")
    one = await parts.executor.attach(run, Attach("one", "key"))
    other = await parts.executor.attach(run, Attach("other", "key"))
    with parts.database.reject_writes(), expect_refusal("unavailable"):
        await parts.executor.predict(run, predict_command(one, "one", end=1))
    with expect_refusal("session_ended", ended_by="unknown"):
        await parts.executor.predict(run, predict_command(other, "other"))
    assert await parts.registry.get(run.run_id) is not run


async def test_a_lease_end_is_evaluated_once_per_command(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """Between two looks at the clock a lease ended: then it ended for both or none."""
    run = await parts.registry.add(calibration_run("count", "count"), None, "")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    await parts.executor.predict(run, predict_command(turn))
    expires_at = run.workers["w"].expires_at
    moments = iter([expires_at])  # the first look; all others are too late

    def monotonic() -> float:
        return next(moments, expires_at + 0.001)

    clock = types.SimpleNamespace(**vars(time))
    clock.monotonic = monotonic
    monkeypatch.setattr(session_executor, "time", clock)
    with expect_refusal("worker_busy"):
        await parts.executor.attach(run, Attach("w", "another"))
    turn = await parts.executor.attach(run, Attach("w", "another"))
    assert turn["episode"]["attempt"] == 2
    assert parts.pool.busy == 1
    monkeypatch.undo()
    parts.executor.heartbeat(run, Heartbeat("w", turn["session_id"]))


async def test_a_fault_at_the_next_beginning_is_not_of_the_turn(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """FAULT-012: what was executed and scored is shown, and the fault is counted."""
    right = SimulatorHandle.begin
    begun: list[str] = []

    async def begin(self: SimulatorHandle, command: Begin) -> Any:
        begun.append(command.task)
        if begun == ["score", "count"]:
            raise SimulatorFault("It died.")
        return await right(self, command)

    monkeypatch.setattr(SimulatorHandle, "begin", begin)
    monkeypatch.setattr(episode_beginnings, "BEGIN_PAUSES_S", (0.0,))
    run = calibration_run("score", "count")
    run = await parts.registry.add(run, None, "")
    turn = await parts.executor.attach(run, Attach("w", "key"))
    command = predict_command(turn, success=1, end=1)
    turn = await parts.executor.predict(run, command)
    assert turn["episode_result"]["outcome"] == "success"
    assert turn["executed_steps"] == len(turn["rewards"]) == 1
    assert "fault" not in turn
    assert (turn["episode"]["task"], turn["episode"]["step"]) == ("count", 0)
    assert [episode.faults for episode in run.episodes] == [0, 1]
    assert begun == ["score", "count", "count"]
    turn = await parts.executor.predict(run, predict_command(turn))
    assert "fault" not in turn


async def test_a_fault_of_a_sealed_episode_does_not_name_its_seed(
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    parts: ServerParts,
) -> None:
    seed = 1_903_886_417

    async def begin(_: SimulatorHandle, command: Begin) -> Any:
        assert command.is_sealed
        raise SimulatorFault(f"ValueError: seed {seed}, {seed:#x} of 11903886417")

    monkeypatch.setattr(SimulatorHandle, "begin", begin)
    monkeypatch.setattr(episode_beginnings, "BEGIN_PAUSES_S", (0.0,))
    run = calibration_run("score")
    run.episodes[0].seed, run.episodes[0].is_sealed = seed, True
    run = await parts.registry.add(run, None, "")
    with expect_refusal("session_ended", ended_by="run_failed"):
        await parts.executor.attach(run, Attach("w", "key"))
    shown = "seed (sealed seed), (sealed seed) of 11903886417"
    assert shown in (run.reason or "")
    assert run.episodes[0].faults > 1
    assert caplog.text.count(shown) == 1  # not again for each fault of one text
    for text in (run.reason or "", caplog.text):
        assert f"seed {seed}" not in text
        assert f"{seed:x}" not in text


# --- a simulator that is away ---


class Away:
    """Lets a method of simulators fail for some seconds from its first call on."""

    def __init__(self, patch: pytest.MonkeyPatch, name: str, seconds: float) -> None:
        right = getattr(SimulatorHandle, name)
        self.calls: list[float] = []  # when each was made

        async def call(*arguments: Any, **named: Any) -> Any:
            self.calls.append(time.monotonic())
            if self.calls[-1] < self.calls[0] + seconds:
                raise SimulatorFault("It is away.")
            return await right(*arguments, **named)

        patch.setattr(SimulatorHandle, name, call)

    def lasted(self, pauses: Sequence[float]) -> bool:
        """Whether each call came after at least this pause."""
        steps = zip(itertools.pairwise(self.calls), pauses, strict=False)
        return all(after - before >= pause for (before, after), pause in steps)


async def test_nothing_is_waited_for_that_time_does_not_mend(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """An edited file. Expect the reason at once, however many faults are allowed."""
    monkeypatch.setattr(episode_beginnings, "BEGIN_PAUSES_S", (60.0,))

    async def begin(*_: Any, **__: Any) -> Any:
        raise LastingFault("lab.py has changed")

    monkeypatch.setattr(SimulatorHandle, "begin", begin)
    run = calibration_run("count")
    run.manifest = {**run.manifest, "max_faults": 9}
    run = await parts.registry.add(run, None, "")
    with expect_refusal("session_ended", ended_by="run_failed"):
        await asyncio.wait_for(parts.executor.attach(run, Attach("w", "key")), 20.0)
    assert run.reason == "Episode e0000 faulted 9 times: lab.py has changed"


async def test_a_pause_ends_with_its_session(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    monkeypatch.setattr(episode_beginnings, "BEGIN_PAUSES_S", (60.0,))
    monkeypatch.setattr(episode_beginnings, "LOOK_S", 0.01)
    paused, begin = asyncio.Event(), LongWait.begin

    def begin_wait(self: LongWait, what: str) -> None:
        begin(self, what)
        if what.startswith("another beginning"):
            paused.set()

    monkeypatch.setattr(LongWait, "begin", begin_wait)
    run = await parts.registry.add(calibration_run("count"), None, "")
    away = Away(monkeypatch, "begin", 60.0)
    attaching = start_task(parts.executor.attach(run, Attach("w", "key")))
    await paused.wait()
    stop_run(parts, run)
    with expect_refusal("session_ended", ended_by="run_stopped"):
        await attaching
    assert len(away.calls) == 1
