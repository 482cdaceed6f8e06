"""The tasks of the tabletop benchmark. A new task is one class, listed in TASKS.

A task defines how an episode begins, which stages lead to its goal, and the goal: one
predicate of the scene. The docstring of a class is its goal in words, for
docs/evaluate/tasks.md. The manifest lists the tasks from here, so this module imports
MuJoCo for types only. The expert needs a plan for each task (plans.py).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from reference_sim.benchmarks.tabletop.layout import HOLE_DEPTH_M
from reference_sim.benchmarks.tabletop.variation import Area, Placement, draw_look

if TYPE_CHECKING:
    from reference_sim.benchmarks.tabletop.scene import TabletopScene
    from reference_sim.mujoco.task_simulator import Task

AT_THING_M = 0.03  # between the point midway between the fingertips and an object
CARRIED_M = 0.05  # an object at this height is clear of its surroundings


class TabletopTask:
    """Base class: draws the look of an episode, applies it and names its colours."""

    name: str
    wording: str  # of the instruction; {thing} stands for the thing's colour
    stages: Sequence[str] = ()

    def reset(self, scene: TabletopScene, rng: np.random.Generator, split: str) -> None:
        look = draw_look(rng, split)
        scene.apply_look(look)
        self.instruction = self.wording.format(**look.colours)
        self.arrange(scene, Placement(rng, split))

    def arrange(self, scene: TabletopScene, draw: Placement) -> None:
        """Places the things of the task."""
        raise NotImplementedError

    def reached(self, scene: TabletopScene) -> Sequence[bool]:
        """Whether each stage of the task holds; most tasks have none."""
        return ()


class Reach(TabletopTask):
    """The middle of the fingertips is within 2 cm of the ball's centre."""

    name = "reach"
    wording = "Move the gripper to the {ball} ball."

    REACHED_M = 0.02
    AREA = Area((0.36, 0.52), (-0.22, 0.22))
    HEIGHT_M = (0.06, 0.30)

    def arrange(self, scene: TabletopScene, draw: Placement) -> None:
        scene.place("ball", *draw.spot(self.AREA), z=draw.height(*self.HEIGHT_M))

    def goal_holds(self, scene: TabletopScene) -> bool:
        return scene.distance_m("tcp", "ball") <= self.REACHED_M


class Push(TabletopTask):
    """The cube stands on the table, its centre within 3 cm of the disc's."""

    name = "push"
    wording = "Push the {cube} cube onto the {disc} disc."
    stages = ("touched", "half way")

    ON_DISC_M = 0.03
    ON_TABLE_M = 0.005
    AREA = Area((0.36, 0.48), (-0.15, 0.15))
    WAY_M = (0.12, 0.20)

    def arrange(self, scene: TabletopScene, draw: Placement) -> None:
        start, least, most = draw.spot(self.AREA), *self.WAY_M
        goal = draw.spot(self.AREA, away_from=start, at_least_m=least, at_most_m=most)
        scene.place("cube", *start, draw.yaw())
        scene.place("disc", *goal)
        self._half_way_m = float(np.hypot(*np.subtract(goal, start))) / 2

    def goal_holds(self, scene: TabletopScene) -> bool:
        return (
            scene.apart_level_m("cube", "disc") <= self.ON_DISC_M
            and scene.clearance_m("cube") <= self.ON_TABLE_M
        )

    def reached(self, scene: TabletopScene) -> Sequence[bool]:
        return (
            scene.is_touched("cube"),
            scene.apart_level_m("cube", "disc") <= self._half_way_m,
        )


class LiftCube(TabletopTask):
    """The cube is gripped, its underside at least 10 cm above the table."""

    name = "lift_cube"
    wording = "Lift the {cube} cube at least 10 cm above the table."
    stages = ("at the cube", "gripped", "half way up")

    LIFT_M = 0.10
    AREA = Area((0.38, 0.54), (-0.18, 0.18))

    def arrange(self, scene: TabletopScene, draw: Placement) -> None:
        scene.place("cube", *draw.spot(self.AREA), draw.yaw())

    def goal_holds(self, scene: TabletopScene) -> bool:
        return scene.is_gripped("cube") and scene.clearance_m("cube") >= self.LIFT_M

    def reached(self, scene: TabletopScene) -> Sequence[bool]:
        gripped = scene.is_gripped("cube")
        return (
            scene.distance_m("tcp", "cube") <= AT_THING_M,
            gripped,
            gripped and scene.clearance_m("cube") >= self.LIFT_M / 2,
        )


class PickAndPlace(TabletopTask):
    """The cube lies in the tray, and no finger touches it."""

    name = "pick_and_place"
    wording = "Pick up the {cube} cube and place it in the tray."
    stages = ("at the cube", "gripped", "lifted", "above the tray")

    TRAY_HALF_M = 0.064  # between the walls
    IN_TRAY_M = 0.05  # the cube's centre is lower than this above the table
    CUBE_AREA = Area((0.38, 0.54), (-0.18, -0.05))
    TRAY_AREA = Area((0.38, 0.48), (0.12, 0.18))
    TURN_RAD = 0.4
    APART_M = 0.17  # no tray's corner where a finger goes

    def arrange(self, scene: TabletopScene, draw: Placement) -> None:
        spot = draw.spot(self.CUBE_AREA)
        tray = draw.spot(self.TRAY_AREA, away_from=spot, at_least_m=self.APART_M)
        scene.place("cube", *spot, draw.yaw())
        scene.place("tray", *tray, draw.turn(self.TURN_RAD))

    def goal_holds(self, scene: TabletopScene) -> bool:
        return (
            self._is_over_tray(scene)
            and scene.height_m("cube") <= self.IN_TRAY_M
            and not scene.is_touched("cube")
        )

    def reached(self, scene: TabletopScene) -> Sequence[bool]:
        lifted = scene.is_gripped("cube") and scene.clearance_m("cube") >= CARRIED_M
        return (
            scene.distance_m("tcp", "cube") <= AT_THING_M,
            scene.is_gripped("cube"),
            lifted,
            lifted and self._is_over_tray(scene),
        )

    def _is_over_tray(self, scene: TabletopScene) -> bool:
        return scene.aside_m("cube", "tray") <= self.TRAY_HALF_M


class Stack(TabletopTask):
    """The cube stands on the second cube, and no finger touches it."""

    name = "stack"
    wording = "Stack the {cube} cube on the {second_cube} cube."
    stages = ("at the cube", "gripped", "lifted", "above the other cube")

    OFF_CENTRE_M = 0.018  # less than half a cube: it would topple
    HEIGHT_ERROR_M = 0.006
    AREA = Area((0.38, 0.52), (-0.17, 0.17))
    APART_M = 0.11

    def arrange(self, scene: TabletopScene, draw: Placement) -> None:
        spot = draw.spot(self.AREA)
        second_spot = draw.spot(self.AREA, away_from=spot, at_least_m=self.APART_M)
        scene.place("cube", *spot, draw.yaw())
        scene.place("second_cube", *second_spot, draw.yaw())

    def goal_holds(self, scene: TabletopScene) -> bool:
        above = scene.height_m("cube") - scene.height_m("second_cube")
        standing = scene.half_height_m("cube") + scene.half_height_m("second_cube")
        return (
            scene.apart_level_m("cube", "second_cube") <= self.OFF_CENTRE_M
            and abs(above - standing) <= self.HEIGHT_ERROR_M
            and not scene.is_touched("cube")
        )

    def reached(self, scene: TabletopScene) -> Sequence[bool]:
        lifted = scene.is_gripped("cube") and scene.clearance_m("cube") >= CARRIED_M
        return (
            scene.distance_m("tcp", "cube") <= AT_THING_M,
            scene.is_gripped("cube"),
            lifted,
            lifted and scene.apart_level_m("cube", "second_cube") <= self.OFF_CENTRE_M,
        )


class OpenDrawer(TabletopTask):
    """The drawer, which a spring pulls shut, is at least 12 cm open."""

    name = "open_drawer"
    wording = "Open the drawer at least 12 cm."
    stages = ("at the handle", "ajar", "half open")

    OPEN_M = 0.12
    AJAR_M = 0.02
    AREA = Area((0.38, 0.48), (0.33, 0.38))
    TURN_RAD = 0.25

    def arrange(self, scene: TabletopScene, draw: Placement) -> None:
        scene.place("chest", *draw.spot(self.AREA), draw.turn(self.TURN_RAD))

    def goal_holds(self, scene: TabletopScene) -> bool:
        return scene.drawer_opening_m() >= self.OPEN_M

    def reached(self, scene: TabletopScene) -> Sequence[bool]:
        return (
            scene.distance_m("tcp", "handle") <= AT_THING_M,
            scene.drawer_opening_m() >= self.AJAR_M,
            scene.drawer_opening_m() >= self.OPEN_M / 2,
        )


class PressButton(TabletopTask):
    """The button is pressed at least 9 mm deep."""

    name = "press_button"
    wording = "Press the {button} button."
    stages = ("above the button", "touched")

    PRESSED_M = 0.009
    ABOVE_M = 0.06
    AREA = Area((0.38, 0.54), (-0.18, 0.18))

    def arrange(self, scene: TabletopScene, draw: Placement) -> None:
        scene.place("button_box", *draw.spot(self.AREA), draw.yaw())

    def goal_holds(self, scene: TabletopScene) -> bool:
        return scene.button_travel_m() >= self.PRESSED_M

    def reached(self, scene: TabletopScene) -> Sequence[bool]:
        return (
            scene.distance_m("tcp", "button") <= self.ABOVE_M,
            scene.is_touched("button"),
        )


class InsertPeg(TabletopTask):
    """The peg stands in the hole of the block, at least 3 cm deep."""

    name = "insert_peg"
    wording = "Insert the {peg} peg into the hole of the block."
    stages = ("at the peg", "gripped", "lifted", "above the hole")

    DEPTH_M = 0.03
    OFF_AXIS_M = 0.008
    ABOVE_HOLE_M = 0.015
    PEG_AREA = Area((0.40, 0.52), (-0.18, -0.04))
    BLOCK_AREA = Area((0.40, 0.48), (0.08, 0.16))
    TURN_RAD = 0.4
    APART_M = 0.14  # no block's corner where a finger goes

    def arrange(self, scene: TabletopScene, draw: Placement) -> None:
        spot = draw.spot(self.PEG_AREA)
        block = draw.spot(self.BLOCK_AREA, away_from=spot, at_least_m=self.APART_M)
        scene.place("peg", *spot, draw.turn(self.TURN_RAD))
        scene.place("hole", *block, draw.turn(self.TURN_RAD))

    def goal_holds(self, scene: TabletopScene) -> bool:
        return (
            scene.apart_level_m("peg", "hole") <= self.OFF_AXIS_M
            and scene.is_upright("peg")
            and scene.clearance_m("peg") <= HOLE_DEPTH_M - self.DEPTH_M
        )

    def reached(self, scene: TabletopScene) -> Sequence[bool]:
        lifted = scene.is_gripped("peg") and scene.clearance_m("peg") >= CARRIED_M
        return (
            scene.distance_m("tcp", "peg") <= 2 * AT_THING_M,  # it is taken at its top
            scene.is_gripped("peg"),
            lifted,
            lifted and scene.apart_level_m("peg", "hole") <= self.ABOVE_HOLE_M,
        )


TASKS: dict[str, type[Task[TabletopScene]]] = {
    task.name: task
    for task in (
        Reach,
        Push,
        LiftCube,
        PickAndPlace,
        Stack,
        OpenDrawer,
        PressButton,
        InsertPeg,
    )
}
