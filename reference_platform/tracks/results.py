"""Results of a track, and who sees which part of them (HST-026).

A result is a completed run that counts, made on another machine or of a submission.
Its owner sees all of it; other accounts see what its phase shows now.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Final

import msgspec
from msgspec.structs import replace

from reference_platform.tracks.history_entries import HistoryEntries
from reference_platform.tracks.result_rules import (
    ShownResult,
    StoredResult,
    in_order,
    seen_by,
)
from reference_platform.tracks.run_figures import note_figures
from reference_platform.tracks.track_rules import Phase, Shown, Track
from reference_platform.tracks.tracks import RunReader, Tracks
from reference_server.rules.refusal import Refused

RESULTS_MAX: Final = 1000  # that one answer has
READS_MAX: Final = 20  # of runs at the server, in one request
AGAIN_S: Final = 60.0  # until a score that the server did not have is asked for again
_COMPLETED: Final = (
    "(SELECT run_id AS result_id, track_id, phase_id, account AS owner, "
    "policy_name, made_at, run_id, score, 0 AS is_hosted FROM track_runs "
    "WHERE state = 'completed' UNION ALL "
    "SELECT submission_id, track_id, phase_id, account, policy_name, started_at, "
    "run_id, score, 1 FROM submissions WHERE state = 'completed' AND run_id != '') "
)
# Those without figures; an earlier version has stored `null` for a run that was gone.
_MISSING: Final = (
    f"SELECT run_id, score FROM {_COMPLETED} "  # noqa: S608
    "LEFT JOIN run_figures USING (run_id) WHERE track_id = ? AND "
    "(score IS NULL OR document IS NULL OR document = 'null') "
    "ORDER BY score IS NOT NULL, made_at DESC"
)
# Results of a phase without their figures, and what may exclude each.
_OF_PHASE: Final = (
    "SELECT completed.*, entry.flag, "  # noqa: S608
    "owner IN (SELECT account FROM accounts WHERE state = 'suspended') "
    "AS is_suspended, COALESCE(entry.state = 'withdrawn', 0) AS is_withdrawn "
    f"FROM {_COMPLETED} AS completed "
    "LEFT JOIN board_entries AS entry USING (run_id) "
    "WHERE track_id = ? AND phase_id = ?"
)
_FIGURES: Final = (
    "SELECT run_id, document FROM run_figures "
    "WHERE run_id IN (SELECT value FROM json_each(?))"
)
NOT_FOUND = "There is no such result, or it is not shown to you."


class _Missing(msgspec.Struct, frozen=True):
    run_id: str
    score: float | None


class _Figures(msgspec.Struct, frozen=True):
    run_id: str
    document: str


@dataclass(frozen=True, slots=True)
class Ranking:
    """The results of a phase. leading: one of each entrant, the best first.

    others: others of the same entrants, the newest first; those that the phase ranks
    highest, of each entrant about as many. others_total: how many there are.
    """

    phase: Phase
    leading: Sequence[ShownResult]
    others: Sequence[ShownResult]
    others_total: int


@dataclass(frozen=True, slots=True)
class Results:
    """The results of all tracks."""

    tracks: Tracks
    entries: HistoryEntries
    _again_at: dict[str, float] = field(default_factory=dict, init=False)

    async def of_track(
        self, track_id: str, owners: Collection[str], reader: RunReader
    ) -> Sequence[ShownResult]:
        """The newest first; those of which nothing is shown are left out.

        owners: the names that the caller acts for. reader: of runs at the server.
        RESULTS_MAX at most; those that stand for entrants come before others.
        """
        track = self.tracks.get(track_id)
        await self.refresh(track_id, reader)
        with suppress(Refused):  # flags that are known stay
            await self.entries.refresh(reader)
        rankings = [self.ranking(track, phase, owners) for phase in track.phases]
        results = [one for ranking in rankings for one in _all_of(ranking)]
        results = sorted(results, key=lambda one: one.stored.place)[:RESULTS_MAX]
        return _newest_first(results)

    def ranking(
        self, track: Track, phase: Phase, owners: Collection[str], others_max: int = 0
    ) -> Ranking:
        """As stored now. others_max: RESULTS_MAX in all if it is 0."""
        ids = track.track_id, phase.phase_id
        rows = self.tracks.database.rows(StoredResult, _OF_PHASE, *ids)
        seen = seen_by(owners, rows, phase, self.tracks.clock())
        results = self._with_figures(in_order(seen, phase.ranks)[:RESULTS_MAX])
        leading = [one for one in results if one.stored.place == 1]
        others = results[len(leading) :][: others_max or RESULTS_MAX]
        entrants = len({one.stored.owner for one in seen})
        return Ranking(phase, leading, _newest_first(others), len(seen) - entrants)

    def _with_figures(
        self, placed: Sequence[tuple[int, ShownResult]]
    ) -> Sequence[ShownResult]:
        run_ids = msgspec.json.encode([one.stored.run_id for _, one in placed]).decode()
        found = self.tracks.database.rows(_Figures, _FIGURES, run_ids)
        documents = {one.run_id: one.document for one in found}
        return [
            replace(
                one,
                stored=replace(
                    one.stored, place=place, document=documents.get(one.stored.run_id)
                ),
            )
            for place, one in placed
        ]

    async def refresh(self, track_id: str, reader: RunReader) -> int:
        """Read the open runs of a track at the server, and figures that are missing.

        Returns how many are still to be looked at. Raises Refused if the server is away
        and a score is missing.
        """
        left = await self.tracks.refresh_track(track_id, reader)
        missing = self.tracks.database.rows(_Missing, _MISSING, track_id)
        now = self.tracks.clock()
        due = [one for one in missing if self._again_at.get(one.run_id, now) <= now]
        for one in due[:READS_MAX]:
            try:
                score = await reader.read_figures(one.run_id)
            except Refused:
                if one.score is None:
                    raise
                break
            if score is not None:
                note_figures(self.tracks.database, one.run_id, score)
            if score is None or score.get("score") is None:
                self._again_at[one.run_id] = now + AGAIN_S
        return left + len(due[READS_MAX:])

    def get(self, result_id: str, part: Shown, owners: Collection[str]) -> StoredResult:
        """The result, if the caller may see this part of it now. Raises Refused."""
        row = self.tracks.database.row(
            StoredResult,
            f"SELECT * FROM {_COMPLETED} WHERE result_id = ?",  # noqa: S608
            result_id,
        )
        if row is not None:
            phase = self.tracks.get(row.track_id).phase(row.phase_id)
            seen = seen_by(owners, [row], phase, self.tracks.clock())
            if any(part in one.shown for one in seen):
                return row
        raise Refused("not_found", NOT_FOUND)


def _all_of(ranking: Ranking) -> Sequence[ShownResult]:
    return [*ranking.leading, *ranking.others]


def _newest_first(results: Sequence[ShownResult]) -> Sequence[ShownResult]:
    return sorted(results, key=lambda one: one.stored.made_at, reverse=True)
