"""The robot and the objects of the tabletop scene, by name, in SI units."""

from __future__ import annotations

import math
from importlib.resources import files

import numpy as np

from reference_sim.benchmarks.tabletop.layout import (
    CUBE_HALF_M,
    FINGER_STROKE_M,
    FINGERS,
    HOME_RAD,
    JOINT_HIGH_RAD,
    JOINT_LOW_RAD,
    JOINTS,
    PEG_HALF_LENGTH_M,
)
from reference_sim.benchmarks.tabletop.variation import Look
from reference_sim.interface import Action
from reference_sim.mujoco.world import Vector, World

LOOSE = ("cube", "second_cube", "peg")  # objects with a free joint


def scene_mjcf() -> str:
    """The MJCF text of robot, table and objects."""
    return (files("reference_sim.benchmarks.tabletop") / "scene.xml").read_text()


class TabletopScene:
    """Objects are named as in the XML; one that is not placed is parked far away."""

    def __init__(self, quality: str = "fast") -> None:
        """quality: a key of mujoco.world.QUALITIES."""
        self.world = World(scene_mjcf(), quality)
        self._scales: dict[str, float] = {}

    # --- beginning of an episode ---

    def reset(self) -> None:
        """The arm at home, the gripper open, all objects parked, nominal appearance."""
        self.world.reset()
        self._scales = {}
        self.world.set_joint_positions(JOINTS, HOME_RAD)
        self.world.set_joint_positions(FINGERS, (FINGER_STROKE_M, FINGER_STROKE_M))
        self.command({"joint_position": HOME_RAD, "gripper": (1.0,)})

    def apply_look(self, look: Look) -> None:
        """Colours, sizes, light and the front camera; until the next reset."""
        for geom, rgba in look.rgba.items():
            self.world.set_geom_rgba(geom, rgba)
        for thing, scale in look.scales.items():
            self.world.scale_body(thing, scale)
            self._scales[thing] = scale
        if look.camera_position_m is not None:
            self.world.set_camera_position("front", look.camera_position_m)
        if look.light is not None:
            self.world.set_light("lamp", *look.light)

    def place(
        self, thing: str, x: float, y: float, yaw: float = 0.0, z: float | None = None
    ) -> None:
        """Upright, on the table unless z is given. Metres and radians."""
        turned = (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))
        if thing in LOOSE:
            self.world.set_gravity_compensation(thing, 0.0)
            height = self.half_height_m(thing) if z is None else z
            self.world.set_free_pose(thing, (x, y, height, *turned))
        else:
            self.world.set_mocap_pose(thing, (x, y, z or 0.0, *turned))

    # --- measurements ---

    def half_height_m(self, thing: str) -> float:
        """Half the height of a loose thing that stands upright."""
        nominal = PEG_HALF_LENGTH_M if thing == "peg" else CUBE_HALF_M
        return nominal * self._scales.get(thing, 1.0)

    def position(self, thing: str) -> Vector:
        """(3,) m."""
        return self.world.body_pose(thing)[:3]

    def height_m(self, thing: str) -> float:
        """The height of its middle above the table."""
        return float(self.position(thing)[2])

    def distance_m(self, thing: str, target: str) -> float:
        """The distance of two things; `tcp` is the point between the fingertips."""
        return float(np.linalg.norm(self.position(thing) - self.position(target)))

    def apart_level_m(self, thing: str, target: str) -> float:
        """The horizontal distance between two things."""
        return float(np.linalg.norm((self.position(thing) - self.position(target))[:2]))

    def clearance_m(self, thing: str) -> float:
        """The space between the table and a loose thing, if the thing is upright."""
        return self.height_m(thing) - self.half_height_m(thing)

    def aside_m(self, thing: str, container: str) -> float:
        """The distance from the middle of an upright container, along its sides."""
        pose = self.world.body_pose(container)
        yaw = 2 * math.atan2(pose[6], pose[3])
        x, y, _ = self.position(thing) - pose[:3]
        cos, sin = math.cos(yaw), math.sin(yaw)
        return float(max(abs(cos * x + sin * y), abs(cos * y - sin * x)))

    def is_touched(self, thing: str) -> bool:
        return any(self.world.bodies_touch(finger, thing) for finger in FINGERS)

    def is_gripped(self, thing: str) -> bool:
        return all(self.world.bodies_touch(finger, thing) for finger in FINGERS)

    def is_upright(self, thing: str) -> bool:
        """Tilted by less than some 15 degrees."""
        _, x, y, _ = self.world.body_pose(thing)[3:]
        return bool(1 - 2 * (x * x + y * y) > 0.966)

    def drawer_opening_m(self) -> float:
        return float(self.world.joint_positions(("drawer",))[0])

    def button_travel_m(self) -> float:
        return float(self.world.joint_positions(("button",))[0])

    # --- actions and observations of a policy ---

    def command(self, action: Action) -> None:
        finger = FINGER_STROKE_M * min(max(action["gripper"][0], 0.0), 1.0)
        joints = np.clip(action["joint_position"], JOINT_LOW_RAD, JOINT_HIGH_RAD)
        self.world.set_controls([*joints, finger, finger])

    def state(self) -> dict[str, Vector]:
        opening = self.world.joint_positions(FINGERS).mean() / FINGER_STROKE_M
        return {
            "joint_position": self.world.joint_positions(JOINTS),
            "gripper": np.array([opening]),
            "ee_pose": self.world.body_pose("tcp"),
            "cube_pose": self.world.body_pose("cube"),
            "second_cube_pose": self.world.body_pose("second_cube"),
            "peg_pose": self.world.body_pose("peg"),
            "hole_pose": self.world.body_pose("hole"),
            "tray_pose": self.world.body_pose("tray"),
            "handle_pose": self.world.body_pose("handle"),
            "drawer_opening": self.world.joint_positions(("drawer",)),
            "button_position": self.position("button"),
            "button_travel": self.world.joint_positions(("button",)),
            "ball_position": self.position("ball"),
            "disc_position": self.position("disc"),
        }
