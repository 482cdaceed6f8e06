"""Runs beside a baseline, offered with the profile `compare` (CMP).

What each must come to is worked out in `oracle/expected_comparison.py` from what was
played.
Every check also asks for what any comparison obeys: a run beside itself, two runs that
change places.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import permutations
from typing import Any

from hypothesis import strategies as st

from conformance.checks.runs.test_scoring import (
    GIVEN_UP,
    LEFT,
    LOST,
    TRIAL,
    WON,
    Game,
    Trial,
    close,
)
from conformance.checks.support.generated_examples import for_all
from conformance.checks.support.given_states import run_in, without
from conformance.client.check_context import Run, Story
from conformance.oracle.expected_comparison import expected_comparison
from conformance.runner.requirement import requirement
from conformance.verdicts import expect

DEFAULT_TOLERANCE = 0.05
MEANS = ("baseline_mean", "mean", "difference")


def compared(
    story: Story, baseline: Run, *runs: Run, tolerance: float | None = None
) -> list[dict[str, Any]]:
    """Compare runs with a baseline; the entries of the answer are under test."""
    params: dict[str, Any] = {"baseline": baseline.id}
    params["runs"] = ",".join(run.id for run in runs)
    if tolerance is not None:
        params["tolerance"] = tolerance
    body = expect.ok(story.call("compare_runs", params=params))
    entries: list[dict[str, Any]] = body["runs"]
    return entries


def beside(
    story: Story, base: Game, game: Game, tolerance: float | None = None
) -> dict[str, Any]:
    """Compare one game with another."""
    (entry,) = compared(story, base.run, game.run, tolerance=tolerance)
    return entry


def due(base: Game, game: Game, tolerance: float = DEFAULT_TOLERANCE) -> dict[str, Any]:
    """Work out what a comparison of two games must come to."""
    return expected_comparison(base.episodes(), game.episodes(), tolerance)


def played(story: Story, *matches: Sequence[Trial]) -> list[Game]:
    """Play runs of one manifest."""
    games = [Game(story, trials) for trials in matches]
    for game in games:
        game.play_all()
    return games


def close_means(found: dict[str, Any], expected: dict[str, Any], what: str) -> None:
    """Expect both means and their difference."""
    for member in MEANS:
        close(found[member], expected[member], f"{member} {what}")


@requirement("CMP-001")
def test_cmp_001_one_entry_per_run_in_their_order(story: Story) -> None:
    """Three runs are named in every order, with the baseline and a run named twice.

    Expect the ids of the entries in that order.
    """
    base, *others = [game.run for game in played(story, *([[WON]] * 4))]
    for named in (*permutations(others), [others[0], base, others[0]]):
        entries = compared(story, base, *named)
        ids = [entry["run_id"] for entry in entries]
        expect.equal(ids, [run.id for run in named], "ids of the entries")


@requirement("CMP-002")
def test_cmp_002_pairs_are_scored_in_both(story: Story) -> None:
    """Two runs are played at different speeds; each abandons an episode.

    Expect after each step as many pairs as both have scored.
    """
    base = Game(story, [WON, GIVEN_UP, LOST, LEFT])
    game = Game(story, [LOST, WON, GIVEN_UP, LEFT])
    for steps in ((0, 1), (2, 0), (1, 1), (0, 1)):
        for one, times in zip((base, game), steps, strict=True):
            for _ in range(times):
                one.play_next()
        for pair in ((base, game), (game, base)):
            paired = beside(story, *pair)["paired"]
            expect.equal(paired, min(base.played, game.played), "paired")


@requirement("CMP-003")
def test_cmp_003_complete_when_both_are(story: Story) -> None:
    """A whole run, and one that lacks an episode, in both places; then both are whole.

    Expect `complete` only then.
    """
    whole, part = Game(story, [WON, LOST]), Game(story, [WON, GIVEN_UP])
    whole.play_all()
    part.play_next()
    for pair in ((whole, part), (part, whole), (part, part)):
        expect.equal(beside(story, *pair)["complete"], False, "complete")
    part.play_next()
    for pair in ((whole, part), (part, whole), (part, part)):
        expect.equal(beside(story, *pair)["complete"], True, "complete of whole runs")


@requirement("CMP-004")
def test_cmp_004_difference_is_baseline_minus_run(story: Story) -> None:
    """Two runs with generated outcomes, of which the second may lack some episodes.

    Expect null before there is a pair, then the means over the pairs and their
    difference, within 1e-12; 0 beside itself, and another sign in the other order.
    """

    def law(pairs: list[tuple[Trial, Trial]], left: int) -> None:
        base = Game(story, [first for first, _ in pairs])
        planned = [replace(second, task=first.task) for first, second in pairs]
        played = max(0, len(pairs) - left)
        planned[played:] = [replace(one, outcome=None) for one in planned[played:]]
        game = Game(story, planned)
        close_means(beside(story, base, game), due(base, game), "before the first")
        base.play_all()
        game.play_all()
        close_means(beside(story, base, game), due(base, game), "over the pairs")
        close_means(beside(story, base, base), due(base, base), "beside itself")
        close_means(beside(story, game, base), due(game, base), "in the other order")

    pairs = st.lists(st.tuples(TRIAL, TRIAL), min_size=1, max_size=12)
    cases = st.tuples(pairs, st.integers(0, 4))
    for_all(story, cases, lambda drawn: law(*drawn), times=5)


@requirement("CMP-005")
def test_cmp_005_groups_by_task(story: Story) -> None:
    """Tasks with three, two and one episode; of the last no pair is scored.

    Expect each task once, with pairs, means and difference of its episodes.
    """
    count = [Trial("success", task="count"), Trial("failure", task="count")]
    echo = Trial(None, task="echo")
    base, game = played(
        story,
        [WON, LOST, GIVEN_UP, *count, echo],
        [LOST, LOST, WON, *reversed(count), echo],
    )
    found, expected = beside(story, base, game)["by_task"], due(base, game)["by_task"]
    expect.equal(sorted(found), sorted(expected), "tasks")
    for task, group in expected.items():
        expect.equal(found[task]["paired"], group["paired"], f"paired of {task}")
        close_means(found[task], group, f"of {task}")


@requirement("CMP-006")
def test_cmp_006_counts_who_succeeds_alone(story: Story) -> None:
    """Every pair of success, failure, abandoned and unscored, in different numbers.

    Expect the counts; in the other order wins and losses change places.
    """
    base, game = played(
        story,
        [WON, WON, WON, WON, LOST, LOST, GIVEN_UP, GIVEN_UP, WON],
        [LOST, GIVEN_UP, LOST, WON, WON, LOST, WON, LOST, LEFT],
    )
    for pair in ((base, game), (game, base), (game, game)):
        entry, expected = beside(story, *pair), due(*pair)
        for member in ("wins", "losses", "ties"):
            expect.equal(entry[member], expected[member], member)


@requirement("CMP-007")
def test_cmp_007_p_value_is_exact(story: Story) -> None:
    """A baseline that wins half of twelve episodes, and runs from its twin to its
    contrary.

    Expect the p-value of each within 1e-9, and 1 for the twin.
    """
    half = [WON] * 6 + [LOST] * 6
    others = [[*half], [LOST] * 6 + [WON] * 6, [LOST] * 12, [WON] * 12]
    others += [[LOST, *half[1:]], [LOST] * 4 + half[4:11] + [WON]]
    base, *games = played(story, half, *others)
    entries = compared(story, base.run, *(game.run for game in games))
    by_id = {entry["run_id"]: entry for entry in entries}
    for game in games:
        expected = due(base, game)
        what = f"p_value of {expected['wins']} wins, {expected['losses']} losses"
        close(by_id[game.run.id]["p_value"], expected["p_value"], what)


@requirement("CMP-008")
def test_cmp_008_releases_what_is_near_everywhere(story: Story) -> None:
    """A baseline beside runs that are as good, a little or much worse or better, good
    only on the whole, and not yet complete, with several tolerances.

    Expect `release` where no difference is beyond the tolerance; on its edge, too.
    """

    def scores(first: float, second: float) -> list[Trial]:
        return [Trial("failure", first), Trial("success", second), even]

    even = Trial("success", task="count")
    plans = [scores(0.5, 0.5), scores(0.5, 0.25), scores(0.75, 0.5), scores(1, 0)]
    plans += [scores(0.5, 0.42), scores(0.5, 0.38), scores(0.62, 0.5)]
    plans += [[*scores(0.5, 0.5)[:2], Trial("failure", task="count")]]
    plans += [[*scores(0.5, 0.5)[:2], Trial(None, task="count")]]
    base, *games = played(story, scores(0.5, 0.5), *plans)
    for tolerance in (None, 0.0, 0.125, 0.25, 0.35, 1.0):
        runs = [game.run for game in games]
        entries = compared(story, base.run, *runs, tolerance=tolerance)
        found = {entry["run_id"]: entry["release"] for entry in entries}
        allowed = DEFAULT_TOLERANCE if tolerance is None else tolerance
        for game in games:
            expected = due(base, game, allowed)
            text = f"release with difference {float(expected['difference']):+.4f}"
            text += f", tolerance {'absent' if tolerance is None else tolerance}"
            expect.equal(found[game.run.id], expected["release"], text)


@requirement("CMP-009")
def test_cmp_009_cannot_compare_runs_of_different_manifests(story: Story) -> None:
    """Runs of other tasks, other lengths and other rules, alone and behind a good one.

    Expect `not_comparable` pointing at `query:runs`; the good one alone is compared.
    """
    base, good = (story.submit("score", "count", wait_ready=False) for _ in range(2))
    strangers = [
        story.submit("score", "score", wait_ready=False),
        story.submit("score", "count", "score", wait_ready=False),
        story.submit("score", "count", max_steps=3, wait_ready=False),
    ]
    for stranger in strangers:
        for named in (stranger.id, f"{good.id},{stranger.id}"):
            params = {"baseline": base.id, "runs": named}
            answer = story.call("compare_runs", params=params)
            expect.refused(answer, "not_comparable", pointer="query:runs")
    compared(story, base, good)


@requirement("CMP-010")
def test_cmp_010_cannot_compare_runs_of_others(story: Story) -> None:
    """Another account's runs and one that is none, as baseline and among the runs.

    Expect `not_found` from each, and service for the owner.
    """
    other = story.wire_2
    ours = story.submit("score", wait_ready=False)
    theirs = story.submit("score", wait_ready=False, wire=other)
    named = [(ours.id, ours.id), (theirs.id, ours.id), (theirs.id, f"{theirs.id},none")]
    named += [(ours.id, theirs.id), ("none", theirs.id)]
    for baseline, runs in named:
        params = {"baseline": baseline, "runs": runs}
        answer = story.call("compare_runs", params=params, wire=other)
        expect.refused(answer, "not_found")
    params = {"baseline": theirs.id, "runs": theirs.id}
    expect.ok(story.call("compare_runs", params=params, wire=other))


@requirement("CMP-011")
def test_cmp_011_answers_in_every_state(story: Story) -> None:
    """A run in each of the seven states, beside itself.

    Expect an answer in each, in which nothing differs.
    """
    for state in story.spec.lifecycle["states"]:
        run = run_in(story, state)
        (entry,) = compared(story, run, run)
        nothing = {"wins": 0, "losses": 0, "p_value": 1}
        found = {name: entry[name] for name in nothing}
        expect.equal(without(found), nothing, f"comparison when {state}")
