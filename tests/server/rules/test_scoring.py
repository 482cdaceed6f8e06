"""The numbers of a score: the vectors, known intervals, and the oracle of the kit."""

import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from conformance.oracle.expected_score import expected_score
from reference_record.generated.answers import Outcome
from reference_server.rules.scoring import Z_95, ScoredEpisode, score_of, wilson
from tests.support.kit.score_differences import differences
from tests.support.paths import ROOT
from tests.support.repository.answer_schemas import check_answer
from tests.support.server.score_equality import EXACTNESS, assert_same

VECTORS = sorted((ROOT / "spec" / "vectors" / "scoring").glob("*.json"))


@st.composite
def scored_episodes(draw: st.DrawFn) -> ScoredEpisode:
    outcome: Outcome | None = draw(
        st.sampled_from([None, "success", "failure", "abandoned"])
    )
    # The values of an abandoned episode count for nothing.
    return ScoredEpisode(
        task=draw(st.sampled_from("abc")),
        split=draw(st.sampled_from("xy")),
        outcome=outcome,
        score=draw(st.floats(0, 1)),
    )


runs = st.lists(scored_episodes(), min_size=1, max_size=60)


@pytest.mark.parametrize("path", VECTORS, ids=lambda path: path.stem)
def test_a_vector_is_scored_as_it_says(path: Path) -> None:
    vector = json.loads(path.read_text())
    episodes = [
        ScoredEpisode(e["task"], e["split"], e["outcome"], e.get("score") or 0.0)
        for e in vector["episodes"]
    ]
    assert_same(score_of(episodes), vector["score"])


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
def test_the_oracle_of_the_kit_says_the_same(episodes: list[ScoredEpisode]) -> None:
    expected = expected_score([episode._asdict() for episode in episodes])
    assert differences(score_of(episodes), expected) == []


@given(runs)
def test_a_score_fits_its_schema(episodes: list[ScoredEpisode]) -> None:
    names = {"run_id": "r", "benchmark_id": "b", "state": "running"}
    names |= {"manifest_sha256": "0" * 64}
    check_answer("Score", {**names, **score_of(episodes)})
