"""`proctor submit --track`: hands a policy in, and follows it to its result.

Exit codes: 0 completed, verified where this command starts nothing, or it waits for a
date, such as that of the draw of its seeds; 1 it failed, was stopped or has expired; 2
it could not be handed in, or the host was lost.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from datetime import UTC, datetime, timedelta
from functools import cached_property
from pathlib import Path
from typing import Self
from urllib.parse import quote

from reference_client.command.command_line.chosen_server import command_text
from reference_client.command.exit_codes import DONE, NOT_COMPLETE
from reference_client.command.output.printer import Printer
from reference_client.command.output.text_tables import fact_table
from reference_client.command.output.transfer_progress import TransferProgress
from reference_client.command.server_connection import retry_policy_of
from reference_client.command.usage_error import UsageError
from reference_client.errors import ProctorError
from reference_client.hosting.hosting_client import (
    HostedSubmission,
    HostingClient,
    digest_of,
    pack_code,
    require_accounts,
)
from reference_client.hosting.next_commands import SubmissionCommands, until
from reference_client.protocol.connection import Connection
from reference_record.command_line.click_commands import Options
from reference_record.texts.repeated_lines import RepeatedLines

_LOOK_S = 0.5
# For the last lines of a log; a host with a full disk may never write them.
_REST_S = 10.0
# A policy that is handed in again so soon after its result is the same one.
_SAME_AFTER_END = timedelta(days=1)
# Who brought an end about, as hosting.yaml has it, for its entrant.
_OWNERS = {
    "owner": "you",
    "policy": "your policy",
    "platform": "the platform",
    "host": "the host",
}


def submit_policy(args: Options, printer: Printer) -> int:
    """Upload, verify, start, and follow the log to the end."""
    if args.start and args.verify_only:
        raise UsageError("--verify-only starts no evaluation, and --start does")
    with Connection(args.url, args.credential, requests=1) as connection:
        retry_policy = retry_policy_of(connection, args, printer)
        require_accounts(connection, retry_policy)
        client = HostingClient(connection, retry_policy)
        with _PolicyFile(args, printer) as file:
            if args.submission is not None:
                submission = client.read(args.submission)
            else:
                submission = _hand_in(args, file, client, printer)
            follower = _Follower(args, client, submission, printer)
            with follower.saying_what_follows():
                if submission.state == "created":
                    follower.upload(file)
                submission = follower.follow()
    _print(args, submission, printer)
    is_done = submission.state in ("completed", "verified")
    return DONE if is_done or submission.waits_for_a_date else NOT_COMPLETE


def _print(args: Options, submission: HostedSubmission, printer: Printer) -> None:
    """Print its state, who brought an end about, and the next step."""
    name, run = submission.submission_id, submission.run_id
    value = {"submission_id": name, "state": submission.state}
    value |= {"reason": submission.reason, "run_id": run}
    value |= {"cause": submission.cause, "next_action": submission.next_action}
    value |= {"track_id": submission.track_id, "phase_id": submission.phase_id}
    facts = {
        "submission": name,
        "phase": _phase_of(submission) or None,
        "state": submission.state,
        "reason": submission.reason,
        "ended by": _OWNERS.get(submission.cause, submission.cause) or None,
        "next": submission.next_action or None,
        "results": command_text(args, "results", run) if run else None,
        **SubmissionCommands(args).named(submission),
    }
    printer.answer(value, fact_table(facts))


def _hand_in(
    args: Options, file: _PolicyFile, client: HostingClient, printer: Printer
) -> HostedSubmission:
    """The submission of the same file that is there already, or a new one.

    Raises UsageError, and ProctorError for a refusal.
    """
    if (args.code is None) != (args.preset is None):
        raise UsageError("--code and --preset belong together")
    if args.preset is not None and args.preset not in (names := client.presets()):
        raise UsageError(
            f"the host has no preset {args.preset}; it has {', '.join(names) or 'none'}"
        )
    source = _source_of(args)
    _read_dockerfile(args)
    members = {
        "track_id": args.track,
        "phase_id": args.phase or "",
        "kind": "image" if args.code is None else "code",
        "preset": args.preset or "",
        "policy_name": args.name or source.resolve().stem,
    }
    if not args.another and (same := _find_same(members, file, client)) is not None:
        _say_goes_on(args, same, printer)
        return same
    return _create(args, members, client, printer)


def _say_goes_on(args: Options, same: HostedSubmission, printer: Printer) -> None:
    since = f" of {same.created_at:%Y-%m-%d %H:%M} UTC" if same.created_at else ""
    phase = f" in the phase {_phase_of(same)}" if same.phase_id else ""
    state = f"has the same policy{phase} and is {same.state}"
    if same.state == "created":
        state = f"waits for this upload{phase}"
    printer.say(
        f"submission {same.submission_id}{since} {state}; this command goes on with "
        "it. --another hands the policy in once more."
    )
    if args.dockerfile is not None and same.state != "created":
        printer.say("Its Dockerfile stays the one that it was handed in with.")


def _find_same(
    members: Mapping[str, str], file: _PolicyFile, client: HostingClient
) -> HostedSubmission | None:
    """The newest submission of these members and this file that is not over for long.

    The phase is the one that a new submission would have. The file is packed only where
    such a submission may be there.
    """
    submissions = client.all()
    alike = [one for one in submissions if _is_alike(one, members)]
    if not alike:
        return None
    phase = members["phase_id"] or client.phase_of_next(members["track_id"])
    alike = [one for one in alike if one.phase_id == phase]
    for submission in alike:
        if submission.digest == file.digest:
            return submission
    waiting = [one for one in alike if one.state == "created"]
    if len(waiting) != 1:
        return None
    # The bytes that have arrived may be those of another submission, which names them.
    is_named = any(one.digest == file.digest for one in submissions)
    return waiting[0] if not is_named and client.has_begun(file.digest) else None


def _is_alike(submission: HostedSubmission, members: Mapping[str, str]) -> bool:
    """Whether all but the phase and the file are these, and it is not over for long."""
    is_recent = (
        submission.state == "completed"
        and submission.entered_at is not None
        and datetime.now(UTC) - submission.entered_at < _SAME_AFTER_END
    )
    if submission.has_ended and not is_recent:
        return False
    names = members.keys() - {"phase_id"}
    return all(members[name] == getattr(submission, name) for name in names)


def _create(
    args: Options, members: Mapping[str, str], client: HostingClient, printer: Printer
) -> HostedSubmission:
    """Make it before anything is packed: that may be in vain, as the track may refuse.

    Raises ProctorError for a refusal.
    """
    try:
        submission = client.create(**members)
    except ProctorError as error:
        if error.code != "forbidden":
            raise
        page = f"{args.url.rstrip('/')}/hosting/tracks/{quote(args.track, safe='')}"
        raise error.explained(f"Page of the track: {page}") from error
    name = submission.submission_id
    reason = f"{submission.reason} This command uploads it now."
    printer.say(f"submission {name}: {reason}")
    if phase := _phase_of(submission):
        another = "" if args.phase else " --phase names another one."
        printer.say(f"It takes part in the phase {phase}.{another}")
    return submission


def _phase_of(submission: HostedSubmission) -> str:
    """Empty at a server that does not say it."""
    if not submission.phase_id:
        return ""
    return f"{submission.phase_id} of the track {submission.track_id}"


def _read_dockerfile(args: Options) -> str:
    if args.dockerfile is None:
        return ""
    try:
        return Path(args.dockerfile).read_text()
    except (OSError, UnicodeError) as error:
        raise UsageError(f"{args.dockerfile} cannot be read: {error}") from error


def _source_of(args: Options) -> Path:
    """The image, or the folder of code. Raises UsageError."""
    if (args.image is None) == (args.code is None):
        raise UsageError("--track needs --image FILE, or --code FOLDER --preset NAME")
    if args.image is not None:
        if not Path(args.image).is_file():
            raise UsageError(f"{args.image}: there is no such file")
        return Path(args.image)
    if not Path(args.code).is_dir():
        raise UsageError(f"{args.code}: there is no such folder")
    return Path(args.code)


class _PolicyFile:
    """The image; or an archive of the code, packed when it is first needed.

    A context manager that removes the archive.
    """

    def __init__(self, args: Options, printer: Printer) -> None:
        self._args, self._printer = args, printer
        self._folders = ExitStack()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._folders.close()

    @cached_property
    def path(self) -> Path:
        """Raises UsageError without a file, or a folder, of the options."""
        source = _source_of(self._args)
        if self._args.image is not None:
            return source
        folder = self._folders.enter_context(tempfile.TemporaryDirectory())
        archive = Path(folder, "code.tar.gz")
        pack_code(source, archive, TransferProgress(self._printer, "packed"))
        return archive

    @cached_property
    def digest(self) -> str:
        return digest_of(self.path)


_STARTS_IT = (
    "This command starts the evaluation now; it counts against the quota of the track."
)


class _FollowedLog:
    """The log of a submission, printed as it grows, without lines that come again."""

    def __init__(self, client: HostingClient, name: str, printer: Printer) -> None:
        self._client, self._name, self._printer = client, name, printer
        self._after = 0
        self._repeats = RepeatedLines()

    def print_new(self) -> bool:
        """Whether lines may follow."""
        log = self._client.log(self._name, self._after)
        for line in log.lines:
            self._after = line.number
            if line.source == "policy":
                self._print_policy(self._repeats.add(line.text))
            else:
                self.end()
                self._printer.say(f"{line.source:8} | {line.text}")
        self._print_policy(self._repeats.pause())
        return bool(log.lines) or not log.is_ended

    def print_rest(self) -> None:
        """To the last line, which a submission gets after its last state."""
        give_up_at = time.monotonic() + _REST_S
        while self.print_new() and time.monotonic() < give_up_at:
            time.sleep(_LOOK_S)

    def end(self) -> None:
        self._print_policy(self._repeats.flush())

    def _print_policy(self, lines: Iterable[str]) -> None:
        for line in lines:
            self._printer.say(f"{'policy':8} | {line}")


class _Follower:
    """Brings one submission to its end, or as far as this command takes it."""

    def __init__(
        self,
        args: Options,
        client: HostingClient,
        submission: HostedSubmission,
        printer: Printer,
    ) -> None:
        self._args, self._client, self._printer = args, client, printer
        self._commands = SubmissionCommands(args)
        self._submission = submission  # as it was read last

    @contextmanager
    def saying_what_follows(self) -> Iterator[None]:
        """Ctrl-C, and a host that is lost, end this program and not the submission."""
        try:
            yield
        except KeyboardInterrupt:
            line = self._commands.sentence(self._submission)
            self._printer.say(f"\nproctor: {line}")
            raise
        except ProctorError as error:
            line = self._commands.sentence(self._submission)
            raise error.explained(f"{line}.") from error

    def upload(self, file: _PolicyFile) -> None:
        """Send what the server lacks of the file of a submission that waits for it."""
        submission = self._submission
        command = self._commands.uploading(submission)
        if getattr(self._args, submission.kind, None) is None:
            raise UsageError(
                f"{submission.submission_id} waits for its upload{until(submission)}, "
                f"which another command began and has not ended; `{command}` continues "
                "it where it was"
            )
        sentence = self._commands.sentence(submission)
        self._printer.say(f"Ctrl-C interrupts the upload: {sentence}.")
        progress = TransferProgress(self._printer, "uploaded")
        self._client.upload(file.path, file.digest, progress)
        name = submission.submission_id
        self._client.attach(name, file.digest, _read_dockerfile(self._args))
        self._submission = self._client.read(name)
        line = self._commands.sentence(self._submission)
        self._printer.say(f"Ctrl-C ends nothing now: {line}.")

    def follow(self) -> HostedSubmission:
        """Print the log as it grows; start the evaluation where this command does."""
        name, said = self._submission.submission_id, ""
        log = _FollowedLog(self._client, name, self._printer)
        while True:
            self._submission = submission = self._client.read(name)
            log.print_new()
            is_verified = submission.state == "verified"
            starts = is_verified and self._commands.starts
            state = f"{submission.state}: {submission.reason}"
            if state != said and not submission.has_ended:
                next_action = _STARTS_IT if starts else submission.next_action
                self._printer.say(f"{state} {next_action}")
                said = state
            is_over = submission.has_ended or submission.waits_for_a_date
            if is_over or (is_verified and not starts):
                if submission.has_ended:
                    log.print_rest()
                log.end()
                return submission
            if starts:
                self._start(name)
            time.sleep(_LOOK_S)

    def _start(self, name: str) -> None:
        try:
            self._client.start(name)
        except ProctorError as error:
            if error.code != "illegal_transition":  # it was started elsewhere
                raise
