"""The plan of each tabletop task, made of skills and selected by the instruction.

A plan that fails starts again. Plans never end; the episode does.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np

from reference_sim.benchmarks.tabletop.layout import HOLE_DEPTH_M, PEG_HALF_LENGTH_M
from reference_sim.benchmarks.tabletop.skills import (
    AJAR,
    CARRY_HEIGHT_M,
    CLOSED,
    HOVER_M,
    LOST_M,
    OPEN,
    SQUEEZE_STEPS,
    TIPS_M,
    Move,
    ObservedState,
    Plan,
    Waypoint,
    carry,
    fixed,
    grasp,
    half_turn,
    level,
    quarter_turn,
    raised,
    release,
    travel,
    wait,
)
from reference_sim.mujoco.world import Vector

OVER_CUBE_M = 0.075  # of the gripper on its way to push
PUSH_HEIGHT_M = 0.026
BEHIND_M = 0.065  # the cube, where the gripper comes down to push
BACK_M = 0.02  # from the cube, before the gripper goes up
CONTACT_M = 0.030  # from the closed gripper to the centre of the cube that it pushes
ASTRAY_M = 0.015  # beside the line of push, the gripper starts afresh
PUSH_STRIDE_M = 0.015  # per control step
PUSHED_M = 0.012  # from the disc's middle: far enough
PULL_LEAD_M = 0.05  # of the gripper's goal, ahead of the handle
PULL_STRIDE_M = 0.02
PEG_GRIP_M = 0.035  # above the peg's centre
SLOW_M = 0.015  # per control step, where aim matters


def reach(observed: ObservedState) -> Plan:
    while True:
        yield Move(observed.position("ball"), 0.0, OPEN)


def push(observed: ObservedState) -> Plan:
    while True:
        direction = _to_disc(observed)[0]
        yaw = fixed(_line(direction))
        behind = level(observed.position("cube")) - BEHIND_M * direction
        for height_m in (OVER_CUBE_M, PUSH_HEIGHT_M):
            yield from travel(observed, fixed(raised(behind, height_m)), yaw, CLOSED)
        yield from _push_on(observed)
        back = fixed(raised(observed.hand, OVER_CUBE_M) - BACK_M * direction)
        yield from travel(observed, back, yaw, CLOSED)


def _push_on(observed: ObservedState) -> Plan:
    """Push until the cube has arrived or the gripper has left it."""
    while True:
        direction, length_m = _to_disc(observed)
        to_cube = level(observed.position("cube") - observed.hand)
        beside = to_cube - (to_cube @ direction) * direction
        if length_m < PUSHED_M or float(np.linalg.norm(beside)) > ASTRAY_M:
            return
        goal = level(observed.position("disc")) - CONTACT_M * direction
        yield Move(raised(goal, PUSH_HEIGHT_M), _line(direction), CLOSED, PUSH_STRIDE_M)


def _to_disc(observed: ObservedState) -> tuple[Vector, float]:
    """The unit direction from the cube to the disc, and the distance in m."""
    way = level(observed.position("disc") - observed.position("cube"))
    length_m = float(np.linalg.norm(way))
    return way / max(length_m, 1e-9), length_m


def _line(direction: Vector) -> float:
    """Yaw of a gripper that pushes with both fingers at once, rad."""
    return half_turn(math.atan2(direction[1], direction[0]))


def lift_cube(observed: ObservedState) -> Plan:
    while True:
        yield from grasp(observed, "cube")
        if (yield from carry(observed, "cube")):
            yield from wait(observed, CLOSED, 5)


def pick_and_place(observed: ObservedState) -> Plan:
    def over_tray(height_m: float) -> Waypoint:
        return Waypoint(lambda: raised(observed.position("tray"), height_m))

    while True:
        yield from grasp(observed, "cube")
        waypoints = over_tray(CARRY_HEIGHT_M), over_tray(0.04)
        if (yield from carry(observed, "cube", *waypoints)):
            yield from release(observed)


def stack(observed: ObservedState) -> Plan:
    # Cubes differ in size; at first both stand on the table.
    standing_m = float(
        observed.position("cube")[2] + observed.position("second_cube")[2]
    )

    def over_other(height_m: float) -> Callable[[], Vector]:
        return lambda: raised(observed.position("second_cube"), standing_m + height_m)

    while True:
        yield from grasp(observed, "cube")
        waypoints = (
            Waypoint(over_other(0.06)),
            Waypoint(over_other(0.002), 0.005, SLOW_M),
        )
        if (yield from carry(observed, "cube", *waypoints)):
            yield from release(observed)


def open_drawer(observed: ObservedState) -> Plan:
    def yaw() -> float:
        return half_turn(observed.yaw("handle"))

    def handle() -> Vector:
        return observed.position("handle")

    def ahead() -> Vector:
        """The direction in which the drawer opens, of unit length."""
        turn = observed.yaw("handle")
        return np.array([math.sin(turn), -math.cos(turn), 0.0])

    while True:
        # Half open, so that a finger fits between handle and drawer.
        yield from travel(observed, lambda: raised(handle(), HOVER_M), yaw, AJAR)
        yield from travel(observed, handle, yaw, AJAR)
        yield from wait(observed, CLOSED, SQUEEZE_STEPS)
        while float(np.linalg.norm(observed.hand - handle())) < LOST_M:
            yield Move(handle() + PULL_LEAD_M * ahead(), yaw(), CLOSED, PULL_STRIDE_M)


def press_button(observed: ObservedState) -> Plan:
    def cap(height_m: float) -> Vector:
        return raised(observed.position("button"), TIPS_M + height_m)

    yield from travel(observed, lambda: cap(0.05), fixed(0.0), CLOSED)
    while True:
        yield Move(cap(-0.02), 0.0, CLOSED)


def insert_peg(observed: ObservedState) -> Plan:
    def yaw() -> float:
        """The gripper's, which turns the peg to the hole."""
        return observed.hand_yaw + quarter_turn(
            observed.yaw("hole") - observed.yaw("peg")
        )

    def over_block(lower_end_m: float) -> Callable[[], Vector]:
        height_m = HOLE_DEPTH_M + PEG_HALF_LENGTH_M + lower_end_m
        return lambda: raised(observed.position("hole"), height_m)

    while True:
        yield from grasp(observed, "peg", above_centre_m=PEG_GRIP_M)
        waypoints = (
            Waypoint(over_block(0.03)),
            Waypoint(over_block(0.01), within_m=0.002, stride_m=SLOW_M),
            Waypoint(over_block(-0.04), stride_m=SLOW_M),
        )
        if (yield from carry(observed, "peg", *waypoints, yaw=yaw)):
            yield from release(observed)


PLANS: Mapping[str, Callable[[ObservedState], Plan]] = {
    # by the first word of the instruction
    "Move": reach,
    "Push": push,
    "Lift": lift_cube,
    "Pick": pick_and_place,
    "Stack": stack,
    "Open": open_drawer,
    "Press": press_button,
    "Insert": insert_peg,
}
