"""Comparison of runs with a baseline: the profile `compare` (CMP).

`oracle/expected_comparison.py` computes the expected values from the episodes played.
The checks also verify properties of every comparison: a run with itself, and two runs
in both orders.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import permutations
from typing import Any

from hypothesis import strategies as st

from conformance.checks.support.generated.generated_examples import for_all
from conformance.checks.support.given_states import make_run_in_state, without
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
MEANS = ("baseline_mean", "mean", "difference")


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


def compare_planned_runs(
    context: CheckContext,
    base: PlannedRun,
    planned_run: PlannedRun,
    tolerance: float | None = None,
) -> dict[str, Any]:
    (entry,) = compare(context, base.run, planned_run.run, tolerance=tolerance)
    return entry


def expected_entry(
    base: PlannedRun, planned_run: PlannedRun, tolerance: float = DEFAULT_TOLERANCE
) -> dict[str, Any]:
    """Compute the expected comparison of two planned runs."""
    return expected_comparison(base.episodes(), planned_run.episodes(), tolerance)


def play_runs(
    context: CheckContext, *plans_of_runs: Sequence[PlannedEpisode]
) -> list[PlannedRun]:
    """Play runs of one manifest."""
    planned_runs = [PlannedRun(context, plan) for plan in plans_of_runs]
    for planned_run in planned_runs:
        planned_run.play_all()
    return planned_runs


def expect_close_means(
    actual: dict[str, Any], expected: dict[str, Any], what: str
) -> None:
    """Expect both means and their difference."""
    for member in MEANS:
        expect_close(actual[member], expected[member], f"{member} {what}")


def compare_long_runs(context: CheckContext) -> tuple[dict[str, Any], dict[str, Any]]:
    """Compare the long runs; give the entry and what is expected of it."""
    base, second = long_run(context), other_long_run(context)
    (entry,) = compare(context, base.run, second.run)
    expected = expected_comparison(
        base.episodes(), second.episodes(), DEFAULT_TOLERANCE
    )
    return entry, expected


@requirement("CMP-001")
def test_cmp_001_one_entry_per_run_in_their_order(context: CheckContext) -> None:
    """Three runs are listed in every order, with the baseline and one run twice, and
    sixteen times in all. Expect the ids of the entries in that order."""
    base, *others = [
        planned_run.run for planned_run in play_runs(context, *([[SUCCESS]] * 4))
    ]
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
    planned_run = PlannedRun(context, [FAILURE, SUCCESS, ABANDONED, UNPLAYED])
    for steps in ((0, 1), (2, 0), (1, 1), (0, 1)):
        for planned, times in zip((base, planned_run), steps, strict=True):
            for _ in range(times):
                planned.play_next()
        for pair in ((base, planned_run), (planned_run, base)):
            paired = compare_planned_runs(context, *pair)["paired"]
            expect.equal(paired, min(base.played, planned_run.played), "paired")


@requirement("CMP-003")
def test_cmp_003_complete_when_both_are(context: CheckContext) -> None:
    """A complete run and an incomplete one, in both orders; then both are complete.
    Expect `complete` only then."""
    whole, part = (
        PlannedRun(context, [SUCCESS, FAILURE]),
        PlannedRun(context, [SUCCESS, ABANDONED]),
    )
    whole.play_all()
    part.play_next()
    for pair in ((whole, part), (part, whole), (part, part)):
        expect.equal(
            compare_planned_runs(context, *pair)["complete"], False, "complete"
        )
    part.play_next()
    for pair in ((whole, part), (part, whole), (part, part)):
        expect.equal(
            compare_planned_runs(context, *pair)["complete"],
            True,
            "complete of whole runs",
        )


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
        planned = [replace(second, task=first.task) for first, second in pairs]
        played = max(0, len(pairs) - left)
        planned[played:] = [
            replace(episode, outcome=None) for episode in planned[played:]
        ]
        planned_run = PlannedRun(context, planned)
        expect_close_means(
            compare_planned_runs(context, base, planned_run),
            expected_entry(base, planned_run),
            "before the first",
        )
        base.play_all()
        planned_run.play_all()
        expect_close_means(
            compare_planned_runs(context, base, planned_run),
            expected_entry(base, planned_run),
            "over the pairs",
        )
        expect_close_means(
            compare_planned_runs(context, base, base),
            expected_entry(base, base),
            "beside itself",
        )
        expect_close_means(
            compare_planned_runs(context, planned_run, base),
            expected_entry(planned_run, base),
            "in the other order",
        )

    pairs = st.lists(st.tuples(EPISODE_PLANS, EPISODE_PLANS), min_size=1, max_size=12)
    cases = st.tuples(pairs, st.integers(0, 4))
    for_all(context, cases, lambda drawn: check_property(*drawn), times=5)
    expect_close_means(*compare_long_runs(context), "of long runs")


def expect_tasks(actual: dict[str, Any], expected: dict[str, Any]) -> None:
    """Expect each task once, with its numbers."""
    expect.equal(sorted(actual), sorted(expected), "tasks")
    for task, group in expected.items():
        expect.equal(actual[task]["paired"], group["paired"], f"paired of {task}")
        expect_close_means(actual[task], group, f"of {task}")


@on_long_run
@requirement("CMP-005")
def test_cmp_005_groups_by_task(context: CheckContext) -> None:
    """Tasks with three, two and one episode; the last has no scored pair. Two runs of a
    hundred and eighty episodes. Expect each task once, with pairs, means and difference
    of its episodes."""
    count = [
        PlannedEpisode("success", task="count"),
        PlannedEpisode("failure", task="count"),
    ]
    echo = PlannedEpisode(None, task="echo")
    base, planned_run = play_runs(
        context,
        [SUCCESS, FAILURE, ABANDONED, *count, echo],
        [FAILURE, FAILURE, SUCCESS, *reversed(count), echo],
    )
    actual, expected = (
        compare_planned_runs(context, base, planned_run)["by_task"],
        expected_entry(base, planned_run)["by_task"],
    )
    expect_tasks(actual, expected)
    actual, expected = compare_long_runs(context)
    expect_tasks(actual["by_task"], expected["by_task"])


@on_long_run
@requirement("CMP-006")
def test_cmp_006_counts_one_sided_successes(context: CheckContext) -> None:
    """Every pair of success, failure, abandoned and unscored, in different numbers; two
    runs of a hundred and eighty episodes that were scored in different orders. Expect
    the counts; in reverse order wins and losses are exchanged."""
    base, planned_run = play_runs(
        context,
        [
            SUCCESS,
            SUCCESS,
            SUCCESS,
            SUCCESS,
            FAILURE,
            FAILURE,
            ABANDONED,
            ABANDONED,
            SUCCESS,
        ],
        [
            FAILURE,
            ABANDONED,
            FAILURE,
            SUCCESS,
            SUCCESS,
            FAILURE,
            SUCCESS,
            FAILURE,
            UNPLAYED,
        ],
    )
    pairs = ((base, planned_run), (planned_run, base), (planned_run, planned_run))
    entries = [
        (compare_planned_runs(context, *pair), expected_entry(*pair)) for pair in pairs
    ]
    for entry, expected in (*entries, compare_long_runs(context)):
        for member in ("wins", "losses", "ties"):
            expect.equal(entry[member], expected[member], member)


def entry_of(planned_run: PlannedRun, entries: list[dict[str, Any]]) -> dict[str, Any]:
    """Find the entry of a run among those of a comparison."""
    for entry in entries:
        if entry["run_id"] == planned_run.run.id:
            return entry
    raise SetUpFailed("a comparison leaves a run out", breaks="CMP-001")


@on_long_run
@requirement("CMP-007")
def test_cmp_007_p_value_is_exact(context: CheckContext) -> None:
    """A baseline with six successes in twelve episodes, and runs from equal to opposite
    outcomes; two runs that differ in more than 170 episodes. Expect the p-value of each
    within 1e-9, and 1 for equal outcomes."""
    half = [SUCCESS] * 6 + [FAILURE] * 6
    others = [[*half], [FAILURE] * 6 + [SUCCESS] * 6, [FAILURE] * 12, [SUCCESS] * 12]
    others += [[FAILURE, *half[1:]], [FAILURE] * 4 + half[4:11] + [SUCCESS]]
    base, *planned_runs = play_runs(context, half, *others)
    entries = compare(
        context, base.run, *(planned_run.run for planned_run in planned_runs)
    )
    for planned_run in planned_runs:
        expected = expected_entry(base, planned_run)
        what = f"p_value of {expected['wins']} wins, {expected['losses']} losses"
        entry = entry_of(planned_run, entries)
        expect_close(entry["p_value"], expected["p_value"], what)
    entry, expected = compare_long_runs(context)
    expect_close(entry["p_value"], expected["p_value"], "p_value of long runs")


@requirement("CMP-008")
def test_cmp_008_release_needs_every_difference_within_tolerance(
    context: CheckContext,
) -> None:
    """A baseline and runs that are equal, slightly or much worse or better, close only
    in total, and incomplete, with several tolerances. Expect `release` where no
    difference exceeds the tolerance, the limit included."""

    def scores(first: float, second: float) -> list[PlannedEpisode]:
        return [
            PlannedEpisode("failure", first),
            PlannedEpisode("success", second),
            even,
        ]

    even = PlannedEpisode("success", task="count")
    plans = [scores(0.5, 0.5), scores(0.5, 0.25), scores(0.75, 0.5), scores(1, 0)]
    plans += [scores(0.5, 0.42), scores(0.5, 0.38), scores(0.62, 0.5)]
    # In the task `score`, 2e-8 beyond the tolerance, 1e-10 beyond, and less.
    plans += [scores(0.5, 0.5 - 2 * x) for x in (0.05 + 2e-8, 0.05 + 1e-10, 0.0499)]
    plans += [scores(0.5 + 2 * x, 0.5) for x in (0.05 + 2e-8, 0.05 + 1e-10, 0.0499)]
    plans += [[*scores(0.5, 0.5)[:2], PlannedEpisode("failure", task="count")]]
    plans += [[*scores(0.5, 0.5)[:2], PlannedEpisode(None, task="count")]]
    base, *planned_runs = play_runs(context, scores(0.5, 0.5), *plans)
    for tolerance in (None, 0.0, 0.125, 0.25, 0.35, 1.0):
        runs = [planned_run.run for planned_run in planned_runs]
        entries = compare(context, base.run, *runs, tolerance=tolerance)
        allowed = DEFAULT_TOLERANCE if tolerance is None else tolerance
        for planned_run in planned_runs:
            expected = expected_entry(base, planned_run, allowed)
            text = f"release with difference {float(expected['difference']):+.4f}"
            text += f", tolerance {'absent' if tolerance is None else tolerance}"
            release = entry_of(planned_run, entries)["release"]
            expect.equal(release, expected["release"], text)
    unfinished = compare_planned_runs(context, planned_runs[-1], base, 1.0)
    expect.equal(unfinished["release"], False, "release beside an incomplete baseline")


@requirement("CMP-009")
def test_cmp_009_cannot_compare_runs_of_different_manifests(
    context: CheckContext,
) -> None:
    """Runs with other tasks, lengths and rules, alone and after a comparable one.
    Expect `not_comparable` pointing at `query:runs`; the comparable one is compared."""
    base, good = (context.submit("score", "count", wait_ready=False) for _ in range(2))
    incomparable_runs = [
        context.submit("score", "score", wait_ready=False),
        context.submit("score", "count", "score", wait_ready=False),
        context.submit("score", "count", max_steps=3, wait_ready=False),
    ]
    for incomparable_run in incomparable_runs:
        for named in (incomparable_run.id, f"{good.id},{incomparable_run.id}"):
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
        members = {name: entry[name] for name in nothing}
        expect.equal(without(members), nothing, f"comparison when {state}")


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
            expect.equal(comparison["baseline"], base.id, "baseline")
            for name in ("benchmark_id", "manifest_sha256"):
                expect.equal(comparison[name], body[name], name)
            applied = DEFAULT_TOLERANCE if tolerance is None else tolerance
            expect.equal(comparison["tolerance"], applied, "tolerance")
