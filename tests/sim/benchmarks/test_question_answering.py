"""Questions about pictures: the truth is right, nothing else is; chance is chance."""

import colorsys
import itertools
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from reference_server.rules.runs.action_space import action_errors
from reference_sim import benchmark_registry
from reference_sim.benchmarks.question_answering.arrangement import (
    ASPECT,
    NOUNS,
    PALETTE,
    REACH_M,
)
from reference_sim.benchmarks.question_answering.items import (
    BLOCK,
    CAMERA,
    CHANCES,
    FIRST_SEEDS,
    LETTERS,
)
from reference_sim.benchmarks.question_answering.questions import action
from reference_sim.benchmarks.question_answering.simulator import QuestionSimulator
from reference_sim.benchmarks.tabletop.layout import JOINT_HIGH_RAD, JOINTS
from reference_sim.benchmarks.tabletop.scene import TabletopScene
from reference_sim.benchmarks.tabletop.variation import COLOURS
from reference_sim.episode import Episode
from reference_sim.interface import Action, TaskUnplayable

MANIFEST = benchmark_registry.resolve("question_answering").manifest
SMALL = (160, 120)
GRID = [(x / 20 + 0.025, y / 20 + 0.025) for x in range(20) for y in range(20)]


@dataclass(frozen=True)
class Item:
    """The facts of one item that tests need, noted while it stood."""

    task: str
    text: str
    truth: Action
    truth_scores: float
    nothing_scores: float
    target: str | None
    hits: frozenset[int]  # of GRID, what a point there would score
    hidden: list[str]


@pytest.fixture(scope="module")
def simulator() -> Iterator[QuestionSimulator]:
    made = QuestionSimulator(SMALL, "fast")
    yield made
    made.close()


@pytest.fixture(scope="module")
def items(simulator: QuestionSimulator) -> list[Item]:
    return [measure_item(simulator, plan) for plan in MANIFEST["episodes"]]


def measure_item(simulator: QuestionSimulator, plan: dict[str, Any]) -> Item:
    text = simulator.reset(plan["task"], plan["seed"], plan["split"])
    assert simulator._item is not None
    question, shown = simulator._item
    hits: set[int] = set()
    if question.target is not None:
        points = enumerate(GRID)
        hits = {i for i, p in points if simulator.step(action(point=p)).success}
    return Item(
        plan["task"],
        text,
        simulator.truth(),
        simulator.step(simulator.truth()).score,
        simulator.step(action()).score,
        question.target,
        frozenset(hits),
        [t for t in shown.things if shown.body_at(shown.spot(t)) != t],
    )


def by_task(items: list[Item]) -> dict[str, list[Item]]:
    found: dict[str, list[Item]] = defaultdict(list)
    for item in items:
        found[item.task].append(item)
    return found


# --- what is right ---


def test_the_truth_scores_one_on_every_item(items: list[Item]) -> None:
    assert len(items) == MANIFEST["episodes_total"] == 2 * BLOCK * len(CHANCES)
    assert {item.truth_scores for item in items} == {1.0}
    assert {item.nothing_scores for item in items} == {0.0}


def test_a_constant_answer_is_no_better_than_chance(items: list[Item]) -> None:
    """Every letter, every count, every point of a grid, over the items of a task."""
    for task, task_items in by_task(items).items():
        if task == "point":
            best = max(Counter(i for item in task_items for i in item.hits).values())
            assert 0 < best / len(task_items) <= CHANCES[task]
            continue
        answers = Counter(
            (tuple(item.truth["choice"]), tuple(item.truth["number"]))
            for item in task_items
        )
        # Balanced, not only on the average: each right answer comes as often.
        assert set(answers.values()) == {round(CHANCES[task] * len(task_items))}, task


def test_the_order_of_answers_has_no_period(items: list[Item]) -> None:
    """The order of right answers has no period, in which the manifest's would show."""
    for task, task_items in by_task(items).items():
        if task == "point":
            continue
        answers = [(item.truth["choice"], item.truth["number"]) for item in task_items]
        period = round(1 / CHANCES[task])
        repeats = [a == b for a, b in itertools.pairwise(answers[::period])]
        assert not all(repeats), task


def test_no_other_answer_is_right(simulator: QuestionSimulator) -> None:
    """Answers beside the truth, in the wrong entry, and between two letters."""
    for task in CHANCES:
        simulator.reset(task, 6000, "val")
        truth = simulator.truth()
        choice, number = truth["choice"][0], truth["number"][0]
        wrong = [
            action(choice=choice + 0.5),
            action(choice=(choice + 1) % 4),
            action(number=number + 1),
            action(number=choice),
            action(choice=number, point=(0.001, 0.001)),
            action(point=(0.001, 0.001)),
        ]
        for answer in wrong:
            assert simulator.step(answer).score == 0.0, (task, answer)


# --- what is seen ---


def test_every_object_is_visible(items: list[Item]) -> None:
    assert [item.text for item in items if item.hidden] == []


def test_the_picture_matches_the_arrangement(simulator: QuestionSimulator) -> None:
    """The pixel at each thing's middle has the hue of its colour, in both splits."""
    seen: Counter[str] = Counter()
    for task, split in (("count", "val"), ("count", "test"), ("point", "test")):
        simulator.reset(task, FIRST_SEEDS[split] + 3, split)
        picture = simulator.observe().images[CAMERA]
        assert picture.shape == (SMALL[1], SMALL[0], 3)
        assert simulator._item is not None
        _, shown = simulator._item
        for thing in shown.things:
            x, y = shown.spot(thing)
            pixel = picture[int(y * SMALL[1]), int(x * SMALL[0])] / 255
            assert nearest_colour(pixel) == shown.colours[thing], (task, thing)
            seen[NOUNS[thing]] += 1
    assert set(seen) == set(NOUNS.values())


def nearest_colour(pixel: np.ndarray[Any, Any]) -> str:
    hue = colorsys.rgb_to_hsv(*pixel)[0]

    def apart(word: str) -> float:
        other = colorsys.rgb_to_hsv(*COLOURS[word][:3])[0]
        return min(abs(hue - other), 1 - abs(hue - other))

    return min(PALETTE, key=apart)


@pytest.mark.slow("draws for a second")
def test_a_point_is_judged_as_it_is_drawn(simulator: QuestionSimulator) -> None:
    """The target is painted anew: the pixels that change are those it may be found at.
    A ray through a pixel's middle meets what is drawn there; edges may differ."""
    width, height = SMALL
    for seed in range(6000, 6006):
        simulator.reset("point", seed, "val")
        assert simulator._item is not None
        question, shown = simulator._item
        assert question.target is not None
        before = simulator.observe().images[CAMERA].copy()
        shown.scene.world.set_geom_rgba(question.target, (0.0, 0.0, 0.0, 1.0))
        drawn = (simulator.observe().images[CAMERA] != before).any(axis=2)
        found = np.zeros_like(drawn)
        for x, y in itertools.product(range(width), range(height)):
            spot = ((x + 0.5) / width, (y + 0.5) / height)
            found[y, x] = simulator.step(action(point=spot)).success
        assert drawn.sum() > 5
        assert (drawn != found).sum() <= 0.25 * drawn.sum()


def test_the_stated_reach_is_that_of_the_arm() -> None:
    """The arm is stretched and lowered to the table: it ends near REACH_M."""
    scene = TabletopScene()
    reached = []
    for elbow in np.linspace(0, 1, 1000):
        posture = (0, JOINT_HIGH_RAD[1], 0, elbow, 0, 0, 0)
        scene.world.set_joint_positions(JOINTS, posture)
        scene.world.forward_poses()
        x, y, z = scene.position("tcp")
        if 0 < z < 0.04:
            reached.append(float(np.hypot(x, y)))
    assert abs(float(np.mean(reached)) - REACH_M) < 0.01


# --- what is asked ---


def test_questions_state_the_answer_format(items: list[Item]) -> None:
    for item in items:
        if item.task == "count":
            assert item.text.endswith("Answer with the number alone.")
        elif item.task == "point":
            assert "Answer with x, y alone" in item.text
        else:
            assert item.text.endswith("Answer with the letter alone.")
            letter = LETTERS[int(item.truth["choice"][0])]
            assert f" {letter}) " in item.text
    assert len({item.text for item in items}) > len(items) // 2


def test_every_truth_fits_the_action_space(items: list[Item]) -> None:
    for item in items:
        assert action_errors([item.truth], MANIFEST) == []
    assert action_errors([action()], MANIFEST) == []
    assert action_errors([action(choice=4)], MANIFEST) != []


def test_pictures_have_one_shape() -> None:
    for size in MANIFEST["image_sizes"]:
        assert size["width"] / size["height"] == ASPECT


# --- as an episode ---


def test_the_same_seed_is_the_same_item_and_another_is_not(
    simulator: QuestionSimulator,
) -> None:
    def item(seed: int, split: str) -> tuple[str, bytes]:
        text = simulator.reset("nearest", seed, split)
        return text, simulator.observe().images[CAMERA].tobytes()

    first, other = item(6000, "val"), item(6001, "val")
    assert item(6000, "val") == first
    assert other[1] != first[1]
    assert item(6000, "test")[1] != first[1]  # another camera


def test_an_item_is_an_episode_of_one_step() -> None:
    resolved = benchmark_registry.resolve("question_answering")
    assert resolved.images == {"codec": "png", "width": 640, "height": 480}
    simulator = benchmark_registry.make(resolved.world)
    assert isinstance(simulator, QuestionSimulator)
    for answer in ("truth", "none"):
        episode = Episode(
            simulator,
            "side",
            6000,
            split="val",
            max_steps=MANIFEST["max_steps"],
            success_rule=MANIFEST["success_rule"],
        )
        given = simulator.truth() if answer == "truth" else action()
        assert list(episode.play([given])) == [0.0]
        is_right = answer == "truth"
        assert (episode.success, episode.score) == (is_right, float(is_right))
        assert (episode.ended, episode.terminated, episode.steps) == (True, True, 1)
    simulator.close()


def test_an_unknown_task_is_unplayable_in_question_answering(
    simulator: QuestionSimulator,
) -> None:
    with pytest.raises(TaskUnplayable):
        simulator.reset("riddle", 1)
    with pytest.raises(RuntimeError, match="reset comes before"):
        QuestionSimulator(SMALL, "fast").truth()
