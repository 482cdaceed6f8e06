"""The command upload: hands a record in, and says how far it is trusted there.

Exit codes: 0 taken in, and with --wait not diverged; 1 the record is broken or its
replay diverged; 2 it could not be handed in.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from proctor_client import RecordImport

from reference_client.command.exit_codes import DONE, NOT_COMPLETE, with_flag_names
from reference_client.command.output.printer import Printer
from reference_client.command.output.text_tables import TextTable, fact_table
from reference_client.command.output.transfer_progress import TransferProgress
from reference_client.command.records.record_commands import BROKEN, NOT_SHOWN, fault_of
from reference_client.command.server_connection import retry_policy_of
from reference_client.command.usage_error import UsageError
from reference_client.errors import ProctorError
from reference_client.protocol.connection import TIMEOUTS_S, Connection
from reference_client.protocol.record_client import read_import, send_record
from reference_client.protocol.retry_policy import RetryPolicy
from reference_record.broken import BrokenRecord, UnusableRecord
from reference_record.command_line.click_commands import Options
from reference_record.command_line.printed_commands import server_check
from reference_record.formats.archive import stream_archive
from reference_record.formats.bundle import open_bundle
from reference_record.texts.counted_text import counted
from reference_record.texts.figures import figure
from reference_record.unsigned_record import save_blocks, with_verdict

_CHECKED = "The server checks the whole record before it answers."
POLL_FIRST_S, POLL_LONGEST_S = 0.2, 5.0
_MEANING = {
    "reported": "the file is whole and its score follows; by whom it was made, and "
    "whether it happened, nothing says there",
    "signed": "the file is whole, its score follows, and the server knows the key that "
    "signed it; the owner of the key could have made it up",
    "replayed": "the server simulated the recorded actions again, and every result "
    "came out the same",
    "diverged": "the server simulated the recorded actions again, and other results "
    "came out: do not trust the score",
}


def upload(args: Options, printer: Printer) -> int:
    with Connection(args.url, args.credential, requests=1) as connection:
        policy = retry_policy_of(connection, args, printer)
        try:
            with _archive_of(Path(args.file)) as path:
                _check_taken_in(connection, policy, args.file)
                progress = TransferProgress(printer, "uploaded", then=_CHECKED)
                taken = send_record(connection, policy, path, progress)
        except ProctorError as error:
            if error.code != "record_broken":
                raise
            return _print_broken(error, printer)
        if args.wait:
            taken = _wait_until_finished(connection, policy, taken, args.timeout)
    printer.answer(taken.to_dict(), _facts(args.file, taken))
    if args.wait and taken.state != "finished":
        printer.say(f"proctor: still {taken.state} after {args.timeout:g} s")
        return NOT_COMPLETE
    return BROKEN if taken.level == "diverged" else DONE


def _check_taken_in(connection: Connection, policy: RetryPolicy, file: str) -> None:
    """Raise UsageError if the server takes no records, before a long one is sent."""
    service = policy.call(
        lambda: connection.control.describe_service(_request_timeout=TIMEOUTS_S)
    )
    if "record_import" not in service.profiles:
        raise UsageError(
            f"{connection.url} takes no records in; if it is a server of Proctor, its "
            "host turns that on with --record-imports on or "
            "PROCTOR_RECORD_IMPORTS=on, which needs recordings. "
            f"`{server_check('', file)}` checks the record here"
        )


@contextmanager
def _archive_of(path: Path) -> Iterator[Path]:
    """The file; of a directory its archive, as long as that is needed."""
    if not path.is_dir():
        if not path.is_file():
            raise UsageError(f"{path}: there is no such file")
        try:
            open_bundle(path)
        except BrokenRecord as error:
            if error.way_out:  # the server would only refuse it
                raise UsageError(f"{path}: {fault_of(error)}") from error
        yield path
        return
    with tempfile.TemporaryDirectory() as folder:
        packed = Path(folder, "record.proctor")
        try:
            contents = with_verdict(open_bundle(path), "", None)
            save_blocks(packed, stream_archive(contents.items()))
        except (BrokenRecord, UnusableRecord) as error:
            way_out = getattr(error, "way_out", "")
            text = f"{path} is no record: {error}"
            raise UsageError(f"{text}. {way_out}" if way_out else text) from error
        yield packed


def _wait_until_finished(
    connection: Connection,
    policy: RetryPolicy,
    taken: RecordImport,
    timeout_s: float | None,
) -> RecordImport:
    pause_s = POLL_FIRST_S
    until = None if timeout_s is None else time.monotonic() + timeout_s
    while taken.state != "finished":
        if until is not None and time.monotonic() > until:
            return taken
        policy.pause(pause_s)
        pause_s = min(2 * pause_s, POLL_LONGEST_S)
        taken = read_import(connection, policy, taken.import_id)
    return taken


def _print_broken(error: ProctorError, printer: Printer) -> int:
    problem = error.problem
    rule = None if problem is None else problem.requirement
    detail = with_flag_names(error.detail)
    printer.say(f"proctor: do not trust it: {detail} [{rule}]")
    if printer.as_json:
        pointer, detail = next(iter(error.errors), ("", detail))
        file = pointer.removeprefix("record:")
        printer.answer({"level": None, "file": file, "rule": rule, "detail": detail})
    return BROKEN


def _facts(file: str, taken: RecordImport) -> TextTable:
    version = f", version {taken.policy.version}" if taken.policy.version else ""
    done = f"{taken.episodes_replayed} of {counted(taken.episodes, 'episode')}"
    score = "not complete"
    if taken.score is not None:
        score = f"{figure(taken.score, 4)}, the mean of all its episodes; that of each "
        score += f"split is in `{server_check('', file)}`"
    return fact_table(
        {
            "file": file,
            "import": f"{taken.import_id}, {taken.state}",
            "level": taken.level_text,
            "it means": _MEANING.get(taken.level),
            "score": score,
            "policy": f"{taken.policy.name}{version}",
            "benchmark": f"{taken.benchmark_id}, version {taken.benchmark_version}",
            "manifest": taken.manifest_sha256,
            "signed by": taken.signer or f"{taken.keyid}, which is not known there",
            "replayed": taken.reason or done,
            "not shown": NOT_SHOWN,
        }
    )
