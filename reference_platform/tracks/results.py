"""Results of a track, and who sees which part of them (HST-026).

A result is a completed run that counts, made on another machine or of a submission.
Its owner sees all of it; other accounts see what its phase shows now.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, Final, Literal

import msgspec

from reference_platform.storage.platform_database import Value
from reference_platform.tracks.history_entries import HistoryEntries
from reference_platform.tracks.run_figures import note_figures
from reference_platform.tracks.track_rules import SHOWN, Phase, Ranks, Shown, Track
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
    "LEFT JOIN run_figures USING (run_id) "
)
# Those without figures; an earlier version has stored `null` for a run that was gone.
_MISSING: Final = (
    f"SELECT run_id, score FROM {_COMPLETED} WHERE track_id = ? AND "  # noqa: S608
    "(score IS NULL OR document IS NULL OR document = 'null') "
    "ORDER BY score IS NOT NULL, made_at DESC"
)
# HST-044, HST-045: why a result has no rank, as BRD-012 has it for flagged entries.
_EXCLUDED: Final = (
    "CASE WHEN flag IS NOT NULL THEN 'flagged' WHEN owner IN "
    "(SELECT account FROM accounts WHERE state = 'suspended') THEN 'suspended' END"
)
# Results of a phase, as one reader sees them. A score that is not shown decides no
# order. 1 and 2: track and phase; 3: names of the reader, as JSON; 4, 5, 6: whether
# others see the score, the log and the record.
_SEEN: Final = (
    "WITH seen AS (SELECT *, CASE WHEN ?4 OR is_own THEN score END AS seen_score "  # noqa: S608
    "FROM (SELECT *, owner IN (SELECT value FROM json_each(?3)) AS is_own, "
    f"{_EXCLUDED} AS excluded FROM {_COMPLETED} "
    "LEFT JOIN history_entries USING (run_id) WHERE track_id = ?1 AND phase_id = ?2) "
    "WHERE is_own OR ?4 OR ?6 OR (?5 AND is_hosted)) "
)
# One whose score is not shown is last; the earlier one of two equal ones is better.
# Those that are excluded are behind all others, as on the leaderboard.
_RANKED_FIRST: Final = "excluded IS NOT NULL"
_BEST_FIRST: Final = "seen_score IS NULL, seen_score DESC, made_at, result_id"
_ORDERS: Final[Mapping[Ranks, str]] = {
    "best": _BEST_FIRST,
    "last": "made_at DESC, result_id",
}
NOT_FOUND = "There is no such result, or it is not shown to you."


class StoredResult(msgspec.Struct, frozen=True):
    """result_id: of the submission, or of the run that was made elsewhere.

    document: its figures, as JSON. excluded: why it has no rank; None if it has one.
    flag: what the host says of its entry. place: among the results of its entrant in
    the phase, as `ranks` of the phase says; the first one stands for the entrant.
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
    document: str | None = None
    excluded: Literal["flagged", "suspended"] | None = None
    flag: str | None = None
    place: int = 1

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

    @property
    def figures(self) -> Mapping[str, Any] | None:
        """Parts of the schema Score; None if they are not shown, or missing."""
        if "score" not in self.shown or self.stored.document is None:
            return None
        figures: Mapping[str, Any] | None = msgspec.json.decode(self.stored.document)
        return figures


class _Missing(msgspec.Struct, frozen=True):
    run_id: str
    score: float | None


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
        now = self.tracks.clock()
        names = msgspec.json.encode([*owners]).decode()
        shows = [phase.shows(part, now) for part in SHOWN]
        values: list[Value] = [track.track_id, phase.phase_id, names, *shows]
        database = self.tracks.database
        rows = database.rows(
            StoredResult,
            f"{_SEEN} SELECT *, row_number() OVER (PARTITION BY owner "  # noqa: S608
            f"ORDER BY {_RANKED_FIRST}, {_ORDERS[phase.ranks]}) AS place FROM seen "
            f"ORDER BY place, {_RANKED_FIRST}, {_BEST_FIRST} LIMIT {RESULTS_MAX}",
            *values,
        )
        count = "SELECT count(*) - count(DISTINCT owner) FROM seen"
        results = [ShownResult(row, self._shown(row, phase, owners)) for row in rows]
        leading = [one for one in results if one.stored.place == 1]
        others = results[len(leading) :][: others_max or RESULTS_MAX]
        total = database.number(_SEEN + count, *values)
        return Ranking(phase, leading, _newest_first(others), int(total or 0))

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
            if part in self._shown(row, phase, owners):
                return row
        raise Refused("not_found", NOT_FOUND)

    def _shown(
        self, row: StoredResult, phase: Phase, owners: Collection[str]
    ) -> frozenset[Shown]:
        now, is_own = self.tracks.clock(), row.owner in owners
        return frozenset(part for part in row.parts if is_own or phase.shows(part, now))


def _all_of(ranking: Ranking) -> Sequence[ShownResult]:
    return [*ranking.leading, *ranking.others]


def _newest_first(results: Sequence[ShownResult]) -> Sequence[ShownResult]:
    return sorted(results, key=lambda one: one.stored.made_at, reverse=True)
