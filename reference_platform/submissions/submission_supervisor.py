"""Moves submissions along: begins what may begin, and ends what is late.

It decides no rule: what an event does is in `lifecycle`, how a policy is played in
`sandboxed_runner`. A platform that starts again takes up what the last one left.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import sqlite3
import time
from collections.abc import Awaitable, Callable, Iterable
from dataclasses import replace
from functools import partial
from typing import Final

from reference_platform.images.image_reviews import ImageReviews
from reference_platform.submissions.interfaces import (
    Outcome,
    PolicyRunner,
    SubmissionLogs,
)
from reference_platform.submissions.interfaces import Track as PlayedTrack
from reference_platform.submissions.lifecycle import (
    FINAL,
    OPEN_STATES,
    Event,
    IllegalTransition,
    State,
    Submission,
)
from reference_platform.submissions.log_redaction import LogRedaction
from reference_platform.submissions.submission_store import SubmissionStore
from reference_platform.tracks.phase_draws import DrawHistory
from reference_server.rules.refusal import Refused
from reference_server.telemetry.repeated_failures import RepeatedFailures

log = logging.getLogger("proctor.hosting")

LOOK_S: Final = 0.25
# A fault of the host may pass: so often is one submission tried, with growing pauses.
TRIES_MAX: Final = 5
PAUSE_S: Final = 5.0
# The logs and files of submissions that ended so lately are looked after at a start.
_TIDIED_S: Final = 30 * 86_400.0
_STARTED_S: Final = 30.0
_DEFECT: Final = "The platform has a defect; the host finds it in the log."


class SubmissionSupervisor:
    """Plays the submissions of a store. at_once: how many sandboxes run at a time.

    history: of the server, for seeds that are drawn; None: none are.
    """

    def __init__(
        self,
        store: SubmissionStore,
        reviews: ImageReviews,
        runner: PolicyRunner,
        logs: SubmissionLogs,
        at_once: int = 1,
        *,
        history: DrawHistory | None = None,
    ) -> None:
        self._store = store
        self._reviews = reviews
        self._runner = runner
        self._logs = logs
        self._at_once = at_once
        self._history = history
        self._tasks: dict[str, asyncio.Task[None]] = {}
        self._noted: dict[str, State] = {}  # of those that have not ended
        # How often each was tried in vain, and when it may begin again.
        self._tries: dict[str, tuple[int, float]] = {}
        # Submission → its run, and whether that is of a verification.
        self._runs_to_note: dict[str, tuple[str, bool]] = {}
        # Why nothing goes on; empty if it does.
        self.problem = ""
        self._failures = RepeatedFailures(log)
        self._begun_at = time.monotonic()

    def has_written(self, submission_id: str) -> bool:
        """Whether the end of a submission that has ended is in its log."""
        return submission_id not in self._noted

    async def run(self) -> None:
        """Until it is cancelled; then nothing is played any more."""
        try:
            is_begun = False
            while True:
                try:
                    if not is_begun:
                        await self._take_up()
                        is_begun = True
                    await self._look()
                    self.problem = ""
                except (sqlite3.Error, OSError) as error:
                    if str(error) != self.problem:
                        log.warning("submissions wait: %s", error)
                    self.problem = str(error)
                except Exception as error:
                    log.exception("submissions wait")
                    self.problem = f"{_DEFECT} ({error!r})"
                await asyncio.sleep(LOOK_S)
        finally:
            tasks = list(self._tasks.values())
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)

    async def _take_up(self) -> None:
        """Finish what the last platform has left: ends without a line, and files."""
        now = {s.submission_id: s for s in self._store.in_states(*OPEN_STATES)}
        for name, submission in now.items():
            self._noted.setdefault(name, submission.state)
        since = self._store.clock() - _TIDIED_S
        for ended in self._store.ended_since(since):
            last = self._logs.last_text(ended.submission_id)
            if last != _state_text(ended):
                self._say(ended, _state_text(ended))
            await self._remove_files(ended, now.values())

    async def _look(self) -> None:
        self._note_runs()
        await self._draw_seeds()
        self._store.end_late()
        await self._note_changes()
        played = self._store.in_states("verifying", "running")
        active = {submission.submission_id for submission in played}
        for submission in played:
            if submission.submission_id not in self._tasks:
                self._say(submission, "The platform was restarted.")
                self._store.move(submission.submission_id, "requeue")
        for name in self._tasks.keys() - active:  # stopped, or late
            await self._runner.stop(name)
        for submission in self._store.in_states("uploaded"):
            if self._may_be_played(submission) and self._has_room(submission):
                self._begin(submission, "begin_verification", self._verify)
        for submission in self._store.in_states("queued"):
            place = self._store.place_of(submission)
            is_drawn = self._store.tracks.draws.may_play(place)
            may_play = self._may_be_played(submission) and is_drawn
            if may_play and self._has_room(submission):
                self._begin(submission, "begin_run", self._evaluate)

    async def _draw_seeds(self) -> None:
        """Each leaf when it is due; a server that is away is asked again."""
        tracks = self._store.tracks
        for place in tracks.places():
            if not place.phase.is_held_out or self._history is None:
                continue
            try:
                await tracks.draws.advance(place, self._history, tracks.clock())
            except Refused as refused:
                # A server that starts with its host does not answer at once.
                if time.monotonic() > self._begun_at + _STARTED_S:
                    self._failures.report(f"the seeds of {place}", refused.detail)
        for submission in self._store.wait_for_draws():
            if self._noted.get(submission.submission_id) == submission.state:
                self._say(submission, submission.reason)

    async def _note_changes(self) -> None:
        """Write each new state down, whichever program has changed it."""
        now = {s.submission_id: s for s in self._store.in_states(*OPEN_STATES)}
        for name in self._noted.keys() - now.keys():
            if name not in self._tasks:  # else its sandbox still writes
                ended = self._store.get(name)
                if self._logs.last_text(name) != _state_text(ended):
                    self._say(ended, _state_text(ended))
                if self._logs.is_durable(name):
                    await self._remove_files(ended, now.values())
                    del self._noted[name]
                    self._tries.pop(name, None)
        for submission in now.values():
            self._note(submission)

    def _note(self, submission: Submission) -> None:
        """Write down the state of one that has not ended, if it is a new one."""
        name = submission.submission_id
        if name not in self._noted:
            place = self._store.place_of(submission)
            self._say(submission, f"It takes part in {place}.")
        if self._noted.get(name) != submission.state:
            self._noted[name] = submission.state
            self._say(submission, _state_text(submission))

    async def _remove_files(
        self, ended: Submission, still_open: Iterable[Submission]
    ) -> None:
        """A submission has ended; remove its files unless another one needs them."""
        same = [s for s in still_open if s.digest == ended.digest]
        if ended.digest and all(s.account != ended.account for s in same):
            await self._runner.remove_files(ended, and_root=not same)

    def _has_room(self, submission: Submission) -> bool:
        """Also whether the pause after its last fault is over."""
        _, begins_at = self._tries.get(submission.submission_id, (0, 0.0))
        return len(self._tasks) < self._at_once and time.monotonic() >= begins_at

    def _may_be_played(self, submission: Submission) -> bool:
        """Code always, an image while approved (HST-023). A rejected one fails."""
        if submission.kind == "code":
            return True
        image = self._reviews.get(submission.digest)
        if image is not None and image.state == "rejected":
            reason = f"The host has rejected the image: {image.reason}"
            name = submission.submission_id
            self._store.move(name, "fail", reason=reason, cause="host")
        return image is not None and image.state == "approved"

    def _begin(
        self,
        submission: Submission,
        event: Event,
        play: Callable[[Submission], Awaitable[None]],
    ) -> None:
        name = submission.submission_id
        if name in self._tasks:  # its last run is being ended
            return
        moved = self._store.move(name, event)
        self._note(moved)
        task = asyncio.ensure_future(self._guard(moved, play))
        self._tasks[name] = task
        task.add_done_callback(lambda _: self._tasks.pop(name, None))

    async def _guard(
        self, submission: Submission, play: Callable[[Submission], Awaitable[None]]
    ) -> None:
        try:
            await play(submission)
        except Exception:
            log.exception("submission %s failed", submission.submission_id)
            self._say(submission, _DEFECT)
            outcome = Outcome(False, _DEFECT, "platform", may_retry=True)
            await self._end(submission, "fail", outcome)

    async def _verify(self, submission: Submission) -> None:
        note = partial(self._note_run, submission.submission_id, is_verification=True)
        outcome = await self._runner.verify(submission, self._track(submission), note)
        await self._end(submission, "pass_verification", outcome)

    async def _evaluate(self, submission: Submission) -> None:
        note = partial(self._note_run, submission.submission_id, is_verification=False)
        outcome = await self._runner.evaluate(submission, self._track(submission), note)
        await self._end(submission, "complete", outcome)

    def _note_run(self, name: str, run_id: str, *, is_verification: bool) -> None:
        """Now, or as soon as the database takes it."""
        self._runs_to_note[name] = run_id, is_verification
        with contextlib.suppress(sqlite3.OperationalError):
            self._note_runs()

    def _note_runs(self) -> None:
        """Before submissions leave their states, so that none is played again."""
        for name, (run_id, is_verification) in list(self._runs_to_note.items()):
            self._store.note_run(name, run_id, is_verification=is_verification)
            del self._runs_to_note[name]

    async def _explained(self, submission: Submission, outcome: Outcome) -> Outcome:
        """With the last words of the policy, where its phase shows what it prints."""
        if outcome.passed or outcome.cause != "policy":
            return outcome
        phase = self._store.place_of(submission).phase
        redaction = LogRedaction.of(phase, self._logs.host_folders)
        lines = await asyncio.to_thread(self._logs.read, submission.submission_id)
        last = redaction.last_words(lines, has_exited=outcome.has_exited)
        return replace(outcome, reason=f"{outcome.reason} {last}".rstrip())

    async def _end(
        self, submission: Submission, passed: Event, outcome: Outcome
    ) -> None:
        """Store an outcome, as soon as the database takes it."""
        outcome = await self._explained(submission, outcome)
        name, event, reason = submission.submission_id, passed, outcome.reason
        if not outcome.passed:
            event = "stop" if outcome.cause == "owner" else "fail"
        tries = self._tries.get(name, (0, 0.0))[0] + 1
        has_ended = self._store.get(name).state in FINAL  # stopped, or too late
        if (
            event == "fail"
            and outcome.may_retry
            and not has_ended
            and tries < TRIES_MAX
        ):
            pause_s = PAUSE_S * tries
            self._tries[name] = tries, time.monotonic() + pause_s
            event, reason = "requeue", f"It is tried again. {outcome.reason}"
            text = f"This may be a fault of the host. Next: try {tries + 1} of "
            self._say(submission, f"{text}{TRIES_MAX}, in {pause_s:g} s.")
        purpose = "evaluation" if passed == "complete" else "verification"
        while True:
            moved = None
            try:
                with self._store.database.transaction():
                    self._note_runs()
                    if outcome.seconds:
                        self._store.note_use(
                            submission, purpose, outcome.seconds, outcome.cpu_s
                        )
                    # It may have been stopped, or have been too late, meanwhile.
                    with contextlib.suppress(IllegalTransition):
                        moved = self._store.move(
                            name, event, reason=reason, cause=outcome.cause
                        )
                        if event == "complete" and outcome.score is not None:
                            self._store.note_score(moved, outcome.score)
            except sqlite3.OperationalError as error:
                self.problem = str(error)
                await asyncio.sleep(LOOK_S)
            else:
                if moved is not None and moved.state not in FINAL:
                    self._note(moved)
                return

    def _track(self, submission: Submission) -> PlayedTrack:
        track, phase = self._store.place_of(submission)
        return PlayedTrack(
            track.track_id, phase.benchmark_id, phase.splits, phase.options or {}
        )

    def _say(self, submission: Submission, text: str) -> None:
        self._logs.write(submission.submission_id, "platform", text)


def _state_text(submission: Submission) -> str:
    """A line of the log at each change, and the last line of each log."""
    return f"State {submission.state}: {submission.reason}".rstrip(": ")
