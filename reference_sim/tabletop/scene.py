"""Robot and cube, in the words of a task: no indices, no engine."""

from __future__ import annotations

import math
from importlib.resources import files

import numpy as np

from reference_sim.interface import Action
from reference_sim.mujoco_world import Vector, World
from reference_sim.tabletop.layout import (
    CUBE_HALF_M,
    FINGER_STROKE_M,
    FINGERS,
    HOME_RAD,
    JOINT_HIGH_RAD,
    JOINT_LOW_RAD,
    JOINTS,
)


def scene_mjcf() -> str:
    """The XML text of robot, table and cube."""
    return (files("reference_sim.tabletop") / "scene.xml").read_text()


class TabletopScene:
    """Robot and cube, in the words of a task: no indices, no engine."""

    def __init__(self, quality: str = "fast") -> None:
        """quality: a key of mujoco_world.QUALITIES."""
        self.world = World(scene_mjcf(), quality)

    def reset(self) -> None:
        """The arm at home, the gripper open, the cube where the XML has it."""
        self.world.reset()
        self.world.set_joint_positions(JOINTS, HOME_RAD)
        self.world.set_joint_positions(FINGERS, (FINGER_STROKE_M, FINGER_STROKE_M))
        self.command({"joint_position": HOME_RAD, "gripper": (1.0,)})

    def command(self, action: Action) -> None:
        finger = FINGER_STROKE_M * min(max(action["gripper"][0], 0.0), 1.0)
        joints = np.clip(action["joint_position"], JOINT_LOW_RAD, JOINT_HIGH_RAD)
        self.world.set_controls([*joints, finger, finger])

    def place_cube(self, x: float, y: float, yaw: float) -> None:
        """On the table, flat. Metres and radians."""
        turned = (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))
        self.world.set_free_pose("cube", (x, y, CUBE_HALF_M, *turned))

    def cube_clearance_m(self) -> float:
        """Between the table and the underside of the cube, were it level."""
        return float(self.world.body_pose("cube")[2]) - CUBE_HALF_M

    def cube_distance_m(self) -> float:
        """Between the fingertips' middle and the cube's centre."""
        apart = self.world.body_pose("tcp")[:3] - self.world.body_pose("cube")[:3]
        return float(np.linalg.norm(apart))

    def cube_is_gripped(self) -> bool:
        return all(self.world.bodies_touch(finger, "cube") for finger in FINGERS)

    def state(self) -> dict[str, Vector]:
        opening = self.world.joint_positions(FINGERS).mean() / FINGER_STROKE_M
        return {
            "joint_position": self.world.joint_positions(JOINTS),
            "gripper": np.array([opening]),
            "ee_pose": self.world.body_pose("tcp"),
            "cube_pose": self.world.body_pose("cube"),
        }
