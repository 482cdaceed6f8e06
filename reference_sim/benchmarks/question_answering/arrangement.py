"""The scene of an item: objects, positions, colours and camera.

Drawn from a random generator, so that nothing is downloaded and the truth is known. The
arm is folded away and objects keep a distance, so that none hides another.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from reference_sim.benchmarks.tabletop.layout import CAMERA_POSITION_M, JOINTS
from reference_sim.benchmarks.tabletop.scene import TabletopScene
from reference_sim.benchmarks.tabletop.variation import COLOURS, Look

# Thing → what people call it.
NOUNS = {
    "cube": "cube",
    "second_cube": "cube",
    "peg": "peg",
    "ball": "ball",
    "disc": "disc",
    "button": "button",
}
THINGS = tuple(NOUNS)
# Distinguishable on any screen; the arm is blue, white and grey, the table brown.
PALETTE = ("red", "green", "yellow", "purple", "turquoise")
ASPECT = 4 / 3
REACH_M = 0.78  # of the gripper over the table, from the middle of the arm's foot
_VIEW = "front"
_CAMERA_BACK = 1.24  # times the tabletop benchmarks' place: the whole table is seen
_CAMERA_SHIFT_M = 0.05  # in the split `test`
_FOLDED_RAD = (2.8, -0.9, 0.0, 2.2, 0.0, 1.2, 0.0)
_TABLE_X_M, _TABLE_Y_M = (0.14, 0.80), (-0.46, 0.46)
_APART_M = 0.16
_MARGIN = 0.06  # of the picture, in which nothing stands
# Gravity does not move these things, so each is put at a height of its own.
_HEIGHTS_M = {"ball": 0.02, "disc": 0.001}
_CARRIERS = {"button": "button_box"}  # thing → the body that it is mounted on
_TRIES = 10_000


@dataclass(frozen=True, slots=True)
class Arrangement:
    """colours: object → name of its colour, for the objects on the table."""

    scene: TabletopScene
    colours: Mapping[str, str] = field(default_factory=dict)

    @property
    def things(self) -> Sequence[str]:
        return list(self.colours)

    def name(self, thing: str) -> str:
        return f"the {self.colours[thing]} {NOUNS[thing]}"

    def spot(self, thing: str) -> tuple[float, float]:
        """The image coordinates of its centre."""
        return self.scene.world.spot_of(_VIEW, self.scene.position(thing), ASPECT)

    def body_at(self, spot: Sequence[float]) -> str | None:
        return self.scene.world.body_at(_VIEW, spot, ASPECT)

    def hides_nothing(self) -> bool:
        """Whether the centre of each object is visible."""
        return all(self.body_at(self.spot(thing)) == thing for thing in self.things)

    def from_foot_m(self, thing: str) -> float:
        """The distance of a thing from the centre of the arm's foot."""
        return float(np.linalg.norm(self.scene.position(thing)[:2]))

    def picture(self, width: int, height: int) -> NDArray[np.uint8]:
        return self.scene.world.render(_VIEW, width, height)


def arrange(
    scene: TabletopScene,
    rng: np.random.Generator,
    split: str,
    colours: Mapping[str, str],
) -> Arrangement:
    """Places the objects on the table, with the appearance of the split."""
    scene.reset()
    rgba = {thing: COLOURS[colour] for thing, colour in colours.items()}
    place = np.array(CAMERA_POSITION_M) * _CAMERA_BACK
    if split == "test":
        place += rng.uniform(-_CAMERA_SHIFT_M, _CAMERA_SHIFT_M, 3)
    scene.apply_look(Look(colours, rgba, camera_position_m=place))
    scene.world.set_joint_positions(JOINTS, _FOLDED_RAD)
    scene.world.forward()
    taken: list[tuple[float, float]] = []
    for thing in colours:
        taken.append(_free_spot(scene, rng, taken))
        scene.place(
            _CARRIERS.get(thing, thing),
            *taken[-1],
            rng.uniform(-math.pi, math.pi),
            _HEIGHTS_M.get(thing),
        )
    scene.world.forward()
    return Arrangement(scene, colours)


def _free_spot(
    scene: TabletopScene, rng: np.random.Generator, taken: Sequence[tuple[float, float]]
) -> tuple[float, float]:
    """x and y in m, inside the image and away from other objects."""
    for _ in range(_TRIES):
        spot = rng.uniform(*_TABLE_X_M), rng.uniform(*_TABLE_Y_M)
        in_picture = scene.world.spot_of(_VIEW, (*spot, 0.0), ASPECT)
        is_free = all(math.dist(spot, taken_spot) >= _APART_M for taken_spot in taken)
        if is_free and all(
            _MARGIN <= coordinate <= 1 - _MARGIN for coordinate in in_picture
        ):
            return spot
    raise RuntimeError("the table is full")
