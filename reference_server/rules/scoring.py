"""Episodes in, score out: `spec/scoring.md` in code. Pure."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from operator import attrgetter
from typing import NamedTuple

from reference_record.generated.answers import (
    ComputedScore,
    GroupScore,
    Interval,
    Outcome,
    OutcomeCounts,
)

Z_95 = 1.959963984540054  # the 97.5 % point of the normal distribution


class ScoredEpisode(NamedTuple):
    """The members of an episode that scoring reads. outcome: None while unscored."""

    task: str
    split: str
    outcome: Outcome | None
    score: float = 0.0


def wilson(rate: float | None, n: int) -> Interval:
    """SCORE-012: the 95 % Wilson interval of a rate over n trials; [0, 1] for n = 0."""
    if rate is None or n == 0:
        return {"low": 0.0, "high": 1.0}
    z2 = Z_95 * Z_95
    centre = (rate + z2 / (2 * n)) / (1 + z2 / n)
    spread = math.sqrt(max(0.0, rate * (1 - rate)) / n + z2 / (4 * n * n))
    half = Z_95 / (1 + z2 / n) * spread
    return {"low": max(0.0, centre - half), "high": min(1.0, centre + half)}


def score_of(episodes: Sequence[ScoredEpisode]) -> ComputedScore:
    """The score of one run's episodes (at least one)."""
    total = len(episodes)  # N
    group = _group(episodes)
    scored = total - group["counts"]["unscored"]
    sum_ = _sum(episodes)
    complete = scored == total
    return {
        "complete": complete,  # SCORE-005
        "score": sum_ / total if complete else None,  # SCORE-006
        "score_low": sum_ / total,  # SCORE-007
        "score_high": (sum_ + (total - scored)) / total,
        "counts": group["counts"],
        "mean": group["mean"],
        "success_rate": group["success_rate"],
        "success_interval": wilson(group["success_rate"], scored),
        "mean_interval": wilson(group["mean"], scored),  # SCORE-013
        "by_task": _by(episodes, attrgetter("task")),  # SCORE-011
        "by_split": _by(episodes, attrgetter("split")),
    }


def _sum(episodes: Iterable[ScoredEpisode]) -> float:
    # fsum is exact before its one rounding: 1e-12 holds for any number of episodes.
    # SCORE-004: an abandoned episode has score 0 and stays in every denominator.
    return math.fsum(e.score for e in episodes if e.outcome in ("success", "failure"))


def _counts(episodes: Sequence[ScoredEpisode]) -> OutcomeCounts:
    """SCORE-008."""
    outcomes = [episode.outcome for episode in episodes]
    return {
        "total": len(outcomes),
        "success": outcomes.count("success"),
        "failure": outcomes.count("failure"),
        "abandoned": outcomes.count("abandoned"),
        "unscored": outcomes.count(None),
    }


def _group(episodes: Sequence[ScoredEpisode]) -> GroupScore:
    """SCORE-009: null where there is nothing to divide by."""
    counts = _counts(episodes)
    scored = counts["total"] - counts["unscored"]
    return {
        "counts": counts,
        "mean": _sum(episodes) / scored if scored else None,
        "success_rate": counts["success"] / scored if scored else None,
    }


def _by(
    episodes: Sequence[ScoredEpisode], key: Callable[[ScoredEpisode], str]
) -> dict[str, GroupScore]:
    groups: dict[str, list[ScoredEpisode]] = {}
    for episode in episodes:
        groups.setdefault(key(episode), []).append(episode)
    return {name: _group(members) for name, members in groups.items()}
