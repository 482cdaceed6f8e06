"""Comparison of runs with a baseline: the profile `compare` (CMP).

`oracle/expected_comparison.py` computes the expected values from the episodes played.
The checks also verify properties of every comparison: a run with itself, and two runs
in both orders.
"""

from collections.abc import Callable, Sequence
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
    expect_close,
)
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.oracle.expected_comparison import expected_comparison
from conformance.runner.requirement import on_long_run, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

DEFAULT_TOLERANCE = 0.05
SUCCESS_AND_FAILURE = ("success", "failure")


def compare(
    context: CheckContext,
    baseline: RunClient,
    *runs: RunClient,
    tolerance: float | None = None,
) -> list[dict[str, Any]]:
    """Compare runs with a baseline; the entries of the answer are under test."""
    params: dict[str, Any] = {"baseline": baseline.id}
    params["runs"] = ",".join(run.id for run in runs)
    if tolerance is not None:
        params["tolerance"] = tolerance
    body = expect.ok(context.call("compare_runs", params=params))
    entries: list[dict[str, Any]] = body["runs"]
    return entries


def compare_two(
    context: CheckContext, *pair: PlannedRun, tolerance: float | None = None
) -> dict[str, Any]:
    """Compare the second of two runs with the first."""
    base, second = pair
    (entry,) = compare(context, base.run, second.run, tolerance=tolerance)
    return entry


def expected_entry(
    base: PlannedRun, played: PlannedRun, tolerance: float = DEFAULT_TOLERANCE
) -> dict[str, Any]:
    """Compute the expected comparison of two following runs."""
    return expected_comparison(base.episodes(), played.episodes(), tolerance)


def play_runs(
    context: CheckContext, *plans: Sequence[PlannedEpisode]
) -> list[PlannedRun]:
    """Play runs of one manifest."""
    runs_played = [PlannedRun(context, plan) for plan in plans]
    for played in runs_played:
        played.play_all()
    return runs_played


def expect_close_means(actual: dict[str, Any], expected: dict[str, Any]) -> None:
    """Expect both means and their difference."""
    for member in ("baseline_mean", "mean", "difference"):
        expect_close(actual[member], expected[member], member)


def expect_pairs(
    context: CheckContext,
    expect_entry: Callable[[dict[str, Any], dict[str, Any]], None],
    *pairs: tuple[PlannedRun, PlannedRun],
) -> None:
    """Expect what the oracle computes for some comparisons, and for the long runs."""
    for pair in pairs:
        expect_entry(compare_two(context, *pair), expected_entry(*pair))
    base, second = long_run(context), other_long_run(context)
    (entry,) = compare(context, base.run, second.run)
    episodes = base.episodes(), second.episodes()
    expect_entry(entry, expected_comparison(*episodes, DEFAULT_TOLERANCE))


@requirement("CMP-001")
def test_cmp_001_one_entry_per_run_in_their_order(context: CheckContext) -> None:
    """Three runs are listed in every order, with the baseline and one run twice, and
    sixteen times in all. Expect the ids of the entries in that order."""
    base, *others = [played.run for played in play_runs(context, *([[SUCCESS]] * 4))]
    first, second, third = others
    sixteen = [first, second, third, second, base] * 3 + [third]
    for named in (*permutations(others), [first, base, first], sixteen):
        entries = compare(context, base, *named)
        ids = [entry["run_id"] for entry in entries]
        expect.equal(ids, [run.id for run in named], "ids of the entries")


@requirement("CMP-002")
def test_cmp_002_pairs_are_scored_in_both(context: CheckContext) -> None:
    """Two runs are played at different speeds; each abandons an episode. Expect after
    each step as many pairs as both have scored."""
    base = PlannedRun(context, [SUCCESS, ABANDONED, FAILURE, UNPLAYED])
    second = PlannedRun(context, [FAILURE, SUCCESS, ABANDONED, UNPLAYED])
    for steps in ((0, 1), (2, 0), (1, 1), (0, 1)):
        for planned, times in zip((base, second), steps, strict=True):
            for _ in range(times):
                planned.play_next()
        for pair in ((base, second), (second, base)):
            paired = compare_two(context, *pair)["paired"]
            expect.equal(paired, min(base.played, second.played), "paired")


@requirement("CMP-003")
def test_cmp_003_complete_when_both_are(context: CheckContext) -> None:
    """A complete run and an incomplete one, in both orders; then both are complete.
    Expect `complete` only then."""
    whole = PlannedRun(context, [SUCCESS, FAILURE])
    part = PlannedRun(context, [SUCCESS, ABANDONED])
    whole.play_all()
    for is_complete in (False, True):
        part.play_next()
        for pair in ((whole, part), (part, whole), (part, part)):
            complete = compare_two(context, *pair)["complete"]
            expect.equal(complete, is_complete, "complete")


@on_long_run
@requirement("CMP-004")
def test_cmp_004_difference_is_baseline_minus_run(context: CheckContext) -> None:
    """Two runs with generated outcomes; episodes of the second may be missing. Two runs
    of a hundred and eighty episodes. Expect null before there is a pair, then the means
    over the pairs and their difference, within 1e-12; 0 with itself, and the opposite
    sign in reverse order."""

    def check_property(
        pairs: list[tuple[PlannedEpisode, PlannedEpisode]], left: int
    ) -> None:
        base = PlannedRun(context, [first for first, _ in pairs])
        plan = [replace(second, task=first.task) for first, second in pairs]
        left_from = max(0, len(pairs) - left)
        plan[left_from:] = [replace(left, outcome=None) for left in plan[left_from:]]
        second = PlannedRun(context, plan)
        compared = compare_two(context, base, second)
        expect_close_means(compared, expected_entry(base, second))
        base.play_all()
        second.play_all()
        pairs_of_runs = ((base, second), (base, base), (second, base))
        expect_pairs(context, expect_close_means, *pairs_of_runs)

    pairs = st.lists(st.tuples(EPISODE_PLANS, EPISODE_PLANS), min_size=1, max_size=12)
    cases = st.tuples(pairs, st.integers(0, 4))
    for_all(context, cases, lambda drawn: check_property(*drawn), times=5)


def expect_tasks(entry: dict[str, Any], due: dict[str, Any]) -> None:
    """Expect each task once, with its numbers."""
    actual, expected = entry["by_task"], due["by_task"]
    expect.equal(sorted(actual), sorted(expected), "tasks")
    for task, group in expected.items():
        expect.equal(actual[task]["paired"], group["paired"], f"paired of {task}")
        expect_close_means(actual[task], group)


@on_long_run
@requirement("CMP-005")
def test_cmp_005_groups_by_task(context: CheckContext) -> None:
    """Tasks with three, two and one episode; the last has no scored pair. Two runs of a
    hundred and eighty episodes. Expect each task once, with pairs, means and difference
    of its episodes."""
    count = [PlannedEpisode(o, task="count") for o in SUCCESS_AND_FAILURE]
    echo = PlannedEpisode(None, task="echo")
    base, second = play_runs(
        context,
        [SUCCESS, FAILURE, ABANDONED, *count, echo],
        [FAILURE, FAILURE, SUCCESS, *reversed(count), echo],
    )
    expect_pairs(context, expect_tasks, (base, second))


@on_long_run
@requirement("CMP-006")
def test_cmp_006_counts_one_sided_successes(context: CheckContext) -> None:
    """Every pair of success, failure, abandoned and unscored, in different numbers; two
    runs of a hundred and eighty episodes that were scored in different orders. Expect
    the counts; in reverse order wins and losses are exchanged."""

    def expect_counts(entry: dict[str, Any], expected: dict[str, Any]) -> None:
        due = {name: expected[name] for name in ("wins", "losses", "ties")}
        expect.members(entry, due, "")

    s, f, a = SUCCESS, FAILURE, ABANDONED
    base, second = play_runs(
        context, [s, s, s, s, f, f, a, a, s], [f, a, f, s, s, f, s, f, UNPLAYED]
    )
    pairs = ((base, second), (second, base), (second, second))
    expect_pairs(context, expect_counts, *pairs)


def entry_of(played: PlannedRun, entries: list[dict[str, Any]]) -> dict[str, Any]:
    """Find the entry of a run among those of a comparison."""
    for entry in entries:
        if entry["run_id"] == played.run.id:
            return entry
    raise SetUpFailed("a comparison leaves a run out", breaks="CMP-001")


@on_long_run
@requirement("CMP-007")
def test_cmp_007_p_value_is_exact(context: CheckContext) -> None:
    """A baseline with six successes in twelve episodes, and runs from equal to opposite
    outcomes; two runs that differ in more than 170 episodes. Expect the p-value of each
    within 1e-9, and 1 for equal outcomes."""

    def expect_p_value(entry: dict[str, Any], expected: dict[str, Any]) -> None:
        what = f"p_value of {expected['wins']} wins, {expected['losses']} losses"
        expect_close(entry["p_value"], expected["p_value"], what)

    half = [SUCCESS] * 6 + [FAILURE] * 6
    others = [[*half], [FAILURE] * 6 + [SUCCESS] * 6, [FAILURE] * 12, [SUCCESS] * 12]
    others += [[FAILURE, *half[1:]], [FAILURE] * 4 + half[4:11] + [SUCCESS]]
    base, *runs_played = play_runs(context, half, *others)
    entries = compare(context, base.run, *(played.run for played in runs_played))
    for played in runs_played:
        expect_p_value(entry_of(played, entries), expected_entry(base, played))
    expect_pairs(context, expect_p_value)


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
        runs = [played.run for played in runs_played]
        entries = compare(context, base.run, *runs, tolerance=tolerance)
        allowed = DEFAULT_TOLERANCE if tolerance is None else tolerance
        for played in runs_played:
            expected = expected_entry(base, played, allowed)
            text = f"release with difference {float(expected['difference']):+.4f}"
            text += f", tolerance {'absent' if tolerance is None else tolerance}"
            release = entry_of(played, entries)["release"]
            expect.equal(release, expected["release"], text)
    unfinished = compare_two(context, runs_played[-1], base, tolerance=1.0)
    expect.equal(unfinished["release"], False, "release beside an incomplete baseline")


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
    """A run in each of the seven states is compared with itself. Expect success in
    each, without a difference."""
    for state in context.spec.lifecycle["states"]:
        run = make_run_in_state(context, state)
        (entry,) = compare(context, run, run)
        nothing = {"wins": 0, "losses": 0, "p_value": 1}
        expect.members(entry, nothing, f"when {state}")


@requirement("CMP-012")
def test_cmp_012_says_what_was_compared(context: CheckContext) -> None:
    """Two runs are compared with several tolerances and without one, in both orders.
    Expect the id, the benchmark and the hash of the baseline, and the tolerance."""
    runs = [context.submit("echo", "score", max_steps=4) for _ in range(2)]
    for base, compared in (runs, reversed(runs)):
        body = base.get()
        for tolerance in (None, 0, 1 / 3, 0.05, 1e-9, 1):
            params: dict[str, Any] = {"baseline": base.id, "runs": compared.id}
            if tolerance is not None:
                params["tolerance"] = tolerance
            comparison = expect.ok(context.call("compare_runs", params=params))
            due = {name: body[name] for name in ("benchmark_id", "manifest_sha256")}
            due["tolerance"] = DEFAULT_TOLERANCE if tolerance is None else tolerance
            expect.members(comparison, due | {"baseline": base.id}, "compared")
