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
    make_run_in_state,
    results,
    submit_and_attach,
    without,
)
from conformance.client.check_context import CheckContext, RunClient, WorkerClient
from conformance.oracle.expected_score import expected_score, is_close
from conformance.runner.requirement import requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed


@dataclass(frozen=True)
class PlannedEpisode:
    """What is to become of an episode; an outcome of None leaves it unscored."""

    outcome: str | None
    score: float = 0.0
    task: str = "score"


SUCCESS, FAILURE, UNPLAYED = (
    PlannedEpisode("success", 0.9),
    PlannedEpisode("failure", 0.2),
    PlannedEpisode(None),
)
ABANDONED = PlannedEpisode("abandoned", 0.7)


class PlannedRun:
    """A run that is played trial by trial, and what its score must be."""

    def __init__(self, context: CheckContext, plan: Sequence[PlannedEpisode]) -> None:
        self.run: RunClient = context.submit(*[t.task for t in plan], max_attempts=1)
        self.played = 0
        self._story = context
        self._plan = plan
        self._worker: WorkerClient | None = None

    def play_next(self) -> None:
        """Play one episode to the outcome that is planned."""
        if self._worker is None:
            self._worker = self.run.worker()
            self._worker.attach()
        if index_of(self._worker) != self.played:
            raise SetUpFailed("episodes come in another order; see EPI-001")
        planned_episode = self._plan[self.played]
        is_abandoned = planned_episode.outcome == "abandoned"
        self._worker.predict(
            self._story.action(
                score=planned_episode.score,
                success=int(planned_episode.outcome == "success"),
                end=int(not is_abandoned),
            )
        )
        if is_abandoned:
            self._worker.detach()
            self._worker = None
            result = results(self.run)[self.played]
            if result is None or result["outcome"] != "abandoned":
                raise SetUpFailed("the last attempt is not abandoned; see EPI-004")
        self.played += 1

    def play_all(self) -> dict[str, Any]:
        """Play up to the first trial that is to be left; the score then."""
        while self.played < len(self._plan) and self._plan[self.played].outcome:
            self.play_next()
        return self.score()

    def score(self) -> dict[str, Any]:
        """Read the score, whose members are what is under test."""
        return expect.ExpectedBody(self.run.score())

    def expected(self) -> dict[str, Any]:
        """Work out the score, of what was played so far."""
        return expected_score(self.episodes())

    def episodes(self) -> list[dict[str, Any]]:
        """Give what was played so far in the format of the scoring vectors."""
        return [
            {
                "task": planned_episode.task,
                "split": ("even", "odd")[index % 2],
                "outcome": planned_episode.outcome if index < self.played else None,
                "score": _score_of(planned_episode),
            }
            for index, planned_episode in enumerate(self._plan)
        ]


def _score_of(planned_episode: PlannedEpisode) -> float:
    return (
        planned_episode.score
        if planned_episode.task == "score"
        else float(planned_episode.outcome == "success")
    )


def expect_close(
    observed: object, expected: Fraction | float | None, what: str
) -> None:
    """Expect a number, as exactly as the rules ask for."""
    shown = None if expected is None else float(expected)
    expect.true(is_close(observed, expected), f"{what} = {shown}", [observed])


def expect_close_interval(observed: Any, expected: dict[str, float], what: str) -> None:
    """Expect both ends of an interval."""
    for end in ("low", "high"):
        expect_close(observed[end], expected[end], f"{what}.{end}")


def play_patterns(
    context: CheckContext, rule: str, patterns: Sequence[Sequence[float]]
) -> list[str]:
    """Play episodes of at most three steps, whose goal holds as given step by step."""
    worker = submit_and_attach(
        context, *["score"] * len(patterns), max_steps=3, success_rule=rule
    )
    found: list[str] = []
    for pattern in patterns:
        chunk = [context.action(success=goal) for goal in pattern]
        chunk[-1]["values"]["end"] = [float(len(pattern) < 3)]
        turn = worker.predict(*chunk)
        found.append(turn["episode_result"]["outcome"])
    return found


@requirement("SCORE-001")
def test_score_001_lies_between_0_and_1(context: CheckContext) -> None:
    """Episodes of every task, of several steps, whose every step is worth 1, or 0.

    Expect no score outside [0, 1].
    """
    tasks = ["score", "count", "echo", "delay", "fault"] * 2
    worker = submit_and_attach(context, *tasks)
    for index in range(len(tasks)):
        value = float(index < len(tasks) / 2)
        result = worker.play(score=value, success=value, steps=3)["episode_result"]
        score = result["score"]
        expect.true(0 <= score <= 1, "a score in [0, 1]", score)


@requirement("SCORE-002")
def test_score_002_any_step(context: CheckContext) -> None:
    """Rule `any_step`; the goal holds first, last, in between, nearly, and never.

    Expect a success exactly where it held after some step.
    """
    patterns: list[list[float]] = [[1, 0], [0, 1], [0, 1, 0], [0.999, 0.5], [0, 0, 0]]
    found = play_patterns(context, "any_step", patterns)
    expect.equal(found, ["success"] * 3 + ["failure"] * 2, "outcomes")


@requirement("SCORE-003")
def test_score_003_last_step(context: CheckContext) -> None:
    """Rule `last_step`; the goal holds first, in between, never, and in the end.

    Expect a success exactly where it held after the last step.
    """
    patterns = [[1, 0], [1, 1, 0], [0, 0], [0, 1], [0, 0, 1], [1]]
    found = play_patterns(context, "last_step", patterns)
    expect.equal(found, ["failure"] * 3 + ["success"] * 3, "outcomes")


@requirement("SCORE-004")
def test_score_004_abandoned_counts_as_zero(context: CheckContext) -> None:
    """Two runs: in one an episode is abandoned, in the other it fails with score 0.

    Expect the same score, mean, rate and intervals, and one success in each.
    """
    abandoned = PlannedRun(context, [SUCCESS, ABANDONED])
    failed = PlannedRun(context, [SUCCESS, PlannedEpisode("failure", 0.0)])
    scores = [
        without(
            planned_run.play_all(),
            "run_id",
            "manifest_sha256",
            "by_task",
            "by_split",
            "counts",
        )
        for planned_run in (abandoned, failed)
    ]
    expect.equal(scores[0], scores[1], "score of the run with an abandoned episode")
    expect.equal(abandoned.score()["counts"]["success"], 1, "counts.success")


@requirement("SCORE-005")
def test_score_005_complete_when_all_are_scored(context: CheckContext) -> None:
    """Three episodes are played, the last one is abandoned.

    Expect `complete` only after the third.
    """
    planned_run = PlannedRun(context, [SUCCESS, FAILURE, ABANDONED])
    for _ in range(3):
        expect.equal(
            planned_run.score()["complete"],
            False,
            f"complete after {planned_run.played}",
        )
        planned_run.play_next()
    expect.equal(planned_run.score()["complete"], True, "complete after all three")


EPISODE_PLANS = st.builds(
    PlannedEpisode,
    st.sampled_from(["success", "failure", "abandoned"]),
    st.one_of(st.floats(0, 1), st.sampled_from([0.1, 0.2, 0.3, 1 / 3])),
    st.sampled_from(["score", "score", "count"]),
)
RUN_PLANS = st.lists(EPISODE_PLANS, min_size=1, max_size=40)


@requirement("SCORE-006")
def test_score_006_is_the_mean_of_all_episodes(context: CheckContext) -> None:
    """Runs of up to forty episodes of two tasks, with generated outcomes.

    Expect null while one is missing; then the mean over the episodes, within 1e-12.
    """

    def check_property(plan: list[PlannedEpisode]) -> None:
        planned_run = PlannedRun(context, plan)
        while planned_run.played < len(plan) - 1:
            planned_run.play_next()
        expect.equal(planned_run.score()["score"], None, "score while one is missing")
        expect_close(
            planned_run.play_all()["score"], planned_run.expected()["score"], "score"
        )

    for_all(context, RUN_PLANS, check_property, times=8)


@requirement("SCORE-007")
def test_score_007_bounds_what_can_come(context: CheckContext) -> None:
    """Five episodes, one after another, abandoned ones among them.

    Expect the bounds after each: the missing ones count as 0, or as 1.
    """
    planned_run = PlannedRun(context, [SUCCESS, ABANDONED, FAILURE, SUCCESS, FAILURE])
    for _ in range(6):
        score, expected = planned_run.score(), planned_run.expected()
        for member in ("score_low", "score_high"):
            expect_close(
                score[member], expected[member], f"{member} after {planned_run.played}"
            )
        if planned_run.played < 5:
            planned_run.play_next()


@requirement("SCORE-008")
def test_score_008_counts_every_outcome(context: CheckContext) -> None:
    """Eight episodes: three successes, a failure, two abandoned, two not played.

    Expect these counts, which add up to eight.
    """
    planned_run = PlannedRun(
        context,
        [SUCCESS, FAILURE, ABANDONED, SUCCESS, SUCCESS, ABANDONED, UNPLAYED, UNPLAYED],
    )
    counts = planned_run.play_all()["counts"]
    for name, number in planned_run.expected()["counts"].items():
        expect.equal(counts[name], number, f"counts.{name}")


@requirement("SCORE-009")
def test_score_009_mean_and_rate_of_what_is_scored(context: CheckContext) -> None:
    """Five of seven episodes are played.

    Expect mean and rate null before the first; then those of the scored ones.
    """
    planned_run = PlannedRun(
        context, [FAILURE, SUCCESS, ABANDONED, SUCCESS, FAILURE, UNPLAYED, UNPLAYED]
    )
    before = planned_run.score()
    after, expected = planned_run.play_all(), planned_run.expected()
    for member in ("mean", "success_rate"):
        expect.equal(before[member], None, f"{member} before the first")
        expect_close(after[member], expected[member], member)


@requirement("SCORE-010")
def test_score_010_answers_in_every_state(context: CheckContext) -> None:
    """A run in each of the seven states. Expect an answer in each."""
    for state in context.spec.lifecycle["states"]:
        run = make_run_in_state(context, state)
        expect.ok(run.call("get_score"))


@requirement("SCORE-011")
def test_score_011_groups_by_task_and_split(context: CheckContext) -> None:
    """Tasks with three, two and one episode, the last one not played.

    Expect each task and each split once, with counts, mean and rate of its episodes.
    """
    plan = [SUCCESS, FAILURE, ABANDONED]
    plan += [
        PlannedEpisode("success", task="count"),
        PlannedEpisode("failure", task="count"),
    ]
    planned_run = PlannedRun(context, [*plan, PlannedEpisode(None, task="echo")])
    score, expected = planned_run.play_all(), planned_run.expected()
    for member in ("by_task", "by_split"):
        expect.equal(sorted(score[member]), sorted(expected[member]), member)
        for name, group in expected[member].items():
            found, what = score[member][name], f"{member}.{name}"
            expect.equal(without(found["counts"]), group["counts"], f"{what}.counts")
            for number in ("mean", "success_rate"):
                expect_close(found[number], group[number], f"{what}.{number}")


def expect_interval(planned_run: PlannedRun, plan: int, member: str) -> None:
    """Expect the interval before the first trial and after each."""
    for _ in range(plan + 1):
        what = f"{member} after {planned_run.played}"
        expect_close_interval(
            planned_run.score()[member], planned_run.expected()[member], what
        )
        if planned_run.played < plan:
            planned_run.play_next()


@requirement("SCORE-012")
def test_score_012_interval_of_the_rate(context: CheckContext) -> None:
    """Six episodes, one after another, and a run in which every one succeeds.

    Expect [0, 1] before the first, and the Wilson interval of the rate after each.
    """
    for plan in (
        [FAILURE, FAILURE, SUCCESS, ABANDONED, SUCCESS, FAILURE],
        [SUCCESS, SUCCESS, SUCCESS],
    ):
        expect_interval(PlannedRun(context, plan), len(plan), "success_interval")


@requirement("SCORE-013")
def test_score_013_interval_of_the_mean(context: CheckContext) -> None:
    """Episodes worth 0.2, 0.9 and 0, one after another, and one worth 1.

    Expect [0, 1] before the first, and the Wilson interval of the mean after each.
    """
    for plan in (
        [FAILURE, SUCCESS, ABANDONED, SUCCESS],
        [PlannedEpisode("failure", 1.0)],
    ):
        expect_interval(PlannedRun(context, plan), len(plan), "mean_interval")
