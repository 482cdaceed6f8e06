"""Variation between the splits: appearance, sizes, and the spread of objects.

Policies may be trained on `val_train`; the other splits draw from wider ranges, with
colours of their own. All choices are made at the reset of an episode and undone by the
next reset.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from reference_sim.benchmarks.mobile_bimanual.layout import CAMERA_POSITIONS_M

if TYPE_CHECKING:
    from reference_sim.benchmarks.mobile_bimanual.scene import MobileBimanualScene

Rgb = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class SplitVariation:
    """spread: share of the range of positions; 1 is all of it. scale: maximum change of
    the size of box and bar. camera_m: maximum displacement of a camera along each axis.
    colours: object → its possible colours."""

    spread: float
    scale: float
    camera_m: float
    colours: dict[str, tuple[Rgb, ...]]


SPLITS = {
    "val_train": SplitVariation(
        spread=0.7,
        scale=0.0,
        camera_m=0.0,
        colours={
            "box": ((0.86, 0.20, 0.16), (0.90, 0.45, 0.12)),
            "bar": ((0.93, 0.67, 0.13), (0.86, 0.80, 0.30)),
            "tray": ((0.20, 0.45, 0.66), (0.30, 0.38, 0.62)),
            "mat": ((0.24, 0.60, 0.36), (0.16, 0.52, 0.50)),
        },
    ),
    "val_unseen": SplitVariation(
        spread=1.0,
        scale=0.10,
        camera_m=0.03,
        colours={
            "box": ((0.80, 0.16, 0.42), (0.95, 0.60, 0.55)),
            "bar": ((0.60, 0.80, 0.20), (0.93, 0.52, 0.36)),
            "tray": ((0.12, 0.56, 0.66), (0.44, 0.40, 0.70)),
            "mat": ((0.42, 0.66, 0.22), (0.20, 0.44, 0.30)),
        },
    ),
    "test": SplitVariation(
        spread=1.0,
        scale=0.15,
        camera_m=0.05,
        colours={
            "box": ((0.62, 0.10, 0.10), (0.72, 0.34, 0.74)),
            "bar": ((0.98, 0.84, 0.60), (0.70, 0.50, 0.16)),
            "tray": ((0.36, 0.56, 0.84), (0.22, 0.26, 0.44)),
            "mat": ((0.56, 0.72, 0.46), (0.10, 0.38, 0.40)),
        },
    ),
}


class EpisodeVariation:
    """The random choices of one episode, drawn in the order of the calls."""

    def __init__(self, rng: np.random.Generator, split: str) -> None:
        """split: a key of SPLITS; empty for the first."""
        self._rng = rng
        self._split = SPLITS[split or next(iter(SPLITS))]

    def apply_to(self, scene: MobileBimanualScene) -> None:
        """Colours, sizes and cameras; before anything is placed."""
        for thing, colours in self._split.colours.items():
            scene.colour(thing, colours[self._rng.integers(len(colours))])
        for thing in ("box", "bar"):
            scene.scale(thing, 1.0 + self._split.scale * self._rng.uniform(-1, 1))
        for camera in CAMERA_POSITIONS_M:
            shift = self._split.camera_m * self._rng.uniform(-1, 1, 3)
            scene.shift_camera(camera, shift.tolist())

    def within(self, low: float, high: float) -> float:
        """Uniform in the part of the range, around its middle, that the split has."""
        middle, half = (low + high) / 2, (high - low) / 2
        return float(middle + self._split.spread * half * self._rng.uniform(-1, 1))
