"""A policy that solves the tabletop tasks, which proves that they are solvable.

It receives what any policy receives: the instruction, and the observation's state as
sent over the wire. It knows no tasks, seeds or scores.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from reference_sim.benchmarks.tabletop.layout import HOME_RAD, JOINTS
from reference_sim.benchmarks.tabletop.plans import PLANS
from reference_sim.benchmarks.tabletop.scene import scene_mjcf
from reference_sim.benchmarks.tabletop.skills import ObservedState, Plan
from reference_sim.mujoco.kinematics import ArmKinematics
from reference_sim.mujoco.world import Vector

PICTURE_CAMERA = "front"
PICTURE_MOMENTS = {  # task → the share of an episode that its picture shows
    "reach": 0.7,
    "push": 0.45,
    "lift_cube": 1.0,
    "pick_and_place": 0.72,
    "stack": 0.75,
    "open_drawer": 1.0,
    "press_button": 0.85,
    "insert_peg": 0.8,
}


class TabletopExpert:
    """Executes the plan selected by the instruction."""

    def __init__(self) -> None:
        self._arm = tabletop_arm()
        self._observed = ObservedState()
        self._plan: Plan | None = None

    def reset(self, instruction: str) -> None:
        """Begin an episode. Raises KeyError for an unknown instruction."""
        self._plan = PLANS[instruction.split(maxsplit=1)[0]](self._observed)
        self._joints: Vector | None = None  # as last commanded

    def act(
        self, observation_state: Mapping[str, npt.ArrayLike]
    ) -> dict[str, list[float]]:
        """Raises RuntimeError before the first reset."""
        if self._plan is None:
            raise RuntimeError("reset comes before act")
        self._observed.update(observation_state)
        if self._joints is None:
            self._joints = np.array(observation_state["joint_position"])
            self._waypoint = self._observed.hand
        move = next(self._plan)
        self._stride_to(move.position, move.stride_m)
        pose = np.concatenate([self._waypoint, _facing_down(move.yaw)])
        self._joints = self._arm.inverse(pose, self._joints)
        return {"joint_position": self._joints.tolist(), "gripper": [move.opening]}

    def _stride_to(self, goal: Vector, stride_m: float) -> None:
        way = goal - self._waypoint
        length = float(np.linalg.norm(way))
        self._waypoint = self._waypoint + way * min(1.0, stride_m / max(length, 1e-9))


def make_expert() -> TabletopExpert:
    """Called by tools/experts.py."""
    return TabletopExpert()


def tabletop_arm() -> ArmKinematics:
    """The arm's kinematics, apart from the simulator being played."""
    return ArmKinematics(scene_mjcf(), JOINTS, "tcp", HOME_RAD)


def _facing_down(yaw: float) -> Vector:
    """Quaternion wxyz of a gripper that points down, rotated by yaw about z."""
    return np.array([0.0, -math.sin(yaw / 2), math.cos(yaw / 2), 0.0])
