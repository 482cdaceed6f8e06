"""The end of a program by Ctrl-C, or when its output is read no more (`… | head`).

This module must not import what may be missing.
"""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Callable

# As shells report a program that SIGINT or SIGPIPE has ended.
INTERRUPTED, READ_NO_MORE = 130, 141


def run_program(main: Callable[[], int]) -> int:
    """The exit code of `main`, or READ_NO_MORE without a word.

    An interruption that `main` leaves to its caller, as while it imports, is one line.
    """
    try:
        try:
            code = main()
        except SystemExit as ended:  # help was printed
            if not isinstance(ended.code, int | None):
                raise
            code = ended.code or 0
        if sys.stdout is not None:
            sys.stdout.flush()  # here a closed pipe is noticed
    except BrokenPipeError:
        discard_standard_output()
        return READ_NO_MORE
    except KeyboardInterrupt:
        with contextlib.suppress(OSError, ValueError):
            sys.stderr.write("\nInterrupted.\n")
        return INTERRUPTED
    return code


def discard_standard_output() -> None:
    """Write to nowhere what is still written, also when Python exits."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
