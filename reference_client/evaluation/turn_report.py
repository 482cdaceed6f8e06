"""A worker's latest turn for the live view: small images, texts and times.

Made on request only, from the snapshot that the worker stores.
"""

from __future__ import annotations

import base64
import io
from collections import deque
from collections.abc import Iterable, Sequence
from typing import Any, TypedDict

import numpy as np
import numpy.typing as npt

from reference_client.evaluation.status_board import TurnSnapshot
from reference_record.texts.figures import figure

WIDTH_MAX = 320  # pixels, of a picture on the page
NUMBERS_MAX = 12  # of one vector
RESULTS_MAX = 50


class EpisodeOutcome(TypedDict):
    """The result of an episode, as the live view lists it."""

    episode_id: str
    task: str
    outcome: str
    score: str
    steps: int


class TurnReport(TypedDict):
    """A turn for the live view: texts, times in seconds, JPEG in base64 by camera.

    values: the numbers of the state and of the last action, as text by name.
    """

    values: dict[str, str]
    fault: str
    instruction: str
    episode_id: str
    step: int
    task: str
    think_s: float
    server_s: float
    wire_s: float
    done: bool
    images: dict[str, str]
    results: list[EpisodeOutcome]


class LatestTurn:
    """One worker's data for the live view: its latest turn and its last results."""

    def __init__(self) -> None:
        self._snapshot: TurnSnapshot | None = None
        self._results: deque[EpisodeOutcome] = deque(maxlen=RESULTS_MAX)

    def keep(self, snapshot: TurnSnapshot) -> None:
        self._snapshot = snapshot
        if result := snapshot.turn.episode_result:
            self._results.append(
                {
                    "episode_id": result.episode_id,
                    "task": result.task,
                    "outcome": result.outcome,
                    "score": figure(result.score, 3),
                    "steps": result.steps,
                }
            )

    def describe(self) -> TurnReport | None:
        """The latest turn; None before the first."""
        if self._snapshot is None:
            return None
        return describe_turn(self._snapshot, self._results)


def describe_turn(
    snapshot: TurnSnapshot, results: Iterable[EpisodeOutcome] = ()
) -> TurnReport:
    """A turn, with the last results of its worker."""
    turn, observation = snapshot.turn, snapshot.observation
    values = {name: _numbers(vector) for name, vector in observation.state.items()}
    if snapshot.actions:
        last = snapshot.actions[-1]["values"]
        values |= {f"action: {name}": _numbers(last[name]) for name in last}
    return {
        "values": values,
        "fault": turn.fault.detail if turn.fault else "",
        "instruction": observation.instruction,
        "episode_id": observation.episode_id,
        "step": observation.step + turn.executed_steps,
        "task": turn.episode.task if turn.episode else "",
        "think_s": snapshot.think_s,
        "server_s": turn.timing.total_s,
        "wire_s": max(0.0, snapshot.turn_s - turn.timing.total_s),
        "done": turn.done,
        "images": {
            name: _jpeg(picture) for name, picture in observation.images.items()
        },
        "results": list(results),
    }


def _numbers(vector: Sequence[float] | npt.NDArray[Any]) -> str:
    shown = " ".join(f"{number:.3f}" for number in vector[:NUMBERS_MAX])
    return shown if len(vector) <= NUMBERS_MAX else f"{shown} … ({len(vector)})"


def _jpeg(picture: npt.NDArray[np.uint8]) -> str:
    import PIL.Image

    flat = picture[:, :, 0] if picture.shape[2] < 3 else picture[:, :, :3]
    every = -(-picture.shape[1] // WIDTH_MAX)
    image = PIL.Image.fromarray(np.ascontiguousarray(flat[::every, ::every]))
    file = io.BytesIO()
    image.save(file, "JPEG", quality=80)
    return base64.b64encode(file.getvalue()).decode()
