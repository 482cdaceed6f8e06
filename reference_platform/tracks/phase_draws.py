"""Draws of the seeds of held-out phases: when each leaf of the history is due.

The server keeps the key and appends the leaves. A phase goes from `sealed` to `drawn`
to `opened`. Every step may be repeated, also after a kill of any program.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol

import msgspec

from reference_platform.storage.platform_database import Database
from reference_platform.tracks.track_rules import Phase, Place, said_time
from reference_record.history.drawn_seeds import SeedsDrawn
from reference_record.texts.counted_text import counted
from reference_server.rules.refusal import Refused

DrawState = Literal["sealed", "drawn", "opened"]


class AppendedLeaf(msgspec.Struct, frozen=True):
    """root_sha256: of the leaves in front of it."""

    index: int
    root_sha256: str


class DrawHistory(Protocol):
    """The history of the server."""

    async def append(self, kind: str, draw_id: str, digest: str = "") -> AppendedLeaf:
        """Raises Refused."""


class Draw(msgspec.Struct, frozen=True):
    """drawn: `seeds_drawn` of its runs as JSON; empty before."""

    draw_id: str
    state: DrawState = "sealed"
    drawn: str = ""


class _Committed(msgspec.Struct):
    submission_id: str
    digest: str
    state: str
    commit_index: int | None


@dataclass(frozen=True, slots=True)
class SeedDraws:
    """The draws of all phases."""

    database: Database

    def get(self, place: Place) -> Draw | None:
        return self.database.row(
            Draw, "SELECT * FROM draws WHERE draw_id = ?", draw_id_of(place)
        )

    def may_play(self, place: Place) -> bool:
        """Whether an evaluation in this phase may begin (HST-030)."""
        if not place.phase.is_held_out:
            return True
        draw = self.get(place)
        return draw is not None and draw.state == "drawn"

    def seeds_of(self, place: Place) -> Mapping[str, Any] | None:
        """`seeds_drawn` of a run in this phase; None if its seeds are not drawn."""
        draw = self.get(place) if place.phase.is_held_out else None
        return msgspec.json.decode(draw.drawn) if draw and draw.drawn else None

    def describe(self, place: Place, now: float) -> str:
        """The state of the seeds of a phase, as words that follow "the seeds"."""
        draw, closes_at = self.get(place), place.phase.closes_at
        number = self._unfinished(place)
        left = f"still to be evaluated: {counted(number, 'submission')}"
        if now < closes_at:
            at = f"are drawn when the phase closes, at {said_time(closes_at)}"
            return f"{at}, after every submission was committed to"
        if draw is not None and draw.state != "sealed":
            return f"were drawn after the phase closed; {left}"
        if number:
            return f"are drawn now, as the phase has closed; {left}"
        return "were not drawn, as no submission was started"

    def _unfinished(self, place: Place) -> int:
        """How many submissions of the phase wait for their evaluation, or are in it."""
        return int(
            self.database.number(
                "SELECT count(*) FROM submissions WHERE track_id = ? AND phase_id = ? "
                "AND state IN ('queued', 'running')",
                *(place.track.track_id, place.phase.phase_id),
            )
            or 0
        )

    def check_change(self, place: Place, after: Phase | None) -> None:
        """A phase whose seeds were drawn stays as it is. Raises Refused."""
        draw = self.get(place) if place.phase.is_held_out else None
        if draw is None or draw.state == "sealed" or after == place.phase:
            return
        text = f"The seeds of {place} were drawn, so it stays as it is; add a phase."
        raise Refused("illegal_transition", text)

    async def advance(self, place: Place, history: DrawHistory, now: float) -> None:
        """Append the leaves that are due (HST-030, HST-031). Raises Refused."""
        draw_id = draw_id_of(place)
        draw = self.get(place)
        if draw is None:
            await history.append("seal", draw_id)
            draw = Draw(draw_id)
            self.database.insert("draws", draw)
        if draw.state == "sealed":
            await self._commit(place, history)
            if now >= place.phase.closes_at and self._started(place):
                leaf = await history.append("draw", draw_id)
                drawn = SeedsDrawn(draw_id, leaf.index, leaf.root_sha256)
                self._set(draw_id, "drawn", msgspec.json.encode(drawn).decode())
        elif draw.state == "drawn":
            states = {row.state for row in self._started(place)}
            if not states & {"queued", "running"}:
                await history.append("open", draw_id)
                self._set(draw_id, "opened", draw.drawn)

    async def _commit(self, place: Place, history: DrawHistory) -> None:
        for row in self._started(place):
            if row.commit_index is None and row.state == "queued":
                leaf = await history.append("commit", draw_id_of(place), row.digest)
                self.database.execute(
                    "UPDATE submissions SET commit_index = ? WHERE submission_id = ?",
                    *(leaf.index, row.submission_id),
                )

    def _started(self, place: Place) -> Sequence[_Committed]:
        """Submissions of the phase that wait for the draw, or were played after it."""
        return self.database.rows(
            _Committed,
            "SELECT submission_id, digest, state, commit_index FROM submissions "
            "WHERE track_id = ? AND phase_id = ? "
            "AND (state = 'queued' OR commit_index IS NOT NULL)",
            *(place.track.track_id, place.phase.phase_id),
        )

    def _set(self, draw_id: str, state: DrawState, drawn: str) -> None:
        self.database.execute(
            "UPDATE draws SET state = ?, drawn = ? WHERE draw_id = ?",
            *(state, drawn, draw_id),
        )


def draw_id_of(place: Place) -> str:
    return f"{place.track.track_id}/{place.phase.phase_id}"
