"""The expected score of a run: `spec/scoring.md` as arithmetic. Pure.

Sums and quotients are exact fractions of the numbers sent, so that a response is
compared with the exact value and not with another rounding. Takes episodes in the
format of `spec/vectors/scoring/` and gives the computed members of the schema Score.
"""

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from math import isfinite, sqrt
from typing import Any

Z = 1.959963984540054
SUM_TOLERANCE = Fraction(1, 10**12)  # stated by SCORE-006
INTERVAL_TOLERANCE = Fraction(1, 10**9)  # a root is not exact in any language
OUTCOMES = ("success", "failure", "abandoned")


def expected_score(episodes: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Score at least one episode; `outcome` is None where there is none yet."""
    total = len(episodes)
    tally = _counts(episodes)
    scored = total - tally["unscored"]
    earned = _sum(episodes)
    whole = _group(episodes)
    return {
        "complete": scored == total,
        "score": earned / total if scored == total else None,
        "score_low": earned / total,
        "score_high": (earned + total - scored) / total,
        "counts": tally,
        "success_rate": whole["success_rate"],
        "success_interval": wilson(whole["success_rate"], scored),
        "mean": whole["mean"],
        "mean_interval": wilson(whole["mean"], scored),
        "by_task": _by("task", episodes),
        "by_split": _by("split", episodes),
    }


def wilson(rate: Fraction | None, n: int) -> dict[str, float]:
    """Give the 95 % interval of a rate over n trials; [0, 1] without a trial."""
    if rate is None:
        return {"low": 0.0, "high": 1.0}
    p, z2 = float(rate), Z * Z
    centre = (p + z2 / (2 * n)) / (1 + z2 / n)
    half = Z / (1 + z2 / n) * sqrt(p * (1 - p) / n + z2 / (4 * n * n))
    return {"low": max(0.0, centre - half), "high": min(1.0, centre + half)}


def is_close(observed: object, expected: Fraction | float | None) -> bool:
    """Whether a number is the expected one; null only where null is expected."""
    if expected is None or observed is None:
        return observed is expected
    if isinstance(observed, bool) or not isinstance(observed, int | float):
        return False
    is_exact = isinstance(expected, Fraction)
    tolerance = SUM_TOLERANCE if is_exact else INTERVAL_TOLERANCE
    if not isfinite(observed):
        return False
    return abs(Fraction(observed) - Fraction(expected)) <= tolerance


def _counts(episodes: Iterable[Mapping[str, Any]]) -> dict[str, int]:
    outcomes = [episode["outcome"] for episode in episodes]
    counts = {outcome: outcomes.count(outcome) for outcome in OUTCOMES}
    return {"total": len(outcomes), **counts, "unscored": outcomes.count(None)}


def _sum(episodes: Iterable[Mapping[str, Any]]) -> Fraction:
    # An abandoned episode has score 0: SCORE-004.
    earning = (e for e in episodes if e["outcome"] in ("success", "failure"))
    return sum((Fraction(e["score"]) for e in earning), Fraction(0))


def _group(episodes: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    counts = _counts(episodes)
    scored = counts["total"] - counts["unscored"]
    return {
        "counts": counts,
        "mean": _sum(episodes) / scored if scored else None,
        "success_rate": Fraction(counts["success"], scored) if scored else None,
    }


def _by(member: str, episodes: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    names = dict.fromkeys(episode[member] for episode in episodes)
    return {
        name: _group([episode for episode in episodes if episode[member] == name])
        for name in names
    }
