"""The place of a submission that waits for a sandbox, as a sentence.

The supervisor begins what may be played in this order: verifications before
evaluations, and of each the one that waits longest.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from reference_platform.submissions.lifecycle import State, Submission
from reference_platform.submissions.submission_store import SubmissionStore
from reference_platform.tracks.track_rules import said_time
from reference_record.texts.counted_text import counted

_WAITING: Final[tuple[State, ...]] = ("uploaded", "queued")
_APPROVED: Final = "SELECT count(*) FROM images WHERE digest = ? AND state = 'approved'"


def with_place(store: SubmissionStore, submission: Submission) -> Submission:
    """The same, whose reason says how many are before it, if a sandbox is missing."""
    if submission.state not in _WAITING or not _may_be_played(store, submission):
        return submission
    before = sum(
        _order(one) < _order(submission) and _may_be_played(store, one)
        for one in store.in_states(*_WAITING)
    )
    playing = store.in_states("verifying", "running")
    text = place_text(before, [one.entered_at for one in playing])
    return replace(submission, reason=f"{submission.reason} {text}".rstrip())


def _order(submission: Submission) -> tuple[int, float]:
    return _WAITING.index(submission.state), submission.entered_at


def place_text(before: int, busy_since: Sequence[float]) -> str:
    """busy_since: when each sandbox that is in use began, the earliest first.

    Empty for one that begins in a moment.
    """
    verb = "is" if before == 1 else "are"
    texts = [f"{counted(before, 'submission')} {verb} before it."] if before else []
    if len(busy_since) == 1:
        texts.append(f"The sandbox is busy since {said_time(busy_since[0])}.")
    elif busy_since:
        since = f"the longest since {said_time(busy_since[0])}"
        texts.append(f"{len(busy_since)} sandboxes are busy, {since}.")
    return " ".join(texts)


def _may_be_played(store: SubmissionStore, submission: Submission) -> bool:
    """As the supervisor decides it: images are approved, and seeds are drawn."""
    if submission.kind == "image" and not store.database.number(
        _APPROVED, submission.digest
    ):
        return False
    is_queued = submission.state == "queued"
    return not is_queued or store.tracks.draws.may_play(store.place_of(submission))
