"""The plan of each task; an object that slips is grasped again.

The targets of the hands are computed from the latest observation at every step. Plans
never end; the simulator ends the episode.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial

import numpy as np

from reference_sim.benchmarks.mobile_bimanual import frames
from reference_sim.benchmarks.mobile_bimanual.layout import (
    SIDE_TABLE_EDGE_M,
    TABLE_TOP_M,
    WORK_TABLE_EDGE_M,
)
from reference_sim.benchmarks.mobile_bimanual.skills import RobotController, Steps
from reference_sim.benchmarks.mobile_bimanual.tasks import (
    FetchAndPlace,
    Handover,
    TwoHandedLift,
)
from reference_sim.mujoco.world import Vector

HOVER_M = 0.10  # above what is to be gripped, where the fingers are clear of it
CARRIED_M = 0.04  # farther from the fingertips than this, a thing was lost
SQUEEZE_STEPS = 6
CARRY_LEFT = np.array([0.44, 0.22, 0.98, 0])
CARRY_RIGHT = np.array([0.44, -0.22, 0.98, 0])

BEFORE_BASE_M = np.array([0.48, -0.20])  # where the right hand works best
BACK_OFF_M = 0.25  # from a table, before turning
CLEARANCE_M = 0.30  # between the base's middle and a table's edge

GRIP_Y_M, GRIP_Z_M = 0.162, 0.042  # where the tray is gripped, in its frame
LIFT_HEIGHT_M = TABLE_TOP_M + 0.20  # of the fingertips, with the tray
LIFT_STRIDE_M = 0.015

BAR_END_M = 0.055  # from the bar's middle to where each hand grips
BAR_DEPTH_M = 0.006  # above its middle, or the fingers would meet the table
MEETING = np.array([0.42, 0.06, 0.95, math.pi / 2])  # of the left hand, with the bar


def fetch_and_place(robot: RobotController) -> Steps:
    while True:
        robot.open("right")
        yield from robot.reach({"right": CARRY_RIGHT})
        yield from _dock(robot, "box")
        lying_m = float(robot.thing("box")[2])
        yield from _grip(robot, {"right": partial(_box, robot)})
        yield from robot.reach({"right": CARRY_RIGHT})
        if _lost(robot, "right", "box"):
            continue
        yield from _dock(robot, "mat")
        yield from robot.reach({"right": partial(_mat, robot, lying_m + HOVER_M)})
        yield from robot.reach({"right": partial(_mat, robot, lying_m + 0.003)})
        robot.open("right")
        yield from robot.wait(SQUEEZE_STEPS)
        yield from robot.reach({"right": partial(_mat, robot, lying_m + HOVER_M)})
        yield from robot.wait(2 * SQUEEZE_STEPS)


def two_handed_lift(robot: RobotController) -> Steps:
    grips = {
        "left": partial(robot.point_of, "tray", 0.0, GRIP_Y_M, GRIP_Z_M),
        "right": partial(robot.point_of, "tray", 0.0, -GRIP_Y_M, GRIP_Z_M),
    }
    while True:
        robot.open("left", "right")
        yield from _grip(robot, grips)
        up = {side: _raised(robot.hand(side), LIFT_HEIGHT_M) for side in grips}
        yield from robot.reach(up, LIFT_STRIDE_M)
        yield from robot.wait(2 * SQUEEZE_STEPS)


def handover(robot: RobotController) -> Steps:
    while True:
        robot.open("left", "right")
        yield from _grip(robot, {"left": partial(_bar, robot, BAR_END_M)})
        yield from robot.reach({"left": _raised(robot.hand("left"), MEETING[2])})
        yield from robot.reach({"left": MEETING})
        yield from robot.wait(SQUEEZE_STEPS)
        yield from _grip(robot, {"right": partial(_bar, robot, -BAR_END_M)})
        robot.open("left")
        yield from robot.wait(SQUEEZE_STEPS)
        yield from robot.reach({"left": _raised(MEETING, MEETING[2] + HOVER_M)})
        yield from robot.reach({"left": CARRY_LEFT})
        yield from robot.wait(2 * SQUEEZE_STEPS)


PLANS: dict[str, Callable[[RobotController], Steps]] = {
    FetchAndPlace.instruction: fetch_and_place,
    TwoHandedLift.instruction: two_handed_lift,
    Handover.instruction: handover,
}


def _grip(robot: RobotController, places: Mapping[str, Callable[[], Vector]]) -> Steps:
    """Hovers, descends and squeezes, with one hand or with both at once."""
    above = {side: partial(_above, place) for side, place in places.items()}
    yield from robot.reach(above)
    yield from robot.reach(places)
    robot.close(*places)
    yield from robot.wait(SQUEEZE_STEPS)


def _dock(robot: RobotController, thing: str) -> Steps:
    """Drives to the table with the object on it, so that the right hand reaches it."""
    place = robot.thing(thing)[:2]
    on_work_table = place[0] > 0.5 * WORK_TABLE_EDGE_M
    yaw = 0.0 if on_work_table else math.pi / 2
    dock = frames.moved(np.array([*place, yaw]), np.array([*-BEFORE_BASE_M, 0]))
    if on_work_table:
        dock[0] = min(dock[0], WORK_TABLE_EDGE_M - CLEARANCE_M)
    else:
        dock[1] = min(dock[1], SIDE_TABLE_EDGE_M - CLEARANCE_M)
    back = np.array([-BACK_OFF_M, 0, 0])
    if math.hypot(*(dock[:2] - robot.base()[:2])) > BACK_OFF_M:
        yield from robot.drive(frames.moved(robot.base(), back))
        yield from robot.drive(frames.moved(dock, back))
    yield from robot.drive(dock)


def _above(place: Callable[[], Vector]) -> Vector:
    hand = place()
    return _raised(hand, hand[2] + HOVER_M)


def _box(robot: RobotController) -> Vector:
    """The box's middle, the hand square to it with as little turning as it takes."""
    x, y, z, yaw = robot.point_of("box", 0.0, 0.0, 0.0)
    turned = robot.hand("right")[3]
    square = turned + math.remainder(yaw - turned, math.pi / 2)
    return np.array([x, y, z, square])


def _mat(robot: RobotController, z_m: float) -> Vector:
    return np.array([*robot.point_of("mat", 0.0, 0.0, 0.0)[:2], z_m, 0.0])


def _bar(robot: RobotController, left_m: float) -> Vector:
    """The pose to grip the bar, `left_m` from its middle, the hand's back outwards."""
    yaw = robot.point_of("bar", 0.0, 0.0, 0.0)[3]
    swapped = abs(yaw) > math.pi / 2
    x, y, z, yaw = robot.point_of("bar", 0.0, -left_m if swapped else left_m, 0.0)
    along = frames.wrapped(yaw + math.pi * swapped)
    outwards = along + math.copysign(math.pi / 2, left_m)
    return np.array([x, y, z + BAR_DEPTH_M, outwards])


def _raised(hand: Vector, z_m: float) -> Vector:
    return np.array([*hand[:2], z_m, hand[3]])


def _lost(robot: RobotController, side: str, thing: str) -> bool:
    apart = robot.point_of(thing, 0.0, 0.0, 0.0)[:3] - robot.hand(side)[:3]
    return float(np.linalg.norm(apart)) > CARRIED_M
