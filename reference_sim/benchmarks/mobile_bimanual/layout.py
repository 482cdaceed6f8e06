"""Actions, observations and dimensions of the mobile bimanual benchmarks.

The order of numbers is EBench's for its robot lift2: left before right, six joints and
two fingers an arm, then the base. The manifests are made from it. Importing this module
imports no simulator.
"""

from __future__ import annotations

import math

from reference_sim.vector_spaces import Channel, VectorPart, pose_parts

CONTROL_RATE_HZ = 20
SUBSTEPS = 20  # of the scene's timestep, 2.5 ms, in one control step

SIDES = ("left", "right")
_JOINTS = (
    "shoulder_yaw",
    "shoulder_pitch",
    "elbow_pitch",
    "wrist_pitch",
    "wrist_yaw",
    "hand_roll",
)
ARM_JOINTS = {side: tuple(f"{side}_{joint}" for joint in _JOINTS) for side in SIDES}
FINGERS = {side: (f"{side}_finger_1", f"{side}_finger_2") for side in SIDES}
BASE_JOINTS = ("base_x", "base_y", "base_yaw")
BOTH_ARMS_JOINTS = (*ARM_JOINTS["left"], *ARM_JOINTS["right"])
ALL_FINGERS = (*FINGERS["left"], *FINGERS["right"])

JOINT_LOW_RAD = (-2.6, -1.8, 0.0, -2.0, -1.5, -3.1)  # of one arm
JOINT_HIGH_RAD = (2.6, 1.8, 2.8, 2.0, 1.5, 3.1)
# Straight ahead of the shoulder, above the table, the gripper looking down.
HOME_RAD = (0.0, 0.25, 1.6, math.pi - 1.85, 0.0, 0.0)
FINGER_STROKE_M = 0.04

BASE_STEP = (0.05, 0.05, 0.10)  # m, m, rad in one control step, at most
# How far the base's target may be ahead of the base; what blocks it bears no more.
BASE_LEAD = (0.15, 0.15, 0.30)
BASE_LOW_M, BASE_HIGH_M = (-1.6, -1.5), (1.6, 2.0)  # x, y: the room

REACH_M = 1.6  # nothing farther from the base is a target for a hand

_HAND_LOW = (-REACH_M, -REACH_M, 0.0, -1.0, -1.0, -1.0, -1.0)
_HAND_HIGH = (REACH_M, REACH_M, REACH_M, 1.0, 1.0, 1.0, 1.0)

_ARMS = tuple(
    VectorPart(f"{side}_arm", 6, "joint_position", "rad", "joint") for side in SIDES
)
_GRIPPERS = tuple(
    VectorPart(
        side,
        2,
        "gripper",
        "m",
        gripper_open=FINGER_STROKE_M,
        gripper_closed=0.0,
        description="each finger's way from closed",
    )
    for side in SIDES
)
_GRIPPER = Channel(
    "gripper",
    _GRIPPERS,
    "each finger's way from closed: left hand's two, right hand's two",
    (0.0,) * 4,
    (FINGER_STROKE_M,) * 4,
)


def _planar_parts(frame: str, relative_to: str) -> tuple[VectorPart, VectorPart]:
    return (
        VectorPart("position", 2, "position", "m", frame, relative_to=relative_to),
        VectorPart("yaw", 1, "orientation", "rad", frame, "yaw", relative_to),
    )


_BASE_MOTION = Channel(
    "base_motion",
    _planar_parts("base", "commanded"),
    "dx forward, dy to the left, dyaw counter-clockwise of the base's target",
    tuple(-step for step in BASE_STEP),
    BASE_STEP,
)


def _hand_target(side: str) -> Channel:
    return Channel(
        f"{side}_ee_pose",
        pose_parts("base"),
        f"absolute target of the {side} fingertips' middle: position, quaternion wxyz "
        "(normalised when executed), met as well as the arm can",
        _HAND_LOW,
        _HAND_HIGH,
    )


def _seen_pose(name: str, meaning: str, frame: str) -> Channel:
    return Channel(name, pose_parts(frame), meaning)


# Control mode → the vectors of each action. The gripper's and the base's parts are the
# same; a run has one mode, because every declared name is in every action.
ACTION_CHANNELS = {
    "joint_position": (
        Channel(
            "joint_position",
            _ARMS,
            "absolute targets, left arm's six, right arm's six",
            JOINT_LOW_RAD * 2,
            JOINT_HIGH_RAD * 2,
        ),
        _GRIPPER,
        _BASE_MOTION,
    ),
    "ee_pose": (
        _hand_target("left"),
        _hand_target("right"),
        _GRIPPER,
        _BASE_MOTION,
    ),
}
STATE_CHANNELS = (
    Channel("joint_position", _ARMS, "measured, left arm's six, right arm's six"),
    Channel(
        "gripper",
        _GRIPPERS,
        "measured way of each finger from closed, left hand's two, right hand's two",
    ),
    Channel(
        "base_pose",
        _planar_parts("world", "none"),
        "x, y and yaw (-π…π) on the floor; at the origin it is docked at the work "
        "table, facing it",
    ),
    _seen_pose("left_ee_pose", "middle of the left fingertips", "base"),
    _seen_pose("right_ee_pose", "middle of the right fingertips", "base"),
)
FREE_THINGS = ("box", "bar", "tray")
THINGS = (*FREE_THINGS, "mat")
# Only where there are no cameras: with them, a policy has to look.
THING_CHANNELS = tuple(
    _seen_pose(f"{thing}_pose", f"the {thing}'s centre", "world") for thing in THINGS
)
CAMERAS = {
    "head": "on the robot's mast, looking down ahead",
    "front": "in a corner of the room, facing the robot",
    "left_wrist": "on the left hand, looking past its fingertips",
    "right_wrist": "on the right hand, looking past its fingertips",
}

# The scene's measures, which its XML states as well (a test compares them)

TABLE_TOP_M = 0.72
WORK_TABLE_EDGE_M = 0.36  # x of the edge that faces the robot
SIDE_TABLE_EDGE_M = 1.25  # y of the edge that faces the robot
BOX_HALF_M = 0.025
BAR_HALF_M = 0.015  # in its width and height
TRAY_HALF_M = 0.006  # of its plate's thickness
MAT_HALF_M = 0.07
CAMERA_POSITIONS_M = {"front": (1.75, -1.55, 1.85), "head": (0.13, 0.0, 1.38)}
