"""Runs a command of `proctor` whose command line was read; gives its exit code.

Every error is one line on stderr; with --json it is a JSON value on stdout as well.
"""

from __future__ import annotations

import importlib
import traceback
from collections.abc import Callable, Sequence

from reference_client.command.exit_codes import (
    WRONG_USAGE_OR_NO_SERVER,
    exit_code_of,
    message_of,
)
from reference_client.command.output.printer import Printer
from reference_client.command.usage_error import UsageError
from reference_client.errors import ProctorError
from reference_record.command_line.click_commands import Options, WrongUsage

Function = Callable[[Options, Printer], int]
# Command → the function that does it, as MODULE:NAME. A command imports its own alone.
FUNCTIONS = {
    "login": "command.signing_in:login",
    "submit": "command.runs.control:submit",
    "run": "command.runs.running:run",
    "status": "command.runs.control:status",
    "stop": "command.runs.control:stop",
    "resume": "command.runs.control:resume",
    "delete": "command.runs.control:delete",
    "open": "command.runs.page_address:open_page",
    "results": "command.runs.scored_runs:results",
    "compare": "command.runs.scored_runs:compare",
    "benchmarks": "command.runs.control:benchmarks",
    "export": "command.records.record_commands:export",
    "verify": "command.records.record_commands:check",
    "upload": "command.records.uploads:upload",
    "report": "view.report_command:report",
    "board": "board.commands:board",
    "publish": "board.commands:publish",
    "withdraw": "board.commands:withdraw",
    "video": "command.records.record_commands:video",
    "completion": "command.command_line.completion:completion",
}


def import_function(command: str) -> Function:
    """The function of a command, with all that it needs."""
    module, _, name = FUNCTIONS[command].partition(":")
    imported = importlib.import_module(f"reference_client.{module}")
    function: Function = getattr(imported, name)
    return function


def execute(
    function: Function, args: Options, notes: Sequence[str], *, as_json: bool
) -> int:
    """Returns the exit code; see reference_client.command.exit_codes."""
    try:
        for note in notes:
            Printer(as_json=as_json).say(f"proctor: {note}")
        return _run_command(
            function, args, Printer(as_json=args.json, style=args.format)
        )
    except WrongUsage as error:
        return report_wrong_usage(error, as_json=as_json)


def report_wrong_usage(error: WrongUsage, *, as_json: bool) -> int:
    """Print the line; returns the exit code."""
    _print_error("usage", str(error), as_json=as_json)
    return WRONG_USAGE_OR_NO_SERVER


def _run_command(function: Function, args: Options, printer: Printer) -> int:
    try:
        return function(args, printer)
    except ProctorError as error:
        if args.debug:
            printer.say(traceback.format_exc().rstrip())
        if error.code == "not_found":
            from reference_client.command.ids_of_other_kinds import explain_id

            error = explain_id(error, args, printer)
        _print_error(error.code, message_of(error), as_json=args.json)
        return exit_code_of(error, has_run=False)
    except WrongUsage:
        if args.debug:
            traceback.print_exc()
        raise
    except ValueError as error:  # an invalid URL or id, noticed before sending
        raise UsageError(" ".join(str(error).split())) from error


def _print_error(code: str, line: str, *, as_json: bool) -> None:
    printer = Printer(as_json=as_json)
    printer.say(f"proctor: {line}")
    if as_json:
        printer.answer({"error": {"code": code, "detail": line}})
