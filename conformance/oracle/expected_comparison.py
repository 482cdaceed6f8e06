"""The expected comparison of two runs, as the end of `spec/scoring.md` states it. Pure.

Exact fractions of the numbers sent, as in `expected_score.py`. Takes the episodes of
two runs in the format of `spec/vectors/scoring/` and gives the computed members of the
schema ComparedRun.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import comb
from typing import Any

ROUNDING = Fraction(1, 10**9)  # stated by CMP-008

Episode = Mapping[str, Any]
Pair = tuple[Episode, Episode]


def expected_comparison(
    baseline: Sequence[Episode], run: Sequence[Episode], tolerance: float
) -> dict[str, Any]:
    """Compare two runs of one manifest."""
    all_pairs = list(zip(baseline, run, strict=True))
    pairs = [c for c in all_pairs if all(episode["outcome"] for episode in c)]
    whole = _group(pairs)
    tasks = {
        task: _group([pair for pair in pairs if pair[1]["task"] == task])
        for task in dict.fromkeys(episode["task"] for episode in run)
    }
    wins, losses = _count_one_sided(pairs, 1), _count_one_sided(pairs, 0)
    is_complete = len(pairs) == len(all_pairs)
    limit = Fraction(tolerance) + ROUNDING
    is_within_tolerance = is_complete and all(
        abs(group["difference"]) <= limit for group in (whole, *tasks.values())
    )
    return {
        "complete": is_complete,
        "release": is_within_tolerance,
        **whole,
        "wins": wins,
        "losses": losses,
        "ties": len(pairs) - wins - losses,
        "p_value": float(mcnemar(wins, losses)),
        "by_task": tasks,
    }


def mcnemar(wins: int, losses: int) -> Fraction:
    """Give the p-value of the exact two-sided test."""
    n = wins + losses
    tail = sum(comb(n, k) for k in range(min(wins, losses) + 1))
    return min(Fraction(1), Fraction(2 * tail, 2**n))


def _count_one_sided(pairs: Sequence[Pair], side: int) -> int:
    """Count the pairs in which one side succeeds and the other does not."""
    return sum(
        pair[side]["outcome"] == "success" != pair[1 - side]["outcome"]
        for pair in pairs
    )


def _group(pairs: Sequence[Pair]) -> dict[str, Any]:
    if not pairs:
        nothing = dict.fromkeys(("baseline_mean", "mean", "difference"))
        return {"paired": 0, **nothing}
    base, run = (
        sum((_score_of(pair[side]) for pair in pairs), Fraction(0)) / len(pairs)
        for side in (0, 1)
    )
    return {
        "paired": len(pairs),
        "baseline_mean": base,
        "mean": run,
        "difference": base - run,
    }


def _score_of(episode: Episode) -> Fraction:
    # SCORE-004: an abandoned episode scores 0.
    return Fraction(0 if episode["outcome"] == "abandoned" else episode["score"])
