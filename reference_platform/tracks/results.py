"""Results of a track, and who sees which part of them (HST-026).

A result is a completed run that counts, made on another machine or of a submission.
Its owner sees all of it; other accounts see what its phase shows now.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import msgspec

from reference_platform.tracks.track_rules import SHOWN, Phase, Shown
from reference_platform.tracks.tracks import RunReader, Tracks
from reference_server.rules.refusal import Refused

_COMPLETED = (
    "SELECT * FROM (SELECT run_id AS result_id, track_id, phase_id, account AS owner, "
    "policy_name, made_at, run_id, score, 0 AS is_hosted FROM track_runs "
    "WHERE state = 'completed' UNION ALL "
    "SELECT submission_id, track_id, phase_id, account, policy_name, started_at, "
    "run_id, score, 1 FROM submissions WHERE state = 'completed' AND run_id != '') "
)
NOT_FOUND = "There is no such result, or it is not shown to you."


class StoredResult(msgspec.Struct, frozen=True):
    """result_id: of the submission, or of the run that was made elsewhere."""

    result_id: str
    track_id: str
    phase_id: str
    owner: str
    policy_name: str
    made_at: float
    run_id: str
    score: float | None
    is_hosted: bool

    @property
    def parts(self) -> Collection[Shown]:
        """Only a policy that the host runs has a log there."""
        return SHOWN if self.is_hosted else ("score", "record")


@dataclass(frozen=True, slots=True)
class ShownResult:
    """A result as one account sees it. shown: the parts that it may see."""

    stored: StoredResult
    shown: frozenset[Shown]

    @property
    def score(self) -> float | None:
        return self.stored.score if "score" in self.shown else None


@dataclass(frozen=True, slots=True)
class Results:
    """The results of all tracks."""

    tracks: Tracks

    async def of_track(
        self, track_id: str, owners: Collection[str], reader: RunReader
    ) -> Sequence[ShownResult]:
        """The newest first; those of which nothing is shown are left out.

        owners: the names that the caller acts for. reader: of runs at the server.
        """
        track = self.tracks.get(track_id)
        await self.tracks.refresh_track(track_id, reader)
        rows = self.tracks.database.rows(
            StoredResult,
            _COMPLETED + "WHERE track_id = ? ORDER BY made_at DESC LIMIT 1000",
            track_id,
        )
        phases = {phase.phase_id: phase for phase in track.phases}
        results = [
            ShownResult(row, self._shown(row, phases[row.phase_id], owners))
            for row in rows
            if row.phase_id in phases
        ]
        return [await self._with_score(one, reader) for one in results if one.shown]

    def get(self, result_id: str, part: Shown, owners: Collection[str]) -> StoredResult:
        """The result, if the caller may see this part of it now. Raises Refused."""
        row = self.tracks.database.row(
            StoredResult, _COMPLETED + "WHERE result_id = ?", result_id
        )
        if row is not None:
            phase = self.tracks.get(row.track_id).phase(row.phase_id)
            if part in self._shown(row, phase, owners):
                return row
        raise Refused("not_found", NOT_FOUND)

    def _shown(
        self, row: StoredResult, phase: Phase, owners: Collection[str]
    ) -> frozenset[Shown]:
        now, is_own = self.tracks.clock(), row.owner in owners
        return frozenset(part for part in row.parts if is_own or phase.shows(part, now))

    async def _with_score(self, result: ShownResult, reader: RunReader) -> ShownResult:
        """The score of a submission is read at the server once."""
        stored = result.stored
        if stored.score is not None or not stored.is_hosted:
            return result
        score = await reader.read_score(stored.run_id)
        self.tracks.database.execute(
            "UPDATE submissions SET score = ? WHERE submission_id = ?",
            *(score, stored.result_id),
        )
        return ShownResult(msgspec.structs.replace(stored, score=score), result.shown)
