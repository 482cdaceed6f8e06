"""Robot and things, in the words of a task: no indices, no engine."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from reference_sim.benchmarks.mobile_bimanual import frames
from reference_sim.benchmarks.mobile_bimanual.layout import (
    ALL_FINGERS,
    ARM_JOINTS,
    BASE_HIGH_M,
    BASE_JOINTS,
    BASE_LEAD,
    BASE_LOW_M,
    BASE_STEP,
    BOTH_ARMS_JOINTS,
    CAMERA_POSITIONS_M,
    FINGER_STROKE_M,
    FINGERS,
    FREE_THINGS,
    HOME_RAD,
    JOINT_HIGH_RAD,
    JOINT_LOW_RAD,
    REACH_M,
    SIDES,
    TABLE_TOP_M,
    THINGS,
)
from reference_sim.benchmarks.mobile_bimanual.mjcf import scene_mjcf
from reference_sim.interface import Action
from reference_sim.mujoco.kinematics import ArmKinematics
from reference_sim.mujoco.world import Vector, World

# Where each arm's joints and fingers are among the actuators; the base's come first.
_JOINT_SLOTS = {"left": slice(3, 9), "right": slice(11, 17)}
_FINGER_SLOTS = {"left": slice(9, 11), "right": slice(17, 19)}


class MobileBimanualScene:
    """Robot and things, in the words of a task: no indices, no engine."""

    def __init__(
        self,
        quality: str = "fast",
        *,
        control: str = "joint_position",
        thing_poses: bool = False,
    ) -> None:
        """quality: a key of mujoco.world.QUALITIES. control: a key of ACTION_CHANNELS.
        thing_poses: whether the state has the poses of the objects."""
        self.world = World(scene_mjcf(), quality)
        self._thing_poses = thing_poses
        self._arms = arms() if control == "ee_pose" else {}

    # The robot

    def reset(self) -> None:
        """Docked at the work table, arms at home, all objects parked."""
        self.world.reset()
        self.world.set_joint_positions(BOTH_ARMS_JOINTS, HOME_RAD * 2)
        self.world.set_joint_positions(ALL_FINGERS, (FINGER_STROKE_M,) * 4)
        self._scales = dict.fromkeys(THINGS, 1.0)
        for thing in FREE_THINGS:  # hovering, until a task places it
            self.world.set_gravity_compensation(thing, 1.0)
        self.place_base(0.0, 0.0, 0.0)

    def place_base(self, x: float, y: float, yaw: float) -> None:
        """Metres and radians, world frame; the arms keep their joint positions."""
        self.world.set_joint_positions(BASE_JOINTS, (x, y, yaw))
        arm = (*HOME_RAD, FINGER_STROKE_M, FINGER_STROKE_M)
        self.world.set_controls([x, y, yaw, *arm, *arm])

    def command(self, action: Action) -> None:
        """Targets; those of the last step are where the relative ones start from."""
        targets = self.world.controls()
        targets[:3] = self._base_target(targets[:3], action["base_motion"])
        fingers = np.clip(action["gripper"], 0.0, FINGER_STROKE_M)
        for side, number in zip(SIDES, (0, 1), strict=True):
            joints = targets[_JOINT_SLOTS[side]]
            targets[_JOINT_SLOTS[side]] = np.clip(
                self._arms[side].inverse(_target(action[f"{side}_ee_pose"]), joints)
                if self._arms
                else action["joint_position"][6 * number : 6 * number + 6],
                JOINT_LOW_RAD,
                JOINT_HIGH_RAD,
            )
            targets[_FINGER_SLOTS[side]] = fingers[2 * number : 2 * number + 2]
        self.world.set_controls(targets)

    def state(self) -> dict[str, Vector]:
        base = self.base()
        state = {
            "joint_position": self.world.joint_positions(BOTH_ARMS_JOINTS),
            "gripper": self.world.joint_positions(ALL_FINGERS),
            "base_pose": np.array([*base[:2], frames.wrapped(base[2])]),
        }
        for side in SIDES:
            hand = self.world.body_pose(f"{side}_tcp")
            state[f"{side}_ee_pose"] = frames.to_base(base, hand)
        if self._thing_poses:
            state |= {f"{thing}_pose": self.world.body_pose(thing) for thing in THINGS}
        return state

    def base(self) -> Vector:
        """(3,): x, y in m and yaw in rad, measured."""
        return self.world.joint_positions(BASE_JOINTS)

    def _base_target(self, target: Vector, motion: Sequence[float]) -> Vector:
        step = np.clip(motion, -np.array(BASE_STEP), BASE_STEP)
        wanted, here = frames.moved(target, step), self.base()
        ahead: Vector = here + np.clip(wanted - here, -np.array(BASE_LEAD), BASE_LEAD)
        ahead[:2] = np.clip(ahead[:2], BASE_LOW_M, BASE_HIGH_M)
        return ahead

    # --- appearance of an episode ---

    def place(self, thing: str, x: float, y: float, z: float, yaw: float) -> None:
        """Level, its centre at z. Metres and radians, world frame."""
        pose = frames.upright(x, y, z, yaw)
        if thing in FREE_THINGS:
            self.world.set_free_pose(thing, pose)
            self.world.set_gravity_compensation(thing, 0.0)
        else:
            self.world.set_mocap_pose(thing, pose)

    def scale(self, thing: str, factor: float) -> None:
        """Set the size of the box or the bar, before it is placed."""
        self._scales[thing] = factor
        self.world.scale_body(thing, factor)

    def scale_of(self, thing: str) -> float:
        return self._scales[thing]

    def colour(self, thing: str, rgb: Sequence[float]) -> None:
        self.world.set_geom_rgba(thing, (*rgb, 1.0))

    def shift_camera(self, camera: str, offset_m: Sequence[float]) -> None:
        """Move a camera from its place in the XML, in the frame of its carrier."""
        position = np.add(CAMERA_POSITIONS_M[camera], offset_m)
        self.world.set_camera_position(camera, position.tolist())

    # --- conditions of the tasks ---

    def holds(self, side: str, thing: str) -> bool:
        """Whether both fingers of the hand touch it."""
        return all(self.world.bodies_touch(finger, thing) for finger in FINGERS[side])

    def touches(self, side: str, thing: str) -> bool:
        """Whether any finger of the hand touches it."""
        return any(self.world.bodies_touch(finger, thing) for finger in FINGERS[side])

    def lies_on(self, thing: str, carrier: str) -> bool:
        return self.world.bodies_touch(thing, carrier)

    def height_m(self, thing: str) -> float:
        """The height of its centre above the tables' tops."""
        return float(self.world.body_pose(thing)[2]) - TABLE_TOP_M

    def distance_m(self, body: str, target: str) -> float:
        """The distance between two bodies' centres, seen from above."""
        apart = self.world.body_pose(body)[:2] - self.world.body_pose(target)[:2]
        return float(np.hypot(*apart))

    def hand_distance_m(self, side: str, thing: str, y_m: float = 0.0) -> float:
        """The distance from the fingertips to a point on the thing's own y axis."""
        place = frames.offset(self.world.body_pose(thing), 0.0, y_m, 0.0)
        return float(np.linalg.norm(self.world.body_pose(f"{side}_tcp")[:3] - place))

    def tilt_rad(self, thing: str) -> float:
        return frames.tilt_of(self.world.body_pose(thing)[3:])

    def base_distance_m(self, thing: str) -> float:
        """The distance from the base's middle, seen from above."""
        return float(np.hypot(*(self.world.body_pose(thing)[:2] - self.base()[:2])))


def arms() -> dict[str, ArmKinematics]:
    """Side → its arm's kinematics in the base's frame, apart from any simulator."""
    return {
        side: ArmKinematics(scene_mjcf(), ARM_JOINTS[side], f"{side}_tcp", HOME_RAD)
        for side in SIDES
    }


def _target(pose: Sequence[float]) -> Vector:
    """Within reach of numbers, of unit rotation; looking down where it has none."""
    position = np.clip(pose[:3], (-REACH_M, -REACH_M, 0.0), REACH_M)
    quaternion = np.clip(pose[3:], -1.0, 1.0)
    length = math.sqrt(float(quaternion @ quaternion))
    if length < 1e-6:
        quaternion, length = np.array([0.0, 0.0, 1.0, 0.0]), 1.0
    return np.concatenate([position, quaternion / length])
