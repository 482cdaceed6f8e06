"""Poses relative to the robot's base, which moves in the plane.

A pose is seven numbers, position in m and quaternion wxyz; the base is three: x, y, yaw
in the world. This module knows neither MuJoCo nor a robot.
"""

from __future__ import annotations

import math

import numpy as np

from reference_sim.mujoco.world import Vector


def from_base(base: Vector, pose: Vector) -> Vector:
    """A pose in the base's frame → the same pose in the world's."""
    x, y, yaw = base
    pose_in_room: Vector = _turned(pose, yaw) + np.array([x, y, 0, 0, 0, 0, 0])
    return pose_in_room


def to_base(base: Vector, pose: Vector) -> Vector:
    """A pose in the world's frame → the same pose in the base's."""
    x, y, yaw = base
    return _turned(pose - np.array([x, y, 0, 0, 0, 0, 0]), -yaw)


def moved(base: Vector, motion: Vector) -> Vector:
    """The base after a motion (dx, dy, dyaw) in its own frame."""
    cos, sin = math.cos(base[2]), math.sin(base[2])
    dx, dy, dyaw = motion
    after: Vector = base + np.array([cos * dx - sin * dy, sin * dx + cos * dy, dyaw])
    return after


def motion_between(base: Vector, goal: Vector) -> Vector:
    """The motion that leads from one base pose to another, the shorter way round."""
    dx, dy = goal[:2] - base[:2]
    cos, sin = math.cos(base[2]), math.sin(base[2])
    return np.array(
        [cos * dx + sin * dy, -sin * dx + cos * dy, wrapped(goal[2] - base[2])]
    )


def wrapped(angle: float) -> float:
    """The same direction as an angle of -π…π, rad."""
    return math.remainder(angle, math.tau)


def yaw_of(quaternion: Vector) -> float:
    """Rotation about z, rad."""
    w, x, y, z = quaternion
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def upright(x: float, y: float, z: float, yaw: float) -> Vector:
    """The pose of a level object."""
    return np.array([x, y, z, math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2)])


def tilt_of(quaternion: Vector) -> float:
    """The angle between the body's z axis and the world's, rad."""
    _, x, y, _ = quaternion
    return math.acos(max(-1.0, 1 - 2 * (x * x + y * y)))


def offset(pose: Vector, x: float, y: float, z: float) -> Vector:
    """(3,): where a point of a body is, given in the body's own frame."""
    w, *axis = pose[3:]
    point = np.array([x, y, z])
    turn = 2 * np.cross(axis, point)
    place: Vector = pose[:3] + point + w * turn + np.cross(axis, turn)
    return place


def _turned(pose: Vector, yaw: float) -> Vector:
    """About the origin's z axis."""
    c, s = math.cos(yaw), math.sin(yaw)
    half_c, half_s = math.cos(yaw / 2), math.sin(yaw / 2)
    px, py, pz, w, x, y, z = pose
    return np.array(
        [
            c * px - s * py,
            s * px + c * py,
            pz,
            half_c * w - half_s * z,
            half_c * x - half_s * y,
            half_c * y + half_s * x,
            half_c * z + half_s * w,
        ]
    )
