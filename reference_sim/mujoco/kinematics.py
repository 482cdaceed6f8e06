"""From a pose of the gripper to joint angles, for experts and examples.

Why no library: the best one, mink (Apache-2.0), adds 346 MB and a quadratic-program
solver to every client that runs an expert; damped least squares needs forty lines and
0.1 ms. Joint limits are enforced by clipping; redundancy is used to stay near a
posture.

The arm is a separate model: nothing is read from the simulator being played.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from reference_sim.mujoco.world import Vector, World

POSITION_TOLERANCE_M = 1e-4
ROTATION_TOLERANCE_RAD = 1e-3
MAX_ITERATIONS = 60
MAX_STEP_RAD = 0.4  # beyond this the linear model is a guess
POSTURE_GAIN = 0.1


class ArmKinematics:
    """Forward and inverse kinematics of one arm of a model.

    joints: of the arm, in order. body: the gripper, whose pose is computed. posture:
    preferred joint positions, rad, for redundant arms.
    """

    def __init__(
        self, mjcf: str, joints: tuple[str, ...], body: str, posture: Sequence[float]
    ) -> None:
        self._world = World(mjcf)
        self._joints, self._body = joints, body
        self._posture = np.array(posture, dtype=np.float64)
        self._low, self._high = self._world.joint_ranges(joints).T

    def forward(self, joint_position: Sequence[float] | Vector) -> Vector:
        """(n,) rad → (7,) position in m and quaternion wxyz of the gripper, world."""
        self._pose(joint_position)
        return self._world.body_pose(self._body)

    def inverse(self, pose: Vector, start: Sequence[float] | Vector) -> Vector:
        """(n,) rad that bring the gripper to `pose`, searched from `start`.

        An unreachable pose gives the posture where the search ended, near its limits.
        """
        joints = np.array(start, dtype=np.float64)
        for _ in range(MAX_ITERATIONS):
            self._pose(joints)
            error = self._world.body_error(self._body, pose)
            if (
                np.linalg.norm(error[:3]) < POSITION_TOLERANCE_M
                and np.linalg.norm(error[3:]) < ROTATION_TOLERANCE_RAD
            ):
                break
            joints = np.clip(joints + self._step(error, joints), self._low, self._high)
        return joints

    def _pose(self, joint_position: Sequence[float] | Vector) -> None:
        self._world.set_joint_positions(self._joints, joint_position)
        self._world.forward_poses()

    def _step(self, error: Vector, joints: Vector) -> Vector:
        """One step of damped least squares, for the pose just set."""
        jacobian = self._world.body_jacobian(self._body, self._joints)
        # Damping keeps steps finite near singular postures. It shrinks with the error:
        # a constant one would never quite arrive, drawn off by the posture.
        damping = 0.5 * float(error @ error) + 1e-5
        inverse = jacobian.T @ np.linalg.inv(
            jacobian @ jacobian.T + damping * np.eye(6)
        )
        posture = POSTURE_GAIN * (self._posture - joints)
        step = inverse @ (error - jacobian @ posture) + posture
        longest = float(np.abs(step).max())
        return step * min(1.0, MAX_STEP_RAD / longest) if longest > 0 else step
