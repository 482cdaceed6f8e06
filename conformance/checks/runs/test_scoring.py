"""Scores of episodes, of runs, and of incomplete runs (SCORE).

The runs are played to a plan (`support/planned_run.py`); the oracle computes each score
from the results that were shown (`oracle/history/expectations/score_views.py`).
"""

import math
from collections.abc import Callable
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


@requirement("SCORE-002", "SCORE-003")
def test_score_002_success_by_each_rule(context: CheckContext) -> None:
    """Both rules; success in the first, last or middle step, nearly, and never; in a
    step before the worker is taken over. Expect a success exactly where `success` was 1
    in some step, or in the last one."""
    any_step: list[list[float]] = [[1, 0], [0, 1], [0, 1, 0], [BELOW_1, 0.5], [0, 0, 0]]
    last_step: list[list[float]] = [[1, 0], [1, 1, 0], [0, 0], [0, 1], [0, 0, 1], [1]]
    for rule, patterns in (("any_step", any_step), ("last_step", last_step)):
        tasks = ["score"] * len(patterns)
        worker = submit_and_attach(context, *tasks, max_steps=3, success_rule=rule)
        for pattern in patterns:
            chunk = [context.action(success=goal) for goal in pattern]
            chunk[-1]["values"]["end"] = [float(len(pattern) < 3)]
            worker.predict(*chunk)
    if context.offers("sessions"):
        worker = submit_and_attach(context, "score", success_rule="any_step")
        worker.predict(context.action(success=1), context.action())
        worker.attach(takeover=True)
        worker.play()


@requirement("SCORE-004")
def test_score_004_abandoned_counts_as_zero(context: CheckContext) -> None:
    """Two runs: in one an episode is abandoned, in the other it fails with score 0.
    Expect the same score, mean, rate and intervals, and one success in each."""
    abandoned = PlannedRun(context, [SUCCESS, ABANDONED])
    failed = PlannedRun(context, [SUCCESS, PlannedEpisode("failure", 0.0)])
    names = ("run_id", "manifest_sha256", "by_task", "by_split", "counts")
    scores = [without(run.play_all(), *names) for run in (abandoned, failed)]
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


@requirement("SCORE-005", "SCORE-007", "SCORE-009", "SCORE-012", "SCORE-013")
def test_score_005_numbers_after_each_episode(context: CheckContext) -> None:
    """Runs of some episodes, of successes only, of a failure with score 0 or 1, and of
    many, some left unscored. Expect `complete` only after the last episode; bounds in
    which unscored ones count as 0 or 1; mean and rate of the scored ones, null before
    the first; and the Wilson intervals of both, [0, 1] before the first."""
    plan = [SUCCESS, ABANDONED, FAILURE, SUCCESS, FAILURE, ABANDONED, SUCCESS]
    zero, one = (PlannedEpisode("failure", score) for score in (0.0, 1.0))
    score_each(context, plan, [*plan, UNPLAYED, UNPLAYED], [SUCCESS] * 3, [one])
    score_each(context, [zero, UNPLAYED])
    if not context.shared.settings.quick:
        score_each(context, [*MANY, ABANDONED, SUCCESS, SUCCESS])


@on_long_run
@requirement("SCORE-006", "SCORE-008", "SCORE-011")
def test_score_006_numbers_of_all_episodes(context: CheckContext) -> None:
    """Runs of up to forty episodes of two tasks, with generated outcomes; one of tasks
    with thirteen, two and one episode, the last one not played; runs of one episode;
    and one of a hundred and eighty. Expect the mean over all episodes within 1e-12,
    null while one is unscored; counts of each outcome that add up; and each task and
    each split once, with counts, mean and rate of its episodes."""
    plans = st.lists(EPISODE_PLANS, min_size=1, max_size=40)
    for_all(context, plans, partial(score_each, context), times=8)
    plan = [SUCCESS, FAILURE, ABANDONED] + [FAILURE, FAILURE, SUCCESS, FAILURE] * 2
    plan += [SUCCESS, SUCCESS]
    plan += [PlannedEpisode(outcome, task="count") for outcome in SUCCESS_AND_FAILURE]
    plan.append(PlannedEpisode(None, task="delay"))
    score_each(context, plan, [SUCCESS], [PlannedEpisode("failure", 0.0)])
    run = long_run(context).run
    run.get()
    run.results()
    run.score()


@requirement("SCORE-010")
def test_score_010_answers_in_every_state(context: CheckContext) -> None:
    """A run in each of the seven states. Expect a score in each."""
    for state in reachable_states(context):
        expect.ok(make_run_in_state(context, state).call("get_score"))


# So many that intervals of other formulas are close to it.
MANY = [*[SUCCESS] * 4, FAILURE, PlannedEpisode("failure", 0.9)] * 7


@requirement("SCORE-014")
def test_score_014_says_whose_score_it_is(context: CheckContext) -> None:
    """A run in each of the seven states, and one with other options; a run whose score
    is read after each of its changes. Expect the benchmark, the hash and the state of
    the run."""
    runs = [make_run_in_state(context, state) for state in reachable_states(context)]
    for run in (*runs, context.submit("delay", "count", max_steps=3)):
        state = run.score()["state"]
        expect.equal(state, run.get()["state"], "state of the score, read after")
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
