"""Scores of episodes, of runs, and of incomplete runs (SCORE).

The runs are played to a plan (`support/planned_run.py`); the oracle computes each score
from the results that were shown (`oracle/history/expectations/score_views.py`).
"""

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from hypothesis import strategies as st

from conformance.checks.support.generated.generated_examples import for_all
from conformance.checks.support.given_states import (
    make_run_in_state,
    reachable_states,
    submit_and_attach,
    without,
)
from conformance.checks.support.long_run import long_run
from conformance.checks.support.planned_run import (
    ABANDONED,
    EPISODE_PLANS,
    FAILURE,
    SUCCESS,
    UNPLAYED,
    PlannedEpisode,
    PlannedRun,
)
from conformance.client.check_context import CheckContext
from conformance.runner.requirement import on_long_run, requirement
from conformance.verdicts import expect

SUCCESS_AND_FAILURE = ("success", "failure")
BELOW_1 = math.nextafter(1, 0)


def play(context: CheckContext, rule: str, patterns: Sequence[Sequence[float]]) -> None:
    """Play episodes of at most three steps with the given success values per step."""
    worker = submit_and_attach(
        context, *["score"] * len(patterns), max_steps=3, success_rule=rule
    )
    for pattern in patterns:
        chunk = [context.action(success=goal) for goal in pattern]
        chunk[-1]["values"]["end"] = [float(len(pattern) < 3)]
        worker.predict(*chunk)


@requirement("SCORE-001")
def test_score_001_lies_between_0_and_1(context: CheckContext) -> None:
    """Episodes of every task, of several steps, all with score 1, or all with 0. Expect
    no score outside [0, 1]."""
    tasks = context.tasks("score", "count", "echo", "delay", "fault") * 2
    worker = submit_and_attach(context, *tasks)
    for index in range(len(tasks)):
        value = float(index < len(tasks) / 2)
        result = worker.play(score=value, success=value, steps=3)["episode_result"]
        score = result["score"]
        expect.true(0 <= score <= 1, "a score in [0, 1]", score)


@requirement("SCORE-002")
def test_score_002_any_step(context: CheckContext) -> None:
    """Rule `any_step`; success in the first, last or middle step, nearly, and never; in
    a step before the worker is taken over. Expect a success exactly where `success` was
    1 in some step."""
    patterns: list[list[float]] = [[1, 0], [0, 1], [0, 1, 0], [BELOW_1, 0.5], [0, 0, 0]]
    play(context, "any_step", patterns)
    if not context.offers("sessions"):
        return
    worker = submit_and_attach(context, "score", success_rule="any_step")
    worker.predict(context.action(success=1), context.action())
    worker.attach(takeover=True)
    worker.play()


@requirement("SCORE-003")
def test_score_003_last_step(context: CheckContext) -> None:
    """Rule `last_step`; success in the first or middle step, never, and in the last.
    Expect a success exactly where `success` was 1 in the last step."""
    patterns = [[1, 0], [1, 1, 0], [0, 0], [0, 1], [0, 0, 1], [1]]
    play(context, "last_step", patterns)


@requirement("SCORE-004")
def test_score_004_abandoned_counts_as_zero(context: CheckContext) -> None:
    """Two runs: in one an episode is abandoned, in the other it fails with score 0.
    Expect the same score, mean, rate and intervals, and one success in each."""
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


def score_each(context: CheckContext, *plans: list[PlannedEpisode]) -> None:
    """Play runs, and read the score before the first episode and after each.

    The oracle compares every number with the results that were shown.
    """
    for plan in plans:
        planned_run = PlannedRun(context, plan)
        planned_run.score()
        while planned_run.play_next():
            planned_run.score()


def score_long_run(context: CheckContext) -> None:
    """Read the score of a hundred and eighty episodes beside their results."""
    run = long_run(context).run
    run.get()
    run.results()
    run.score()


@requirement("SCORE-005")
def test_score_005_complete_when_all_are_scored(context: CheckContext) -> None:
    """Three episodes are played, the last one is abandoned. Expect `complete` only
    after the third."""
    score_each(context, [SUCCESS, FAILURE, ABANDONED])


RUN_PLANS = st.lists(EPISODE_PLANS, min_size=1, max_size=40)


@on_long_run
@requirement("SCORE-006")
def test_score_006_is_the_mean_of_all_episodes(context: CheckContext) -> None:
    """Runs of up to forty episodes of two tasks, with generated outcomes; and one of a
    hundred and eighty. Expect null while one is unscored; then the mean over the
    episodes, within 1e-12."""
    for_all(context, RUN_PLANS, partial(score_each, context), times=8)
    score_long_run(context)


@requirement("SCORE-007")
def test_score_007_bounds_the_final_score(context: CheckContext) -> None:
    """Seven episodes, one after another, some of them abandoned. Expect the bounds
    after each: unscored episodes count as 0, or as 1."""
    plan = [SUCCESS, ABANDONED, FAILURE, SUCCESS, FAILURE, ABANDONED, SUCCESS]
    score_each(context, plan)


@on_long_run
@requirement("SCORE-008")
def test_score_008_counts_every_outcome(context: CheckContext) -> None:
    """Eight episodes: three successes, a failure, two abandoned, two not played; and a
    run of a hundred and eighty. Expect these counts, which add up to eight, and those
    of the long run."""
    plan = [SUCCESS, FAILURE, ABANDONED, SUCCESS, SUCCESS, ABANDONED]
    score_each(context, [*plan, UNPLAYED, UNPLAYED])
    score_long_run(context)


@requirement("SCORE-009")
def test_score_009_mean_and_rate_of_scored_episodes(context: CheckContext) -> None:
    """Six of eight episodes are played; and one of two, a failure with score 0. Expect
    mean and rate null before the first; then those of the scored episodes."""
    plan = [FAILURE, SUCCESS, ABANDONED, FAILURE, SUCCESS, FAILURE, UNPLAYED]
    score_each(context, [*plan, UNPLAYED], [PlannedEpisode("failure", 0.0), UNPLAYED])


@requirement("SCORE-010")
def test_score_010_answers_in_every_state(context: CheckContext) -> None:
    """A run in each of the seven states. Expect a score in each, with the state,
    benchmark and manifest of the run."""
    for state in reachable_states(context):
        run = make_run_in_state(context, state)
        score = expect.ok(run.call("get_score"))
        for member in ("run_id", "state", "benchmark_id", "manifest_sha256"):
            expect.equal(score[member], run.body[member], member)


@on_long_run
@requirement("SCORE-011")
def test_score_011_groups_by_task_and_split(context: CheckContext) -> None:
    """Tasks with thirteen, two and one episode, the last one not played; runs of one
    episode, a success and a failure; and one of a hundred and eighty, of uneven tasks.
    Expect each task and each split once, with counts, mean and rate of its episodes."""
    plan = [SUCCESS, FAILURE, ABANDONED] + [FAILURE, FAILURE, SUCCESS, FAILURE] * 2
    plan += [SUCCESS, SUCCESS]
    plan += [PlannedEpisode(outcome, task="count") for outcome in SUCCESS_AND_FAILURE]
    plan.append(PlannedEpisode(None, task="delay"))
    score_each(context, plan, [SUCCESS], [PlannedEpisode("failure", 0.0)])
    score_long_run(context)


# So many that intervals of other formulas are close to it.
MANY = [*[SUCCESS] * 4, FAILURE, PlannedEpisode("failure", 0.9)] * 7


@requirement("SCORE-012")
def test_score_012_interval_of_the_rate(context: CheckContext) -> None:
    """Six episodes, one after another, a run of successes only, and one of many. Expect
    [0, 1] before the first, and the Wilson interval of the rate after each."""
    plan = [FAILURE, FAILURE, SUCCESS, ABANDONED, SUCCESS, FAILURE]
    score_each(context, plan, [SUCCESS, SUCCESS, SUCCESS])
    if not context.shared.settings.quick:
        score_each(context, [*MANY, ABANDONED, SUCCESS, SUCCESS])


@requirement("SCORE-013")
def test_score_013_interval_of_the_mean(context: CheckContext) -> None:
    """Episodes of several scores, one after another, one with score 1, and many. Expect
    [0, 1] before the first, and the Wilson interval of the mean after each."""
    plan = [FAILURE, SUCCESS, ABANDONED, SUCCESS]
    score_each(context, plan, [PlannedEpisode("failure", 1.0)])
    if not context.shared.settings.quick:
        score_each(context, [*MANY, ABANDONED, SUCCESS, SUCCESS])


@requirement("SCORE-014")
def test_score_014_says_whose_score_it_is(context: CheckContext) -> None:
    """A run in each of the seven states, and one with other options; a run whose score
    is read after each of its changes. Expect the benchmark, the hash and the state of
    the run."""
    runs = [make_run_in_state(context, state) for state in reachable_states(context)]
    for run in (*runs, context.submit("delay", "count", max_steps=3)):
        score, body = expect.ExpectedBody(run.score()), run.get()
        for name in ("run_id", "benchmark_id", "manifest_sha256", "state"):
            expect.equal(score[name], body[name], f"{name} of a {body['state']} run")
    run = context.submit("score", "score")
    worker = run.worker()
    steps: list[Callable[[], Any]] = [worker.attach, worker.play]
    steps += [worker.detach] if context.offers("sessions") else []
    steps += [run.stop, run.resume] if context.offers("control") else [run.stop]
    for step in steps:
        step()
        state, of_score = run.get()["state"], run.score()["state"]
        if state != "queued":  # it may leave the queue between two requests
            expect.equal(of_score, state, "state of the score, read before")
