"""Comparison of runs with a baseline: the profile `compare` (CMP).

The oracle computes each comparison from the results that were shown
(`oracle/history/expectations/comparisons.py`), so that most checks only compare runs:
also a run with itself, and two runs in both orders.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import permutations
from typing import Any

from hypothesis import strategies as st

from conformance.checks.support.generated.generated_examples import for_all
from conformance.checks.support.given_states import make_run_in_state
from conformance.checks.support.long_run import long_run, other_long_run
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
from conformance.client.run_client import RunClient
from conformance.runner.requirement import on_long_run, requirement
from conformance.verdicts import expect

SUCCESS_AND_FAILURE = ("success", "failure")


def compare(
    context: CheckContext,
    baseline: RunClient,
    *runs: RunClient,
    tolerance: float | None = None,
) -> None:
    """Compare runs with a baseline."""
    params: dict[str, Any] = {"baseline": baseline.id}
    params["runs"] = ",".join(run.id for run in runs)
    if tolerance is not None:
        params["tolerance"] = tolerance
    answer = context.call("compare_runs", params=params)
    expect.require(answer, 200, "compare_runs")


def play_runs(
    context: CheckContext, *plans: Sequence[PlannedEpisode]
) -> list[RunClient]:
    """Play runs of one manifest."""
    runs_played = [PlannedRun(context, plan) for plan in plans]
    for played in runs_played:
        played.play_all()
    return [played.run for played in runs_played]


def compare_in_both_orders(
    context: CheckContext, base: RunClient, second: RunClient
) -> None:
    """Compare two runs with each other, and the second one with itself."""
    for pair in ((base, second), (second, base), (second, second)):
        compare(context, *pair)


@requirement("CMP-001", "CMP-012")
def test_cmp_001_answers_what_was_asked(context: CheckContext) -> None:
    """Three runs are listed in every order, with the baseline and one run twice, and
    sixteen times in all; two runs are compared with several tolerances, in both orders.
    Expect an entry for each id in that order; and the id, the benchmark and the hash of
    the baseline, and the tolerance, which is 0.05 where none was sent."""
    base, *others = play_runs(context, *([[SUCCESS]] * 4))
    first, second, third = others
    sixteen = [first, second, third, second, base] * 3 + [third]
    for named in (*permutations(others), [first, base, first], sixteen):
        compare(context, base, *named)
    runs = [context.submit("echo", "score", max_steps=4) for _ in range(2)]
    for base, compared in (runs, reversed(runs)):
        for tolerance in (None, 0, 1 / 3, 0.05, 1e-9, 1):
            compare(context, base, compared, tolerance=tolerance)


@requirement("CMP-002", "CMP-003")
def test_cmp_002_pairs_are_scored_in_both(context: CheckContext) -> None:
    """Two runs are played at different speeds; each abandons an episode. They are
    compared after each step, in both orders. Expect as many pairs as both have scored,
    and `complete` only when both have scored all."""
    base = PlannedRun(context, [SUCCESS, ABANDONED, FAILURE])
    second = PlannedRun(context, [FAILURE, SUCCESS, ABANDONED])
    for steps in ((0, 1), (2, 0), (1, 1), (0, 1)):
        for planned, times in zip((base, second), steps, strict=True):
            for _ in range(times):
                planned.play_next()
        compare_in_both_orders(context, base.run, second.run)


@on_long_run
@requirement("CMP-004", "CMP-005", "CMP-006", "CMP-007")
def test_cmp_004_numbers_of_the_pairs(context: CheckContext) -> None:
    """Two runs with generated outcomes, of which the second may lack episodes; tasks
    with three, two and one episode, the last without a scored pair; every pair of
    success, failure, abandoned and unscored; a baseline with six successes of twelve,
    and runs from equal to opposite outcomes; two runs of a hundred and eighty episodes
    that were scored in different orders. Expect null before there is a pair, then means
    and difference within 1e-12, of each task, too; the counts, exchanged in reverse
    order; and the p-value within 1e-9, 1 for equal outcomes."""

    def compare_drawn(
        drawn: tuple[list[tuple[PlannedEpisode, PlannedEpisode]], int],
    ) -> None:
        pairs, left = drawn
        plan = [replace(second, task=first.task) for first, second in pairs]
        left_from = max(0, len(pairs) - left)
        plan[left_from:] = [replace(left, outcome=None) for left in plan[left_from:]]
        base = PlannedRun(context, [first for first, _ in pairs])
        second = PlannedRun(context, plan)
        compare(context, base.run, second.run)
        base.play_all()
        second.play_all()
        compare_in_both_orders(context, base.run, second.run)

    pairs = st.lists(st.tuples(EPISODE_PLANS, EPISODE_PLANS), min_size=1, max_size=12)
    for_all(context, st.tuples(pairs, st.integers(0, 4)), compare_drawn, times=5)
    s, f, a = SUCCESS, FAILURE, ABANDONED
    count = [PlannedEpisode(o, task="count") for o in SUCCESS_AND_FAILURE]
    echo = PlannedEpisode(None, task="echo")
    for plans in (
        ([s, f, a, *count, echo], [f, f, s, *reversed(count), echo]),
        ([s, s, s, s, f, f, a, a, s], [f, a, f, s, s, f, s, f, UNPLAYED]),
    ):
        compare_in_both_orders(context, *play_runs(context, *plans))
    half = [s] * 6 + [f] * 6
    others = [half, half[::-1], [f] * 12, [s] * 12, [f, *half[1:]]]
    compare(context, *play_runs(context, half, *others, [f] * 4 + half[4:11] + [s]))
    compare(context, long_run(context).run, other_long_run(context).run)


@requirement("CMP-008")
def test_cmp_008_release_by_every_difference(context: CheckContext) -> None:
    """A baseline and runs that are equal, slightly or much worse or better, close only
    in total, and incomplete, with several tolerances. Expect `release` where no
    difference exceeds the tolerance, the limit included."""

    def scores(first: float, second: float) -> list[PlannedEpisode]:
        of_scores = PlannedEpisode("failure", first), PlannedEpisode("success", second)
        return [*of_scores, even]

    even = PlannedEpisode("success", task="count")
    plans = [scores(0.5, 0.5), scores(0.5, 0.25), scores(0.75, 0.5), scores(1, 0)]
    plans += [scores(0.5, 0.42), scores(0.5, 0.38), scores(0.62, 0.5)]
    # In the task `score`, 2e-8 beyond the tolerance, 1e-10 beyond, and less.
    plans += [scores(0.5, 0.5 - 2 * x) for x in (0.05 + 2e-8, 0.05 + 1e-10, 0.0499)]
    plans += [scores(0.5 + 2 * x, 0.5) for x in (0.05 + 2e-8, 0.05 + 1e-10, 0.0499)]
    plans += [[*scores(0.5, 0.5)[:2], PlannedEpisode("failure", task="count")]]
    plans += [[*scores(0.5, 0.5)[:2], PlannedEpisode(None, task="count")]]
    base, *runs_played = play_runs(context, scores(0.5, 0.5), *plans)
    for tolerance in (None, 0.0, 0.125, 0.25, 0.35, 1.0):
        compare(context, base, *runs_played, tolerance=tolerance)
    compare(context, runs_played[-1], base, tolerance=1.0)


@requirement("CMP-009")
def test_cmp_009_cannot_compare_other_manifests(context: CheckContext) -> None:
    """Runs with other tasks, lengths and rules, alone and after a comparable one.
    Expect `not_comparable` pointing at `query:runs`; the comparable one is compared."""
    base, good = (context.submit("score", "count", wait_ready=False) for _ in range(2))
    for *tasks, max_steps in (
        ("score", "score", None),
        ("score", "count", "score", None),
        ("score", "count", 3),
    ):
        other = context.submit(*tasks, max_steps=max_steps, wait_ready=False)
        for named in (other.id, f"{good.id},{other.id}"):
            params = {"baseline": base.id, "runs": named}
            answer = context.call("compare_runs", params=params)
            expect.refused(answer, "not_comparable", pointer="query:runs")
    compare(context, base, good)


@requirement("CMP-010")
def test_cmp_010_cannot_compare_runs_of_another_account(context: CheckContext) -> None:
    """Runs of another account and unknown ids, as baseline and among the runs. The
    unknown ones are as short and as long as ids may be. Expect `not_found` for each,
    and success for the owner."""
    second_account = context.second_account
    ours = context.submit("score", wait_ready=False)
    theirs = context.submit("score", wait_ready=False, http_client=second_account)
    named = [(ours.id, ours.id), (theirs.id, ours.id), (theirs.id, f"{theirs.id},none")]
    named += [(ours.id, theirs.id), ("none", theirs.id)]
    named += [(theirs.id, f"{theirs.id},{ours.id}")]
    for unknown in ("z", "_" * 64):
        named += [(unknown, theirs.id), (theirs.id, unknown)]
        named += [(theirs.id, f"{theirs.id},{unknown}")]
    for baseline, runs in named:
        params = {"baseline": baseline, "runs": runs}
        answer = context.call("compare_runs", params=params, http_client=second_account)
        expect.refused(answer, "not_found")
    params = {"baseline": theirs.id, "runs": theirs.id}
    expect.ok(context.call("compare_runs", params=params, http_client=second_account))


@requirement("CMP-011")
def test_cmp_011_answers_in_every_state(context: CheckContext) -> None:
    """A run in each of the seven states is compared with itself. Expect success."""
    for state in context.spec.lifecycle["states"]:
        run = make_run_in_state(context, state)
        params = {"baseline": run.id, "runs": run.id}
        expect.ok(context.call("compare_runs", params=params))
