"""Counting, truncation, the success rule and the score, with a scripted simulator."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import msgspec
import pytest

from reference_sim.episode import Episode
from reference_sim.interface import Action, Observation, StepOutcome, TaskUnplayable

STEP: Action = {"nothing": [0.0]}


@dataclass
class ScriptedSimulator:
    """`Simulator` whose outcomes are given beforehand."""

    outcomes: Sequence[StepOutcome]
    stages: Sequence[str] = ()
    steps: int = 0
    resets: list[tuple[str, int]] = field(default_factory=list)

    def reset(self, task: str, seed: int, split: str = "") -> str:
        if task == "broken":
            raise TaskUnplayable("an asset is missing")
        self.resets.append((task, seed))
        return f"Do {task}."

    def step(self, action: Action) -> StepOutcome:
        assert action is STEP
        self.steps += 1
        return self.outcomes[self.steps - 1]

    def observe(self) -> Observation:
        raise AssertionError("an episode does not look")

    def state_bytes(self) -> bytes:
        raise AssertionError("an episode does not look")

    def close(self) -> None: ...


def outcomes(
    flags: str, scores: Sequence[float] = (), terminated_at: int = 0
) -> list[StepOutcome]:
    """One per letter: `+` the goal holds, `-` it does not."""
    return [
        StepOutcome(
            success=flag == "+",
            score=scores[index] if scores else 0.5,
            terminated=index + 1 == terminated_at,
            reward=index + 0.25,
        )
        for index, flag in enumerate(flags)
    ]


def begin(
    script: Sequence[StepOutcome], **how: Any
) -> tuple[Episode, ScriptedSimulator]:
    simulator = ScriptedSimulator(script)
    given: dict[str, Any] = {"max_steps": 10, "success_rule": "any_step"} | how
    return Episode(simulator, "stack", 7, **given), simulator


def test_begins_with_a_reset_and_the_instruction() -> None:
    episode, simulator = begin([])
    assert simulator.resets == [("stack", 7)]
    assert episode.instruction == "Do stack."
    assert (episode.steps, episode.score, episode.success) == (0, 0.0, False)
    assert not episode.ended


def test_executes_a_chunk_in_order_and_yields_its_rewards() -> None:
    episode, _ = begin(outcomes("---"))
    assert list(episode.play([STEP] * 3)) == [0.25, 1.25, 2.25]
    assert episode.steps == 3


def test_a_chunk_of_k_is_k_single_steps() -> None:
    script = outcomes("-+-", [0.1, 0.7, 0.4], terminated_at=3)
    at_once, _ = begin(script)
    one_by_one, _ = begin(script)
    list(at_once.play([STEP] * 3))
    for _ in range(3):
        list(one_by_one.play([STEP]))
    for name in ("steps", "success", "score", "terminated", "truncated"):
        assert getattr(at_once, name) == getattr(one_by_one, name)


def test_stops_when_the_task_ends_itself() -> None:
    episode, simulator = begin(outcomes("-----", terminated_at=2))
    assert len(list(episode.play([STEP] * 5))) == 2
    assert (episode.terminated, episode.truncated) == (True, False)
    assert simulator.steps == 2


def test_stops_at_the_step_limit() -> None:
    episode, simulator = begin(outcomes("-----"), max_steps=3)
    assert len(list(episode.play([STEP] * 5))) == 3
    assert (episode.terminated, episode.truncated) == (False, True)
    assert simulator.steps == 3


def test_a_task_that_ends_itself_at_the_last_step_is_not_truncated() -> None:
    episode, _ = begin(outcomes("---", terminated_at=3), max_steps=3)
    list(episode.play([STEP] * 3))
    assert (episode.terminated, episode.truncated) == (True, False)


def test_executes_nothing_after_the_end() -> None:
    episode, simulator = begin(outcomes("--"), max_steps=1)
    list(episode.play([STEP]))
    assert list(episode.play([STEP])) == []
    assert (simulator.steps, episode.steps) == (1, 1)


@pytest.mark.parametrize(
    ("flags", "any_step", "last_step"),
    [("---", 0, 0), ("+--", 1, 0), ("--+", 1, 1), ("+-+", 1, 1)],
)
def test_success_follows_the_rule(flags: str, any_step: int, last_step: int) -> None:
    for rule, expected in {"any_step": any_step, "last_step": last_step}.items():
        episode, _ = begin(outcomes(flags), success_rule=rule)
        list(episode.play([STEP] * 3))
        assert episode.success is bool(expected)


def test_the_score_is_the_last_one_reported() -> None:
    episode, _ = begin(outcomes("+--", [0.2, 0.9, 0.4]))
    list(episode.play([STEP] * 3))
    assert episode.score == 0.4


@pytest.mark.parametrize(("rule", "score"), [("any_step", 1.0), ("last_step", 0.0)])
def test_a_score_that_is_success_follows_the_rule(rule: str, score: float) -> None:
    script = outcomes("+-", [0.3, 0.3])
    episode, _ = begin(script, success_rule=rule, score_is_success=True)
    list(episode.play([STEP] * 2))
    assert episode.score == score


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"score": -0.01}, "score -0.01 is outside 0"),
        ({"score": 1.01}, "score 1.01 is outside 0"),
        ({"score": float("nan")}, r"score is nan \(float\), and must be a finite"),
        ({"reward": float("inf")}, r"reward is inf \(float\), and must be a finite"),
        ({"success": "no"}, r"success is 'no' \(str\), and must be true or false"),
        ({"terminated": [False]}, r"terminated is \[False\] \(list\), and must be"),
    ],
)
def test_a_wrong_value_of_a_step_is_the_simulators_fault(
    changed: dict[str, Any], said: str
) -> None:
    (right,) = outcomes("-")
    episode, _ = begin([msgspec.structs.replace(right, **changed)])
    with pytest.raises(ValueError, match=said):
        list(episode.play([STEP]))
    assert (episode.steps, episode.success) == (0, False)


@pytest.mark.parametrize(
    ("success", "score", "fits"),
    [
        (False, 0.0, True),
        (False, 0.25, True),
        (False, 0.75 - 1e-9, True),
        (True, 1.0, True),
        (False, 1 / 3, False),
        (False, 2 / 3, False),
        (False, 1.0, False),
        (True, 0.75, False),
        (True, 0.0, False),
    ],
)
def test_a_score_counts_the_stages_that_are_named(
    success: bool, score: float, fits: bool
) -> None:
    """Three stages and the goal are four quarters."""
    (right,) = outcomes("-")
    outcome = msgspec.structs.replace(right, success=success, score=score)
    simulator = ScriptedSimulator([outcome], stages=("near", "held", "lifted"))
    episode = Episode(simulator, "stack", 7, max_steps=9, success_rule="any_step")
    if fits:
        list(episode.play([STEP]))
        assert episode.score == score
        return
    said = r"does not count the stages near, held, lifted: it must be k/4 after"
    with pytest.raises(ValueError, match=said):
        list(episode.play([STEP]))


@pytest.mark.parametrize("stages", [("near", "goal"), ("near", "near"), ("near", "")])
def test_the_goal_is_no_stage(stages: tuple[str, ...]) -> None:
    simulator = ScriptedSimulator([], stages=stages)
    with pytest.raises(
        ValueError, match="none of them empty or `goal`: the goal comes"
    ):
        Episode(simulator, "stack", 7, max_steps=9, success_rule="any_step")


def test_an_unknown_success_rule_is_refused() -> None:
    with pytest.raises(ValueError, match="success rule"):
        begin([], success_rule="sometimes")


def test_an_unplayable_task_says_so() -> None:
    simulator = ScriptedSimulator([])
    with pytest.raises(TaskUnplayable):
        Episode(simulator, "broken", 1, max_steps=1, success_rule="any_step")
