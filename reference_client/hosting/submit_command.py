"""`proctor submit --track`: hands a policy in, and follows it to its result.

Exit codes: 0 completed, with --verify-only verified, or it waits for a date, such as
that of the draw of its seeds; 1 it failed, was stopped or has expired; 2 it could not
be handed in.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import quote

from reference_client.command.command_line.chosen_server import command_text
from reference_client.command.exit_codes import DONE, NOT_COMPLETE
from reference_client.command.output.printer import Printer
from reference_client.command.output.text_tables import fact_table
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
_REPORT_S = 3.0
_LONG_BYTES = 2**23  # of less, only the end is said
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
            submission = _create(args, client, printer)
        name = submission.submission_id
        if submission.state == "created":
            _upload(args, submission, client, printer)
        with _saying_what_follows(
            printer,
            f"{name} goes on without this program; "
            f"`{_following(args, name)}` follows it again",
        ):
            submission = _follow(client, submission, printer, args)
    _print(args, submission, printer)
    is_done = submission.state == "completed" or submission.waits_for_a_date
    is_done |= args.verify_only and submission.state == "verified"
    return DONE if is_done else NOT_COMPLETE


@contextmanager
def _saying_what_follows(printer: Printer, line: str) -> Iterator[None]:
    """At Ctrl-C, print a line on what becomes of the submission."""
    try:
        yield
    except KeyboardInterrupt:
        printer.say(f"\nproctor: {line}")
        raise


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
        "results": command_text(args, "results", run) if run else None,
        "to follow it": command_text(args, "submit", "--submission", name)
        if is_open
        else None,
    }
    printer.answer(value, fact_table(facts))


def _following(args: Options, name: str) -> str:
    only = ["--verify-only"] if args.verify_only else []
    return command_text(args, "submit", "--submission", name, *only)


def _create(args: Options, client: HostingClient, printer: Printer) -> HostedSubmission:
    """Make it before anything is packed: that may be in vain, as the track may refuse.

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
    try:
        submission = client.create(
            track_id=args.track,
            phase_id=args.phase or "",
            kind="image" if args.code is None else "code",
            preset=args.preset or "",
            policy_name=args.name or source.resolve().stem,
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
    return submission


def _upload(
    args: Options, submission: HostedSubmission, client: HostingClient, printer: Printer
) -> None:
    """Send what the server lacks of the file of a submission that waits for it."""
    name = submission.submission_id
    _require_its_file(args, submission)
    source, words = _source_of(args), [f"--{submission.kind}", args.code or args.image]
    if args.dockerfile is not None:
        words += ["--dockerfile", args.dockerfile]
    if args.verify_only:
        words += ["--verify-only"]
    command = command_text(args, "submit", "--submission", name, *words)
    until = _until(submission)
    waits = f"{name} waits for its upload{until}; `{command}` continues it"
    printer.say(f"Ctrl-C interrupts the upload; `{command}` continues it{until}.")
    with _saying_what_follows(printer, waits):
        try:
            with _file_of(args, source, printer) as path:
                digest = client.upload(path, _Progress(printer, "uploaded"))
        except ProctorError as error:
            raise error.explained(f"{waits}.") from error
        client.attach(name, digest, _read_dockerfile(args))
    printer.say(f"Ctrl-C ends nothing now; `{_following(args, name)}` follows it.")


def _require_its_file(args: Options, submission: HostedSubmission) -> None:
    """Raise UsageError unless the options name the file that a submission waits for."""
    kind = submission.kind
    if getattr(args, kind, None) is not None:
        return
    what = "FOLDER" if kind == "code" else "FILE"
    words = ("submit", "--submission", submission.submission_id, f"--{kind}", what)
    raise UsageError(
        f"{submission.submission_id} waits for its upload{_until(submission)}, which "
        f"another command began and has not ended; `{command_text(args, *words)}` "
        "continues it where it was"
    )


def _until(submission: HostedSubmission) -> str:
    if submission.deadline_at is None:
        return ""
    return f" until {submission.deadline_at:%Y-%m-%d %H:%M:%S} UTC"


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


@contextmanager
def _file_of(args: Options, source: Path, printer: Printer) -> Iterator[Path]:
    """The image, or an archive of the code as long as that is needed."""
    if args.image is not None:
        yield source
        return
    with tempfile.TemporaryDirectory() as place:
        archive = Path(place, "code.tar.gz")
        pack_code(source, archive, _Progress(printer, "packed"))
        yield archive


def arrived_text(arrived: int, size: int) -> str:
    """`0.5 of 2.0 MiB`, in the largest unit of which the whole is one or more."""
    units = (("GiB", 2**30), ("MiB", 2**20), ("KiB", 2**10))
    for unit, unit_bytes in units:
        if size >= unit_bytes:
            return f"{arrived / unit_bytes:.1f} of {size / unit_bytes:.1f} {unit}"
    return f"{arrived} of {size} bytes"


class _Progress:
    """Says how much of a long piece of work is done: at first, and every few seconds.

    done: the verb, such as `uploaded`.
    """

    def __init__(self, printer: Printer, done: str) -> None:
        self._printer, self._done = printer, done
        self._said_at = -_REPORT_S
        self._last = ""

    def __call__(self, arrived: int, size: int) -> None:
        now = time.monotonic()
        is_over = arrived == size
        if not is_over and (size < _LONG_BYTES or now < self._said_at + _REPORT_S):
            return
        line = f"{self._done} {arrived_text(arrived, size)}"
        if line != self._last:
            self._said_at, self._last = now, line
            self._printer.say(line)


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
        raise error.explained(
            f"{name} stays verified{_until(submission)}; "
            f"`{_following(args, name)}` starts it then."
        ) from error
