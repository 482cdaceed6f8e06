"""gym-aloha's environment, with the bounds that its arms have, and one camera a step.

gym-aloha declares that every number of an action is from -1 to 1. They are angles of
joints, which begin at 1.16, and it never enforces what it declares; a server does. So
the bounds here are those of the model's actuators, at which MuJoCo stops anyway.

At each step gym-aloha draws three cameras and returns the picture of one. Here the
other two are not drawn, and a step takes a third of the time.

Where a policy drives the arms so hard that the simulation diverges, gym-aloha raises.
Here the episode ends without success. It does not count as a fault of the simulator,
which would cost the policy no attempt.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from gymnasium.spaces import Box
from numpy.typing import NDArray

from reference_sim.mujoco import rendering

rendering.find_backend()  # dm_control reads it while it is imported

from dm_control.rl.control import PhysicsError  # noqa: E402
from gym_aloha.env import AlohaEnv  # noqa: E402

ARM_JOINTS = 6
GRIPPER = np.array([[0.0, 1.0]])  # closed, open


class TwoArms(AlohaEnv):  # type: ignore[misc]
    """`pixels.top`, uint8 (480, 640, 3), and `agent_pos`, (14,) in radians."""

    def __init__(self, task: str) -> None:
        """task: `transfer_cube` or `insertion`."""
        super().__init__(task, obs_type="pixels_agent_pos")
        limits = self._env.physics.model.actuator_ctrlrange
        # Each arm has six joints, and two fingers that the gripper's number moves.
        left, right = limits[:ARM_JOINTS], limits[ARM_JOINTS + 2 :][:ARM_JOINTS]
        low, high = np.concatenate([left, GRIPPER, right, GRIPPER]).T
        self.action_space = Box(low, high, dtype=np.float64)
        self._env.task.get_observation = self._observe

    def _observe(self, physics: Any) -> dict[str, Any]:
        top = physics.render(height=480, width=640, camera_id="top")
        return {"qpos": self._env.task.get_qpos(physics), "images": {"top": top}}

    def _format_raw_obs(self, raw_obs: dict[str, Any]) -> dict[str, Any]:
        observed: dict[str, Any] = super()._format_raw_obs(raw_obs)
        self._last = observed
        return observed

    def step(
        self, action: NDArray[np.float64]
    ) -> tuple[dict[str, Any], float, bool, bool, dict[str, Any]]:
        """Gymnasium's five; the observation before, where the simulation diverged."""
        try:
            observed, reward, terminated, truncated, info = super().step(action)
        except PhysicsError:
            return self._last, 0.0, True, False, {"is_success": False}
        return observed, float(reward), terminated, truncated, info
