"""The numbers of a score: the vectors, known intervals, and exact arithmetic."""

import json
import random
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from reference_server.rules.run import Outcome
from reference_server.rules.scoring import Z_95, ScoredEpisode, score_of, wilson
from tests.support.paths import ROOT
from tests.support.repository.answer_schemas import check_answer
from tests.support.server.score_equality import EXACTNESS, assert_same

VECTORS = sorted((ROOT / "spec" / "vectors" / "scoring").glob("*.json"))


@st.composite
def scored_episodes(draw: st.DrawFn) -> ScoredEpisode:
    outcome: Outcome | None = draw(
        st.sampled_from([None, "success", "failure", "abandoned"])
    )
    score = 0.0
    if outcome in ("success", "failure"):
        score = draw(st.floats(0, 1))
    return ScoredEpisode(
        draw(st.sampled_from("abc")), draw(st.sampled_from("xy")), outcome, score
    )


runs = st.lists(scored_episodes(), min_size=1, max_size=60)


def by_hand(episodes: Sequence[ScoredEpisode]) -> tuple[Fraction, int, int]:
    """The exact sum of scores, how many are scored, how many successes."""
    scored = [e for e in episodes if e.outcome is not None]
    total = sum((Fraction(e.score) for e in scored), Fraction(0))
    return total, len(scored), sum(e.outcome == "success" for e in scored)


def test_there_are_vectors() -> None:
    assert len(VECTORS) >= 5


@pytest.mark.parametrize("path", VECTORS, ids=lambda path: path.stem)
def test_a_vector_is_scored_as_it_says(path: Path) -> None:
    vector = json.loads(path.read_text())
    episodes = [
        ScoredEpisode(e["task"], e["split"], e["outcome"], e.get("score") or 0.0)
        for e in vector["episodes"]
    ]
    assert_same(score_of(episodes), vector["score"])


def test_a_comparison_of_scores_can_fail() -> None:
    with pytest.raises(AssertionError, match=r"score\.a"):
        assert_same({"a": 0.5 + 2e-12}, {"a": 0.5})
    with pytest.raises(AssertionError):
        assert_same({"a": 1, "b": 2}, {"a": 1})


# --- the Wilson interval ---


@pytest.mark.parametrize(
    ("successes", "n", "low", "high"),
    [
        # Newcombe, Statistics in Medicine 17 (1998), table I, method 3.
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 20, 0.0, 0.1611),
        (1, 29, 0.0061, 0.1718),
    ],
)
def test_known_intervals(successes: int, n: int, low: float, high: float) -> None:
    found = wilson(successes / n, n)
    assert (round(found["low"], 4), round(found["high"], 4)) == (low, high)


def test_the_interval_without_trials_is_zero_to_one() -> None:
    assert wilson(None, 0) == {"low": 0.0, "high": 1.0}
    assert wilson(0.5, 0) == {"low": 0.0, "high": 1.0}
    assert wilson(None, 3) == {"low": 0.0, "high": 1.0}


@given(rate=st.floats(0, 1), n=st.integers(1, 10**7))
def test_the_ends_are_where_the_rate_is_z_deviations_away(rate: float, n: int) -> None:
    """Wilson's definition: (rate − end)² = z² · end · (1 − end) / n."""
    found = wilson(rate, n)
    assert 0 <= found["low"] <= rate + EXACTNESS
    assert rate - EXACTNESS <= found["high"] <= 1
    for end in (found["low"], found["high"]):
        spread = Z_95**2 * end * (1 - end) / n
        assert abs((rate - end) ** 2 - spread) <= EXACTNESS


@given(rate=st.floats(0, 1), n=st.integers(1, 10**6))
def test_more_trials_never_widen_the_interval(rate: float, n: int) -> None:
    few, many = wilson(rate, n), wilson(rate, 2 * n)
    assert many["high"] - many["low"] <= few["high"] - few["low"]


# --- any run ---


@given(runs)
def test_sums_are_exact(episodes: list[ScoredEpisode]) -> None:
    total, scored, successes = by_hand(episodes)
    found, number = score_of(episodes), len(episodes)

    def near(value: float | None, exact: Fraction) -> bool:
        return value is not None and abs(Fraction(value) - exact) <= EXACTNESS

    assert near(found["score_low"], total / number)
    assert near(found["score_high"], (total + number - scored) / number)
    assert found["complete"] == (scored == number)
    if found["complete"]:
        assert near(found["score"], total / number)
    else:
        assert found["score"] is None
    if scored:
        assert near(found["mean"], total / scored)
        assert near(found["success_rate"], Fraction(successes, scored))
    else:
        assert (found["mean"], found["success_rate"]) == (None, None)


@given(runs)
def test_counts_add_up(episodes: list[ScoredEpisode]) -> None:
    found: Any = score_of(episodes)
    groups = [found, *found["by_task"].values(), *found["by_split"].values()]
    for counts in (group["counts"] for group in groups):
        parts = ("success", "failure", "abandoned", "unscored")
        assert counts["total"] == sum(counts[part] for part in parts)
    for part, total in found["counts"].items():
        for groups_of in ("by_task", "by_split"):
            members = found[groups_of].values()
            assert total == sum(group["counts"][part] for group in members)
    assert set(found["by_task"]) == {e.task for e in episodes}
    assert set(found["by_split"]) == {e.split for e in episodes}


@given(runs)
def test_the_final_score_lies_within_the_bounds(episodes: list[ScoredEpisode]) -> None:
    found = score_of(episodes)
    assert 0 <= found["score_low"] <= found["score_high"] <= 1
    for rate in (found["mean"], found["success_rate"]):
        assert rate is None or 0 <= rate <= 1
    for score in (0.0, 1.0):
        rest = [
            e if e.outcome else ScoredEpisode(e.task, e.split, "failure", score)
            for e in episodes
        ]
        final = score_of(rest)["score"]
        assert final is not None
        slack = EXACTNESS
        assert found["score_low"] - slack <= final <= found["score_high"] + slack


@given(runs, st.randoms(use_true_random=False))
def test_the_order_of_episodes_does_not_matter(
    episodes: list[ScoredEpisode], chance: random.Random
) -> None:
    mixed = list(episodes)
    chance.shuffle(mixed)
    assert score_of(mixed) == score_of(episodes)


@given(runs)
def test_a_group_is_scored_like_a_run(episodes: list[ScoredEpisode]) -> None:
    for task, group in score_of(episodes)["by_task"].items():
        alone: Any = score_of([e for e in episodes if e.task == task])
        assert group == {key: alone[key] for key in group}
    for split, group in score_of(episodes)["by_split"].items():
        alone = score_of([e for e in episodes if e.split == split])
        assert group == {key: alone[key] for key in group}


def test_an_abandoned_episode_scores_nothing_whatever_it_carries() -> None:
    found = score_of(
        [
            ScoredEpisode("a", "x", "abandoned", 1.0),
            ScoredEpisode("a", "x", "success", 1.0),
        ]
    )
    assert (found["score"], found["success_rate"]) == (0.5, 0.5)


@given(runs)
def test_a_score_fits_its_schema(episodes: list[ScoredEpisode]) -> None:
    names = {"run_id": "r", "benchmark_id": "b", "state": "running"}
    names |= {"manifest_sha256": "0" * 64}
    check_answer("Score", {**names, **score_of(episodes)})
