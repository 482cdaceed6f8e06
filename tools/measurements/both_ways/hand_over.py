"""A scripted policy for gym-aloha that sees what every policy sees, and no more.

It finds the red object in the picture from above, and plans once: the right arm picks
it up and brings it to the middle, where the left arm takes it. Angles come from inverse
kinematics on a model of its own, of the robot alone.
"""

from __future__ import annotations

from typing import NamedTuple

import mujoco
import numpy as np
import numpy.typing as npt
from gym_aloha.constants import ASSETS_DIR, START_ARM_POSE

from tools.measurements.both_ways.compared_benchmark import Parts

Floats = npt.NDArray[np.float64]

JOINTS = ("waist", "shoulder", "elbow", "forearm_roll", "wrist_angle", "wrist_rotate")
OPEN, CLOSED = 1.0, 0.0
FINGERTIPS_M = np.array([0.135, 0, 0])  # from the gripper's body
OBJECT_HEIGHT_M = 0.05
MEETING_M = np.array([0.0, 0.5, 0.25])
# The left gripper lies on its side; the right one comes from above, at a slant.
LEFT_TURN = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], float)
SLANT = np.radians(-60)
RIGHT_TURN = np.array(
    [[np.cos(SLANT), 0, np.sin(SLANT)], [0, 1, 0], [-np.sin(SLANT), 0, np.cos(SLANT)]]
) @ np.diag([-1.0, -1.0, 1.0])


class ArmGoal(NamedTuple):
    """step: when it is reached. at: of the fingertips, metres; None: stay."""

    step: int
    at: Floats | None
    gripper: float


class HandOver:
    """One episode."""

    def __init__(self) -> None:
        self._plan: Floats | None = None
        self._step = 0

    def act(self, seen: Parts) -> Floats:
        if self._plan is None:
            self._plan = _plan(seen["pixels.top"], seen["agent_pos"])
        action: Floats = self._plan[min(self._step, len(self._plan) - 1)].copy()
        # The observation steers a little, so that a difference in it shows.
        action += 1e-3 * (seen["agent_pos"] - action)
        self._step += 1
        return action


def _plan(picture: npt.NDArray[np.uint8], start: Floats) -> Floats:
    """(steps, 14)."""
    model = mujoco.MjModel.from_xml_path(
        str(ASSETS_DIR / "bimanual_viperx_transfer_cube.xml")
    )
    data = mujoco.MjData(model)
    data.qpos[: len(START_ARM_POSE)] = START_ARM_POSE
    mujoco.mj_forward(model, data)
    at = _find_red(model, data, picture)
    aside, above = np.array([0.1, 0, 0]), np.array([0, 0, 0.08])
    left = [
        ArmGoal(100, MEETING_M - aside - above / 4, OPEN),
        ArmGoal(260, MEETING_M + aside / 5 - above / 4, OPEN),
        ArmGoal(310, None, CLOSED),
        ArmGoal(360, MEETING_M - aside - above / 4, CLOSED),
    ]
    right = [
        ArmGoal(90, at + above, OPEN),
        ArmGoal(130, at - above / 5, OPEN),
        ArmGoal(170, None, CLOSED),
        ArmGoal(200, MEETING_M + aside / 2, CLOSED),
        ArmGoal(220, MEETING_M, CLOSED),
        ArmGoal(310, None, OPEN),
        ArmGoal(360, MEETING_M + aside, OPEN),
    ]
    arms = [
        _trajectory(_Arm(model, data, "left", LEFT_TURN), left, start[:7]),
        _trajectory(_Arm(model, data, "right", RIGHT_TURN), right, start[7:]),
    ]
    return np.hstack(arms)


def _find_red(
    model: mujoco.MjModel, data: mujoco.MjData, picture: npt.NDArray[np.uint8]
) -> Floats:
    """Where the object is, from the middle of the pixels that are red."""
    red, green, blue = picture.astype(int).transpose(2, 0, 1)
    rows, columns = np.nonzero((red > 80) & (red > 2 * green) & (red > 2 * blue))
    height, width = picture.shape[:2]
    camera = data.camera("top")
    view = np.radians(model.camera("top").fovy[0])
    focal = height / 2 / np.tan(view / 2)
    ray = camera.xmat.reshape(3, 3) @ [
        columns.mean() - (width - 1) / 2,
        (height - 1) / 2 - rows.mean(),
        -focal,
    ]
    depth = (OBJECT_HEIGHT_M - camera.xpos[2]) / ray[2]
    found: Floats = camera.xpos + depth * ray
    return found


def _trajectory(arm: _Arm, goals: list[ArmGoal], start: Floats) -> Floats:
    """(steps, 7): straight lines between the angles of the goals."""
    steps, rows = [0], [start]
    for goal in goals:
        angles = rows[-1][:6] if goal.at is None else arm.reach(goal.at)
        steps.append(goal.step)
        rows.append(np.append(angles, goal.gripper))
    table = np.array(rows)
    every = np.arange(steps[-1] + 1)
    return np.column_stack([np.interp(every, steps, column) for column in table.T])


class _Arm:
    """Inverse kinematics by damped least squares, from where it was solved last."""

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, side: str, turn: Floats
    ) -> None:
        self._model, self._data, self._turn = model, data, turn
        self._body = model.body(f"vx300s_{side}/gripper_link").id
        joints = [model.joint(f"vx300s_{side}/{name}") for name in JOINTS]
        self._places = [int(joint.qposadr[0]) for joint in joints]
        self._columns = [int(joint.dofadr[0]) for joint in joints]
        self._low, self._high = np.array([joint.range for joint in joints]).T

    def reach(self, fingertips: Floats) -> Floats:
        """Angles (6,) with which the fingertips are there, turned as it is held."""
        model, data = self._model, self._data
        goal = fingertips - self._turn @ FINGERTIPS_M
        jacobian = np.zeros((6, model.nv))
        for _ in range(200):
            mujoco.mj_kinematics(model, data)
            mujoco.mj_comPos(model, data)
            mujoco.mj_jacBody(model, data, jacobian[:3], jacobian[3:], self._body)
            error = np.concatenate(
                [goal - data.xpos[self._body], self._turning(data.xmat[self._body])]
            )
            part = jacobian[:, self._columns]
            damped = part @ part.T + 1e-4 * np.eye(6)
            angles = data.qpos[self._places] + part.T @ np.linalg.solve(damped, error)
            data.qpos[self._places] = np.clip(angles, self._low, self._high)
        reached: Floats = data.qpos[self._places].copy()
        return reached

    def _turning(self, matrix: Floats) -> Floats:
        """Axis times angle from a rotation (9,) to the one that is wanted."""
        quaternion, turning = np.zeros(4), np.zeros(3)
        difference = self._turn @ matrix.reshape(3, 3).T
        mujoco.mju_mat2Quat(quaternion, difference.ravel())
        mujoco.mju_quat2Vel(turning, quaternion, 1.0)
        return turning
