"""The tasks of mobile_bimanual. A new task is one class, listed in _CLASSES.

A task defines how an episode begins, which stages lead to its goal, the goal as one
predicate of the scene, and the track that it belongs to. The manifests list the tasks
from here, so this module imports MuJoCo for types only. The expert needs a plan for
each task (plans.py).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from reference_sim.benchmarks.mobile_bimanual.layout import (
    BAR_HALF_M,
    BOX_HALF_M,
    MAT_HALF_M,
    SIDES,
    TABLE_TOP_M,
    TRAY_HALF_M,
)
from reference_sim.benchmarks.mobile_bimanual.splits import EpisodeVariation

if TYPE_CHECKING:
    from reference_sim.benchmarks.mobile_bimanual.scene import MobileBimanualScene
    from reference_sim.mujoco.task_simulator import Task

LIFTED_M = 0.10  # above its initial height
IN_THE_AIR_M = 0.03


class FetchAndPlace:
    name = "fetch_and_place"
    track = "mobile_manip"
    instruction = (
        "Drive to the side table, fetch the box and put it on the mat on the work "
        "table."
    )
    stages = ("at the side table", "box lifted", "box at the work table")

    AT_TABLE_M = 0.80  # an arm's length, about
    BASE_X_M, BASE_Y_M, BASE_YAW_RAD = (-1.1, -0.6), (-0.5, 0.2), (-0.5, 0.5)
    BOX_X_M, BOX_Y_M = (-1.20, -0.60), (1.32, 1.42)
    MAT_X_M, MAT_Y_M = (0.46, 0.54), (-0.30, 0.30)

    def reset(
        self, scene: MobileBimanualScene, rng: np.random.Generator, split: str
    ) -> None:
        variation = EpisodeVariation(rng, split)
        variation.apply_to(scene)
        scene.place_base(
            variation.within(*self.BASE_X_M),
            variation.within(*self.BASE_Y_M),
            variation.within(*self.BASE_YAW_RAD),
        )
        scene.place(
            "box",
            variation.within(*self.BOX_X_M),
            variation.within(*self.BOX_Y_M),
            TABLE_TOP_M + BOX_HALF_M * scene.scale_of("box"),
            variation.within(-math.pi, math.pi),
        )
        scene.place(
            "mat",
            variation.within(*self.MAT_X_M),
            variation.within(*self.MAT_Y_M),
            TABLE_TOP_M + 0.001,
            variation.within(-0.4, 0.4),
        )

    def goal_holds(self, scene: MobileBimanualScene) -> bool:
        """The box's middle is on the mat, its whole side down, both hands off."""
        return (
            scene.distance_m("box", "mat") <= MAT_HALF_M
            and scene.height_m("box") <= BOX_HALF_M * scene.scale_of("box") + 0.005
            and not any(scene.touches(side, "box") for side in SIDES)
        )

    def reached(self, scene: MobileBimanualScene) -> list[bool]:
        lifted = scene.height_m("box") >= BOX_HALF_M + IN_THE_AIR_M and any(
            scene.holds(side, "box") for side in SIDES
        )
        return [
            scene.base_distance_m("box") <= self.AT_TABLE_M,
            lifted,
            lifted and scene.base_distance_m("mat") <= self.AT_TABLE_M,
        ]


class TwoHandedLift:
    name = "two_handed_lift"
    track = "table_top_manip"
    instruction = (
        "Lift the tray with both hands at least 10 cm above the table. Keep it level, "
        "so that the box stays on it."
    )
    stages = ("both hands at the tray's grips", "both hands hold it", "half way up")

    AT_GRIP_M = 0.06  # from the grip's foot, between the fingertips
    GRIP_Y_M = 0.162
    LEVEL_RAD = math.radians(10)
    TRAY_X_M, TRAY_Y_M, TRAY_YAW_RAD = (0.50, 0.57), (-0.06, 0.06), (-0.25, 0.25)
    BOX_X_M, BOX_Y_M, BOX_YAW_RAD = (-0.04, 0.04), (-0.05, 0.05), (-math.pi, math.pi)

    def reset(
        self, scene: MobileBimanualScene, rng: np.random.Generator, split: str
    ) -> None:
        variation = EpisodeVariation(rng, split)
        variation.apply_to(scene)
        _dock(scene, variation)
        x, y = variation.within(*self.TRAY_X_M), variation.within(*self.TRAY_Y_M)
        z, yaw = TABLE_TOP_M + TRAY_HALF_M, variation.within(*self.TRAY_YAW_RAD)
        scene.place("tray", x, y, z, yaw)
        scene.place(
            "box",
            x + variation.within(*self.BOX_X_M),
            y + variation.within(*self.BOX_Y_M),
            z + TRAY_HALF_M + BOX_HALF_M * scene.scale_of("box"),
            variation.within(*self.BOX_YAW_RAD),
        )

    def goal_holds(self, scene: MobileBimanualScene) -> bool:
        """Both hands hold the tray up, level, with the box on it."""
        return (
            scene.height_m("tray") >= TRAY_HALF_M + LIFTED_M
            and scene.tilt_rad("tray") <= self.LEVEL_RAD
            and scene.lies_on("box", "tray")
            and all(scene.holds(side, "tray") for side in SIDES)
        )

    def reached(self, scene: MobileBimanualScene) -> list[bool]:
        held = all(scene.holds(side, "tray") for side in SIDES)
        grips = zip(SIDES, (self.GRIP_Y_M, -self.GRIP_Y_M), strict=True)
        return [
            all(
                scene.hand_distance_m(side, "tray", y_m) <= self.AT_GRIP_M
                for side, y_m in grips
            ),
            held,
            held and scene.height_m("tray") >= TRAY_HALF_M + LIFTED_M / 2,
        ]


class Handover:
    name = "handover"
    track = "table_top_manip"
    instruction = (
        "Pick up the bar with the left hand, hand it over to the right hand, and hold "
        "it at least 10 cm above the table with the right hand alone."
    )
    stages = ("left hand holds the bar", "in the air", "both hands hold it")

    BAR_X_M, BAR_Y_M, BAR_YAW_RAD = (0.46, 0.56), (0.30, 0.40), (-0.4, 0.4)

    def reset(
        self, scene: MobileBimanualScene, rng: np.random.Generator, split: str
    ) -> None:
        variation = EpisodeVariation(rng, split)
        variation.apply_to(scene)
        _dock(scene, variation)
        scene.place(
            "bar",
            variation.within(*self.BAR_X_M),
            variation.within(*self.BAR_Y_M),
            TABLE_TOP_M + BAR_HALF_M * scene.scale_of("bar"),
            variation.within(*self.BAR_YAW_RAD),
        )

    def goal_holds(self, scene: MobileBimanualScene) -> bool:
        """The right hand holds the bar up, and the left hand does not touch it.

        How the right hand came to hold the bar is recorded by the stages alone.
        """
        return (
            scene.height_m("bar") >= BAR_HALF_M + LIFTED_M
            and scene.holds("right", "bar")
            and not scene.touches("left", "bar")
        )

    def reached(self, scene: MobileBimanualScene) -> list[bool]:
        left = scene.holds("left", "bar")
        high = scene.height_m("bar") >= BAR_HALF_M + IN_THE_AIR_M
        return [left, left and high, left and high and scene.holds("right", "bar")]


def _dock(scene: MobileBimanualScene, variation: EpisodeVariation) -> None:
    """Place the base at the work table, with the errors of a robot that docks."""
    scene.place_base(
        variation.within(-0.04, 0.02),
        variation.within(-0.04, 0.04),
        variation.within(-0.06, 0.06),
    )


_CLASSES = (FetchAndPlace, TwoHandedLift, Handover)
TASKS: dict[str, type[Task[MobileBimanualScene]]] = {
    task.name: task for task in _CLASSES
}
# Track → its tasks; `generalist` has all of them.
TRACKS: dict[str, tuple[str, ...]] = {
    track: tuple(task.name for task in _CLASSES if task.track == track)
    for track in sorted({task.track for task in _CLASSES})
} | {"generalist": tuple(TASKS)}
