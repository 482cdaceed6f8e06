"""The manifests of the benchmarks `tabletop` and `tabletop_state`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from reference_sim.definition import (
    Definition,
    Json,
    image_sizes,
    installed_version,
    without_mujoco,
    without_pictures,
)
from reference_sim.interface import Simulator
from reference_sim.tabletop.layout import (
    ACTION_CHANNELS,
    CAMERAS,
    CONTROL_RATE_HZ,
    STATE_CHANNELS,
    SUBSTEPS,
)

MAX_STEPS = 150
QUALITY = "fast"


def _describe_tabletop(options: Mapping[str, Any], max_chunk: int) -> Json:  # noqa: ARG001 - takes none
    splits = ["val_train", "val_unseen"]
    episodes = [
        {"task": "lift_cube", "split": splits[index // 10], "seed": 2000 + index}
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
        "tasks": ["lift_cube"],
        "splits": splits,
        "control_rate_hz": float(CONTROL_RATE_HZ),
        "max_steps": MAX_STEPS,
        "max_chunk": max_chunk,
        "max_attempts": 3,
        "max_faults": 3,
        "success_rule": "any_step",
        "action_space": {one.name: one.space() for one in ACTION_CHANNELS},
        "observation_space": {
            "state": {one.name: one.space() for one in STATE_CHANNELS},
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
    return _make(CAMERAS, (settings["width"], settings["height"]))


def _make_tabletop_state(settings: Mapping[str, Any]) -> Simulator:  # noqa: ARG001 - no pictures
    return _make((), (0, 0))


def _make(cameras: Sequence[str], size: tuple[int, int]) -> Simulator:
    from reference_sim.physical import PhysicalSimulator
    from reference_sim.tabletop.scene import TabletopScene
    from reference_sim.tabletop.tasks import TASKS

    return PhysicalSimulator(
        TabletopScene(QUALITY),
        TASKS,
        substeps=SUBSTEPS,
        cameras=cameras,
        camera_size=size,
    )


BENCHMARKS = {
    "tabletop": Definition(
        _describe_tabletop, dict, _make_tabletop, unavailable=without_pictures
    ),
    "tabletop_state": Definition(
        _describe_tabletop_state, dict, _make_tabletop_state, unavailable=without_mujoco
    ),
}
