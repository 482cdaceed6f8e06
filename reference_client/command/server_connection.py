"""The connection of a command to the server that its flags name.

While it waits to repeat a request, it says on stderr why and for how long.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from proctor_client import Run

from reference_client.command.command_line.chosen_server import command_text
from reference_client.command.exit_codes import with_flag_names
from reference_client.command.output.printer import Printer
from reference_client.errors import ProctorError
from reference_client.protocol.connection import Connection
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.retry_policy import RetryPolicy
from reference_record.command_line.click_commands import Options
from reference_record.texts.counted_text import counted

FIRST_CONTACT_S = 10.0


@contextmanager
def open_control_client(args: Options, printer: Printer) -> Iterator[ControlClient]:
    """A client of the server that the flags name."""
    with Connection(args.url, args.credential, requests=2) as connection:
        yield ControlClient(
            connection.control, retry_policy_of(connection, args, printer)
        )


def retry_policy_of(
    connection: Connection, args: Options, printer: Printer
) -> RetryPolicy:
    return connection.retry_policy(
        threading.Event(),
        _waiting_reporter(printer),
        args.retry_timeout_s,
        FIRST_CONTACT_S,
    )


@contextmanager
def connect(
    args: Options, printer: Printer, *, anonymous_at: str | None = None
) -> Iterator[tuple[Connection, RetryPolicy]]:
    """The connection to the server that the flags name, with its token.

    anonymous_at: the URL of a server in its place, which gets none.
    """
    credential = None if anonymous_at else args.credential
    with Connection(anonymous_at or args.url, credential, requests=1) as connection:
        yield connection, retry_policy_of(connection, args, printer)


@contextmanager
def explaining_state(
    args: Options, connection: Connection, retry_policy: RetryPolicy, run_id: str
) -> Iterator[None]:
    """A request that the state of the run does not allow: says what to do first."""
    try:
        yield
    except ProctorError as error:
        if error.code != "illegal_transition":
            raise
        run = retry_policy.call(lambda: connection.control.get_run(run_id))
        raise error.explained(_way_to_completion(args, run)) from error


def _way_to_completion(args: Options, run: Run) -> str:
    scored, total = run.progress.episodes_scored, run.progress.episodes_total
    counts = f"{scored} of {counted(total, 'episode is', 'episodes are')} scored"
    if run.state.value == "failed" and not run.retryable:
        return f"{counts}, and the run cannot be resumed."
    if run.policy_server is not None:
        command = command_text(args, "status", run.run_id, "--watch")
        return f"{counts}; `{command}` waits for it."
    command = command_text(args, "run", "--run-id", run.run_id, "--policy", "POLICY")
    return f"{counts}. Play the rest, then repeat this command: {command}"


def _waiting_reporter(printer: Printer) -> Any:
    def report_waiting(what: str | None) -> None:
        if what is not None:
            then = "" if what.endswith("…") else " Trying again …"
            printer.say(f"proctor: {with_flag_names(what)}{then}")

    return report_waiting
