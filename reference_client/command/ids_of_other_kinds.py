"""Ids that are not of a run, where a command wants one: says what to give instead.

Only a server knows its ids: one that finds a run by such an id has named it so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress

from reference_client.board.board_client import BoardClient
from reference_client.command.command_line.chosen_server import command_text
from reference_client.command.output.printer import Printer
from reference_client.command.server_connection import connect, retry_policy_of
from reference_client.errors import ProctorError
from reference_client.hosting.hosting_client import HostingClient
from reference_client.protocol.connection import Connection
from reference_client.protocol.retry_policy import RetryPolicy
from reference_record.command_line.click_commands import Options

# The options that hold ids of runs, and the beginning of ids in these of other kinds.
_OF_RUNS = ("run", "run_id", "baseline", "runs")
_KINDS = {
    "entry_": "an entry of the leaderboard",
    "sub_": "a submission",
    "sess_": "a session of a worker",
    "imp_": "an import of a record",
    "key_": "a key",
}


def explain_id(error: ProctorError, args: Options, printer: Printer) -> ProctorError:
    """The refusal of an unknown id, with the kind of an id that is of no run."""
    if error.code != "not_found":
        return error
    given = next((name for name in _given(args) if name in error.detail), "")
    kind = next((kind for kind in _KINDS if given.startswith(kind)), None)
    if kind is not None:
        return error.explained(_instead(given, kind, args, printer))
    submission = getattr(args, "submission", None) or ""
    if submission.startswith("run_"):
        command = command_text(args, "status", submission)
        return error.explained(f"That is the id of a run; `{command}` shows it.")
    return error


def _given(args: Options) -> Iterator[str]:
    for option in _OF_RUNS:
        value = getattr(args, option, None) or ()
        yield from [value] if isinstance(value, str) else value


def _instead(given: str, kind: str, args: Options, printer: Printer) -> str:
    """A sentence with the kind of an id that is of no run, and the id to give."""
    what = f"That is the id of {_KINDS[kind]}"
    run_id = ""
    find = _FINDERS.get(kind)
    if find is not None:
        with suppress(ProctorError), connect(args, printer) as (connection, _):
            run_id = find(connection, retry_policy_of(connection, args, printer), given)
    if run_id:
        return f"{what}; give its run, {run_id}."
    listing = command_text(args, "status")
    if kind == "sub_":
        following = command_text(args, "submit", "--submission", given)
        return f"{what}; `{following}` follows it, and `{listing}` lists runs."
    return f"{what}; give that of a run: `{listing}` lists them."


def _run_of_entry(connection: Connection, retry_policy: RetryPolicy, name: str) -> str:
    return BoardClient(connection, retry_policy).entry(name).run_id


def _run_of_submission(
    connection: Connection, retry_policy: RetryPolicy, name: str
) -> str:
    return HostingClient(connection, retry_policy).read(name).run_id


_FINDERS: dict[str, Callable[[Connection, RetryPolicy, str], str]] = {
    "entry_": _run_of_entry,
    "sub_": _run_of_submission,
}
