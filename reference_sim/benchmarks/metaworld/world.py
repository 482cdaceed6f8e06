"""Meta-World's environments with reproducible seeds, and its scripted experts.

Meta-World says of its `reset(seed)`: "Ignored, use seed() instead", and draws a new
arrangement only while `_freeze_rand_vec` is false. So a reset here sets that flag,
seeds and resets; the same seed then gives the same episode, regardless of history.
"""

from __future__ import annotations

import warnings
from typing import Any, Protocol

import metaworld.env_dict
import metaworld.policies
import numpy as np
from numpy.typing import NDArray


class Expert(Protocol):
    def get_action(self, obs: NDArray[np.float64]) -> NDArray[np.float32]:
        """obs: the 39 numbers of the observation. The action, 4 numbers, unclipped."""


class SeededTask:
    """One task, with the interface of a Gymnasium environment.

    The goal is part of the observation, which scripted experts need.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 80}  # noqa: RUF012 - theirs

    def __init__(self, task: str) -> None:
        """task: as Meta-World names it, `reach-v3`."""
        made = metaworld.env_dict.ALL_V3_ENVIRONMENTS_GOAL_OBSERVABLE
        self.unwrapped: Any = made[f"{task}-goal-observable"]()
        self.render_mode = None
        self.action_space = self.unwrapped.action_space
        declared = self.unwrapped.observation_space
        # Declared are bounds that observations leave: the goal's are 0 … 0.
        free = np.full(declared.shape, np.inf)
        self.observation_space = type(declared)(-free, free, dtype=declared.dtype)

    def reset(
        self, *, seed: int | None = None, options: object = None
    ) -> tuple[NDArray[np.float64], dict[str, Any]]:
        """Observation (39,), and an empty dict. options: there are none."""
        environment = self.unwrapped
        if seed is not None:
            environment.seeded_rand_vec = True
            environment._freeze_rand_vec = False  # noqa: SLF001 - there is no other way
            environment.seed(seed)
        observation, info = environment.reset()
        environment._freeze_rand_vec = True  # noqa: SLF001 - the same
        return observation, dict(info)

    def step(
        self, action: NDArray[np.float32]
    ) -> tuple[NDArray[np.float64], float, bool, bool, dict[str, Any]]:
        """action: (4,), within -1 … 1. Gymnasium's five."""
        observation, reward, terminated, truncated, info = self.unwrapped.step(action)
        return observation, float(reward), terminated, truncated, info

    def render(self) -> None:
        """The benchmark has no camera."""

    def close(self) -> None:
        self.unwrapped.close()


def expert(task: str) -> Expert:
    """Meta-World's own scripted policy of a task."""
    # They command more than they may, and say so at every step.
    warnings.filterwarnings("ignore", "Constant", module=r"metaworld\.policies")
    made: Expert = metaworld.policies.ENV_POLICY_MAP[task]()
    return made
