"""The manifests of the benchmarks `tabletop` and `tabletop_state`.

Tasks are defined in tasks.py. Importing this module imports no simulator.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from reference_sim.benchmarks.tabletop.layout import (
    ACTION_CHANNELS,
    CAMERAS,
    CONTROL_RATE_HZ,
    STATE_CHANNELS,
    SUBSTEPS,
)
from reference_sim.benchmarks.tabletop.tasks import TASKS
from reference_sim.definition import (
    BenchmarkDefinition,
    Json,
    goals_in_words,
    image_sizes,
    installed_version,
    without_mujoco,
    without_pictures,
)
from reference_sim.interface import Simulator

FIRST_SEEDS = {"val_train": 2000, "val_unseen": 3000, "test": 4000}
EPISODES_PER_TASK = {"val_train": 2, "val_unseen": 2, "test": 4}
MAX_STEPS = 200
QUALITY = "fast"


def _episodes() -> list[Json]:
    """Tasks alternate, so that the first episodes of a run cover all of them."""
    return [
        {"task": task, "split": split, "seed": first_seed + index}
        for split, first_seed in FIRST_SEEDS.items()
        for index, task in enumerate([*TASKS] * EPISODES_PER_TASK[split])
    ]


def _describe_tabletop(options: Mapping[str, Any], max_chunk: int) -> Json:  # noqa: ARG001 - takes none
    episodes = _episodes()
    return {
        "benchmark_id": "tabletop",
        "version": "2",
        "title": "Tabletop",
        "description": "A seven-joint arm with a gripper and two cameras "
        "reaches, pushes, lifts, places, stacks, opens, presses and inserts. "
        "Unseen splits vary places, colours, sizes, camera and light.",
        "episodes_total": len(episodes),
        "episodes": episodes,
        "tasks": list(TASKS),
        "task_goals": goals_in_words(TASKS),
        "splits": list(FIRST_SEEDS),
        "sealed_splits": ["test"],
        "control_rate_hz": float(CONTROL_RATE_HZ),
        "max_steps": MAX_STEPS,
        "max_chunk": max_chunk,
        "max_attempts": 3,
        "max_faults": 3,
        "success_rule": "any_step",
        "action_space": {channel.name: channel.space() for channel in ACTION_CHANNELS},
        "observation_space": {
            "state": {channel.name: channel.space() for channel in STATE_CHANNELS},
            "images": {
                camera: {"channels": 3, "description": f"RGB, the {camera} camera"}
                for camera in CAMERAS
            },
            "tensors": {},
        },
        "image_sizes": image_sizes((128, 128), (224, 224), (640, 480)),
        "image_codecs": ["raw", "png", "jpeg"],
        "simulator": {
            "name": "mujoco",
            "version": installed_version("mujoco"),
            "quality": QUALITY,
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
        "simulator": {"name": "mujoco", "version": installed_version("mujoco")},
    }


def _make_tabletop(settings: Mapping[str, Any]) -> Simulator:
    # Another quality is for documents, fewer cameras are for videos: no choice of a
    # submitter sets them.
    cameras = tuple(c for c in CAMERAS if c in settings.get("cameras", CAMERAS))
    quality = settings.get("quality", QUALITY)
    return _make(cameras, (settings["width"], settings["height"]), quality)


def _make_tabletop_state(settings: Mapping[str, Any]) -> Simulator:  # noqa: ARG001 - no pictures
    return _make((), (0, 0), QUALITY)


def _make(cameras: Sequence[str], size: tuple[int, int], quality: str) -> Simulator:
    from reference_sim.benchmarks.tabletop.scene import TabletopScene
    from reference_sim.mujoco.task_simulator import PhysicalSimulator

    return PhysicalSimulator(
        TabletopScene(quality),
        TASKS,
        substeps=SUBSTEPS,
        cameras=cameras,
        camera_size=size,
    )


BENCHMARKS = {
    "tabletop": BenchmarkDefinition(
        _describe_tabletop, dict, _make_tabletop, unavailable=without_pictures
    ),
    "tabletop_state": BenchmarkDefinition(
        _describe_tabletop_state,
        dict,
        _make_tabletop_state,
        unavailable=without_mujoco,
    ),
}
