"""The simulator of `question_answering`: an item is an episode of one step.

The image is the observation, the answer is the action. It must not know how an answer
is made: texts, parsers and models are the policy's. The picture of an item is the same
in every evaluation: it is drawn once, and then taken from the picture store.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from reference_sim.benchmarks.question_answering.arrangement import Arrangement
from reference_sim.benchmarks.question_answering.items import (
    BLOCK,
    CAMERA,
    FIRST_SEEDS,
    QUALITY,
    TASKS,
)
from reference_sim.benchmarks.question_answering.questions import Question, draw
from reference_sim.benchmarks.tabletop.scene import TabletopScene
from reference_sim.interface import Action, Observation, StepOutcome, TaskUnplayable
from reference_sim.picture_store import PICTURES


class QuestionSimulator:
    """Plays an item; the score is 1 for the right answer, otherwise 0."""

    def __init__(self, size: tuple[int, int], quality: str = QUALITY) -> None:
        """size: width and height of the image, 4 to 3."""
        self._scene = TabletopScene(quality)
        self._quality = quality
        self._size = size
        self._plan = ("", 0, "")
        self._item: tuple[Question, Arrangement] | None = None
        self._is_answered = False

    def reset(self, task: str, seed: int, split: str = "") -> str:
        """Draws the item; returns the question. Raises TaskUnplayable."""
        if task not in TASKS:
            raise TaskUnplayable(f"there is no task {task}")
        self._item = draw(self._scene, task, seed, split)
        self._plan = (task, seed, split)
        self._is_answered = False
        return self._item[0].text

    def step(self, action: Action) -> StepOutcome:
        question, arrangement = self._require_item()
        is_right = question.is_right(action, arrangement)
        self._is_answered = True
        return StepOutcome(success=is_right, score=float(is_right), terminated=True)

    def observe(self) -> Observation:
        _, arrangement = self._require_item()
        return Observation(state={}, images={CAMERA: self._picture(arrangement)})

    def _picture(self, arrangement: Arrangement) -> NDArray[np.uint8]:
        """The picture of the item, drawn if it is not stored."""
        slot = _slot(*self._plan)
        if slot is None:
            return arrangement.picture(*self._size)
        width, height = self._size
        key = f"{self._quality} {self._plan} {width} {height}"
        picture = PICTURES.find(slot, key, (height, width, 3))
        if picture is None:
            picture = arrangement.picture(width, height)
            PICTURES.put(slot, key, picture)
        return picture

    def state_bytes(self) -> bytes:
        """The question and its picture, and whether it was answered.

        The seed is left out: the digest of these bytes is published, and a seed has so
        few bits that it could be found by trying all of them.
        """
        question, arrangement = self._require_item()
        spots = [arrangement.spot(thing) for thing in arrangement.things]
        shown = question.text, dict(arrangement.colours), spots, self._is_answered
        return self._scene.world.snapshot().tobytes() + repr(shown).encode()

    def truth(self) -> Action:
        """The right answer, for tests; not part of the Simulator interface."""
        return self._require_item()[0].right

    def close(self) -> None:
        self._scene.world.close()

    def _require_item(self) -> tuple[Question, Arrangement]:
        if self._item is None:
            raise RuntimeError("reset comes before step, observe and truth")
        return self._item


def _slot(task: str, seed: int, split: str) -> int | None:
    """The place of an item among those of a manifest; None if the split is in none.

    A split is one whole block of seeds, wherever a host has drawn it.
    """
    if split not in FIRST_SEEDS:
        return None
    block = list(FIRST_SEEDS).index(split) * BLOCK
    return (block + seed % BLOCK) * len(TASKS) + TASKS.index(task)
