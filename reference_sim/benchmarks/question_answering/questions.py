"""The questions: how an item of each task is drawn, and its right answer.

The right answer is computed from the scene, never from the image. It is drawn first,
with every answer equally often in a block of BLOCK seeds: no constant answer is better
than chance. Then scenes are drawn until one fits, with a margin that excludes
ambiguity.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from reference_sim.benchmarks.question_answering.arrangement import (
    NOUNS,
    PALETTE,
    REACH_M,
    THINGS,
    Arrangement,
    arrange,
)
from reference_sim.benchmarks.question_answering.items import (
    BLOCK,
    LETTERS,
    NO_ANSWER,
    TASKS,
)
from reference_sim.benchmarks.tabletop.scene import TabletopScene
from reference_sim.interface import Action

_BY_LETTER = "Answer with the letter alone."
_BY_NUMBER = "Answer with the number alone."
_BY_POINT = (
    "Answer with x, y alone: 0, 0 is the upper left corner of the picture and 1, 1 the "
    "lower right one."
)
_SIDE_MARGIN = 0.08  # of the picture's width
_NEARER_M = 0.08
_IN_REACH_M, _OUT_OF_REACH_M = 0.68, 0.84
_TRIES = 1000


@dataclass(frozen=True, slots=True)
class Question:
    """text: the question. right: the right action; a point is that of an object."""

    text: str
    right: Action
    target: str | None = None

    def is_right(self, answer: Action, arrangement: Arrangement) -> bool:
        if self.target is not None:
            point = answer["point"]
            is_inside = all(0 <= coordinate <= 1 for coordinate in point)
            return is_inside and arrangement.body_at(point) == self.target
        return all(
            list(answer[name]) == list(right)
            for name, right in self.right.items()
            if list(right) != [NO_ANSWER] * len(right)
        )


def action(
    choice: float = NO_ANSWER,
    number: float = NO_ANSWER,
    point: Sequence[float] = (NO_ANSWER, NO_ANSWER),
) -> Action:
    """An action; omitted entries mean no answer."""
    return {"choice": [choice], "number": [number], "point": list(point)}


Draw = Callable[["ItemDraft"], "Question | None"]


@dataclass(frozen=True, slots=True)
class ItemDraft:
    """An attempt at an item: rank is the place of the right answer among `ranks`."""

    scene: TabletopScene
    rng: np.random.Generator
    split: str
    rank: int
    arrangement: list[Arrangement]

    def arrange(self, colours: dict[str, str]) -> Arrangement:
        self.arrangement[:] = [arrange(self.scene, self.rng, self.split, colours)]
        return self.arrangement[0]

    def things(self, number: int) -> list[str]:
        """Draw so many different objects, in random order."""
        return [str(thing) for thing in self.rng.permutation(THINGS)[:number]]

    def distinct(self, number: int) -> Arrangement:
        """Arrange so many objects, of which two cubes differ in colour."""
        while True:
            colours = {t: str(self.rng.choice(PALETTE)) for t in self.things(number)}
            if len({(NOUNS[t], c) for t, c in colours.items()}) == number:
                return self.arrange(colours)

    def lettered(self, right: str, wrong: Sequence[str]) -> str:
        """The options, the right one at its place."""
        options = list(wrong)
        options.insert(self.rank, right)
        return " ".join(
            f"{letter}) {option}"
            for letter, option in zip(LETTERS, options, strict=False)
        )


def draw(
    scene: TabletopScene, task: str, seed: int, split: str
) -> tuple[Question, Arrangement]:
    """The item of a task and seed; the scene is left as it shows. KeyError: no task."""
    ranks, attempt = _DRAWN[task]
    rng = np.random.Generator(np.random.PCG64([seed, TASKS.index(task)]))
    draft = ItemDraft(scene, rng, split, _rank(task, seed, ranks), [])
    for _ in range(_TRIES):
        question = attempt(draft)
        if question is not None and draft.arrangement[0].hides_nothing():
            return question, draft.arrangement[0]
    raise RuntimeError(f"no {task} could be drawn")


def _rank(task: str, seed: int, ranks: int) -> int:
    """Every rank equally often in a block of seeds, in a shuffled order."""
    block, place = divmod(seed, BLOCK)
    rng = np.random.Generator(np.random.PCG64([block, TASKS.index(task)]))
    return int(rng.permutation(BLOCK)[place]) % ranks


def _count(draft: ItemDraft) -> Question:
    colour, *others = (str(word) for word in draft.rng.permutation(PALETTE))
    things = draft.things(len(THINGS))
    colours = dict.fromkeys(things[: draft.rank], colour)
    colours |= {t: str(draft.rng.choice(others)) for t in things[draft.rank :]}
    draft.arrange({thing: colours[thing] for thing in THINGS})
    text = f"How many {colour} things are on the table? {_BY_NUMBER}"
    return Question(text, action(number=float(draft.rank)))


def _colour(draft: ItemDraft) -> Question | None:
    arrangement = draft.distinct(4)
    subject = arrangement.things[0]
    if sum(NOUNS[thing] == NOUNS[subject] for thing in arrangement.things) > 1:
        return None  # which cube?
    right = arrangement.colours[subject]
    wrong = [str(c) for c in draft.rng.permutation(PALETTE) if c != right][:3]
    options = draft.lettered(right, wrong)
    text = f"Which colour is the {NOUNS[subject]}? {options}. {_BY_LETTER}"
    return Question(text, action(choice=float(draft.rank)))


def _side(draft: ItemDraft) -> Question | None:
    arrangement = draft.distinct(4)
    left, right = sorted(
        arrangement.things[:2], key=lambda thing: arrangement.spot(thing)[0]
    )
    if arrangement.spot(right)[0] - arrangement.spot(left)[0] < _SIDE_MARGIN:
        return None
    subject, neighbour = (left, right) if draft.rank == 0 else (right, left)
    text = (
        f"In the picture, is {arrangement.name(subject)} to the left or to the right "
        f"of {arrangement.name(neighbour)}? A) left B) right. {_BY_LETTER}"
    )
    return Question(text, action(choice=float(draft.rank)))


def _nearest(draft: ItemDraft) -> Question | None:
    arrangement = draft.distinct(5)
    subject, *others = arrangement.things[:4]
    scene = arrangement.scene
    others.sort(key=lambda thing: scene.apart_level_m(subject, thing))
    near, second = (scene.apart_level_m(subject, thing) for thing in others[:2])
    if second - near < _NEARER_M:
        return None
    wrong = [str(thing) for thing in draft.rng.permutation(others[1:])]
    options = draft.lettered(
        arrangement.name(others[0]), [arrangement.name(t) for t in wrong]
    )
    name = arrangement.name(subject)
    text = f"Which of these is nearest to {name}? {options}. {_BY_LETTER}"
    return Question(text, action(choice=float(draft.rank)))


def _reachable(draft: ItemDraft) -> Question | None:
    arrangement = draft.distinct(4)
    subject = arrangement.things[0]
    distance = arrangement.from_foot_m(subject)
    is_so = distance <= _IN_REACH_M if draft.rank == 0 else distance >= _OUT_OF_REACH_M
    if not is_so:
        return None
    text = (
        f"The gripper reaches {REACH_M} m from the middle of the arm's round foot, "
        f"which is 0.17 m wide. Is {arrangement.name(subject)} in reach? A) yes B) no. "
        f"{_BY_LETTER}"
    )
    return Question(text, action(choice=float(draft.rank)))


def _point(draft: ItemDraft) -> Question:
    arrangement = draft.distinct(5)
    subject = arrangement.things[0]
    text = f"Point at {arrangement.name(subject)}. {_BY_POINT}"
    return Question(text, action(point=arrangement.spot(subject)), target=subject)


# Task → how many answers there are, and how an item of it is drawn.
_DRAWN: dict[str, tuple[int, Draw]] = {
    "count": (6, _count),
    "colour": (4, _colour),
    "side": (2, _side),
    "nearest": (3, _nearest),
    "reachable": (2, _reachable),
    "point": (1, _point),
}
