"""Moves submissions along: begins what may begin, and ends what is late.

It decides no rule: what an event does is in `lifecycle`, how a policy is played in
`sandboxed_runner`. A platform that starts again takes up what the last one left.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
from collections.abc import Awaitable, Callable
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
    STATES,
    Event,
    IllegalTransition,
    State,
    Submission,
)
from reference_platform.submissions.submission_store import SubmissionStore

log = logging.getLogger("proctor.hosting")

LOOK_S: Final = 0.25
_OPEN: Final = tuple(state for state in STATES if state not in FINAL)
_DEFECT: Final = "The platform has a defect; the host finds it in the log."


class SubmissionSupervisor:
    """Plays the submissions of a store. at_once: how many sandboxes run at a time."""

    def __init__(
        self,
        store: SubmissionStore,
        reviews: ImageReviews,
        runner: PolicyRunner,
        logs: SubmissionLogs,
        at_once: int = 1,
    ) -> None:
        self._store = store
        self._reviews = reviews
        self._runner = runner
        self._logs = logs
        self._at_once = at_once
        self._tasks: dict[str, asyncio.Task[None]] = {}
        self._noted: dict[str, State] = {}  # of those that have not ended

    def has_written(self, submission_id: str) -> bool:
        """Whether the end of a submission that has ended is in its log."""
        return submission_id not in self._noted

    async def run(self) -> None:
        """Until it is cancelled; then nothing is played any more."""
        for submission in self._store.in_states(*_OPEN):
            self._noted[submission.submission_id] = submission.state
        for submission in self._store.in_states("verifying", "running"):
            self._say(submission, "The platform was restarted.")
            self._store.move(submission.submission_id, "requeue")
        try:
            while True:
                await self._look()
                await asyncio.sleep(LOOK_S)
        finally:
            tasks = list(self._tasks.values())
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)

    async def _look(self) -> None:
        self._store.end_late()
        await self._note_changes()
        played = self._store.in_states("verifying", "running")
        active = {submission.submission_id for submission in played}
        for name in self._tasks.keys() - active:  # stopped, or late
            await self._runner.stop(name)
        for submission in self._store.in_states("uploaded"):
            if self._may_be_verified(submission) and self._has_room():
                self._begin(submission, "begin_verification", self._verify)
        for submission in self._store.in_states("queued"):
            if self._has_room():
                self._begin(submission, "begin_run", self._evaluate)

    async def _note_changes(self) -> None:
        """Write each new state down, whichever program has changed it."""
        now = {s.submission_id: s for s in self._store.in_states(*_OPEN)}
        for name in self._noted.keys() - now.keys():
            if name not in self._tasks:  # else its sandbox still writes
                ended = self._store.get(name)
                self._say(ended, f"It is {ended.state}. {ended.reason}")
                del self._noted[name]
                same = [s for s in now.values() if s.digest == ended.digest]
                if ended.digest and all(s.account != ended.account for s in same):
                    await self._runner.remove_files(ended, and_root=not same)
        for name, submission in now.items():
            if self._noted.get(name) != submission.state:
                self._noted[name] = submission.state
                self._say(submission, f"It is {submission.state}. {submission.reason}")

    def _has_room(self) -> bool:
        return len(self._tasks) < self._at_once

    def _may_be_verified(self, submission: Submission) -> bool:
        """Code at once, an image once approved (HST-023). A rejected one fails."""
        if submission.kind == "code":
            return True
        image = self._reviews.get(submission.digest)
        if image is not None and image.state == "rejected":
            reason = f"The host has rejected the image: {image.reason}"
            self._end(submission, "fail", Outcome(False, reason, "host"))
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
            self._end(submission, "fail", Outcome(False, _DEFECT, "platform"))

    async def _verify(self, submission: Submission) -> None:
        note = partial(self._store.note_run, submission.submission_id)
        outcome = await self._runner.verify(submission, self._track(submission), note)
        self._end(submission, "pass_verification", outcome)

    async def _evaluate(self, submission: Submission) -> None:
        note = partial(self._store.note_run, submission.submission_id)
        outcome = await self._runner.evaluate(submission, self._track(submission), note)
        self._end(submission, "complete", outcome)

    def _end(self, submission: Submission, passed: Event, outcome: Outcome) -> None:
        event: Event = passed
        if not outcome.passed:
            event = "stop" if outcome.cause == "owner" else "fail"
        # It may have been stopped, or have been too late, in the meantime.
        with contextlib.suppress(IllegalTransition):
            self._store.move(
                submission.submission_id,
                event,
                reason=outcome.reason,
                cause=outcome.cause,
            )

    def _track(self, submission: Submission) -> PlayedTrack:
        track = self._store.tracks.get(submission.track_id)
        return PlayedTrack(track.track_id, track.benchmark_id, track.splits)

    def _say(self, submission: Submission, text: str) -> None:
        self._logs.write(submission.submission_id, "platform", text)
