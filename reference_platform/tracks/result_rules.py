"""Results of a phase: what an account sees of each, and their order. Pure.

Its owner sees all of a result; other accounts see what its phase shows now (HST-026).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any, Final, Literal

import msgspec

from reference_platform.tracks.track_rules import SHOWN, Phase, Ranks, Shown

_HOSTED_PARTS: Final = frozenset(SHOWN)
_PARTS: Final = _HOSTED_PARTS - {"log"}


class StoredResult(msgspec.Struct, frozen=True, gc=False):
    """result_id: of the submission, or of the run that was made elsewhere.

    flag: what the host says of its entry. is_withdrawn: the entry, by its owner.
    is_suspended: its owner. document: its
    figures, as JSON. place: among the results of its entrant in the phase, as `ranks`
    of the phase says; the first one stands for the entrant.
    """

    result_id: str
    track_id: str
    phase_id: str
    owner: str
    policy_name: str
    made_at: float
    run_id: str
    score: float | None
    is_hosted: bool
    flag: str | None = None
    is_withdrawn: bool = False
    is_suspended: bool = False
    document: str | None = None
    place: int = 1

    @property
    def parts(self) -> frozenset[Shown]:
        """Only a policy that the host runs has a log there."""
        return _HOSTED_PARTS if self.is_hosted else _PARTS

    @property
    def excluded(self) -> Literal["flagged", "withdrawn", "suspended"] | None:
        """HST-044, HST-045: why it has no rank, as BRD-012 has it for its entry."""
        if self.flag is not None:
            return "flagged"
        if self.is_withdrawn:
            return "withdrawn"
        return "suspended" if self.is_suspended else None


class ShownResult(msgspec.Struct, frozen=True, gc=False):
    """A result as one account sees it. shown: the parts that it may see."""

    stored: StoredResult
    shown: frozenset[Shown]

    @property
    def score(self) -> float | None:
        return self.stored.score if "score" in self.shown else None

    @property
    def figures(self) -> Mapping[str, Any] | None:
        """Parts of the schema Score; None if they are not shown, or missing."""
        if "score" not in self.shown or self.stored.document is None:
            return None
        figures: Mapping[str, Any] | None = msgspec.json.decode(self.stored.document)
        return figures


def seen_by(
    owners: Collection[str], results: Iterable[StoredResult], phase: Phase, now: float
) -> Sequence[ShownResult]:
    """Those of which something is shown to an account that acts for these owners."""
    of_others = frozenset(part for part in SHOWN if phase.shows(part, now))
    seen = (
        ShownResult(one, one.parts if one.owner in owners else one.parts & of_others)
        for one in results
    )
    return [one for one in seen if one.shown]


def in_order(
    results: Iterable[ShownResult], ranks: Ranks
) -> Sequence[tuple[int, ShownResult]]:
    """Each result with its place among those of its entrant; the best first.

    Those with the first place, which stand for their entrants, come before all others.
    """
    counted: Counter[str] = Counter()
    placed = []
    for one in sorted(results, key=_quality if ranks == "best" else _age):
        counted[one.stored.owner] += 1
        placed.append((counted[one.stored.owner], one))
    return sorted(
        placed, key=lambda with_place: (with_place[0], *_quality(with_place[1]))
    )


def _quality(one: ShownResult) -> tuple[bool, bool, float, float, str]:
    """HST-044: one that is excluded is behind all others, as on the leaderboard.

    A score that is not seen is last; the earlier one of two equal ones is better.
    """
    score, stored = one.score, one.stored
    ways = -(score or 0.0), stored.made_at, stored.result_id
    return stored.excluded is not None, score is None, *ways


def _age(one: ShownResult) -> tuple[bool, float, str]:
    """The newest first. A withdrawal does not choose an earlier one in its place."""
    stored = one.stored
    yields = stored.excluded not in (None, "withdrawn")
    return yields, -stored.made_at, stored.result_id
