"""`proctor submit --track`: hands a policy in, and follows it to its result.

Exit codes: 0 completed, with --verify-only verified, or it waits for a date, such as
that of the draw of its seeds; 1 it failed, was stopped or has expired; 2 it could not
be handed in.
"""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import quote

from reference_client.command.command_line.chosen_server import DEFAULT_URL
from reference_client.command.exit_codes import DONE, NOT_COMPLETE
from reference_client.command.output.printer import Printer
from reference_client.command.output.text_tables import fact_table
from reference_client.command.programs import own_name
from reference_client.command.server_connection import retry_policy_of
from reference_client.command.usage_error import UsageError
from reference_client.errors import ProctorError
from reference_client.hosting.hosting_client import (
    HostedSubmission,
    HostingClient,
    pack_code,
    require_accounts,
)
from reference_client.protocol.connection import Connection
from reference_record.command_line.click_commands import Options

_LOOK_S = 0.5
_REPORT_S = 5.0
# Who brought an end about, as hosting.yaml has it, for its entrant.
_OWNERS = {
    "owner": "you",
    "policy": "your policy",
    "platform": "the platform",
    "host": "the host",
}


def submit_policy(args: Options, printer: Printer) -> int:
    """Upload, verify, start, and follow the log to the end."""
    with Connection(args.url, args.credential, requests=1) as connection:
        retry_policy = retry_policy_of(connection, args, printer)
        require_accounts(connection, retry_policy)
        client = HostingClient(connection, retry_policy)
        if args.submission is not None:
            submission = client.read(args.submission)
        else:
            submission = _hand_in(args, client, printer)
        name = submission.submission_id
        try:
            submission = _follow(client, submission, printer, args)
        except KeyboardInterrupt:
            printer.say(
                f"\nproctor: {name} goes on without this program; "
                f"`{_following(args, name)}` follows it again"
            )
            raise
    _print(args, submission, printer)
    is_done = submission.state == "completed" or submission.waits_for_a_date
    is_done |= args.verify_only and submission.state == "verified"
    return DONE if is_done else NOT_COMPLETE


def _print(args: Options, submission: HostedSubmission, printer: Printer) -> None:
    """Print its state, who brought an end about, and the next step."""
    name, run = submission.submission_id, submission.run_id
    value = {"submission_id": name, "state": submission.state}
    value |= {"reason": submission.reason, "run_id": run}
    value |= {"cause": submission.cause, "next_action": submission.next_action}
    value |= {"track_id": submission.track_id, "phase_id": submission.phase_id}
    is_open = not submission.has_ended
    facts = {
        "submission": name,
        "phase": _phase_of(submission) or None,
        "state": submission.state,
        "reason": submission.reason,
        "ended by": _OWNERS.get(submission.cause, submission.cause) or None,
        "next": submission.next_action or None,
        "results": _command(args, f"results {run}") if run else None,
        "to follow it": _following(args, name) if is_open else None,
    }
    printer.answer(value, fact_table(facts))


def _following(args: Options, name: str) -> str:
    return _command(args, f"submit --submission {name}")


def _command(args: Options, words: str) -> str:
    """A command to copy, wherever its server is."""
    default = os.environ.get("PROCTOR_URL") or DEFAULT_URL
    place = "" if args.url == default else f" --url {args.url}"
    return f"{own_name()} {words}{place}"


def _hand_in(
    args: Options, client: HostingClient, printer: Printer
) -> HostedSubmission:
    if (args.image is None) == (args.code is None):
        raise UsageError("--track needs --image FILE, or --code FOLDER --preset NAME")
    if (args.code is None) != (args.preset is None):
        raise UsageError("--code and --preset belong together")
    if args.preset is not None and args.preset not in (names := client.presets()):
        raise UsageError(
            f"the host has no preset {args.preset}; it has {', '.join(names) or 'none'}"
        )
    dockerfile = _read_dockerfile(args)
    with _file_of(args) as path:
        # Created first: an upload for a track that is closed would be in vain.
        try:
            submission = client.create(
                track_id=args.track,
                phase_id=args.phase or "",
                kind="image" if args.code is None else "code",
                preset=args.preset or "",
                policy_name=args.name or Path(args.image or args.code).resolve().stem,
            )
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
        printer.say(
            f"Ctrl-C ends nothing; `{_following(args, name)}` follows it again."
        )
        digest = client.upload(path, _Progress(printer))
    client.attach(submission.submission_id, digest, dockerfile)
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


@contextmanager
def _file_of(args: Options) -> Iterator[Path]:
    """The image, or an archive of the code as long as that is needed."""
    if args.image is not None:
        path = Path(args.image)
        if not path.is_file():
            raise UsageError(f"{path}: there is no such file")
        yield path
        return
    folder = Path(args.code)
    if not folder.is_dir():
        raise UsageError(f"{folder}: there is no such folder")
    with tempfile.TemporaryDirectory() as place:
        archive = Path(place, "code.tar.gz")
        pack_code(folder, archive)
        yield archive


def arrived_text(arrived: int, size: int) -> str:
    """`0.5 of 2.0 MiB`, in the largest unit of which the whole is one or more."""
    units = (("GiB", 2**30), ("MiB", 2**20), ("KiB", 2**10))
    for unit, unit_bytes in units:
        if size >= unit_bytes:
            return f"{arrived / unit_bytes:.1f} of {size / unit_bytes:.1f} {unit}"
    return f"{arrived} of {size} bytes"


class _Progress:
    """Says how much of a long upload has arrived."""

    def __init__(self, printer: Printer) -> None:
        self._printer = printer
        self._said_at = time.monotonic()

    def __call__(self, arrived: int, size: int) -> None:
        now = time.monotonic()
        if now > self._said_at + _REPORT_S or arrived == size:
            self._said_at = now
            self._printer.say(f"uploaded {arrived_text(arrived, size)}")


_STARTS_IT = (
    "This command starts the evaluation now; it counts against the quota of the track."
)


def _follow(
    client: HostingClient,
    submission: HostedSubmission,
    printer: Printer,
    args: Options,
) -> HostedSubmission:
    """Print the log as it grows; start the evaluation once the policy is verified."""
    name, after, said = submission.submission_id, 0, ""
    while True:
        submission = client.read(name)
        for line in client.log(name, after):
            printer.say(f"{line.source:8} | {line.text}")
            after = line.number
        state = f"{submission.state}: {submission.reason}"
        if state != said and not submission.has_ended:
            starts = submission.state == "verified" and not args.verify_only
            next_action = _STARTS_IT if starts else submission.next_action
            printer.say(f"{state} {next_action}")
            said = state
        is_over = submission.has_ended or submission.waits_for_a_date
        if is_over or (args.verify_only and submission.state == "verified"):
            return submission
        if submission.state == "verified":
            _start(client, submission, args)
        time.sleep(_LOOK_S)


def _start(client: HostingClient, submission: HostedSubmission, args: Options) -> None:
    name = submission.submission_id
    try:
        client.start(name)
    except ProctorError as error:
        if error.code == "illegal_transition":  # it was started elsewhere
            return
        until = ""
        if submission.deadline_at is not None:
            until = f" until {submission.deadline_at:%Y-%m-%d %H:%M:%S} UTC"
        raise error.explained(
            f"{name} stays verified{until}; `{_following(args, name)}` starts it then."
        ) from error
