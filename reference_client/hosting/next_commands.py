"""The commands that go on with a submission, as `proctor submit` prints them.

Each says what it does. Following starts nothing: an evaluation counts against the quota
of its track, so that only --track, or --start, begins one.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from reference_client.command.command_line.chosen_server import command_text
from reference_client.hosting.hosting_client import HostedSubmission
from reference_record.command_line.click_commands import Options


@dataclass(frozen=True, slots=True)
class SubmissionCommands:
    """args: of the command that prints them."""

    args: Options

    @property
    def starts(self) -> bool:
        """Whether this command starts an evaluation once the policy is verified."""
        if self.args.submission is not None:
            return bool(self.args.start)
        return not self.args.verify_only

    def named(self, submission: HostedSubmission) -> Mapping[str, str]:
        """Label → the command that does it; none for a submission that has ended."""
        name = submission.submission_id
        if submission.has_ended:
            return {}
        if submission.state == "created":
            return {"to upload it": self.uploading(submission)}
        if submission.state == "verified":
            return {"to start it, which counts": self._of(name, "--start")}
        return {"to follow it": self._of(name)}

    def sentence(self, submission: HostedSubmission) -> str:
        """The fate of the submission without this program; it has no full stop."""
        name = submission.submission_id
        starting = f"`{self._of(name, '--start')}`"
        if submission.state == "created":
            then = ", and then starts its evaluation, which counts"
            upload = f"`{self.uploading(submission)}` continues it"
            upload += then if self.starts else ""
            return f"{name} waits for its upload{until(submission)}; {upload}"
        if submission.state == "verified":
            start = f"{starting} starts its evaluation, which counts"
            return f"{name} stays verified{until(submission)}; {start}"
        if submission.has_ended:
            return f"{name} has ended; `{self._of(name)}` shows how"
        text = f"{name} goes on at the host without this program; "
        text += f"`{self._of(name)}` follows it again"
        if self.starts and submission.state in ("uploaded", "verifying"):
            text += f", and {starting} also starts its evaluation, which counts"
        return text

    def uploading(self, submission: HostedSubmission) -> str:
        """The command that begins the upload, or continues it where it was."""
        file = "FOLDER" if submission.kind == "code" else "FILE"
        words = [f"--{submission.kind}", self.args.code or self.args.image or file]
        if self.args.dockerfile is not None:
            words += ["--dockerfile", self.args.dockerfile]
        return self._of(
            submission.submission_id, *words, *(["--start"] if self.starts else [])
        )

    def _of(self, name: str, *words: str) -> str:
        return command_text(self.args, "submit", "--submission", name, *words)


def until(submission: HostedSubmission) -> str:
    """` until 2027-01-01 00:00:00 UTC`, the deadline of its state."""
    if submission.deadline_at is None:
        return ""
    return f" until {submission.deadline_at:%Y-%m-%d %H:%M:%S} UTC"
