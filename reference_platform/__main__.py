"""`proctor-host`: a server and the platform beside it, on one machine."""

from __future__ import annotations

import sys

from reference_record.command_line.closed_output import run_program


def main() -> int:
    return run_program(_start)


def _start() -> int:
    from reference_platform.command_line.host_command import start

    return start()


if __name__ == "__main__":
    sys.exit(main())
