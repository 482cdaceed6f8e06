"""`proctor COMMAND …`: parses the command line, runs the command, returns an exit code.

Every error is one line on stderr; with --json it is a JSON value on stdout as well.
"""

from __future__ import annotations

import importlib
import os
import sys
import traceback
from collections.abc import Callable, Sequence

from reference_client.command.command_line.aliases import (
    PASS_THROUGH_COMMANDS,
    translate,
)
from reference_client.command.command_line.arguments import parse
from reference_client.command.exit_codes import (
    INTERRUPTED,
    WRONG_USAGE_OR_NO_SERVER,
    exit_code_of,
    message_of,
)
from reference_client.command.output.printer import Printer
from reference_client.command.programs import start
from reference_client.command.usage_error import UsageError
from reference_client.errors import ProctorError
from reference_record.command_line.click_commands import Options, WrongUsage

# Command → the function that does it, as MODULE:NAME. A module is imported when its
# command is given: help, mistakes and a Tab in a shell need none of them.
FUNCTIONS = {
    "submit": "command.runs.control:submit",
    "run": "command.runs.running:run",
    "status": "command.runs.control:status",
    "stop": "command.runs.control:stop",
    "resume": "command.runs.control:resume",
    "delete": "command.runs.control:delete",
    "open": "command.runs.page_address:open_page",
    "results": "command.runs.control:results",
    "compare": "command.runs.control:compare",
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


def main(arguments: Sequence[str] | None = None) -> int:
    """Returns the exit code; see reference_client.command.exit_codes."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    as_json = "--json" in given
    try:
        words, notes = translate(given)
        for note in notes:
            Printer(as_json=as_json).say(f"proctor: {note}")
        if words and words[0] in PASS_THROUGH_COMMANDS:
            return start(words[0], words[1:])
        args = parse(words)
        printer = Printer(as_json=args.json, style=args.format)
        return _run_command(args, printer)
    except WrongUsage as error:
        _print_error("usage", str(error), as_json=as_json)
        return WRONG_USAGE_OR_NO_SERVER
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:  # `proctor results | head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return WRONG_USAGE_OR_NO_SERVER


def _run_command(args: Options, printer: Printer) -> int:
    try:
        return _function_of(args.command)(args, printer)
    except ProctorError as error:
        if args.debug:
            printer.say(traceback.format_exc().rstrip())
        _print_error(error.code, message_of(error), as_json=args.json)
        return exit_code_of(error, has_run=False)
    except UsageError:
        if args.debug:
            traceback.print_exc()
        raise
    except ValueError as error:  # an invalid URL or id, noticed before sending
        raise UsageError(" ".join(str(error).split())) from error


def _function_of(command: str) -> Callable[[Options, Printer], int]:
    module, _, name = FUNCTIONS[command].partition(":")
    function: Callable[[Options, Printer], int] = getattr(
        importlib.import_module(f"reference_client.{module}"), name
    )
    return function


def _print_error(code: str, line: str, *, as_json: bool) -> None:
    printer = Printer(as_json=as_json)
    printer.say(f"proctor: {line}")
    if as_json:
        printer.answer({"error": {"code": code, "detail": line}})
