"""Lift of robosuite; `make robosuite` installs it into .venv-robosuite."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import robosuite

from tools.measurements.both_ways.compared_benchmark import (
    EXAMPLES,
    ComparedBenchmark,
    Parts,
)

# The hand moves by at most 0.05 m a step.
STRIDE_M = 0.05
CLOSING_STEPS = 10
UP_M = np.array([0, 0, 0.1])


class Lifter:
    """Goes above the cube, then down to it, closes the gripper and goes up."""

    def __init__(self) -> None:
        self._closed_for = 0

    def act(self, seen: Parts) -> npt.NDArray[np.float64]:
        action = np.zeros(7)
        way = seen["cube_pos"] - seen["robot0_eef_pos"]
        is_above = np.linalg.norm(way[:2]) < 0.02
        if self._closed_for or (is_above and abs(way[2]) < 0.01):
            self._closed_for += 1
        if self._closed_for > CLOSING_STEPS:
            way = UP_M
        elif not is_above:
            way = way + UP_M
        action[:3] = np.clip(way / STRIDE_M, -1, 1)
        action[6] = 1 if self._closed_for else -1
        return action


class LiftEpisode:
    """As robosuite's own pages make it, and begin it with one reset."""

    def __init__(self, task: str, seed: int) -> None:
        self._environment = robosuite.make(
            "Lift",
            robots="Panda",
            has_renderer=False,
            has_offscreen_renderer=False,
            use_camera_obs=False,
            reward_shaping=True,
            control_freq=20,
            seed=seed,
        )
        self._note(self._environment.reset())

    def _note(self, observables: Parts) -> None:
        self.observed = {
            name: np.asarray(value, np.float64)
            for name, value in observables.items()
            if not name.endswith("-state")
        }

    def step(self, action: npt.NDArray[np.float64]) -> tuple[float, bool]:
        observables, reward, _, _ = self._environment.step(action)
        self._note(observables)
        return float(reward), bool(self._environment._check_success())  # noqa: SLF001 - no other way

    def close(self) -> None:
        self._environment.close()


COMPARED = ComparedBenchmark(
    file=EXAMPLES / "robosuite" / "lift.toml",
    begin=LiftEpisode,
    expert=lambda _: Lifter(),
)
