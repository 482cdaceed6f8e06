"""Variation between episodes: positions of objects and appearance.

The split `val_train` has the nominal appearance and its own areas. The unseen splits
use what no `val_train` episode shows: a band around each area, other colours, cubes
10 % smaller or larger, another camera position, other light. `val_unseen` and `test`
have different colours. This module knows no scene.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from reference_sim.benchmarks.tabletop.layout import CAMERA_POSITION_M

if TYPE_CHECKING:
    from reference_sim.mujoco.world import Vector

SPLITS = ("val_train", "val_unseen", "test")

Rgba = tuple[float, float, float, float]

COLOURS: dict[str, Rgba] = {
    "red": (0.86, 0.20, 0.16, 1),
    "blue": (0.15, 0.38, 0.80, 1),
    "green": (0.20, 0.68, 0.32, 1),
    "orange": (0.90, 0.45, 0.10, 1),
    "yellow": (0.95, 0.72, 0.12, 1),
    "purple": (0.46, 0.24, 0.68, 1),
    "turquoise": (0.10, 0.68, 0.70, 1),
    "pink": (0.93, 0.45, 0.62, 1),
    "white": (0.95, 0.95, 0.93, 1),
    "brown": (0.42, 0.25, 0.14, 1),
    "black": (0.10, 0.10, 0.11, 1),
}
NOMINAL_COLOURS = {  # by thing, as in the XML
    "cube": "red",
    "second_cube": "blue",
    "peg": "yellow",
    "button": "orange",
    "ball": "green",
    "disc": "green",
}
_PALETTES = {
    "val_unseen": ("green", "orange", "yellow", "purple", "turquoise", "white"),
    "test": ("blue", "purple", "pink", "brown", "black", "white"),
}
_TABLES: dict[str, Sequence[Rgba]] = {
    # Tints of the wood: its texture shows through.
    "val_unseen": ((0.80, 0.92, 1, 1), (1, 0.80, 0.66, 1)),
    "test": ((0.72, 0.72, 0.76, 1), (0.80, 1, 0.86, 1), (1, 0.72, 0.72, 1)),
}
CUBE_SCALES = (0.9, 1.1)
BAND_M = 0.03
BAND_TURN = 1.3  # times the nominal angle
CAMERA_SHIFT_M = 0.06
LIGHT_TILT = 0.35  # of the direction's horizontal parts
LIGHT_DIFFUSE = (0.40, 0.66)
LIGHT_TINT = 0.08


@dataclass(frozen=True, slots=True)
class Look:
    """colours: object → name of its colour. rgba: geom → colour. scales: object →
    factor. light: direction (unit length) and diffuse colour. None: as in the XML."""

    colours: Mapping[str, str]
    rgba: Mapping[str, Rgba] = field(default_factory=dict)
    scales: Mapping[str, float] = field(default_factory=dict)
    camera_position_m: Vector | None = None
    light: tuple[Vector, Vector] | None = None


def draw_look(rng: np.random.Generator, split: str) -> Look:
    """Raises KeyError if there is no such split; the empty one is `val_train`."""
    if is_nominal(split):
        return Look(NOMINAL_COLOURS)
    words = [str(word) for word in rng.permutation(_PALETTES[split])]
    colours = dict(zip(NOMINAL_COLOURS, words, strict=True))
    rgba = {thing: COLOURS[colour] for thing, colour in colours.items()}
    rgba["table"] = _TABLES[split][int(rng.integers(len(_TABLES[split])))]
    scales = {cube: rng.uniform(*CUBE_SCALES) for cube in ("cube", "second_cube")}
    shift = rng.uniform(-CAMERA_SHIFT_M, CAMERA_SHIFT_M, 3)
    tilt = rng.uniform(-LIGHT_TILT, LIGHT_TILT, 2)
    direction = np.array([-0.40 + tilt[0], -0.38 + tilt[1], -1.0])
    tint = rng.uniform(1 - LIGHT_TINT, 1 + LIGHT_TINT, 3)
    return Look(
        colours=colours,
        rgba=rgba,
        scales=scales,
        camera_position_m=CAMERA_POSITION_M + shift,
        light=(
            direction / np.linalg.norm(direction),
            rng.uniform(*LIGHT_DIFFUSE) * tint,
        ),
    )


def is_nominal(split: str) -> bool:
    return split in ("", "val_train")


@dataclass(frozen=True, slots=True)
class Area:
    """A rectangle of the table; bounds in m."""

    x: tuple[float, float]
    y: tuple[float, float]

    def grown(self, margin: float) -> Area:
        x, y = self.x, self.y
        return Area(
            (x[0] - margin, x[1] + margin),
            (y[0] - margin, y[1] + margin),
        )

    def holds(self, x: float, y: float) -> bool:
        return self.x[0] <= x <= self.x[1] and self.y[0] <= y <= self.y[1]


class Placement:
    """Draws positions of objects: in the nominal areas, or in the bands around them."""

    def __init__(self, rng: np.random.Generator, split: str) -> None:
        self._rng = rng
        self._nominal = is_nominal(split)

    def spot(
        self,
        area: Area,
        *,
        away_from: tuple[float, float] | None = None,
        at_least_m: float = 0.0,
        at_most_m: float = math.inf,
    ) -> tuple[float, float]:
        """x and y in m, at a distance from another spot that lies within bounds."""
        drawn_from = area if self._nominal else area.grown(BAND_M)
        while True:
            x = self._rng.uniform(*drawn_from.x)
            y = self._rng.uniform(*drawn_from.y)
            if not self._nominal and area.holds(x, y):
                continue
            apart = at_least_m if away_from is None else math.dist((x, y), away_from)
            if at_least_m <= apart <= at_most_m:
                return x, y

    def height(self, low: float, high: float) -> float:
        """z in m."""
        return self._rng.uniform(low, high)

    def yaw(self) -> float:
        """Draw a direction, rad."""
        return self._rng.uniform(-math.pi, math.pi)

    def turn(self, limit: float) -> float:
        """Up to a limit to either side, rad; beyond it in unseen splits."""
        if self._nominal:
            return self._rng.uniform(-limit, limit)
        side = self._rng.choice((-1.0, 1.0))
        return float(side * self._rng.uniform(limit, limit * BAND_TURN))
