"""Tasks of robosuite with one Panda arm, as Gymnasium environments.

robosuite draws an episode from the seed with which an environment is made, and from all
that was drawn since. So a reset makes it anew: the same seed then gives the same
episode, which is the first one of `robosuite.make(…, seed=seed)`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import robosuite
from gymnasium.spaces import Box, Dict
from numpy.typing import NDArray

CONTROL_RATE_HZ = 20
SETTINGS = {
    "robots": "Panda",
    "has_renderer": False,
    "has_offscreen_renderer": False,
    "use_camera_obs": False,
    "reward_shaping": True,
    "control_freq": CONTROL_RATE_HZ,
    "ignore_done": True,  # the benchmark counts the steps
}

Observed = dict[str, NDArray[Any]]


class Panda:
    """`action`, (7,) within -1 … 1, and each observable of the task by its name."""

    metadata = {"render_modes": [], "render_fps": CONTROL_RATE_HZ}  # noqa: RUF012 - theirs
    unwrapped: Any = None

    def __init__(self, task: str) -> None:
        """task: as robosuite names it, `Lift`."""
        self._task = task
        observed, _ = self.reset(seed=0)
        low, high = self.unwrapped.action_spec
        self.action_space = Box(low, high, dtype=np.float64)
        self.observation_space = Dict(
            {
                name: Box(-np.inf, np.inf, value.shape, np.float64)
                for name, value in observed.items()
            }
        )

    def reset(
        self, *, seed: int | None = None, options: object = None
    ) -> tuple[Observed, dict[str, Any]]:
        """The observation, and an empty dict. options: there are none."""
        self.close()
        self.unwrapped = robosuite.make(self._task, seed=seed, **SETTINGS)
        return _observed(self.unwrapped.reset()), {}

    def step(
        self, action: NDArray[np.float64]
    ) -> tuple[Observed, float, bool, bool, dict[str, Any]]:
        """Gymnasium's five; `info["success"]` is robosuite's own judgement."""
        observed, reward, _, _ = self.unwrapped.step(action)
        # robosuite has no other way to ask.
        success = self.unwrapped._check_success()  # noqa: SLF001
        return _observed(observed), float(reward), False, False, {"success": success}

    def render(self) -> None:
        """The benchmark has no camera."""

    def close(self) -> None:
        if self.unwrapped is not None:
            self.unwrapped.close()
        self.unwrapped = None


def _observed(observables: Observed) -> Observed:
    """Without those that repeat others: `robot0_proprio-state`, `object-state`."""
    return {
        name: np.asarray(value, np.float64)
        for name, value in observables.items()
        if not name.endswith("-state")
    }
