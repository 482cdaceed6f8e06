"""A robot is stopped in time, whatever happens and whatever it does."""

from __future__ import annotations

import random

import pytest

from tests.support.cells.stop_cases import CASES, LIMITS_S, PHASES, StopBench

pytestmark = pytest.mark.slow("starts a server, and a robot for many trials")


# One phase of each cause, and all phases of the stop that a person presses.
ALWAYS = {"stop now": set(PHASES), "killed client": {"between turns"}}
ALWAYS |= {cause: {"in a turn"} for cause in LIMITS_S if cause not in ALWAYS}


@pytest.mark.parametrize(
    ("cause", "phase"),
    [
        pytest.param(
            cause,
            phase,
            marks=() if phase in ALWAYS[cause] else pytest.mark.release("more phases"),
        )
        for cause, phase in CASES
    ],
)
def test_the_robot_stops_in_time(bench: StopBench, cause: str, phase: str) -> None:
    stopped = bench.play_case(cause, phase, random.Random(f"{cause} {phase}"))
    assert stopped.is_right, stopped
