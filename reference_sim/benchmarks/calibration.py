"""The benchmark `calibration`: manifest and simulator, without physics.

Specified in spec/calibration.md; rules that are decided here are cited by id.
"""

from __future__ import annotations

import os
import time
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from reference_sim.definition import BenchmarkDefinition, Json, image_sizes
from reference_sim.interface import (
    Action,
    Observation,
    Simulator,
    StepOutcome,
    TaskUnplayable,
)
from reference_sim.shared_frame_buffer import FRAME_BUFFER
from reference_sim.vector_spaces import VectorPart, bounds, numbers, vector

TASKS = ("score", "count", "echo", "delay", "fault")
VECTOR_SIZE = 8
CLIPPED_SIZE = 2
DEATH_EXIT_CODE = 70


class Calibration:
    """`Simulator` of the benchmark. Width and height in pixels, of the image."""

    def __init__(self, width: int, height: int) -> None:
        row, column, channel = np.ogrid[:height, :width, :3]
        pattern = 7 * column + 13 * row + 29 * channel
        self._pattern = pattern.astype(np.uint8)  # modulo 256

    def reset(self, task: str, seed: int, split: str = "") -> str:
        if task not in TASKS:
            raise TaskUnplayable(f"calibration has no task {task!r}")
        self._task = task
        self._count = 0
        self._vector = np.zeros(VECTOR_SIZE)
        self._clipped = np.zeros(CLIPPED_SIZE)
        return f"Calibration task {task}."

    def step(self, action: Action) -> StepOutcome:
        if self._task == "delay":  # CAL-004
            time.sleep(action["delay_s"][0])
        if self._task == "fault":  # CAL-010: both are ignored in the other tasks
            _break_down(action["fault"][0])
        self._count += 1  # CAL-003
        self._vector = np.array(action["vector"], dtype=np.float64)  # CAL-007
        self._clipped = np.array([min(max(x, -1.0), 1.0) for x in action["clipped"]])
        score = action["score"][0]
        return StepOutcome(
            success=action["success"][0] >= 1,
            score=score,  # CAL-002; in other tasks the success rule decides instead
            terminated=action["end"][0] >= 1,  # CAL-005
            reward=score,  # CAL-008
        )

    def observe(self) -> Observation:
        state = {
            "count": np.array([float(self._count)]),
            "vector": self._vector,
            "clipped": self._clipped,
        }
        if self._task != "echo":  # CAL-006
            return Observation(state)
        height, width, _ = self._pattern.shape  # ENC-005
        pattern = FRAME_BUFFER.allocate(height, width)
        np.add(self._pattern, np.uint8(self._count % 256), out=pattern)
        return Observation(state, {"pattern": pattern}, TENSORS)

    def state_bytes(self) -> bytes:
        head = f"{self._task} {self._count} ".encode()  # no seed: it may be sealed
        return head + self._vector.tobytes() + self._clipped.tobytes()

    def close(self) -> None:
        """No resources to free."""


def _break_down(command: float) -> None:
    """2 reports the task unplayable (FAULT-005), from 1 on it kills the process.

    FAULT-001, CAL-009: nothing is rounded.
    """
    if command >= 2:
        raise TaskUnplayable("the policy commanded fault 2")
    if command >= 1:
        os._exit(DEATH_EXIT_CODE)


def _tensors() -> Mapping[str, NDArray[np.generic]]:
    elements: dict[str, list[float]] = {"bool": [0, 1, 0, 1, 0, 1]}
    for bits in (8, 16, 32, 64):
        signed, unsigned = np.iinfo(f"int{bits}"), np.iinfo(f"uint{bits}")
        elements[f"int{bits}"] = [-2, -1, 0, 1, signed.min, signed.max]
        elements[f"uint{bits}"] = [0, 1, 2, 3, 4, unsigned.max]
    tensors: dict[str, NDArray[np.generic]] = {}
    for dtype, values in elements.items():
        tensors[dtype] = np.array(values, dtype=dtype).reshape(2, 3)
    for floating in (np.float16, np.float32, np.float64):
        limits = np.finfo(floating)
        values = [-2, -0.5, 0, 0.5, float(limits.smallest_normal), float(limits.max)]
        tensors[limits.dtype.name] = np.array(values, dtype=floating).reshape(2, 3)
    return tensors | {"empty": np.zeros((0, 3))}


TENSORS = _tensors()


# The manifest


def _describe(options: Mapping[str, Any], max_chunk: int) -> Json:
    """CAL-001: spaces, options and tasks of calibration.md."""
    splits = ["even", "odd"]
    episodes = [
        {"task": task, "split": splits[index % 2], "seed": 1000 + index}
        for index, task in enumerate(options.get("tasks", ["score"]))
    ]
    sealed = {"sealed_splits": ["odd"]} if options.get("sealed") else {}
    return {
        "benchmark_id": "calibration",
        "version": "1",
        "title": "Calibration",
        "description": "No physics: judges a server without knowing its simulators. "
        "Its scores compare no policies.",
        "episodes_total": len(episodes),
        "episodes": episodes,
        "tasks": list(TASKS),
        "splits": splits,
        **sealed,
        "control_rate_hz": 10.0,
        "max_steps": options.get("max_steps", 10),
        "max_chunk": max_chunk,
        "max_attempts": options.get("max_attempts", 3),
        "max_faults": options.get("max_faults", 3),
        "success_rule": options.get("success_rule", "any_step"),
        "action_space": {
            "score": numbers(1, **bounds(1, 0, 1, "refuse")),
            "success": numbers(1, **bounds(1, 0, 1, "refuse")),
            "end": numbers(1, **bounds(1, 0, 1, "refuse")),
            "delay_s": vector(
                VectorPart("all", 1, "time", "s"), **bounds(1, 0, 5, "refuse")
            ),
            "fault": numbers(1, **bounds(1, 0, 2, "refuse")),
            "vector": numbers(VECTOR_SIZE),
            "clipped": numbers(CLIPPED_SIZE, **bounds(CLIPPED_SIZE, -1, 1, "clip")),
        },
        "observation_space": {
            "state": {
                "count": numbers(1),
                "vector": numbers(VECTOR_SIZE),
                "clipped": numbers(CLIPPED_SIZE),
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
                for name, tensor in TENSORS.items()
            },
        },
        "image_sizes": image_sizes((16, 12), (64, 48)),
        "image_codecs": ["raw", "png", "jpeg"],
        "simulator": {"name": "calibration", "version": "1"},
    }


def _settings(images: Mapping[str, Any]) -> Json:
    # CAL-011: in the other tasks the score is 1 when the episode is a success.
    scored = [task for task in TASKS if task != "score"]
    return {**images, "success_scored_tasks": scored}


def _make(settings: Mapping[str, Any]) -> Simulator:
    return Calibration(settings["width"], settings["height"])


BENCHMARKS = {
    "calibration": BenchmarkDefinition(_describe, _settings, _make, has_options=True)
}
