"""The use cases of tracks: make them, enter them, admit runs and count them.

An entrant is an account or an organisation, each by its name.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final, Literal, Protocol

import msgspec

from reference_platform.accounts.organisations import Organisations, Owner, is_taken
from reference_platform.mail.outbox import Outbox
from reference_platform.storage.platform_database import Database, audit
from reference_platform.tracks.history_entries import HistoryReader
from reference_platform.tracks.phase_draws import SeedDraws
from reference_platform.tracks.run_figures import note_figures
from reference_platform.tracks.served_benchmarks import check_served
from reference_platform.tracks.track_rules import (
    OPEN_STATES,
    AskedRun,
    Place,
    Track,
    TrackRun,
    Usage,
    check_track,
    choose_phase,
    fits,
    room_refusal,
    said_time,
    usages,
)
from reference_server.rules.refusal import Refused, not_found

# A run that the server does not know yet may be stored a moment later.
UNKNOWN_S: Final = 60.0
# Runs that one request for a track looks at, and how many of them at once.
OPEN_READS_MAX: Final = 200
LOOKED_S: Final = 60.0
_READS_AT_ONCE: Final = 8
# The account of verifications, and the end of the addresses of hosted policies.
PLATFORM_ACCOUNT: Final = "platform"
HOSTED_ENDING: Final = ".sandbox.invalid"
EntrantState = Literal["waiting", "entered", "rejected"]


_RUNS: Final = (
    "SELECT * FROM (SELECT run_id, track_id, account, made_at, state, score, phase_id, "
    "policy_name FROM track_runs UNION ALL "
    "SELECT submission_id, track_id, account, started_at, state, "
    "score, phase_id, policy_name FROM submissions WHERE is_counted = 1) "
    "WHERE account = ? AND (track_id = ? OR ? = '') ORDER BY made_at DESC"
)


class _Document(msgspec.Struct):
    document: str


class _PhaseOfTrack(_Document):
    phase_id: str


class Entrant(msgspec.Struct, frozen=True):
    track_id: str
    account: str
    state: EntrantState
    reason: str
    entered_at: float


class RunReader(HistoryReader, Protocol):
    """Reads runs of any account, and the history, at the server."""

    async def read_run(self, run_id: str) -> Mapping[str, Any] | None:
        """As `get_run` shows it; None if there is no such run. Raises OSError."""

    async def read_figures(self, run_id: str) -> Mapping[str, Any] | None:
        """As `get_score` shows them; None if there is no such run."""


@dataclass(frozen=True, slots=True)
class Tracks:
    database: Database
    outbox: Outbox
    organisations: Organisations
    clock: Callable[[], float] = field(default=time.time)
    url: str = ""  # of the server, for commands that refusals print, if it is known
    _read_at: dict[str, float] = field(default_factory=dict, init=False)

    # --- tracks ---

    @property
    def draws(self) -> SeedDraws:
        return SeedDraws(self.database)

    def all(self) -> Sequence[Track]:
        rows = self.database.rows(_Document, "SELECT document FROM tracks")
        tracks = [msgspec.json.decode(row.document, type=Track) for row in rows]
        return sorted(tracks, key=lambda track: (track.closes_at, track.track_id))

    def get(self, track_id: str) -> Track:
        row = self.database.row(
            _Document, "SELECT document FROM tracks WHERE track_id = ?", track_id
        )
        if row is None:
            raise not_found("track", track_id, (track.track_id for track in self.all()))
        return msgspec.json.decode(row.document, type=Track)

    def places(self, track_id: str = "") -> Sequence[Place]:
        """The phases of a track, if it is there; or of all tracks."""
        tracks = [t for t in self.all() if track_id in ("", t.track_id)]
        return [Place(track, phase) for track in tracks for phase in track.phases]

    def doubts(self, track: Track) -> Sequence[str]:
        """Sentences on members that are allowed, and may be mistakes; before `put`."""
        stored = [place.phase for place in self.places(track.track_id)]
        said = [
            f"The phase {phase.phase_id} closed at {said_time(phase.closes_at)}, and "
            "takes nothing."
            for phase in track.phases
            if phase not in stored and phase.closes_at <= self.clock()
        ]
        if track.entry != "listed":
            unread = 'The list `accounts` has no effect without `entry = "listed"`.'
            return [*said, unread] if track.accounts else said
        if not track.accounts:
            said.append("The list `accounts` is empty, so no account can enter.")
        return said + [
            f"There is no account or organisation {name}, which `accounts` has."
            for name in track.accounts
            if not is_taken(self.database, name)
        ]

    def put(self, track: Track, administrator: str) -> None:
        """Make the track, or change it; runs that count stay counted."""
        check_track(track)
        document = msgspec.json.encode(track).decode()
        after = {phase.phase_id: phase for phase in track.phases}
        with self.database.transaction():
            places = self.places(track.track_id)
            check_served(self.database, track, [place.phase for place in places])
            for before in places:
                changed = after.get(before.phase.phase_id)
                self.draws.check_change(before, changed)
                if changed is None and self._is_used(before):
                    text = f"There are runs in {before}, so it stays; close it."
                    raise Refused("illegal_transition", text)
            self.database.execute(
                "INSERT INTO tracks (track_id, document) VALUES (?, ?) "
                "ON CONFLICT (track_id) DO UPDATE SET document = excluded.document",
                *(track.track_id, document),
            )
            audit(
                self.database,
                self.clock(),
                actor=administrator,
                act="put_track",
                subject=track.track_id,
                detail=document,
            )

    def delete(self, track_id: str, administrator: str) -> None:
        """Only a track that no account or organisation has entered. Raises Refused."""
        with self.database.transaction():
            track = self.get(track_id)
            entrants = "SELECT count(*) FROM entrants WHERE track_id = ?"
            if self.database.number(entrants, track_id):
                text = f"The track {track_id} has entrants, so it stays"
                raise Refused("illegal_transition", f"{text}; close its phases.")
            for place in self.places(track_id):
                self.draws.check_change(place, None)
            self.database.execute("DELETE FROM tracks WHERE track_id = ?", track_id)
            audit(
                self.database, self.clock(), actor=administrator, act="delete_track",
                subject=track_id, detail=msgspec.json.encode(track).decode(),
            )  # fmt: skip

    def _is_used(self, place: Place) -> bool:
        statement = (
            "SELECT count(*) FROM (SELECT track_id, phase_id FROM track_runs UNION ALL "
            "SELECT track_id, phase_id FROM submissions) "
            "WHERE track_id = ? AND phase_id = ?"
        )
        ids = (place.track.track_id, place.phase.phase_id)
        return bool(self.database.number(statement, *ids))

    # --- entrants ---

    def entrant(self, track_id: str, account: str) -> Entrant | None:
        return self.database.row(
            Entrant,
            "SELECT * FROM entrants WHERE track_id = ? AND account = ?",
            *(track_id, account),
        )

    def enter(self, track_id: str, owner: Owner) -> Entrant:
        """As the track says: at once, after a review, or if the owner is listed."""
        now = self.clock()
        with self.database.transaction():  # another process may delete the track
            track = self.get(track_id)
            already = self.entrant(track_id, owner.name)
            if already is not None and already.state != "rejected":
                return already
            if track.closes_at <= now:
                text = f"The track closed at {said_time(track.closes_at)}."
                raise Refused("forbidden", text)
            if track.entrants == "organisations" and not owner.is_organisation:
                text = "Only organisations enter this track: act for one of yours."
                raise Refused("forbidden", text)
            if track.entry == "listed" and owner.name not in track.accounts:
                text = "Only accounts that the host has listed enter this track."
                raise Refused("forbidden", text)
            if already is not None:
                text = f"The host has refused the entry: {already.reason}"
                raise Refused("forbidden", text)
            state: EntrantState = "waiting" if track.entry == "review" else "entered"
            entrant = Entrant(track_id, owner.name, state, "", now)
            self.database.insert("entrants", entrant)
        return entrant

    def waiting_entrants(self) -> Sequence[Entrant]:
        return self.database.rows(
            Entrant,
            "SELECT * FROM entrants WHERE state = 'waiting' ORDER BY entered_at",
        )

    def decide_entry(
        self, track_id: str, owner: str, *, accept: bool, reason: str, actor: str
    ) -> None:
        """Raises Refused. The entrant gets a mail; the audit log has the decision."""
        if not accept and not reason.strip():
            wrong = [("/reason", "is required")]
            raise Refused("invalid_request", "A refusal needs a reason.", errors=wrong)
        state = "entered" if accept else "rejected"
        with self.database.transaction():
            changed = self.database.execute(
                "UPDATE entrants SET state = ?, reason = ? "
                "WHERE track_id = ? AND account = ? AND state = 'waiting'",
                *(state, reason.strip(), track_id, owner),
            )
            if not changed:
                raise Refused("not_found", "No such entry waits for review.")
            audit(
                self.database,
                self.clock(),
                actor=actor,
                act="accept_entry" if accept else "reject_entry",
                subject=f"{track_id} {owner}",
                detail=reason.strip(),
            )
            text = f"You have entered the track {track_id}."
            if not accept:
                text = f"You cannot enter the track {track_id}.\n\nReason: {reason}"
            for email in self.organisations.emails_of(owner):
                self.outbox.add(email, f"The track {track_id}", text)

    # --- runs ---

    def runs_of(self, account: str, track_id: str = "") -> Sequence[TrackRun]:
        """The newest first; of every track if none is named.

        A hosted submission that counts is one of them, under its own id (HST-012).
        """
        return self.database.rows(
            TrackRun,
            _RUNS,
            *(account, track_id, track_id),
        )

    def check_room(self, place: Place, account: str) -> None:
        """Raises Refused if the phase has no room for one more run of the account."""
        refusal = room_refusal(place, self.runs_of(account), self.clock())
        if refusal is not None:
            raise refusal

    def why_to_wait(self, place: Place, account: str) -> str:
        """Why the phase has no room for one more run of the account now; or nothing.

        Raises Refused if it never has any.
        """
        refusal = room_refusal(place, self.runs_of(account), self.clock())
        if refusal is not None and refusal.members["limit"] == "total":
            raise refusal
        return "" if refusal is None else refusal.detail

    def usages_of(self, place: Place, account: str) -> list[Usage]:
        runs = [
            run
            for run in self.runs_of(account, place.track.track_id)
            if run.phase_id == place.phase.phase_id
        ]
        return usages(place.phase, runs, self.clock())

    async def admit(self, asked: AskedRun, reader: RunReader) -> Place | None:
        """Count the run for a phase of a track. Raises Refused (HST-010, HST-011).

        A run of the platform itself, and the one of a submission that was counted when
        it was started, are not counted. A submission that was stopped a moment ago gets
        none.
        """
        if asked.account == PLATFORM_ACCOUNT:
            return None
        if asked.policy_url.endswith(HOSTED_ENDING):
            if self.place_of_submission(asked):
                return None
            raise Refused("forbidden", "No submission waits for this run any more.")
        try:
            return self._admit(asked)
        except Refused as refused:
            if refused.code != "quota_exceeded":
                raise
        # Runs may have ended, or failed by a fault of the server, since they were read.
        await self.refresh(asked.account, reader)
        return self._admit(asked)

    def place_of_submission(self, asked: AskedRun) -> Place | None:
        """The phase of a hosted policy, if a submission there waits for this run."""
        if not asked.policy_url.endswith(HOSTED_ENDING):
            return None
        waiting = self.database.rows(
            _PhaseOfTrack,
            "SELECT document, phase_id FROM submissions JOIN tracks USING (track_id) "
            "WHERE account = ? AND state = 'running' AND run_id = ''",
            asked.account,
        )
        for row in waiting:
            track = msgspec.json.decode(row.document, type=Track)
            place = Place(track, track.phase(row.phase_id))
            if fits(place.phase, asked):
                return place
        return None

    def _admit(self, asked: AskedRun) -> Place:
        now = self.clock()
        with self.database.transaction():
            entered = self.database.rows(
                _Document,
                "SELECT document FROM tracks JOIN entrants USING (track_id) "
                "WHERE entrants.account = ? AND entrants.state = 'entered'",
                asked.account,
            )
            tracks = [msgspec.json.decode(row.document, type=Track) for row in entered]
            place = choose_phase(
                tracks, asked, self.runs_of(asked.account), now, self.url
            )
            run = TrackRun(
                asked.run_id, place.track.track_id, asked.account, now, "admitted",
                None, place.phase.phase_id, asked.policy_name,
            )  # fmt: skip
            self.database.insert("track_runs", run)
        return place

    def check_publication(self, run_id: str) -> None:
        """HST-027: a public entry shows the score. Raises Refused."""
        row = self.database.row(
            _PhaseOfTrack,
            "SELECT document, phase_id FROM (SELECT run_id, track_id, phase_id "
            "FROM track_runs UNION ALL SELECT run_id, track_id, phase_id "
            "FROM submissions) JOIN tracks USING (track_id) WHERE run_id = ?",
            run_id,
        )
        if row is None:
            return
        track = msgspec.json.decode(row.document, type=Track)
        place = Place(track, track.phase(row.phase_id))
        if place.phase.shows("score", self.clock()):
            return
        when = "never"
        if place.phase.score == "after_close":
            when = f"from {said_time(place.phase.closes_at)} on"
        text = f"{str(place).capitalize()} shows scores to others {when}."
        raise Refused("forbidden", text)

    def withdraw(self, run_id: str) -> None:
        """The run was not made."""
        self.database.execute(
            "DELETE FROM track_runs WHERE run_id = ? AND state = 'admitted'", run_id
        )

    async def refresh(self, account: str, reader: RunReader) -> None:
        """Read the open runs of an account at the server, OPEN_READS_MAX at most.

        HST-013: one that failed while it was played there is not counted any more.
        """
        await self._refresh(self.runs_of(account), reader)

    async def refresh_track(self, track_id: str, reader: RunReader) -> int:
        """The same for open runs of every account on a track.

        Returns how many others no request has looked at for LOOKED_S.
        """
        open_runs = self.database.rows(
            TrackRun,
            "SELECT * FROM track_runs WHERE track_id = ? AND state NOT IN "
            "('completed', 'refunded', 'deleted', 'failed') "
            "ORDER BY made_at DESC",
            track_id,
        )
        since = self.clock() - LOOKED_S
        others = await self._refresh(open_runs, reader)
        return sum(self._read_at.get(run.run_id, 0.0) < since for run in others)

    async def _refresh(
        self, runs: Sequence[TrackRun], reader: RunReader
    ) -> Sequence[TrackRun]:
        """Read those whose last look is the longest ago; returns the others.

        Raises Refused after the first requests when the server is away.
        """
        by_look = sorted(
            (
                run  # the platform itself ends a hosted one
                for run in runs
                if not run.is_hosted and run.state in (*OPEN_STATES, "stopped")
            ),
            key=lambda run: (
                self._read_at.get(run.run_id, 0.0),
                run.state == "stopped",
            ),
        )
        open_runs = by_look[:OPEN_READS_MAX]
        for first in range(0, len(open_runs), _READS_AT_ONCE):
            some = open_runs[first : first + _READS_AT_ONCE]
            reads = (self._refresh_run(run, reader) for run in some)
            for outcome in await asyncio.gather(*reads, return_exceptions=True):
                if isinstance(outcome, BaseException):
                    raise outcome
        return by_look[OPEN_READS_MAX:]

    async def _refresh_run(self, run: TrackRun, reader: RunReader) -> None:
        seen = await reader.read_run(run.run_id)
        self._read_at[run.run_id] = self.clock()
        if seen is None:
            if self.clock() > run.made_at + UNKNOWN_S:
                self._note(run, "refunded" if run.state == "admitted" else "deleted")
            return
        state = str(seen["state"])
        score = None
        if state == "completed":
            score = await reader.read_figures(run.run_id)
        elif state == "failed" and seen.get("mode", "pull") == "pull":
            state = "refunded"
        self._note(run, state, score)

    def _note(
        self, run: TrackRun, state: str, score: Mapping[str, Any] | None = None
    ) -> None:
        with self.database.transaction():
            self.database.execute(
                "UPDATE track_runs SET state = ? WHERE run_id = ?", state, run.run_id
            )
            if score is not None:
                note_figures(self.database, run.run_id, score)
        if state not in (*OPEN_STATES, "stopped"):
            self._read_at.pop(run.run_id, None)
