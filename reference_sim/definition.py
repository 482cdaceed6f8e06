"""What a benchmark is before anybody plays it: its manifest, and how its world is made.

A manifest holds everything that can change a score; its members are those of the spec's
schema Benchmark. Whoever offers benchmarks has a mapping `BENCHMARKS`, id → Definition,
in a module that imports no simulator; catalog.py joins them.
"""

from __future__ import annotations

import importlib.metadata
import importlib.util
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from reference_sim.interface import Simulator
from reference_sim.mujoco import rendering

Json = dict[str, Any]


def _always_available() -> None:
    return None


@dataclass(frozen=True, slots=True)
class BenchmarkDefinition:
    """What the catalog asks of a benchmark.

    describe: (options, max_chunk) → manifest: the schema Benchmark without
    `manifest_sha256` and `unavailable_reason`, with one more member, `episodes`: a list
    of {task, split, seed}. settings: images as chosen → World.settings, JSON-able.
    make: World.settings → the simulator, in the process that is to run it.
    unavailable: why it cannot be played here, and the cure, in a line; None if it can.
    """

    describe: Callable[[Mapping[str, Any], int], Json]
    settings: Callable[[Mapping[str, Any]], Json]
    make: Callable[[Mapping[str, Any]], Simulator]
    has_options: bool = False
    unavailable: Callable[[], str | None] = _always_available


@dataclass(frozen=True, slots=True)
class Channel:
    """One named vector of an action or of an observation's state.

    low, high: bounds per element, inclusive; none means unbounded. An action beyond its
    bounds is executed as the nearest allowed one. The rest: see schema VectorSpace.
    """

    name: str
    size: int
    unit: str
    meaning: str
    low: tuple[float, ...] | None = None
    high: tuple[float, ...] | None = None
    frame: str = "none"
    rotation: str = "none"
    relative: bool = False
    gripper_open: float | None = None

    def space(self) -> Json:
        """The VectorSpace, conventions spelled out."""
        space = vector(
            self.size,
            self.unit,
            description=self.meaning,
            frame=self.frame,
            rotation=self.rotation,
            relative=self.relative,
        )
        if self.gripper_open is not None:
            space["gripper_open"] = self.gripper_open
        if self.low is not None and self.high is not None:
            space |= {"minimum": list(self.low), "maximum": list(self.high)}
            space["out_of_range"] = "clip"
        return space


def vector(size: int, unit: str = "1", **more: Any) -> Json:
    """A VectorSpace; what is not given is none, absolute and unbounded."""
    space = {"rotation": "none", "frame": "none", "relative": False}
    return {"size": size, "unit": unit, **space, "out_of_range": "unbounded", **more}


def bounded(size: int, low: float, high: float, *, out_of_range: str) -> Json:
    return vector(
        size,
        minimum=[low] * size,
        maximum=[high] * size,
        out_of_range=out_of_range,
    )


def image_sizes(*sizes: tuple[int, int]) -> list[Json]:
    return [{"width": width, "height": height} for width, height in sizes]


@cache
def installed_version(distribution: str) -> str:
    """Without importing it."""
    try:
        return importlib.metadata.version(distribution)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"


def without_mujoco() -> str | None:
    """Why nothing with physics can be played here."""
    installed = importlib.util.find_spec("mujoco") is not None
    return None if installed else "MuJoCo is not installed: make setup"


def without_pictures() -> str | None:
    """Why nothing with cameras can be played here; starts a process the first time."""
    if reason := without_mujoco():
        return reason  # trying to draw would blame the graphics
    try:
        rendering.find_backend()
    except rendering.RenderingUnavailable as unavailable:
        return str(unavailable)
    return None
