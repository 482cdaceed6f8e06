"""The tasks of the tabletop world. A new one is one class, and its name in TASKS."""

from __future__ import annotations

import math

import numpy as np

from reference_sim.physical import Task
from reference_sim.tabletop.scene import TabletopScene


class LiftCube:
    name = "lift_cube"
    instruction = "Lift the red cube at least 10 cm above the table."
    stages = ("at the cube", "gripped", "half way up")

    LIFT_M = 0.10
    REACHED_M = 0.03
    CUBE_X_M = (0.36, 0.56)
    CUBE_Y_M = (-0.20, 0.20)

    def reset(self, scene: TabletopScene, rng: np.random.Generator, split: str) -> None:
        scene.place_cube(
            x=rng.uniform(*self.CUBE_X_M),
            y=rng.uniform(*self.CUBE_Y_M),
            yaw=rng.uniform(-math.pi, math.pi),
        )

    def goal_holds(self, scene: TabletopScene) -> bool:
        return scene.cube_is_gripped() and scene.cube_clearance_m() >= self.LIFT_M

    def reached(self, scene: TabletopScene) -> list[bool]:
        return [
            scene.cube_distance_m() <= self.REACHED_M,
            scene.cube_is_gripped(),
            scene.cube_is_gripped() and scene.cube_clearance_m() >= self.LIFT_M / 2,
        ]


TASKS: dict[str, type[Task[TabletopScene]]] = {LiftCube.name: LiftCube}
