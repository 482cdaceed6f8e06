"""A simulator that is away for a while, and long waits for it in the log."""

from __future__ import annotations

import asyncio
import itertools
import logging
import time
from collections.abc import Sequence
from typing import Any

import pytest

from reference_server.rules.lifecycle import Attach
from reference_server.runs import session_executor
from reference_server.runs.slow_waits import Wait
from reference_sim.process.pool import SimulatorFault, SimulatorHandle
from tests.support.server.server_parts import (
    ServerParts,
    calibration_run,
    expect_refusal,
    start_task,
    stop_run,
)


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


@pytest.mark.parametrize("pauses", [(0.05, 0.2), (0.01, 0.02, 0.1, 0.2)])
async def test_pauses_grow_until_the_simulator_is_back(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts, pauses: tuple[float, ...]
) -> None:
    monkeypatch.setattr(session_executor, "BEGIN_PAUSES_S", pauses)
    run = calibration_run("count")
    run.manifest = {**run.manifest, "max_faults": len(pauses) + 1}
    run = await parts.registry.add(run, None, "")
    away = Away(monkeypatch, "begin", sum(pauses) * 0.9)
    turn = await parts.executor.attach(run, Attach("w", "key"))
    assert turn["fault"]["faults"] == run.episodes[0].faults == len(away.calls) - 1
    assert away.lasted(pauses)
    assert run.episodes[0].attempt == 1


async def test_a_pause_ends_with_its_session(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    monkeypatch.setattr(session_executor, "BEGIN_PAUSES_S", (60.0,))
    monkeypatch.setattr(session_executor, "LOOK_S", 0.01)
    paused, begin = asyncio.Event(), Wait.begin

    def begin_wait(self: Wait, what: str) -> None:
        begin(self, what)
        if what.startswith("another beginning"):
            paused.set()

    monkeypatch.setattr(Wait, "begin", begin_wait)
    run = await parts.registry.add(calibration_run("count"), None, "")
    away = Away(monkeypatch, "begin", 60.0)
    attaching = start_task(parts.executor.attach(run, Attach("w", "key")))
    await paused.wait()
    stop_run(parts, run)
    with expect_refusal("session_ended", ended_by="run_stopped"):
        await attaching
    assert len(away.calls) == 1


@pytest.mark.parametrize(
    ("looks", "logged"),
    [
        ([4.9], []),
        ([5.1, 6.1, 9.9], [5]),
        ([5.1, 10.2, 15.0, 20.3, 41.0], [5, 10, 20, 41]),
        ([30.0, 31.0, 40.5], [30, 40]),
    ],
)
def test_a_wait_is_logged_at_each_doubling(
    caplog: pytest.LogCaptureFixture, looks: list[float], logged: list[int]
) -> None:
    caplog.set_level(logging.INFO)
    wait = Wait("run_1", "w")
    wait.begin("the simulator, which plays turn 3")
    for seconds in looks:
        wait.log_if_long(wait.since + seconds)
    assert [record.members["waited_s"] for record in caplog.records] == logged  # type: ignore[attr-defined]
    assert {record.getMessage() for record in caplog.records} <= {
        "waits for the simulator, which plays turn 3"
    }
    wait.end()
    wait.log_if_long(wait.since + 1000)
    assert len(caplog.records) == len(logged)
