"""The benchmarks offered: manifests, episodes, and how their worlds are made.

A manifest holds everything that can change a score; its members are those of the spec's
schema Benchmark. Simulators are imported when one is made, so that a server that only
lists benchmarks stays light, and no picture is drawn to learn what is offered.
"""

from __future__ import annotations

import importlib.metadata
import importlib.util
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

from reference_sim import calibration
from reference_sim.interface import Simulator

if TYPE_CHECKING:
    from reference_sim.tabletop import Channel

Json = dict[str, Any]


class UnknownBenchmark(LookupError):
    """There is no benchmark of that id here."""


class InvalidChoice(ValueError):
    """The benchmark does not offer what was asked for; `pointer` says which member."""

    def __init__(self, pointer: str, detail: str) -> None:
        super().__init__(detail)
        self.pointer = pointer
        self.detail = detail


@dataclass(frozen=True, slots=True)
class EpisodePlan:
    task: str
    split: str
    seed: int


@dataclass(frozen=True, slots=True)
class World:
    """What a simulator process needs to build its simulator; `settings` is JSON-able.

    Equal worlds share processes, so settings hold nothing that differs by episode.
    """

    benchmark_id: str
    settings: Mapping[str, Any]

    @property
    def image_codec(self) -> str:
        return str(self.settings["codec"])

    @property
    def success_scored_tasks(self) -> Sequence[str]:
        """Tasks whose score is 1 on success by the success rule, and 0 otherwise."""
        tasks: Sequence[str] = self.settings.get("success_scored_tasks", ())
        return tasks


@dataclass(frozen=True, slots=True)
class Resolved:
    """A benchmark with a submitter's choices applied.

    manifest: the schema Benchmark without `manifest_sha256` and `unavailable_reason`,
    with one more member, `episodes`: a list of {task, split, seed}.
    images: codec, width and height as chosen.
    """

    manifest: Json
    episodes: tuple[EpisodePlan, ...]
    world: World
    images: Json


@dataclass(frozen=True, slots=True)
class _Definition:
    """describe: (options, max_chunk) → manifest; settings: images → World.settings."""

    describe: Callable[[Mapping[str, Any], int], Json]
    settings: Callable[[Mapping[str, Any]], Json]
    make: Callable[[Mapping[str, Any]], Simulator]
    has_options: bool = False
    needs_mujoco: bool = False
    needs_pictures: bool = False


def benchmark_ids() -> tuple[str, ...]:
    return tuple(sorted(_BENCHMARKS))


def resolve(
    benchmark_id: str,
    options: Mapping[str, Any] | None = None,
    images: Mapping[str, Any] | None = None,
    *,
    max_chunk: int = 64,
) -> Resolved:
    """Raises UnknownBenchmark and InvalidChoice. Bounds are the schema's to check."""
    definition = _definition(benchmark_id)
    if options is not None and not definition.has_options:
        raise InvalidChoice("/options", f"{benchmark_id} takes no options")
    manifest = definition.describe(options or {}, max_chunk)
    chosen = _choose_images(manifest, images)
    return Resolved(
        manifest=manifest,
        episodes=tuple(EpisodePlan(**episode) for episode in manifest["episodes"]),
        world=World(benchmark_id, definition.settings(chosen)),
        images=chosen,
    )


@cache
def unavailable_reason(benchmark_id: str) -> str | None:
    """Why it cannot be played here, and the cure; None when it can.

    Blocks up to a second the first time, when a picture has to be tried.
    """
    definition = _definition(benchmark_id)
    if definition.needs_mujoco and importlib.util.find_spec("mujoco") is None:
        return "MuJoCo is not installed: make setup"
    if definition.needs_pictures:
        from reference_sim import rendering

        try:
            rendering.find_backend()
        except rendering.RenderingUnavailable as unavailable:
            return str(unavailable)
    return None


def make(world: World) -> Simulator:
    """Builds the simulator, in the process that is to run it."""
    return _definition(world.benchmark_id).make(world.settings)


def _definition(benchmark_id: str) -> _Definition:
    try:
        return _BENCHMARKS[benchmark_id]
    except KeyError:
        raise UnknownBenchmark(f"no benchmark {benchmark_id!r}") from None


def _choose_images(manifest: Json, images: Mapping[str, Any] | None) -> Json:
    codecs, sizes = manifest["image_codecs"], manifest["image_sizes"]
    if images is None:
        return {"codec": codecs[0], **sizes[0]}
    if images["codec"] not in codecs:
        raise InvalidChoice("/images/codec", f"offered are {', '.join(codecs)}")
    size = {"width": images["width"], "height": images["height"]}
    if size not in sizes:
        offered = ", ".join(f"{one['width']} × {one['height']}" for one in sizes)
        raise InvalidChoice("/images/width", f"offered are {offered}")
    return {"codec": images["codec"], **size}


def _vector(size: int, unit: str = "1", **more: Any) -> Json:
    """A VectorSpace; what is not given is none, absolute and unbounded."""
    space = {"rotation": "none", "frame": "none", "relative": False}
    return {"size": size, "unit": unit, **space, "out_of_range": "unbounded", **more}


def _bounded(size: int, low: float, high: float, *, out_of_range: str) -> Json:
    return _vector(
        size,
        minimum=[low] * size,
        maximum=[high] * size,
        out_of_range=out_of_range,
    )


def _sizes(*sizes: tuple[int, int]) -> list[Json]:
    return [{"width": width, "height": height} for width, height in sizes]


# calibration, as spec/calibration.md has it


def _describe_calibration(options: Mapping[str, Any], max_chunk: int) -> Json:
    splits = ["even", "odd"]
    episodes = [
        {"task": task, "split": splits[index % 2], "seed": 1000 + index}
        for index, task in enumerate(options.get("tasks", ["score"]))
    ]
    return {
        "benchmark_id": "calibration",
        "version": "1",
        "title": "Calibration",
        "description": "No physics: judges a server without knowing its simulators. "
        "Never on a leaderboard.",
        "episodes_total": len(episodes),
        "episodes": episodes,
        "tasks": list(calibration.TASKS),
        "splits": splits,
        "control_rate_hz": 10.0,
        "max_steps": options.get("max_steps", 10),
        "max_chunk": max_chunk,
        "max_attempts": options.get("max_attempts", 3),
        "max_faults": options.get("max_faults", 3),
        "success_rule": options.get("success_rule", "any_step"),
        "action_space": {
            "score": _bounded(1, 0, 1, out_of_range="refuse"),
            "success": _bounded(1, 0, 1, out_of_range="refuse"),
            "end": _bounded(1, 0, 1, out_of_range="refuse"),
            "delay_s": _bounded(1, 0, 5, out_of_range="refuse") | {"unit": "s"},
            "fault": _bounded(1, 0, 2, out_of_range="refuse"),
            "vector": _vector(calibration.VECTOR_SIZE),
            "clipped": _bounded(calibration.CLIPPED_SIZE, -1, 1, out_of_range="clip"),
        },
        "observation_space": {
            "state": {
                "count": _vector(1),
                "vector": _vector(calibration.VECTOR_SIZE),
                "clipped": _vector(calibration.CLIPPED_SIZE),
            },
            "images": {
                "pattern": {
                    "channels": 3,
                    "description": "(7·x + 13·y + 29·c + count) mod 256",
                    "tasks": ["echo"],
                }
            },
            "tensors": {
                name: {
                    "dtype": tensor.dtype.name,
                    "shape": list(tensor.shape),
                    "description": "Fixed elements, extremes of the dtype among them.",
                    "tasks": ["echo"],
                }
                for name, tensor in calibration.TENSORS.items()
            },
        },
        "image_sizes": _sizes((16, 12), (64, 48)),
        "image_codecs": ["raw", "png", "jpeg"],
        "simulator": {"name": "calibration", "version": "1"},
    }


def _calibration_settings(images: Mapping[str, Any]) -> Json:
    # "In the other tasks the score is 1 when the episode is a success."
    scored = [task for task in calibration.TASKS if task != "score"]
    return {**images, "success_scored_tasks": scored}


def _make_calibration(settings: Mapping[str, Any]) -> Simulator:
    return calibration.Calibration(settings["width"], settings["height"])


# tabletop, with cameras and without

_TABLETOP_QUALITY = "fast"


def _describe_tabletop(options: Mapping[str, Any], max_chunk: int) -> Json:  # noqa: ARG001 - takes none
    # See the file's header.
    from reference_sim.tabletop import (
        ACTION_CHANNELS,
        CAMERAS,
        CONTROL_RATE_HZ,
        STATE_CHANNELS,
        LiftCube,
    )

    splits = ["val_train", "val_unseen"]
    episodes = [
        {"task": LiftCube.name, "split": splits[index // 10], "seed": 2000 + index}
        for index in range(20)
    ]
    return {
        "benchmark_id": "tabletop",
        "version": "1",
        "title": "Tabletop",
        "description": "A seven-joint arm with a gripper and two cameras "
        "lifts a cube from a table.",
        "episodes_total": len(episodes),
        "episodes": episodes,
        "tasks": [LiftCube.name],
        "splits": splits,
        "control_rate_hz": float(CONTROL_RATE_HZ),
        "max_steps": LiftCube.max_steps,
        "max_chunk": max_chunk,
        "max_attempts": 3,
        "max_faults": 3,
        "success_rule": "any_step",
        "action_space": {one.name: _tabletop_vector(one) for one in ACTION_CHANNELS},
        "observation_space": {
            "state": {one.name: _tabletop_vector(one) for one in STATE_CHANNELS},
            "images": {
                camera: {"channels": 3, "description": f"RGB, the {camera} camera"}
                for camera in CAMERAS
            },
            "tensors": {},
        },
        "image_sizes": _sizes((128, 128), (224, 224), (640, 480)),
        "image_codecs": ["raw", "png", "jpeg"],
        "simulator": {
            "name": "mujoco",
            "version": _installed_version("mujoco"),
            "quality": _TABLETOP_QUALITY,
        },
    }


def _describe_tabletop_state(options: Mapping[str, Any], max_chunk: int) -> Json:
    manifest = _describe_tabletop(options, max_chunk)
    return manifest | {
        "benchmark_id": "tabletop_state",
        "title": "Tabletop, state only",
        "description": "The benchmark tabletop without cameras.",
        "observation_space": manifest["observation_space"] | {"images": {}},
        # There is no image. Every run records a choice, so there is one to make.
        "image_sizes": manifest["image_sizes"][:1],
        "image_codecs": manifest["image_codecs"][:1],
        "simulator": {"name": "mujoco", "version": _installed_version("mujoco")},
    }


def _tabletop_vector(channel: Channel) -> Json:
    """The VectorSpace of a channel, conventions spelled out."""
    from reference_sim import tabletop

    space = _vector(channel.size, channel.unit, description=channel.meaning)
    if channel.name == "joint_position":
        space["frame"] = "joint"
    elif channel.name == "gripper":
        space |= {"unit": "1", "gripper_open": 1.0}
    else:
        frame, rotation = tabletop.POSE_FRAME, tabletop.ROTATION
        space |= {"unit": "m,1", "frame": frame, "rotation": rotation}
    if channel.low is not None and channel.high is not None:
        space |= {"minimum": list(channel.low), "maximum": list(channel.high)}
        space["out_of_range"] = "clip"
    return space


def _make_tabletop(settings: Mapping[str, Any]) -> Simulator:
    from reference_sim.tabletop import Tabletop

    width, height = settings["width"], settings["height"]
    return Tabletop(width, height, quality=_TABLETOP_QUALITY)


def _make_tabletop_state(settings: Mapping[str, Any]) -> Simulator:
    from reference_sim.tabletop import Tabletop

    return Tabletop(settings["width"], settings["height"], cameras=False)


def _installed_version(distribution: str) -> str:
    """Without importing it."""
    try:
        return importlib.metadata.version(distribution)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"


_BENCHMARKS = {
    "calibration": _Definition(
        _describe_calibration,
        _calibration_settings,
        _make_calibration,
        has_options=True,
    ),
    "tabletop": _Definition(
        _describe_tabletop,
        dict,
        _make_tabletop,
        needs_mujoco=True,
        needs_pictures=True,
    ),
    "tabletop_state": _Definition(
        _describe_tabletop_state, dict, _make_tabletop_state, needs_mujoco=True
    ),
}
