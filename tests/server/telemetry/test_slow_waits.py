"""Long waits of sessions in the log."""

from __future__ import annotations

import logging

import pytest

from reference_server.telemetry.slow_waits import LongWait


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
    wait = LongWait("run_1", "w")
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
