"""The interfaces between the parts of a submission; each part has its own folder.

Files are uploaded (Uploads), logs written and followed (SubmissionLogs), policies
played (PolicyRunner) with keys of accounts (AccountTokens). Nothing starts here.
"""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, Protocol

from reference_platform.submissions.lifecycle import Cause, Submission

Purpose = Literal["verification", "evaluation"]


def beginning_of(purpose: Purpose) -> str:
    """The line of the log with which a policy begins to be played."""
    return f"The {purpose} begins."


@dataclass(frozen=True, slots=True)
class LogLine:
    """source: what the policy printed, or what the platform did. number: from 1."""

    number: int
    at: float
    source: Literal["policy", "platform"]
    text: str


class SubmissionLogs(Protocol):
    """The logs of submissions: durable before the sandbox ends, limited in size.

    host_folders: whose paths participants do not see.
    """

    host_folders: Sequence[Path]

    def write(
        self, submission_id: str, source: Literal["policy", "platform"], text: str
    ) -> None:
        """Append; a text of several lines is several.

        Lines that the disk refuses wait, and are written by a later call.
        """

    def is_durable(self, submission_id: str) -> bool:
        """Write what waits; whether all lines of the submission are on the disk."""

    def last_text(self, submission_id: str) -> str:
        """The text of the last line; empty if there is none."""

    def read(self, submission_id: str, after: int = 0) -> Sequence[LogLine]: ...

    def follow(self, submission_id: str, after: int = 0) -> AsyncIterator[LogLine]:
        """The lines that exist, and new ones, until the submission has ended."""


class Uploads(Protocol):
    """The files that accounts have uploaded, by digest."""

    def path_of(self, account: str, digest: str) -> Path:
        """The complete file. Raises KeyError."""

    def remove(self, account: str, digest: str, before: float) -> None:
        """Unless it arrived later than that."""


@dataclass(frozen=True, slots=True)
class Track:
    """The part of a track that a runner needs.

    splits, options: of the evaluation; empty for all, and for none.
    verification_episodes: how many the verification plays. time_limit_s: of the
    evaluation.
    """

    track_id: str
    benchmark_id: str
    splits: tuple[str, ...] = ()
    options: Mapping[str, Any] = field(default_factory=dict)
    verification_episodes: int = 2
    time_limit_s: float = 24 * 3600.0


class AccountTokens(Protocol):
    """Keys with which the platform acts for an account at the server."""

    def make_token(self, account: str, lifetime_s: float) -> str:
        """A new key with the scopes read and run; it counts against no quota."""

    def revoke_token(self, token: str) -> None: ...


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a verification or an evaluation ended.

    cause: empty if it passed. reason: for people; also why it passed with remarks.
    may_retry: the host may have caused it, so that it is worth another try.
    has_exited: the policy ended before its run did.
    score: of a completed run, as `get_score` shows it.
    seconds, cpu_s: that its sandbox ran and used; None where that is not counted.
    """

    passed: bool
    reason: str
    cause: Cause = ""
    run_id: str = ""
    may_retry: bool = False
    has_exited: bool = False
    score: Mapping[str, Any] | None = None
    seconds: float = 0.0
    cpu_s: float | None = None


class PolicyRunner(Protocol):
    """Plays an uploaded policy in a sandbox, as a push run of the server.

    It writes the log, and leaves no process, mount or file. It does not move the
    submission: its caller does that with the outcome.
    """

    async def verify(
        self,
        submission: Submission,
        track: Track,
        on_run: Callable[[str], None] = ...,
    ) -> Outcome:
        """Play a few episodes. on_run: is given the id of the run once it is made."""

    async def evaluate(
        self,
        submission: Submission,
        track: Track,
        on_run: Callable[[str], None] = ...,
    ) -> Outcome:
        """Play the whole benchmark; go on with `submission.run_id` if it has one."""

    async def stop(self, submission_id: str) -> None:
        """End what is played of the submission; verify or evaluate returns then."""

    async def remove_files(self, submission: Submission, *, and_root: bool) -> None:
        """Remove the upload of a submission that has ended.

        and_root: also what was unpacked, which other accounts may use.
        """
