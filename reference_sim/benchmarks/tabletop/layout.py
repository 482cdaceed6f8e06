"""Actions, observations and dimensions of the tabletop benchmark.

The manifest is made from it. Importing this module imports no simulator.
"""

from __future__ import annotations

import math

from reference_sim.vector_spaces import Channel, VectorPart, pose_parts

CONTROL_RATE_HZ = 20
SUBSTEPS = 20  # of the scene's timestep, 2.5 ms, in one control step

JOINTS = (
    "shoulder_yaw",
    "shoulder_pitch",
    "shoulder_roll",
    "elbow_pitch",
    "forearm_roll",
    "wrist_pitch",
    "hand_roll",
)
JOINT_LOW_RAD = (-2.8, -1.8, -2.8, -2.4, -2.8, -2.2, -2.8)
JOINT_HIGH_RAD = (2.8, 1.8, 2.8, 2.4, 2.8, 2.2, 2.8)
HOME_RAD = (0.0, 0.3, 0.0, 1.6, 0.0, math.pi - 1.9, 0.0)  # the gripper looks down


POSE_FRAME = "world"  # origin under the arm, x forward, z up, z = 0 on the table


def _pose(name: str, meaning: str) -> Channel:
    return Channel(name, pose_parts(POSE_FRAME), meaning)


def _position(name: str, meaning: str) -> Channel:
    return Channel(name, (VectorPart("all", 3, "position", "m", POSE_FRAME),), meaning)


def _length(name: str, meaning: str) -> Channel:
    return Channel(name, (VectorPart("all", 1, "length", "m"),), meaning)


_JOINTS = (VectorPart("all", 7, "joint_position", "rad", "joint"),)
_GRIPPER = (VectorPart("all", 1, "gripper", "1", gripper_open=1.0, gripper_closed=0.0),)
ACTION_CHANNELS = (
    Channel(
        "joint_position", _JOINTS, "absolute targets", JOINT_LOW_RAD, JOINT_HIGH_RAD
    ),
    Channel("gripper", _GRIPPER, "0 closed, 1 open", (0.0,), (1.0,)),
)
# All tasks have these channels. A task parks the things that it does not use more than
# 2 m away.
STATE_CHANNELS = (
    Channel("joint_position", _JOINTS, "measured, in the order of the action"),
    Channel("gripper", _GRIPPER, "measured opening, 0 closed, 1 open"),
    _pose("ee_pose", "between the fingertips"),
    _pose("cube_pose", "the centre of the cube that is to be moved"),
    _pose("second_cube_pose", "the centre of the cube that is to be stacked upon"),
    _pose("peg_pose", "the peg's centre, its length along z"),
    _pose("hole_pose", "the hole's axis along z, at the block's underside"),
    _pose("tray_pose", "the middle of the tray's underside"),
    _pose("handle_pose", "the middle of the drawer's handle, which opens along -y"),
    _length("drawer_opening", "0 shut, 0.16 as far as it goes"),
    _position("button_position", "the middle of the button's cap"),
    _length("button_travel", "0 released, 0.012 as far as it goes"),
    _position("ball_position", "the centre of the ball that is to be reached"),
    _position("disc_position", "the middle of the disc that is to be pushed onto"),
)
CAMERAS = ("front", "wrist")

# The scene's measures, which its XML states as well (a test compares them)

CUBE_HALF_M = 0.022
PEG_HALF_LENGTH_M = 0.05
HOLE_DEPTH_M = 0.05
FINGER_STROKE_M = 0.04  # of each finger
FINGERS = ("left_finger", "right_finger")
DRAWER_TRAVEL_M = 0.16
BUTTON_TRAVEL_M = 0.012
CAMERA_POSITION_M = (1.16, -0.68, 0.68)  # of the front camera
