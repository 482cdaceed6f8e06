"""Scores: of an episode, of a run, and of what is there so far (SCORE).

The task `score` gives an episode the score that is commanded, so any pattern of
outcomes can be played; what it must come to is worked out in
`oracle/expected_score.py`.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from hypothesis import strategies as st

from conformance.checks.support.generated_examples import for_all
from conformance.checks.support.given_states import (
    index_of,
    playing,
    results,
    run_in,
    without,
)
from conformance.client.check_context import Run, Story, Worker
from conformance.oracle.expected_score import expected_score, is_close
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed


@dataclass(frozen=True)
class Trial:
    """What is to become of an episode; an outcome of None leaves it unscored."""

    outcome: str | None
    score: float = 0.0
    task: str = "score"


WON, LOST, LEFT = Trial("success", 0.9), Trial("failure", 0.2), Trial(None)
GIVEN_UP = Trial("abandoned", 0.7)


class Game:
    """A run that is played trial by trial, and what its score must be."""

    def __init__(self, story: Story, trials: Sequence[Trial]) -> None:
        self.run: Run = story.submit(*[t.task for t in trials], max_attempts=1)
        self.played = 0
        self._story = story
        self._trials = trials
        self._worker: Worker | None = None

    def play_next(self) -> None:
        """Play one episode to the outcome that is planned."""
        if self._worker is None:
            self._worker = self.run.worker()
            self._worker.attach()
        if index_of(self._worker) != self.played:
            raise SetUpFailed("episodes come in another order; see EPI-001")
        trial = self._trials[self.played]
        is_given_up = trial.outcome == "abandoned"
        self._worker.predict(
            self._story.action(
                score=trial.score,
                success=int(trial.outcome == "success"),
                end=int(not is_given_up),
            )
        )
        if is_given_up:
            self._worker.detach()
            self._worker = None
            result = results(self.run)[self.played]
            if result is None or result["outcome"] != "abandoned":
                raise SetUpFailed("the last attempt is not abandoned; see EPI-004")
        self.played += 1

    def play_all(self) -> dict[str, Any]:
        """Play up to the first trial that is to be left; the score then."""
        while self.played < len(self._trials) and self._trials[self.played].outcome:
            self.play_next()
        return self.score()

    def score(self) -> dict[str, Any]:
        """Read the score, whose members are what is under test."""
        return expect.Expected(self.run.score())

    def expected(self) -> dict[str, Any]:
        """Work out the score, of what was played so far."""
        return expected_score(self.episodes())

    def episodes(self) -> list[dict[str, Any]]:
        """Give what was played so far in the format of the scoring vectors."""
        return [
            {
                "task": trial.task,
                "split": ("even", "odd")[index % 2],
                "outcome": trial.outcome if index < self.played else None,
                "score": _earned(trial),
            }
            for index, trial in enumerate(self._trials)
        ]


def _earned(trial: Trial) -> float:
    return trial.score if trial.task == "score" else float(trial.outcome == "success")


def close(observed: object, expected: Fraction | float | None, what: str) -> None:
    """Expect a number, as exactly as the rules ask for."""
    shown = None if expected is None else float(expected)
    expect.true(is_close(observed, expected), f"{what} = {shown}", [observed])


def close_interval(observed: Any, expected: dict[str, float], what: str) -> None:
    """Expect both ends of an interval."""
    for end in ("low", "high"):
        close(observed[end], expected[end], f"{what}.{end}")


def outcomes(story: Story, rule: str, patterns: Sequence[Sequence[float]]) -> list[str]:
    """Play episodes of at most three steps, whose goal holds as given step by step."""
    worker = playing(story, *["score"] * len(patterns), max_steps=3, success_rule=rule)
    found: list[str] = []
    for pattern in patterns:
        chunk = [story.action(success=goal) for goal in pattern]
        chunk[-1]["values"]["end"] = [float(len(pattern) < 3)]
        turn = worker.predict(*chunk)
        found.append(turn["episode_result"]["outcome"])
    return found


@requirement("SCORE-001")
def test_score_001_lies_between_0_and_1(story: Story) -> None:
    """Episodes of every task, of several steps, whose every step is worth 1, or 0.

    Expect no score outside [0, 1].
    """
    tasks = ["score", "count", "echo", "delay", "fault"] * 2
    worker = playing(story, *tasks)
    for index in range(len(tasks)):
        value = float(index < len(tasks) / 2)
        result = worker.play(score=value, success=value, steps=3)["episode_result"]
        score = result["score"]
        expect.true(0 <= score <= 1, "a score in [0, 1]", score)


@requirement("SCORE-002")
def test_score_002_any_step(story: Story) -> None:
    """Rule `any_step`; the goal holds first, last, in between, nearly, and never.

    Expect a success exactly where it held after some step.
    """
    patterns: list[list[float]] = [[1, 0], [0, 1], [0, 1, 0], [0.999, 0.5], [0, 0, 0]]
    found = outcomes(story, "any_step", patterns)
    expect.equal(found, ["success"] * 3 + ["failure"] * 2, "outcomes")


@requirement("SCORE-003")
def test_score_003_last_step(story: Story) -> None:
    """Rule `last_step`; the goal holds first, in between, never, and in the end.

    Expect a success exactly where it held after the last step.
    """
    patterns = [[1, 0], [1, 1, 0], [0, 0], [0, 1], [0, 0, 1], [1]]
    found = outcomes(story, "last_step", patterns)
    expect.equal(found, ["failure"] * 3 + ["success"] * 3, "outcomes")


@requirement("SCORE-004")
def test_score_004_abandoned_counts_as_zero(story: Story) -> None:
    """Two runs: in one an episode is abandoned, in the other it fails with score 0.

    Expect the same score, mean, rate and intervals, and one success in each.
    """
    abandoned = Game(story, [WON, GIVEN_UP])
    failed = Game(story, [WON, Trial("failure", 0.0)])
    scores = [
        without(
            game.play_all(),
            "run_id",
            "manifest_sha256",
            "by_task",
            "by_split",
            "counts",
        )
        for game in (abandoned, failed)
    ]
    expect.equal(scores[0], scores[1], "score of the run with an abandoned episode")
    expect.equal(abandoned.score()["counts"]["success"], 1, "counts.success")


@requirement("SCORE-005")
def test_score_005_complete_when_all_are_scored(story: Story) -> None:
    """Three episodes are played, the last one is abandoned.

    Expect `complete` only after the third.
    """
    game = Game(story, [WON, LOST, GIVEN_UP])
    for _ in range(3):
        expect.equal(game.score()["complete"], False, f"complete after {game.played}")
        game.play_next()
    expect.equal(game.score()["complete"], True, "complete after all three")


TRIAL = st.builds(
    Trial,
    st.sampled_from(["success", "failure", "abandoned"]),
    st.one_of(st.floats(0, 1), st.sampled_from([0.1, 0.2, 0.3, 1 / 3])),
    st.sampled_from(["score", "score", "count"]),
)
TRIALS = st.lists(TRIAL, min_size=1, max_size=40)


@requirement("SCORE-006")
def test_score_006_is_the_mean_of_all_episodes(story: Story) -> None:
    """Runs of up to forty episodes of two tasks, with generated outcomes.

    Expect null while one is missing; then the mean over the episodes, within 1e-12.
    """

    def law(trials: list[Trial]) -> None:
        game = Game(story, trials)
        while game.played < len(trials) - 1:
            game.play_next()
        expect.equal(game.score()["score"], None, "score while one is missing")
        close(game.play_all()["score"], game.expected()["score"], "score")

    for_all(story, TRIALS, law, times=8)


@requirement("SCORE-007")
def test_score_007_bounds_what_can_come(story: Story) -> None:
    """Five episodes, one after another, abandoned ones among them.

    Expect the bounds after each: the missing ones count as 0, or as 1.
    """
    game = Game(story, [WON, GIVEN_UP, LOST, WON, LOST])
    for _ in range(6):
        score, expected = game.score(), game.expected()
        for member in ("score_low", "score_high"):
            close(score[member], expected[member], f"{member} after {game.played}")
        if game.played < 5:
            game.play_next()


@requirement("SCORE-008")
def test_score_008_counts_every_outcome(story: Story) -> None:
    """Eight episodes: three successes, a failure, two abandoned, two not played.

    Expect these counts, which add up to eight.
    """
    game = Game(story, [WON, LOST, GIVEN_UP, WON, WON, GIVEN_UP, LEFT, LEFT])
    counts = game.play_all()["counts"]
    for name, number in game.expected()["counts"].items():
        expect.equal(counts[name], number, f"counts.{name}")


@requirement("SCORE-009")
def test_score_009_mean_and_rate_of_what_is_scored(story: Story) -> None:
    """Five of seven episodes are played.

    Expect mean and rate null before the first; then those of the scored ones.
    """
    game = Game(story, [LOST, WON, GIVEN_UP, WON, LOST, LEFT, LEFT])
    before = game.score()
    after, expected = game.play_all(), game.expected()
    for member in ("mean", "success_rate"):
        expect.equal(before[member], None, f"{member} before the first")
        close(after[member], expected[member], member)


@requirement("SCORE-010")
def test_score_010_answers_in_every_state(story: Story) -> None:
    """A run in each of the seven states. Expect an answer in each."""
    for state in story.spec.lifecycle["states"]:
        run = run_in(story, state)
        expect.ok(run.call("get_score"))


@requirement("SCORE-011")
def test_score_011_groups_by_task_and_split(story: Story) -> None:
    """Tasks with three, two and one episode, the last one not played.

    Expect each task and each split once, with counts, mean and rate of its episodes.
    """
    trials = [WON, LOST, GIVEN_UP]
    trials += [Trial("success", task="count"), Trial("failure", task="count")]
    game = Game(story, [*trials, Trial(None, task="echo")])
    score, expected = game.play_all(), game.expected()
    for member in ("by_task", "by_split"):
        expect.equal(sorted(score[member]), sorted(expected[member]), member)
        for name, group in expected[member].items():
            found, what = score[member][name], f"{member}.{name}"
            expect.equal(without(found["counts"]), group["counts"], f"{what}.counts")
            for number in ("mean", "success_rate"):
                close(found[number], group[number], f"{what}.{number}")


def judge_interval(game: Game, trials: int, member: str) -> None:
    """Expect the interval before the first trial and after each."""
    for _ in range(trials + 1):
        what = f"{member} after {game.played}"
        close_interval(game.score()[member], game.expected()[member], what)
        if game.played < trials:
            game.play_next()


@requirement("SCORE-012")
def test_score_012_interval_of_the_rate(story: Story) -> None:
    """Six episodes, one after another, and a run in which every one succeeds.

    Expect [0, 1] before the first, and the Wilson interval of the rate after each.
    """
    for trials in ([LOST, LOST, WON, GIVEN_UP, WON, LOST], [WON, WON, WON]):
        judge_interval(Game(story, trials), len(trials), "success_interval")


@requirement("SCORE-013")
def test_score_013_interval_of_the_mean(story: Story) -> None:
    """Episodes worth 0.2, 0.9 and 0, one after another, and one worth 1.

    Expect [0, 1] before the first, and the Wilson interval of the mean after each.
    """
    for trials in ([LOST, WON, GIVEN_UP, WON], [Trial("failure", 1.0)]):
        judge_interval(Game(story, trials), len(trials), "mean_interval")
