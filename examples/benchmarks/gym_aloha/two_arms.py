"""gym-aloha's environment, with the bounds that its arms have, and one camera a step.

gym-aloha declares that every number of an action is from -1 to 1. They are angles of
joints, which begin at 1.16, and it never enforces what it declares; a server does. So
the bounds here are those of the model's actuators, at which MuJoCo stops anyway.

At each step gym-aloha draws three cameras and returns the picture of one. Here the
other two are not drawn: nothing else differs, and a step takes a third of the time.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from gymnasium.spaces import Box

from reference_sim.mujoco import rendering

rendering.find_backend()  # dm_control reads it while it is imported

from gym_aloha.env import AlohaEnv  # noqa: E402

ARM_JOINTS = 6
GRIPPER = np.array([[0.0, 1.0]])  # closed, open


class TwoArms(AlohaEnv):  # type: ignore[misc]
    """`pixels.top`, uint8 (480, 640, 3), and `agent_pos`, (14,) in radians."""

    def __init__(self, task: str) -> None:
        """task: `transfer_cube` or `insertion`."""
        super().__init__(task, obs_type="pixels_agent_pos")
        limits = self._env.physics.model.actuator_ctrlrange
        # Of each arm: six joints, and two fingers that the gripper's number moves.
        left, right = limits[:ARM_JOINTS], limits[ARM_JOINTS + 2 :][:ARM_JOINTS]
        low, high = np.concatenate([left, GRIPPER, right, GRIPPER]).T
        self.action_space = Box(low, high, dtype=np.float64)
        self._env.task.get_observation = self._observe

    def _observe(self, physics: Any) -> dict[str, Any]:
        top = physics.render(height=480, width=640, camera_id="top")
        return {"qpos": self._env.task.get_qpos(physics), "images": {"top": top}}
