"""The manifests of the mobile bimanual benchmarks, one for each row of VARIANTS.

A track is a selection of tasks (tasks.py). A control mode is a benchmark of its own,
because every action of a run has the same names in it. Importing this module imports no
simulator.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from reference_sim.benchmarks.mobile_bimanual.layout import (
    ACTION_CHANNELS,
    CAMERAS,
    CONTROL_RATE_HZ,
    STATE_CHANNELS,
    SUBSTEPS,
    THING_CHANNELS,
)
from reference_sim.benchmarks.mobile_bimanual.tasks import TASKS, TRACKS
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

MAX_STEPS = 400
QUALITY = "fast"
FIRST_SEEDS = {"val_train": 5000, "val_unseen": 6000, "test": 7000}
EPISODES_PER_TASK = {"val_train": 5, "val_unseen": 5, "test": 10}


@dataclass(frozen=True, slots=True)
class Variant:
    """One benchmark.

    track: a key of TRACKS. control: a key of ACTION_CHANNELS. cameras: False replaces
    the images by the poses of the objects, as part of the state.
    """

    title: str
    track: str
    control: str = "joint_position"
    cameras: bool = True


VARIANTS = {
    "mobile_bimanual": Variant("Mobile bimanual", "generalist"),
    "mobile_bimanual_mobile_manip": Variant(
        "Mobile bimanual, tasks that need driving", "mobile_manip"
    ),
    "mobile_bimanual_table_top_manip": Variant(
        "Mobile bimanual, tasks at the table", "table_top_manip"
    ),
    "mobile_bimanual_ee": Variant(
        "Mobile bimanual, commanded by end-effector poses", "generalist", "ee_pose"
    ),
    "mobile_bimanual_state": Variant(
        "Mobile bimanual, state only", "generalist", cameras=False
    ),
}


def _describe(
    benchmark_id: str,
    variant: Variant,
    options: Mapping[str, Any],  # noqa: ARG001 - takes none
    max_chunk: int,
) -> Json:
    tasks = TRACKS[variant.track]
    episodes = [
        {"task": task, "split": split, "seed": first_seed + number}
        for split, first_seed in FIRST_SEEDS.items()
        for number in range(EPISODES_PER_TASK[split])
        for task in tasks  # alternate, so that a run's first episodes cover all
    ]
    state = STATE_CHANNELS if variant.cameras else STATE_CHANNELS + THING_CHANNELS
    cameras = CAMERAS if variant.cameras else {}
    sizes = image_sizes((640, 480), (224, 224), (128, 128))
    codecs = ["raw", "png", "jpeg"]
    simulator = {"name": "mujoco", "version": installed_version("mujoco")}
    return {
        "benchmark_id": benchmark_id,
        "version": "1",
        "title": variant.title,
        "description": "Two six-joint arms with grippers on a base that drives. "
        f"Track {variant.track}: {', '.join(tasks)}. Controlled by {variant.control}.",
        "episodes_total": len(episodes),
        "episodes": episodes,
        "tasks": list(tasks),
        "task_goals": goals_in_words({name: TASKS[name] for name in tasks}),
        "splits": list(FIRST_SEEDS),
        "sealed_splits": ["test"],
        "control_rate_hz": float(CONTROL_RATE_HZ),
        "max_steps": MAX_STEPS,
        "max_chunk": max_chunk,
        "max_attempts": 3,
        "max_faults": 3,
        "success_rule": "any_step",
        "action_space": {
            channel.name: channel.space()
            for channel in ACTION_CHANNELS[variant.control]
        },
        "observation_space": {
            "state": {channel.name: channel.space() for channel in state},
            "images": {
                camera: {"channels": 3, "description": f"RGB, {where}"}
                for camera, where in cameras.items()
            },
            "tensors": {},
        },
        # Every run records a choice of image, so there is one even without cameras.
        "image_sizes": sizes if variant.cameras else sizes[:1],
        "image_codecs": codecs if variant.cameras else codecs[:1],
        "simulator": simulator | ({"quality": QUALITY} if variant.cameras else {}),
    }


def make_simulator(variant: Variant, settings: Mapping[str, Any]) -> Simulator:
    """The simulator of a variant.

    settings: width and height of an image in pixels, and optionally its quality (for
    the documentation's pictures) and its cameras (for videos); no choice of a submitter
    sets them.
    """
    from reference_sim.benchmarks.mobile_bimanual.scene import MobileBimanualScene
    from reference_sim.mujoco.task_simulator import PhysicalSimulator

    cameras = tuple(c for c in CAMERAS if c in settings.get("cameras", CAMERAS))
    return PhysicalSimulator(
        MobileBimanualScene(
            settings.get("quality", QUALITY),
            control=variant.control,
            thing_poses=not variant.cameras,
        ),
        {name: TASKS[name] for name in TRACKS[variant.track]},
        substeps=SUBSTEPS,
        cameras=cameras if variant.cameras else (),
        camera_size=(settings["width"], settings["height"]),
    )


BENCHMARKS = {
    benchmark_id: BenchmarkDefinition(
        partial(_describe, benchmark_id, variant),
        dict,
        partial(make_simulator, variant),
        unavailable=without_pictures if variant.cameras else without_mujoco,
    )
    for benchmark_id, variant in VARIANTS.items()
}
