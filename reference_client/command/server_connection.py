"""The connection of a command to the server that its flags name.

While it waits to repeat a request, it says on stderr why and for how long.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from reference_client.command.output.printer import Printer
from reference_client.protocol.connection import Connection
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.retry_policy import RetryPolicy
from reference_record.command_line.click_commands import Options

RETRY_TIMEOUT_S = 10.0


@contextmanager
def open_control_client(args: Options, printer: Printer) -> Iterator[ControlClient]:
    """A client of the server that the flags name."""
    with Connection(args.url, args.token, requests=2) as connection:
        yield ControlClient(
            connection.control, retry_policy_of(connection, args, printer)
        )


def retry_policy_of(
    connection: Connection, args: Options, printer: Printer
) -> RetryPolicy:
    retry_timeout_s = (
        RETRY_TIMEOUT_S if args.retry_timeout_s is None else args.retry_timeout_s
    )
    return RetryPolicy(
        connection.url, retry_timeout_s, threading.Event(), _waiting_reporter(printer)
    )


@contextmanager
def connect(
    url: str, token: str | None, args: Options, printer: Printer
) -> Iterator[tuple[Connection, RetryPolicy]]:
    with Connection(url, token, requests=1) as connection:
        yield connection, retry_policy_of(connection, args, printer)


def _waiting_reporter(printer: Printer) -> Any:
    def report_waiting(what: str | None) -> None:
        if what is not None:
            printer.say(f"proctor: {what} Trying again …")

    return report_waiting
