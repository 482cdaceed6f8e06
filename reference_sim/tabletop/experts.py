"""Policies that solve the tabletop tasks, to prove that they can be solved.

An expert sees what any policy sees: the observation's state, as it comes over the wire.
It decides anew at every step from where things are, so a cube that slips is fetched
again.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Literal

import numpy as np

from reference_sim.kinematics import ArmKinematics
from reference_sim.mujoco_world import Vector
from reference_sim.tabletop.layout import HOME_RAD, JOINTS
from reference_sim.tabletop.scene import scene_mjcf

HOVER_M = 0.09  # above the cube, where the fingers are clear of it
ARRIVED_M = 0.01
CARRIED_M = 0.03  # farther from the fingertips than this, the cube was lost
LIFT_HEIGHT_M = 0.17  # fingertips above the table; the task asks for 0.10 below it
STRIDE_M = 0.03  # per control step
SQUEEZE_STEPS = 5

Phase = Literal["hover", "descend", "squeeze", "lift"]


class LiftCubeExpert:
    """Hovers over the cube, descends, squeezes, lifts."""

    def __init__(self) -> None:
        self._arm = tabletop_arm()
        self.reset("")

    def reset(self, instruction: str) -> None:
        """Begins an episode; there is one instruction, so it is not read."""
        self._phase: Phase = "hover"
        self._squeezed_steps = 0
        self._joints: Vector | None = None  # as last commanded
        self._waypoint = np.zeros(3)

    def act(
        self, observation_state: Mapping[str, Sequence[float]]
    ) -> dict[str, list[float]]:
        hand = np.asarray(observation_state["ee_pose"], dtype=np.float64)
        cube = np.asarray(observation_state["cube_pose"], dtype=np.float64)
        if self._joints is None:
            self._joints = np.array(observation_state["joint_position"])
            self._waypoint = hand[:3]
        self._phase = self._next_phase(hand[:3], cube[:3])
        self._stride_to(self._goal(cube[:3]))
        pose = np.concatenate([self._waypoint, _facing_down(_grasp_yaw(cube[3:]))])
        self._joints = self._arm.inverse(pose, self._joints)
        is_open = self._phase in ("hover", "descend")
        return {
            "joint_position": self._joints.tolist(),
            "gripper": [1.0 if is_open else 0.0],
        }

    def _next_phase(self, hand: Vector, cube: Vector) -> Phase:
        arrived = float(np.linalg.norm(hand - self._goal(cube))) < ARRIVED_M
        if self._phase == "hover":
            return "descend" if arrived else "hover"
        if self._phase == "descend":
            self._squeezed_steps = 0
            return "squeeze" if arrived else "descend"
        if float(np.linalg.norm(hand - cube)) > CARRIED_M:
            return "hover"
        self._squeezed_steps += 1
        return "squeeze" if self._squeezed_steps < SQUEEZE_STEPS else "lift"

    def _goal(self, cube: Vector) -> Vector:
        """Where the fingertips should be in this phase."""
        if self._phase == "hover":
            return np.array([cube[0], cube[1], cube[2] + HOVER_M])
        if self._phase == "descend":
            return cube
        if self._phase == "squeeze":
            return self._waypoint
        return np.array([self._waypoint[0], self._waypoint[1], LIFT_HEIGHT_M])

    def _stride_to(self, goal: Vector) -> None:
        way = goal - self._waypoint
        length = float(np.linalg.norm(way))
        self._waypoint = self._waypoint + way * min(1.0, STRIDE_M / max(length, 1e-9))


def tabletop_arm() -> ArmKinematics:
    """The arm's kinematics, apart from the simulator being played."""
    return ArmKinematics(scene_mjcf(), JOINTS, "tcp", HOME_RAD)


def _grasp_yaw(quaternion: Vector) -> float:
    """The cube's yaw, by quarter turns as near to straight ahead as it goes, rad."""
    w, x, y, z = quaternion
    yaw = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    return (yaw + math.pi / 4) % (math.pi / 2) - math.pi / 4


def _facing_down(yaw: float) -> Vector:
    """Quaternion wxyz of a gripper that looks down and is turned by yaw about z."""
    return np.array([0.0, -math.sin(yaw / 2), math.cos(yaw / 2), 0.0])
