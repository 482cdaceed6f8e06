"""Results of a track, and who sees which part of them (HST-026).

A result is a completed run that counts, made on another machine or of a submission.
Its owner sees all of it; other accounts see what its phase shows now.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

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
# Parts of the schema Score that a page shows of a result, beside its splits.
_FIGURES = ("score", "success_rate", "success_interval", "counts")
_SPLITS_MAX = 100
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


class _Figures(msgspec.Struct, frozen=True):
    """document: parts of the schema Score, as JSON; `null` of a run that is gone."""

    run_id: str
    document: str


@dataclass(frozen=True, slots=True)
class Ranking:
    """The results of a phase. leading: one of each entrant, the best first.

    others: all others, the newest first.
    """

    phase: Phase
    leading: Sequence[ShownResult]
    others: Sequence[ShownResult]


def rank_results(phase: Phase, results: Sequence[ShownResult]) -> Ranking:
    """results: of a track, the newest first. One whose score is not shown is last.

    The earlier one of two equal scores is the better.
    """
    here = [one for one in results if one.stored.phase_id == phase.phase_id]
    in_order = sorted(here, key=_worst_last)
    candidates = in_order if phase.ranks == "best" else here
    chosen: dict[str, ShownResult] = {}
    for one in candidates:
        chosen.setdefault(one.stored.owner, one)
    leading = [one for one in in_order if chosen[one.stored.owner] is one]
    return Ranking(phase, leading, [one for one in here if one not in leading])


def _worst_last(result: ShownResult) -> tuple[bool, float, float]:
    return result.score is None, -(result.score or 0.0), result.stored.made_at


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

    async def figures(
        self, results: Sequence[ShownResult], reader: RunReader
    ) -> Mapping[str, Mapping[str, Any]]:
        """Figures of the scores that are shown, by the ids of their runs.

        Each is read at the server once. Those of a server that is away are left out.
        """
        found = {}
        is_away = False
        for result in results:
            run_id = result.stored.run_id
            if "score" not in result.shown:
                continue
            row = self.tracks.database.row(
                _Figures, "SELECT * FROM run_figures WHERE run_id = ?", run_id
            )
            if row is None and not is_away:
                try:
                    row = await self._read_figures(run_id, reader)
                except Refused:
                    is_away = True
            if row is not None and (figures := msgspec.json.decode(row.document)):
                found[run_id] = figures
        return found

    async def _read_figures(self, run_id: str, reader: RunReader) -> _Figures:
        """Raises Refused."""
        score = await reader.read_figures(run_id)
        shown = None
        if score is not None:
            shown = {name: score[name] for name in _FIGURES}
            if len(score["by_split"]) <= _SPLITS_MAX:
                shown["by_split"] = {name: {} for name in score["by_split"]}
        row = _Figures(run_id, msgspec.json.encode(shown).decode())
        self.tracks.database.execute(
            "INSERT OR IGNORE INTO run_figures VALUES (?, ?)", row.run_id, row.document
        )
        return row

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
