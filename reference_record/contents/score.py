"""Computes the score that follows from the episodes of a record (spec/scoring.md).

The server has code of its own for it: a check that shares code with what it checks
repeats its errors.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Final, NamedTuple

from reference_record.generated.answers import (
    ComputedScore,
    GroupScore,
    Interval,
    Outcome,
    OutcomeCounts,
)

_Z: Final = 1.959963984540054
TOLERANCE: Final = 1e-9
# That of a score which counts stages (SIM-037): some simulators compute with 32 bits.
STAGE_TOLERANCE: Final = 1e-6
# Characters of a value that an error text quotes at most.
SHOWN_CHARS: Final = 100


class ScoredLine(NamedTuple):
    """outcome, score: None while the episode is unscored."""

    task: str
    split: str
    outcome: Outcome | None
    score: float | None


def compute_score(episodes: Sequence[ScoredLine]) -> ComputedScore:
    """REC-013: the members of a score that follow from the episodes, at least one."""
    group = _group(episodes)
    total, unscored = len(episodes), group["counts"]["unscored"]
    low = _sum(episodes) / total
    return {
        "complete": unscored == 0,
        "score": None if unscored else low,
        "score_low": low,
        "score_high": low + unscored / total,
        "counts": group["counts"],
        "mean": group["mean"],
        "success_rate": group["success_rate"],
        "success_interval": wilson_interval(group["success_rate"], total - unscored),
        "mean_interval": wilson_interval(group["mean"], total - unscored),
        "by_task": _by(episodes, lambda episode: episode.task),
        "by_split": _by(episodes, lambda episode: episode.split),
    }


def first_difference(expected: Any, stated: Any, path: str = "") -> str | None:
    """The first member in which the stated score differs, with both values; else None.

    Numbers may differ by TOLERANCE. A score may have members of its own beside those of
    `expected`, but no further task, split or count.
    """
    if isinstance(expected, Mapping):
        if not isinstance(stated, Mapping):
            return f"{path} is no object"
        if path and (more := sorted(set(stated) - set(expected))):
            return f"{path}/{more[0]} has no episode"
        for name, value in expected.items():
            if name not in stated:
                return f"{path}/{name} is missing"
            if difference := first_difference(value, stated[name], f"{path}/{name}"):
                return difference
        return None
    equal = _equal(expected, stated)
    return None if equal else f"{path} is {_shown(stated)}, not {_shown(expected)}"


def _equal(expected: Any, stated: Any) -> bool:
    if expected is None or isinstance(expected, bool) or isinstance(stated, bool):
        return expected is stated
    if not isinstance(stated, int | float):
        return False
    try:
        return bool(abs(expected - stated) <= TOLERANCE)
    except OverflowError:  # an integer beyond every float
        return False


def _shown(value: Any) -> str:
    """A value as an error text quotes it: the author of the record chose its length."""
    if isinstance(value, int) and value.bit_length() > 1024:
        return "a huge integer"  # Python refuses to print integers of so many digits
    return f"{value}"[:SHOWN_CHARS]


def wilson_interval(rate: float | None, n: int) -> Interval:
    """95 % interval, `low` and `high`, of a rate that was seen in n episodes."""
    if rate is None:
        return {"low": 0.0, "high": 1.0}
    z2 = _Z * _Z
    centre = (rate + z2 / (2 * n)) / (1 + z2 / n)
    root = math.sqrt(max(0.0, rate * (1 - rate)) / n + z2 / (4 * n * n))
    half = _Z / (1 + z2 / n) * root
    return {"low": max(0.0, centre - half), "high": min(1.0, centre + half)}


def _sum(episodes: Iterable[ScoredLine]) -> float:
    return math.fsum(episode.score or 0.0 for episode in episodes)


def _group(episodes: Sequence[ScoredLine]) -> GroupScore:
    outcomes = [episode.outcome for episode in episodes]
    scored = len(outcomes) - outcomes.count(None)
    counts: OutcomeCounts = {
        "total": len(outcomes),
        "success": outcomes.count("success"),
        "failure": outcomes.count("failure"),
        "abandoned": outcomes.count("abandoned"),
        "unscored": len(outcomes) - scored,
    }
    return {
        "counts": counts,
        "mean": _sum(episodes) / scored if scored else None,
        "success_rate": counts["success"] / scored if scored else None,
    }


def _by(
    episodes: Sequence[ScoredLine], key: Callable[[ScoredLine], str]
) -> dict[str, GroupScore]:
    groups: dict[str, list[ScoredLine]] = {}
    for episode in episodes:
        groups.setdefault(key(episode), []).append(episode)
    return {name: _group(members) for name, members in groups.items()}
