"""Push-T of gym-pusht; `make add PACKAGE=gym-pusht` installs it into .venv-own."""

from __future__ import annotations

import gym_pusht  # noqa: F401 - registers the environment
import gymnasium
import numpy as np
import numpy.typing as npt

from tools.measurements.both_ways.compared_benchmark import (
    EXAMPLES,
    ComparedBenchmark,
    Parts,
)


class Pusher:
    """Goes behind the block, as seen from the middle, then pushes it there."""

    def act(self, seen: Parts) -> npt.NDArray[np.float32]:
        finger, block = seen["observation"][:2], seen["observation"][2:4]
        outwards = (block - 256) / (np.linalg.norm(block - 256) + 1e-9)
        beside = finger - block
        along = float(beside @ outwards)
        is_behind = along > 0 and np.linalg.norm(beside - along * outwards) < 25
        goal = finger - 60 * outwards if is_behind else block + 110 * outwards
        inside: npt.NDArray[np.float32] = np.clip(goal, 0, 512).astype(np.float32)
        return inside


class PushTEpisode:
    """As gym-pusht registers it."""

    def __init__(self, task: str, seed: int) -> None:
        self._environment = gymnasium.make("gym_pusht/PushT-v0", obs_type="state")
        self._note(self._environment.reset(seed=seed)[0])

    def _note(self, state: npt.NDArray[np.float64]) -> None:
        self.observed = {"observation": np.asarray(state, np.float64)}

    def step(self, action: npt.NDArray[np.float32]) -> tuple[float, bool]:
        state, reward, _, _, info = self._environment.step(action)
        self._note(state)
        return float(reward), bool(info["is_success"])

    def close(self) -> None:
        self._environment.close()


COMPARED = ComparedBenchmark(
    file=EXAMPLES / "gym_pusht" / "push_t.toml",
    begin=PushTEpisode,
    expert=lambda _: Pusher(),
)
