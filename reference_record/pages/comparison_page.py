"""Two runs of one manifest, episode by episode.

What the comparison says in numbers is what `compare_runs` answered, or where there is
no server what spec/scoring.md says of the same episodes.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from reference_record.pages.run_page import Document

# In this order they are shown: what changed stands first.
KINDS: Final = {
    "lost": "only the baseline succeeds",
    "won": "only this run succeeds",
    "neither": "neither succeeds",
    "both": "both succeed",
    "open": "one has no result yet",
}


@dataclass(frozen=True, slots=True)
class Pair:
    """One episode in the baseline and in the run."""

    kind: str
    baseline: Document
    run: Document


def pair_episodes(baseline: Sequence[Document], run: Sequence[Document]) -> list[Pair]:
    """The episodes of both, by their index; what changed stands first."""
    others = {one["index"]: one for one in run}
    pairs = [
        Pair(_kind(one, others[one["index"]]), one, others[one["index"]])
        for one in baseline
        if one["index"] in others
    ]
    order = list(KINDS)
    return sorted(pairs, key=lambda p: (order.index(p.kind), p.baseline["index"]))


def _kind(baseline: Document, run: Document) -> str:
    results = [baseline.get("result"), run.get("result")]
    won = [result is not None and result["outcome"] == "success" for result in results]
    if None in results:
        return "open"
    return {(True, False): "lost", (False, True): "won", (True, True): "both"}.get(
        (won[0], won[1]), "neither"
    )


def count_kinds(pairs: Sequence[Pair]) -> Mapping[str, int]:
    counted = Counter(pair.kind for pair in pairs)
    return {kind: counted[kind] for kind in KINDS}


def compare_pairs(pairs: Sequence[Pair]) -> dict[str, Any]:
    """The members of schema ComparedRun that the page shows, of pairs with results."""
    closed = [pair for pair in pairs if pair.kind != "open"]
    counts = count_kinds(closed)
    means = [
        math.fsum(side["result"]["score"] for side in sides) / len(closed)
        if closed
        else None
        for sides in ([p.baseline for p in closed], [p.run for p in closed])
    ]
    return {
        "paired": len(closed),
        "baseline_mean": means[0],
        "mean": means[1],
        "wins": counts["won"],
        "losses": counts["lost"],
        "p_value": _mcnemar(counts["won"], counts["lost"]),
    }


def _mcnemar(wins: int, losses: int) -> float:
    """Exact and two-sided, as spec/scoring.md has it."""
    n = wins + losses
    tail, ways = 0, 1
    for k in range(min(wins, losses) + 1):
        tail += ways
        ways = ways * (n - k) // (k + 1)
    return min(1.0, 2 * tail / (1 << n))
