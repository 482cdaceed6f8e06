"""The expected ranking of entries, as `spec/profiles/board.md` states it. Pure.

Written apart from any server: whole fractions instead of floating point, sets instead
of bits. Takes entries in the order in which they were published.
"""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from conformance.oracle.expected_comparison import mcnemar

ALPHA = Fraction(5, 100)


@dataclass(frozen=True)
class RankedRun:
    """An entry: `1` or `0` for each episode; None for one without a rank."""

    entry_id: str
    score: float
    successes: str | None


def expected_ranking(
    entries: Sequence[RankedRun], episodes_total: int
) -> dict[str, Any]:
    """Give the computed members of the schema Ranking, rows by `entry_id`.

    episodes_total: of the manifest; 0 where there is no entry.
    """
    places = {entry.entry_id: place for place, entry in enumerate(entries)}
    in_order = sorted(
        entries,
        key=lambda e: (-e.score, -(e.successes or "").count("1"), places[e.entry_id]),
    )
    ranked = [entry for entry in in_order if entry.successes is not None]
    better = _pairs_by_holm(ranked)
    n = len(ranked)
    pairs = n * (n - 1) // 2
    rows = []
    letters = _letters([entry.entry_id for entry in ranked], better)
    for entry in ranked:
        wins = sum(winner == entry.entry_id for winner, _ in better)
        losses = sum(loser == entry.entry_id for _, loser in better)
        rows.append(
            {
                "entry_id": entry.entry_id,
                "rank": {"low": 1 + losses, "high": n - wins},
                "better": losses,
                "worse": wins,
                "letters": letters[entry.entry_id],
            }
        )
    unranked = [entry for entry in in_order if entry.successes is None]
    nothing: dict[str, Any] = {"rank": None, "better": 0, "worse": 0, "letters": []}
    rows += [{"entry_id": entry.entry_id, **nothing} for entry in unranked]
    return {
        "ranked": n,
        "comparisons": pairs,
        "differing_min": _least(ALPHA, episodes_total),
        "differing_enough": _least(ALPHA / max(1, pairs), episodes_total),
        "rows": rows,
    }


def _least(bound: Fraction, episodes: int) -> int | None:
    """Give the least k with 2^(1 - k) <= bound, unless there are fewer episodes."""
    k = next(k for k in itertools.count(1) if Fraction(2, 2**k) <= bound)
    return k if k <= episodes else None


def _pairs_by_holm(ranked: Sequence[RankedRun]) -> set[tuple[str, str]]:
    """Give (better, worse) of each pair that is distinguished."""
    tested = []
    p_values: dict[tuple[int, int], Fraction] = {}
    for first, second in itertools.combinations(ranked, 2):
        wins, losses = (
            sum(a == "1" and b == "0" for a, b in zip(*pair, strict=True))
            for pair in (
                (first.successes or "", second.successes or ""),
                (second.successes or "", first.successes or ""),
            )
        )
        p = p_values.setdefault((wins, losses), mcnemar(wins, losses))
        pair = (first, second) if wins > losses else (second, first)
        tested.append((p, pair[0].entry_id, pair[1].entry_id))
    tested.sort()
    distinguished = set()
    for left, (p, winner, loser) in zip(range(len(tested), 0, -1), tested, strict=True):
        if p > ALPHA / left:
            break
        distinguished.add((winner, loser))
    return distinguished


def _letters(ids: Sequence[str], better: set[tuple[str, str]]) -> dict[str, list[str]]:
    """Give the letters of each entry; ids in the order of the rows."""

    def alike(first: str, second: str) -> bool:
        return (first, second) not in better and (second, first) not in better

    groups: list[set[str]] = []
    for place, first in enumerate(ids):
        for second in ids[place + 1 :]:
            if alike(first, second) and not any({first, second} <= g for g in groups):
                group = {first, second}
                for third in ids:
                    if all(alike(third, member) for member in group - {third}):
                        group.add(third)
                groups.append(group)
        if not any(first in group for group in groups):
            groups.append({first})
    return {
        first: [_letter(k) for k, group in enumerate(groups) if first in group]
        for first in ids
    }


def _letter(place: int) -> str:
    """Give a to z, then aa, ab and so on."""
    length, first = 1, 0
    while place - first >= 26**length:
        first += 26**length
        length += 1
    rest, text = place - first, ""
    for _ in range(length):
        rest, digit = divmod(rest, 26)
        text = chr(ord("a") + digit) + text
    return text
