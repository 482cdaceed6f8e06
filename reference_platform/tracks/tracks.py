"""The use cases of tracks: make them, enter them, admit runs and count them."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final, Literal, Protocol

import msgspec

from reference_platform.accounts.account_rules import Account
from reference_platform.mail.outbox import Outbox
from reference_platform.storage.platform_database import Database, audit
from reference_platform.tracks.track_rules import (
    OPEN_STATES,
    AskedRun,
    Track,
    TrackRun,
    Usage,
    check_track,
    choose_track,
    usages,
)
from reference_server.rules.refusal import Refused

# A run that the server does not know yet may be stored a moment later.
UNKNOWN_S: Final = 60.0
# The account of verifications, and the end of the addresses of hosted policies.
PLATFORM_ACCOUNT: Final = "platform"
HOSTED_ENDING: Final = ".sandbox.invalid"
EntrantState = Literal["waiting", "entered", "rejected"]


_RUNS: Final = (
    "SELECT * FROM (SELECT run_id, track_id, account, made_at, state, score "
    "FROM track_runs UNION ALL "
    "SELECT submission_id, track_id, account, started_at, "
    "CASE WHEN state IN ('queued', 'running') THEN 'hosted' ELSE 'completed' END, NULL "
    "FROM submissions WHERE is_counted = 1) "
    "WHERE account = ? AND (track_id = ? OR ? = '') ORDER BY made_at DESC"
)


class _Document(msgspec.Struct):
    document: str


class Entrant(msgspec.Struct, frozen=True):
    track_id: str
    account: str
    state: EntrantState
    reason: str
    entered_at: float


class RunReader(Protocol):
    """Reads runs of any account at the server."""

    async def read_run(self, run_id: str) -> Mapping[str, Any] | None:
        """As `get_run` shows it; None if there is no such run. Raises OSError."""

    async def read_score(self, run_id: str) -> float | None: ...


@dataclass(frozen=True, slots=True)
class Tracks:
    database: Database
    outbox: Outbox
    clock: Callable[[], float] = field(default=time.time)

    # --- tracks ---

    def all(self) -> Sequence[Track]:
        rows = self.database.rows(_Document, "SELECT document FROM tracks")
        tracks = [msgspec.json.decode(row.document, type=Track) for row in rows]
        return sorted(tracks, key=lambda track: (track.closes_at, track.track_id))

    def get(self, track_id: str) -> Track:
        row = self.database.row(
            _Document, "SELECT document FROM tracks WHERE track_id = ?", track_id
        )
        if row is None:
            raise Refused("not_found", "There is no such track.")
        return msgspec.json.decode(row.document, type=Track)

    def put(self, track: Track, administrator: str) -> None:
        """Make the track, or change it; runs that count stay counted."""
        check_track(track)
        document = msgspec.json.encode(track).decode()
        with self.database.transaction():
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

    # --- entrants ---

    def entrant(self, track_id: str, account: str) -> Entrant | None:
        return self.database.row(
            Entrant,
            "SELECT * FROM entrants WHERE track_id = ? AND account = ?",
            *(track_id, account),
        )

    def enter(self, track_id: str, account: Account) -> Entrant:
        """As the track says: at once, after a review, or if the account is listed."""
        track, now = self.get(track_id), self.clock()
        with self.database.transaction():
            already = self.entrant(track_id, account.account)
            if already is not None and already.state != "rejected":
                return already
            if track.closes_at <= now:
                raise Refused("forbidden", "The track is closed.")
            if track.entry == "listed" and account.account not in track.accounts:
                text = "Only accounts that the host has listed enter this track."
                raise Refused("forbidden", text)
            if already is not None:
                text = f"The host has refused the entry: {already.reason}"
                raise Refused("forbidden", text)
            state: EntrantState = "waiting" if track.entry == "review" else "entered"
            entrant = Entrant(track_id, account.account, state, "", now)
            self.database.insert("entrants", entrant)
        return entrant

    def waiting_entrants(self) -> Sequence[Entrant]:
        return self.database.rows(
            Entrant,
            "SELECT * FROM entrants WHERE state = 'waiting' ORDER BY entered_at",
        )

    def decide_entry(
        self, track_id: str, account: Account, *, accept: bool, reason: str, actor: str
    ) -> None:
        """Raises Refused. The account gets a mail; the audit log has the decision."""
        if not accept and not reason.strip():
            wrong = [("/reason", "is required")]
            raise Refused("invalid_request", "A refusal needs a reason.", errors=wrong)
        state = "entered" if accept else "rejected"
        with self.database.transaction():
            changed = self.database.execute(
                "UPDATE entrants SET state = ?, reason = ? "
                "WHERE track_id = ? AND account = ? AND state = 'waiting'",
                *(state, reason.strip(), track_id, account.account),
            )
            if not changed:
                raise Refused("not_found", "No such entry waits for review.")
            audit(
                self.database,
                self.clock(),
                actor=actor,
                act="accept_entry" if accept else "reject_entry",
                subject=f"{track_id} {account.account}",
                detail=reason.strip(),
            )
            text = f"You have entered the track {track_id}."
            if not accept:
                text = f"You cannot enter the track {track_id}.\n\nReason: {reason}"
            self.outbox.add(account.email, f"The track {track_id}", text)

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

    def check_room(self, track_id: str, account: str) -> None:
        """Raises Refused if the track has no room for one more run of the account."""
        track = self.get(track_id)
        asked = AskedRun("", account, track.benchmark_id, track.splits)
        choose_track([track], asked, self.runs_of(account), self.clock())

    def usages_of(self, track: Track, account: str) -> list[Usage]:
        return usages(track, self.runs_of(account, track.track_id), self.clock())

    async def admit(self, asked: AskedRun, reader: RunReader) -> Track | None:
        """Count the run for a track. Raises Refused (HST-010, HST-011).

        A run of the platform itself, and the one of a submission that was counted when
        it was started, are not counted.
        """
        if asked.account == PLATFORM_ACCOUNT or self._is_of_submission(asked):
            return None
        try:
            return self._admit(asked)
        except Refused as refused:
            if refused.code != "quota_exceeded":
                raise
        # Runs may have ended, or failed by a fault of the server, since they were read.
        await self.refresh(asked.account, reader)
        return self._admit(asked)

    def _is_of_submission(self, asked: AskedRun) -> bool:
        """Whether it calls a hosted policy, and a submission waits for its run."""
        if not asked.policy_url.endswith(HOSTED_ENDING):
            return False
        statement = (
            "SELECT count(*) FROM submissions JOIN tracks USING (track_id) "
            "WHERE account = ? AND state = 'running' AND run_id = '' "
            "AND json_extract(document, '$.benchmark_id') = ?"
        )
        return bool(self.database.number(statement, asked.account, asked.benchmark_id))

    def _admit(self, asked: AskedRun) -> Track:
        now = self.clock()
        with self.database.transaction():
            entered = self.database.rows(
                _Document,
                "SELECT document FROM tracks JOIN entrants USING (track_id) "
                "WHERE entrants.account = ? AND entrants.state = 'entered'",
                asked.account,
            )
            tracks = [msgspec.json.decode(row.document, type=Track) for row in entered]
            track = choose_track(tracks, asked, self.runs_of(asked.account), now)
            run = TrackRun(
                asked.run_id, track.track_id, asked.account, now, "admitted", None
            )
            self.database.insert("track_runs", run)
        return track

    def withdraw(self, run_id: str) -> None:
        """The run was not made."""
        self.database.execute(
            "DELETE FROM track_runs WHERE run_id = ? AND state = 'admitted'", run_id
        )

    async def refresh(self, account: str, reader: RunReader) -> None:
        """Read the open runs of an account at the server.

        HST-013: one that failed while it was played there is not counted any more.
        """
        for run in self.runs_of(account):
            if run.state == "hosted":  # the platform itself ends it
                continue
            if run.state not in OPEN_STATES and run.state != "stopped":
                continue
            seen = await reader.read_run(run.run_id)
            if seen is None:
                if self.clock() > run.made_at + UNKNOWN_S:
                    self._note(
                        run, "refunded" if run.state == "admitted" else "deleted"
                    )
                continue
            state = str(seen["state"])
            score = (
                await reader.read_score(run.run_id) if state == "completed" else None
            )
            if state == "failed" and seen.get("mode", "pull") == "pull":
                state = "refunded"
            self._note(run, state, score)

    def _note(self, run: TrackRun, state: str, score: float | None = None) -> None:
        self.database.execute(
            "UPDATE track_runs SET state = ?, score = ? WHERE run_id = ?",
            *(state, score, run.run_id),
        )
