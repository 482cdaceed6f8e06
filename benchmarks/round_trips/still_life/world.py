"""The benchmark of the round trips: a simulator of a still picture that costs nothing.

A `Simulator` in an ordinary simulator process; still_life_server.py adds it to the
registry. Like a MuJoCo camera it renders into the frame buffer; an image that is
already in a half of the buffer is not drawn again, only its number is.
"""

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.round_trips import observations
from reference_sim.definition import BenchmarkDefinition, Json, image_sizes
from reference_sim.interface import Action, Observation, StepOutcome
from reference_sim.shared_frame_buffer import FRAME_BUFFER
from reference_sim.vector_spaces import bounds, numbers

TASK = "sit"
MAX_STEPS = 200  # as long as one of a robot; its end is scored and stored
EPISODES = 2000


class StillLife:
    """`Simulator` of a scenario."""

    def __init__(self, scenario: str) -> None:
        self._pictures = observations.pictures(observations.SCENARIOS[scenario])

    def reset(self, task: str, seed: int, split: str = "") -> str:
        self._step = 1000 * seed
        self._echo = [observations.FRESH]
        self._drawn: set[int] = set()
        return "Sit for a portrait."

    def step(self, action: Action) -> StepOutcome:
        self._step += 1
        self._echo = list(action["joint_position"])
        return StepOutcome(success=False, score=0.0, terminated=False)

    def observe(self) -> Observation:
        state = observations.state(self._step, self._echo)
        images = {name: self._draw(one) for name, one in self._pictures.items()}
        return Observation(state, images)

    def state_bytes(self) -> bytes:
        return np.array([self._step, *self._echo]).tobytes()

    def close(self) -> None:
        """Nothing is held."""

    def _draw(self, picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
        pixels = FRAME_BUFFER.allocate(*picture.shape)
        place = FRAME_BUFFER.place_of(pixels)
        if place is None or place[0] not in self._drawn:
            np.copyto(pixels, picture)
        if place is not None:
            self._drawn.add(place[0])
        observations.stamp(pixels, self._step)
        return pixels


def _describe(scenario: str, _options: Mapping[str, Any], max_chunk: int) -> Json:
    shown = observations.SCENARIOS[scenario]
    episodes = [
        {"task": TASK, "split": "test", "seed": seed} for seed in range(1, EPISODES + 1)
    ]
    return {
        "benchmark_id": f"still_life_{scenario}",
        "version": "1",
        "title": "Still life",
        "description": "What a round trip costs beside simulating.",
        "episodes_total": len(episodes),
        "episodes": episodes,
        "tasks": [TASK],
        "splits": ["test"],
        "control_rate_hz": 20.0,
        "max_steps": MAX_STEPS,
        "max_chunk": max_chunk,
        "max_attempts": 3,
        "max_faults": 3,
        "success_rule": "any_step",
        "action_space": {
            name: numbers(size, **bounds(size, -1, 1, "clip"))
            for name, size in observations.ACTION_SIZES.items()
        },
        "observation_space": {
            "state": {n: numbers(size) for n, size in observations.STATE_SIZES.items()},
            "images": {
                name: {"channels": 3, "description": "A table with boxes."}
                for name in shown.cameras
            },
            "tensors": {},
        },
        "image_sizes": image_sizes((shown.width or 16, shown.height or 16)),
        "image_codecs": ["raw", "jpeg"],
        "simulator": {"name": "still_life", "version": "1"},
    }


def _definition(scenario: str) -> BenchmarkDefinition:
    return BenchmarkDefinition(
        describe=partial(_describe, scenario),
        settings=lambda images: {**images, "success_scored_tasks": [TASK]},
        make=lambda _settings: StillLife(scenario),
    )


NAMES = observations.SCENARIOS
BENCHMARKS = {f"still_life_{name}": _definition(name) for name in NAMES}
