"""`proctor COMMAND …`: reads the command line, and prepares what it asks for.

Help, a Tab in a shell and programs of their own need nothing that takes long to import;
what the other commands need is imported when they are.
"""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable, Sequence

from reference_client.command.command_line.aliases import (
    PASS_THROUGH_COMMANDS,
    translate,
)
from reference_client.command.command_line.arguments import parse
from reference_client.command.programs import program_of, require, start
from reference_record.command_line.click_commands import WrongUsage


def main(arguments: Sequence[str] | None = None) -> int:
    """Returns the exit code; see reference_client.command.exit_codes."""
    return prepare(sys.argv[1:] if arguments is None else arguments)()


def prepare(arguments: Sequence[str]) -> Callable[[], int]:
    """The command, ready to be called; it gives the exit code.

    Ends the process after --help and at a Tab in a shell. Raises ModuleNotFoundError.
    """
    as_json = "--json" in arguments
    try:
        words, notes = translate([*arguments])
        if words and words[0] in PASS_THROUGH_COMMANDS:
            program, rest = program_of(words)
            require(program)
            return lambda: start(program, rest)
        args = parse(words)
    except WrongUsage as error:
        from reference_client.command.command_execution import report_wrong_usage

        return functools.partial(report_wrong_usage, error, as_json=as_json)
    from reference_client.command.command_execution import execute, import_function

    function = import_function(args.command)
    return functools.partial(execute, function, args, notes, as_json=as_json)
