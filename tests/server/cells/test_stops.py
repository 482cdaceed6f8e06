"""A robot is stopped in time, whatever happens and whatever it does."""

from __future__ import annotations

import random

import pytest

from tests.support.cells.stop_cases import CASES, StopBench

pytestmark = pytest.mark.slow("starts a server, and a robot for many trials")


@pytest.mark.parametrize(("cause", "phase"), CASES)
def test_the_robot_stops_in_time(bench: StopBench, cause: str, phase: str) -> None:
    stopped = bench.play_case(cause, phase, random.Random(f"{cause} {phase}"))
    assert stopped.is_right, stopped
