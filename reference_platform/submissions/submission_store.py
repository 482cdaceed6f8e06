"""The stored submissions, and their use cases: create, start, stop.

Every change is one transaction through the table of `lifecycle`.
"""

from __future__ import annotations

import secrets
import time
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any, Final, Literal

from reference_platform.storage.platform_database import Database, audit
from reference_platform.submissions.lifecycle import (
    FINAL,
    WAITING,
    Cause,
    Event,
    IllegalTransition,
    State,
    Submission,
    apply,
    at_deadline,
)
from reference_platform.tracks.run_figures import note_figures
from reference_platform.tracks.track_rules import (
    Place,
    closed_refusal,
    open_place,
    said_time,
)
from reference_platform.tracks.tracks import Entrant, Tracks
from reference_server.rules.refusal import Refused

OPEN_MAX: Final = 10  # of one account that have not ended
_NOT_FOUND: Final = "The account has no such submission."
_ACT: Final = "Check the id; the page Submissions lists those of the account."


@dataclass(frozen=True, slots=True)
class SubmissionStore:
    database: Database
    tracks: Tracks
    clock: Callable[[], float] = time.time

    def get(self, submission_id: str) -> Submission:
        """Raises KeyError."""
        found = self.database.row(
            Submission,
            "SELECT * FROM submissions WHERE submission_id = ?",
            submission_id,
        )
        if found is None:
            raise KeyError(submission_id)
        return found

    def get_own(self, submission_id: str, owners: Collection[str]) -> Submission:
        """Raises Refused, also for one of other owners (HST-009).

        owners: the account, or the names that it acts for.
        """
        try:
            found = self.get(submission_id)
        except KeyError as error:
            raise Refused("not_found", _NOT_FOUND, act=_ACT) from error
        if found.account not in owners:
            raise Refused("not_found", _NOT_FOUND, act=_ACT)
        return found

    def get_for_host(self, submission_id: str) -> Submission:
        """Raises Refused."""
        try:
            return self.get(submission_id)
        except KeyError as error:
            raise Refused("not_found", "There is no such submission.") from error

    def note_use(
        self, submission: Submission, purpose: str, seconds: float, cpu_s: float | None
    ) -> None:
        """A sandbox of the submission has ended."""
        self.database.execute(
            "INSERT INTO sandbox_uses "
            "(submission_id, account, purpose, ended_at, seconds, cpu_s) "
            "VALUES (?, ?, ?, ?, ?, ?)",
            *(submission.submission_id, submission.account, purpose, self.clock()),
            *(seconds, cpu_s),
        )

    def of_owners(self, owners: Collection[str]) -> Sequence[Submission]:
        """The newest first."""
        marks = ", ".join("?" * len(owners))
        return self.database.rows(
            Submission,
            f"SELECT * FROM submissions WHERE account IN ({marks}) "  # noqa: S608
            "ORDER BY created_at DESC",
            *owners,
        )

    def place_of(self, submission: Submission) -> Place:
        """The phase in which it takes part. Raises Refused."""
        track = self.tracks.get(submission.track_id)
        return Place(track, track.phase(submission.phase_id))

    def in_states(self, *states: State) -> Sequence[Submission]:
        """The one that entered its state first is the first."""
        found = [
            one
            for state in states
            for one in self.database.rows(
                Submission, "SELECT * FROM submissions WHERE state = ?", state
            )
        ]
        return sorted(found, key=lambda one: one.entered_at)

    def ended_since(self, since: float) -> Sequence[Submission]:
        return self.database.rows(
            Submission,
            "SELECT * FROM submissions WHERE deadline_at IS NULL AND entered_at > ?",
            since,
        )

    def create(
        self,
        owner: str,
        track_id: str,
        *,
        kind: Literal["image", "code"] = "image",
        preset: str = "",
        policy_name: str = "",
        phase_id: str = "",
    ) -> Submission:
        """Raises Refused. Nothing is counted before it is started.

        phase_id: empty for the open phase that closes first.
        """
        track, now = self.tracks.get(track_id), self.clock()
        entrant = self.tracks.entrant(track_id, owner)
        if entrant is None or entrant.state != "entered":
            raise _why_not_entered(owner, track_id, entrant)
        place = open_place(track, phase_id, now)
        # Now: an upload, and a verification, may take hours.
        wait = self.tracks.why_to_wait(place, owner)
        if (kind == "code") != bool(preset) or not policy_name.isprintable():
            text = "Code needs a preset, an image has none; the name is one line."
            raise Refused("invalid_request", text)
        waiting = WAITING["created"]
        reason = f"{waiting.reason} It cannot be started now: {wait}"
        submission = Submission(
            f"sub_{secrets.token_hex(12)}", owner, track_id, kind, "created",
            now, now, now + waiting.deadline_s, reason if wait else waiting.reason,
            preset=preset, policy_name=policy_name, phase_id=place.phase.phase_id,
        )  # fmt: skip
        with self.database.transaction():
            mine = self.of_owners([owner])
            if sum(one.state not in FINAL for one in mine) >= OPEN_MAX:
                text = f"{owner} has {OPEN_MAX} submissions that have not ended."
                act = "Wait until one of them has ended, or stop one."
                raise Refused("quota_exceeded", text, act=act)
            self.database.insert("submissions", submission)
        return submission

    def move(
        self,
        submission_id: str,
        event: Event,
        *,
        reason: str = "",
        cause: Cause = "",
        run_id: str = "",
        digest: str = "",
    ) -> Submission:
        """Raises KeyError and IllegalTransition."""
        with self.database.transaction():
            before = self.get(submission_id)
            after = apply(before, event, self.clock(), reason=reason, cause=cause)
            if run_id and event in ("begin_verification", "pass_verification"):
                after = replace(after, verification_run_id=run_id)
            elif run_id:
                after = replace(after, run_id=run_id)
            self._store(replace(after, digest=digest or after.digest))
        return after

    def note_run(
        self, submission_id: str, run_id: str, *, is_verification: bool
    ) -> None:
        """The run of a submission, as soon as the server has it.

        It is the submission's also if that has been stopped meanwhile.
        """
        with self.database.transaction():
            before = self.get(submission_id)
            if is_verification:
                self._store(replace(before, verification_run_id=run_id))
            else:
                self._store(replace(before, run_id=run_id))

    def note_score(self, submission: Submission, score: Mapping[str, Any]) -> None:
        """The score of its run, as `get_score` shows it."""
        note_figures(self.database, submission.run_id, score)

    def attach(self, submission_id: str, digest: str) -> Submission:
        """Its upload is complete. Raises Refused."""
        try:
            return self.move(submission_id, "upload", digest=digest)
        except IllegalTransition as error:
            raise Refused("illegal_transition", str(error)) from error

    def start(self, submission_id: str, owners: Collection[str]) -> Submission:
        """Count it, and queue it (HST-012). Raises Refused."""
        with self.database.transaction():
            submission = self.get_own(submission_id, owners)
            if submission.state == "verified":
                place, now = self.place_of(submission), self.clock()
                if not place.phase.is_open(now):
                    raise closed_refusal(place, now)
                self.tracks.check_room(place, submission.account)
            started = self._moved(submission_id, "start")
            place = self.place_of(started)
            if place.phase.is_held_out:
                started = _waiting_for_draw(started, place)
                self._store(started)
        return started

    def continues_at(self, submission: Submission) -> float | None:
        """The date that it waits for, if it waits for one: the draw of its seeds."""
        if submission.state != "queued":
            return None
        place = self.place_of(submission)
        is_due = not place.phase.is_held_out or self.tracks.draws.may_play(place)
        return None if is_due else place.phase.closes_at

    def wait_for_draws(self) -> Sequence[Submission]:
        """Deadlines and reasons follow the date at which a phase closes, and the draw.

        Returns those that have changed.
        """
        changed = []
        for submission in self.in_states("queued"):
            place = self.place_of(submission)
            if not place.phase.is_held_out:
                continue
            waiting = _waiting_for_draw(submission, place)
            if self.tracks.draws.may_play(place):
                waiting = replace(submission, reason=_DRAWN)
            if waiting != submission:
                self._store(waiting)
                changed.append(waiting)
        return changed

    def stop(self, submission_id: str, owners: Collection[str]) -> Submission:
        """By its owner. Raises Refused."""
        self.get_own(submission_id, owners)
        return self._moved(submission_id, "stop", "Its owner stopped it.", "owner")

    def stop_by_host(self, submission_id: str, reason: str, actor: str) -> Submission:
        """Raises Refused. The audit log has it."""
        with self.database.transaction():
            submission = self._moved(submission_id, "stop", reason, "host")
            audit(
                self.database, self.clock(), actor=actor, act="stop_submission",
                subject=submission_id, detail=reason,
            )  # fmt: skip
        return submission

    def end_late(self) -> None:
        """End those that are over their deadlines."""
        now = self.clock()
        with self.database.transaction():
            late = self.database.rows(
                Submission, "SELECT * FROM submissions WHERE deadline_at <= ?", now
            )
            for submission in late:
                after = at_deadline(submission, now)
                if after is not None:
                    self._store(after)

    def _moved(
        self, submission_id: str, event: Event, reason: str = "", cause: Cause = ""
    ) -> Submission:
        try:
            return self.move(submission_id, event, reason=reason, cause=cause)
        except KeyError as error:
            raise Refused("not_found", _NOT_FOUND, act=_ACT) from error
        except IllegalTransition as error:
            raise Refused("illegal_transition", str(error)) from error

    def _store(self, submission: Submission) -> None:
        values = asdict(submission)
        del values["submission_id"]
        names = ", ".join(f"{name} = ?" for name in values)
        self.database.execute(
            f"UPDATE submissions SET {names} WHERE submission_id = ?",  # noqa: S608
            *values.values(),
            submission.submission_id,
        )


_DRAWN = f"Its phase has closed, and the seeds are drawn. {WAITING['queued'].reason}"


def _waiting_for_draw(submission: Submission, place: Place) -> Submission:
    """It is queued until its phase closes, and then as any other."""
    closes_at = place.phase.closes_at
    return replace(
        submission,
        reason=f"Its seeds are drawn when the phase closes, at {said_time(closes_at)}.",
        deadline_at=max(submission.entered_at, closes_at)
        + WAITING["queued"].deadline_s,
    )


def _why_not_entered(owner: str, track_id: str, entrant: Entrant | None) -> Refused:
    page = f"/hosting/tracks/{track_id}"
    if entrant is None:
        text = f"{owner} has not entered the track {track_id}."
        return Refused("forbidden", text, act=f"Enter it on its page, {page}.")
    text = f"The entry of {owner} in the track {track_id} is {entrant.state}."
    return Refused("forbidden", text, act=f"Read more on its page, {page}.")
