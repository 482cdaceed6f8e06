"""`proctor COMMAND …`: parses the command line, runs the command, returns an exit code.

Every error is one line on stderr; with --json it is a JSON value on stdout as well.
"""

from __future__ import annotations

import argparse
import os
import sys
import traceback
from collections.abc import Callable, Sequence

from reference_client.board import commands as board_commands
from reference_client.command.command_line import completion
from reference_client.command.command_line.aliases import (
    PASS_THROUGH_COMMANDS,
    translate,
)
from reference_client.command.command_line.arguments import build_parser, resolve_server
from reference_client.command.exit_codes import (
    INTERRUPTED,
    WRONG_USAGE_OR_NO_SERVER,
    exit_code_of,
    message_of,
)
from reference_client.command.output.printer import Printer
from reference_client.command.programs import start
from reference_client.command.records import record_commands, uploads
from reference_client.command.runs import control, page_address, running
from reference_client.command.usage_error import UsageError
from reference_client.errors import ProctorError


def _report(args: argparse.Namespace, printer: Printer) -> int:
    # The templates take longer to import than most commands take.
    from reference_client.view import report_command

    return report_command.report(args, printer)


COMMANDS: dict[str, Callable[[argparse.Namespace, Printer], int]] = {
    "submit": control.submit,
    "run": running.run,
    "status": control.status,
    "stop": control.stop,
    "resume": control.resume,
    "delete": control.delete,
    "open": page_address.open_page,
    "results": control.results,
    "compare": control.compare,
    "benchmarks": control.benchmarks,
    "export": record_commands.export,
    "verify": record_commands.check,
    "upload": uploads.upload,
    "report": _report,
    "board": board_commands.board,
    "publish": board_commands.publish,
    "withdraw": board_commands.withdraw,
    "video": record_commands.video,
    "completion": completion.completion,
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
        args = build_parser().parse_args(words)
        resolve_server(args)
        printer = Printer(as_json=args.json, style=args.format)
        return _run_command(args, printer)
    except UsageError as error:
        _print_error("usage", str(error), as_json=as_json)
        return WRONG_USAGE_OR_NO_SERVER
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:  # `proctor results | head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return WRONG_USAGE_OR_NO_SERVER


def _run_command(args: argparse.Namespace, printer: Printer) -> int:
    try:
        return COMMANDS[args.command](args, printer)
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


def _print_error(code: str, line: str, *, as_json: bool) -> None:
    printer = Printer(as_json=as_json)
    printer.say(f"proctor: {line}")
    if as_json:
        printer.answer({"error": {"code": code, "detail": line}})
