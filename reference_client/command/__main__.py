"""Entry point of `proctor` and `python -m reference_client.command`.

The kit is installed from the same wheel without the client's dependencies. There,
`proctor` reports the missing dependency in one line. This module must not import what
may be missing.
"""

import sys

from reference_client.printable_text import prepare_output
from reference_record.command_line.closed_output import run_program
from reference_record.command_line.installation import install_command


def main() -> int:
    """Returns the exit code of the command; 2 when it cannot start."""
    prepare_output()
    return run_program(_run_command)


def _run_command() -> int:
    try:
        from reference_client.command.main import prepare

        command = prepare(sys.argv[1:])
    except ModuleNotFoundError as missing:
        print(
            f"proctor: {missing.name} is not installed: "
            f"{install_command('client')} (the kit alone is proctor-conformance)",
            file=sys.stderr,
        )
        return 2
    return command()


if __name__ == "__main__":
    sys.exit(main())
