"""The skills of the tabletop expert: travel, grasp, carry, push, pull, press.

A plan is a generator of moves. It reads the latest state each time it is resumed, so an
object that slips or is pushed away is followed and grasped again. This module knows no
joints.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
import numpy.typing as npt

from reference_sim.mujoco.world import Vector

STRIDE_M = 0.03  # per control step
HOVER_M = 0.09  # above a thing, where the fingers are clear of it
ARRIVED_M = 0.01
LOST_M = 0.035  # farther from where it was gripped than this, a thing was lost
CARRY_HEIGHT_M = 0.15  # of the centre of the carried thing
SQUEEZE_STEPS = 5
TIPS_M = 0.019  # the fingers reach this far beyond the point that is moved
CLOSED, AJAR, OPEN = 0.0, 0.4, 1.0


T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Move:
    """A target of the gripper, which points down: position of the fingertips' midpoint
    in m, world frame; yaw in rad; opening; maximum distance per step."""

    position: Vector
    yaw: float
    opening: float
    stride_m: float = STRIDE_M


Plan = Generator[Move, None, None]
Goal = Callable[[], Vector]  # (3,) m, evaluated for each move


class ObservedState:
    """The latest observation, by object."""

    def __init__(self) -> None:
        self._state: Mapping[str, Vector] = {}

    def update(self, state: Mapping[str, npt.ArrayLike]) -> None:
        self._state = {
            name: np.asarray(values, dtype=np.float64) for name, values in state.items()
        }

    @property
    def hand(self) -> Vector:
        """(3,) m, between the fingertips."""
        return self._state["ee_pose"][:3]

    @property
    def hand_yaw(self) -> float:
        """The yaw of a gripper that points down, rad."""
        _, x, y, _ = self._state["ee_pose"][3:]
        return 2 * math.atan2(-x, y)

    def position(self, thing: str) -> Vector:
        """(3,) m."""
        if f"{thing}_pose" in self._state:
            return self._state[f"{thing}_pose"][:3]
        return self._state[f"{thing}_position"]

    def yaw(self, thing: str) -> float:
        """The yaw of a thing that stands upright, rad."""
        w, x, y, z = self._state[f"{thing}_pose"][3:]
        return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def travel(
    observed: ObservedState, goal: Goal, yaw: Callable[[], float], opening: float
) -> Plan:
    """The gripper to a goal, which may move meanwhile."""
    while _length(observed.hand - goal()) > ARRIVED_M:
        yield Move(goal(), yaw(), opening)


def wait(observed: ObservedState, opening: float, steps: int) -> Plan:
    """Keep the hand where it is while the fingers move."""
    position, yaw = observed.hand, observed.hand_yaw
    for _ in range(steps):
        yield Move(position, yaw, opening)


def grasp(observed: ObservedState, thing: str, *, above_centre_m: float = 0.0) -> Plan:
    """Grasp a thing from above, by two opposite sides."""

    def at(height_m: float) -> Vector:
        return raised(observed.position(thing), above_centre_m + height_m)

    def yaw() -> float:
        return quarter_turn(observed.yaw(thing))

    yield from travel(observed, lambda: at(HOVER_M), yaw, OPEN)
    yield from travel(observed, lambda: at(0.0), yaw, OPEN)
    yield from wait(observed, CLOSED, SQUEEZE_STEPS)


@dataclass(frozen=True, slots=True)
class Waypoint:
    """A target for the centre of a carried object, and its tolerance."""

    goal: Goal
    within_m: float = ARRIVED_M
    stride_m: float = STRIDE_M


def carry(
    observed: ObservedState,
    thing: str,
    *waypoints: Waypoint,
    yaw: Callable[[], float] | None = None,
) -> Generator[Move, None, bool]:
    """Lifts the gripped object, then carries it along the waypoints; False if lost.

    yaw: of the gripper on the way; without it, as it is.
    """
    current_yaw = fixed(observed.hand_yaw)
    top = raised(level(observed.position(thing)), CARRY_HEIGHT_M)
    if not (
        yield from _move_carried(
            observed, thing, Waypoint(fixed(top), 2 * ARRIVED_M), current_yaw
        )
    ):
        return False
    for waypoint in waypoints:
        if not (
            yield from _move_carried(observed, thing, waypoint, yaw or current_yaw)
        ):
            return False
    return True


def _move_carried(
    observed: ObservedState, thing: str, waypoint: Waypoint, yaw: Callable[[], float]
) -> Generator[Move, None, bool]:
    grip = observed.position(thing) - observed.hand
    while _length(waypoint.goal() - observed.position(thing)) > waypoint.within_m:
        held = observed.position(thing) - observed.hand
        if _length(held - grip) > LOST_M:
            return False
        yield Move(waypoint.goal() - held, yaw(), CLOSED, waypoint.stride_m)
    return True


def release(observed: ObservedState) -> Plan:
    """Opens the gripper and moves up."""
    up, yaw = fixed(raised(observed.hand, HOVER_M)), fixed(observed.hand_yaw)
    yield from wait(observed, OPEN, SQUEEZE_STEPS)
    yield from travel(observed, up, yaw, OPEN)


def fixed(value: T) -> Callable[[], T]:
    """A goal that does not change."""
    return lambda: value


def raised(position: Vector, height_m: float) -> Vector:
    """(3,) m: the position `height_m` above another."""
    above: Vector = position + np.array([0.0, 0.0, height_m])
    return above


def level(way: Vector) -> Vector:
    """(3,) m: the horizontal part of a way."""
    along: Vector = way * np.array([1.0, 1.0, 0.0])
    return along


def quarter_turn(yaw: float) -> float:
    """The same for a square, as near to straight ahead as it goes, rad."""
    return (yaw + math.pi / 4) % (math.pi / 2) - math.pi / 4


def half_turn(yaw: float) -> float:
    """The same for a line, as near to straight ahead as it goes, rad."""
    return (yaw + math.pi / 2) % math.pi - math.pi / 2


def _length(way: Vector) -> float:
    return float(np.linalg.norm(way))
