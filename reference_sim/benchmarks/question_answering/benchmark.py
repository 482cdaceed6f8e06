"""The manifest of the benchmark `question_answering`.

An item is an episode of one step: an image, a question as its instruction, and one
action with the answer. Importing this module imports no simulator.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from reference_sim.benchmarks.question_answering.items import (
    BLOCK,
    CAMERA,
    FIRST_SEEDS,
    LETTERS,
    NO_ANSWER,
    NUMBER_MAX,
    QUALITY,
    TASKS,
)
from reference_sim.definition import (
    BenchmarkDefinition,
    Json,
    image_sizes,
    installed_version,
    without_pictures,
)
from reference_sim.interface import Simulator
from reference_sim.vector_spaces import VectorPart, bounds, numbers, vector


def _episodes() -> list[Json]:
    """Tasks alternate, so that the first items of a run cover all of them."""
    return [
        {"task": task, "split": split, "seed": first_seed + index}
        for split, first_seed in FIRST_SEEDS.items()
        for index in range(BLOCK)
        for task in TASKS
    ]


def answer_space(last: int = len(LETTERS) - 1) -> Json:
    """The action space: every action has all entries; a task uses one of them.

    last: the place of the last choice, from 0.
    """
    none = "-1 where that is not the answer"
    return {
        "choice": vector(
            VectorPart("all", 1, "choice", "1"),
            description=f"0 for A, 1 for B and so on; {none}",
            **bounds(1, NO_ANSWER, last, "refuse"),
        ),
        "number": numbers(
            1,
            description=f"a number; {none}",
            **bounds(1, NO_ANSWER, NUMBER_MAX, "refuse"),
        ),
        "point": numbers(
            2,
            description=f"x to the right, y down, from 0 to 1; {none}",
            **bounds(2, NO_ANSWER, 1.0, "refuse"),
        ),
    }


def _describe(options: Mapping[str, Any], max_chunk: int) -> Json:  # noqa: ARG001 - no options, no chunks
    episodes = _episodes()
    return {
        "benchmark_id": "question_answering",
        "version": "2",  # 1 read an answer alone, 2 reads one inside a text, too
        "title": "Questions about a tabletop",
        "description": "A picture of an arm and things on its table, and a question "
        "with one right answer: how many, which colour, left or right, what is "
        "nearest, what is in reach, where. One action is the answer.",
        "episodes_total": len(episodes),
        "episodes": episodes,
        "tasks": list(TASKS),
        "splits": list(FIRST_SEEDS),
        "sealed_splits": ["test"],
        "control_rate_hz": 1.0,  # nothing moves
        "max_steps": 1,
        "max_chunk": 1,
        "max_attempts": 3,
        "max_faults": 3,
        "success_rule": "any_step",
        "action_space": answer_space(),
        "observation_space": {
            "state": {},
            "images": {
                CAMERA: {"channels": 3, "description": "RGB, what is asked about"}
            },
            "tensors": {},
        },
        # One shape, so that a point means the same in every size.
        "image_sizes": image_sizes((640, 480), (320, 240)),
        "image_codecs": ["png", "jpeg", "raw"],
        "simulator": {
            "name": "mujoco",
            "version": installed_version("mujoco"),
            "quality": QUALITY,
        },
    }


def _make(settings: Mapping[str, Any]) -> Simulator:
    from reference_sim.benchmarks.question_answering.simulator import QuestionSimulator

    return QuestionSimulator((settings["width"], settings["height"]))


BENCHMARKS = {
    "question_answering": BenchmarkDefinition(
        _describe, dict, _make, unavailable=without_pictures, seed_block=BLOCK
    ),
}
