"""The skills of the mobile bimanual expert, in Cartesian steps instead of joint angles.

Grippers point down; their targets are the position of the fingertips and a yaw, in the
frame of the base. The base is driven to a pose in the world. Motions are generators
that yield once per control step.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping

import numpy as np
import numpy.typing as npt

from reference_sim.benchmarks.mobile_bimanual import frames
from reference_sim.benchmarks.mobile_bimanual.layout import (
    FINGER_STROKE_M,
    HOME_RAD,
    SIDES,
)
from reference_sim.benchmarks.mobile_bimanual.scene import arms
from reference_sim.mujoco.world import Vector

STRIDE_M, STRIDE_RAD = 0.03, 0.15  # of a hand in one control step
DRIVE_M, DRIVE_RAD = 0.03, 0.06  # of the base
ARRIVED_M, ARRIVED_RAD = 0.010, 0.05
BASE_ARRIVED_M, BASE_ARRIVED_RAD = 0.015, 0.03
MOTION_STEPS_MAX = 60  # a motion that takes longer is given up; the script looks again

Steps = Iterator[None]
# x, y, z in m and yaw in rad, base frame; looked up anew at every step, or fixed
Place = Callable[[], Vector] | Vector


class RobotController:
    """The latest observation and the next command."""

    def __init__(self, control: str) -> None:
        """control: a key of layout.ACTION_CHANNELS."""
        self._control = control
        self._arms = arms()
        self.reset()

    def reset(self) -> None:
        self._state: dict[str, Vector] = {}
        self._joints = {side: np.array(HOME_RAD) for side in SIDES}
        self._opening_m = dict.fromkeys(SIDES, FINGER_STROKE_M)
        self._hands: dict[str, Vector] = {}  # as commanded: x, y, z, yaw
        self._base = np.zeros(3)  # as commanded
        self._motion = np.zeros(3)

    def update(self, observation_state: Mapping[str, npt.ArrayLike]) -> None:
        self._state = {name: np.array(v) for name, v in observation_state.items()}
        self._motion = np.zeros(3)
        if not self._hands:
            self._base = self.base()
            self._hands = {side: self.hand(side) for side in SIDES}

    def action(self) -> dict[str, list[float]]:
        """The action of this control step."""
        action: dict[str, list[float]] = {
            "gripper": [self._opening_m[side] for side in SIDES for _ in range(2)],
            "base_motion": self._motion.tolist(),
        }
        poses = {side: _downward_pose(self._hands[side]) for side in SIDES}
        if self._control == "ee_pose":
            return action | {f"{side}_ee_pose": poses[side].tolist() for side in SIDES}
        for side in SIDES:
            self._joints[side] = self._arms[side].inverse(
                poses[side], self._joints[side]
            )
        action["joint_position"] = [*self._joints["left"], *self._joints["right"]]
        return action

    # --- observations ---

    def base(self) -> Vector:
        """(3,): x, y, yaw in the room."""
        return self._state["base_pose"]

    def hand(self, side: str) -> Vector:
        """(4,): x, y, z of the fingertips and the hand's yaw, base frame."""
        pose = self._state[f"{side}_ee_pose"]
        w, x, y, z = pose[3:]
        ahead = math.atan2(-2 * (x * y + w * z), 2 * (y * y + z * z) - 1)
        return np.array([*pose[:3], ahead])

    def thing(self, name: str) -> Vector:
        """(7,): its pose in the room."""
        return self._state[f"{name}_pose"]

    def point_of(self, name: str, x: float, y: float, z: float) -> Vector:
        """(4,): a point of an object, and its yaw, in the frame of the base."""
        pose = frames.to_base(self.base(), self.thing(name))
        return np.array([*frames.offset(pose, x, y, z), frames.yaw_of(pose[3:])])

    # --- commands ---

    def open(self, *sides: str) -> None:
        self._opening_m.update(dict.fromkeys(sides, FINGER_STROKE_M))

    def close(self, *sides: str) -> None:
        self._opening_m.update(dict.fromkeys(sides, 0.0))

    def wait(self, steps: int) -> Steps:
        yield from (None for _ in range(steps))

    def reach(self, places: Mapping[str, Place], stride_m: float = STRIDE_M) -> Steps:
        """Hands (side → place) to where they are wanted, all at once."""
        for _ in range(MOTION_STEPS_MAX):
            arrived = True
            for side, place in places.items():
                goal = place() if callable(place) else place
                self._hands[side] = _stride_towards(self._hands[side], goal, stride_m)
                arrived &= _is_near(self.hand(side), goal)
            if arrived:
                return
            yield

    def drive(self, goal: Vector) -> Steps:
        """The base to a pose in the room, straight."""
        while True:
            left = frames.motion_between(self._base, goal)
            self._motion = np.array(
                [
                    *_clip_length(left[:2], DRIVE_M),
                    min(max(left[2], -DRIVE_RAD), DRIVE_RAD),
                ]
            )
            self._base = frames.moved(self._base, self._motion)
            short = frames.motion_between(self.base(), goal)
            if (
                math.hypot(*short[:2]) < BASE_ARRIVED_M
                and abs(short[2]) < BASE_ARRIVED_RAD
            ):
                return
            yield


def _downward_pose(hand: Vector) -> Vector:
    """Pose of the fingertips of a gripper that points down, rotated by yaw."""
    x, y, z, yaw = hand
    return np.array([x, y, z, 0.0, -math.sin(yaw / 2), math.cos(yaw / 2), 0.0])


def _stride_towards(hand: Vector, goal: Vector, stride_m: float) -> Vector:
    turn = min(max(frames.wrapped(goal[3] - hand[3]), -STRIDE_RAD), STRIDE_RAD)
    next_hand: Vector = hand + np.array(
        [*_clip_length(goal[:3] - hand[:3], stride_m), turn]
    )
    return next_hand


def _clip_length(way: Vector, length_m: float) -> Vector:
    return way * min(1.0, length_m / max(float(np.linalg.norm(way)), 1e-9))


def _is_near(hand: Vector, goal: Vector) -> bool:
    turn = frames.wrapped(hand[3] - goal[3])
    return (
        float(np.linalg.norm(hand[:3] - goal[:3])) < ARRIVED_M
        and abs(turn) < ARRIVED_RAD
    )
