"""How people judged a run: a summary of the acts at its cell. Pure.

It names no account: a reader of the run learns who judged by pseudonym alone.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from typing import Any


def judged_run(
    acts: Iterable[Mapping[str, Any]], pseudonym: Callable[[str], str]
) -> dict[str, Any] | None:
    """Schema JudgedRun of the acts of one run; None without a judgement or a void."""
    # An episode that was played again after its judgement has the later one.
    judgements: dict[str, Mapping[str, Any]] = {}
    voids: Counter[str] = Counter()
    for line in acts:
        if line.get("act") == "judge":
            judgements[line["episode"]] = line
        elif line.get("act") == "void":
            voids[line["reason"]] += 1
    if not judgements and not voids:
        return None
    given = judgements.values()
    return {
        "judges": sorted({pseudonym(line["operator"]) for line in given}),
        "judgements": len(judgements),
        "blind": all(line.get("blind", True) for line in given),
        "voids": dict(voids),
        "notes": {
            episode: line["note"]
            for episode, line in sorted(judgements.items())
            if line["note"]
        },
    }
