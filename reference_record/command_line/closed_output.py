"""The end of a program whose output is read no more, as in `proctor benchmarks | head`.

This module must not import what may be missing.
"""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Callable

READ_NO_MORE = 141  # as shells report a program that SIGPIPE has ended


def run_program(main: Callable[[], int]) -> int:
    """The exit code of `main`, or READ_NO_MORE without a word."""
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
    return code


def discard_standard_output() -> None:
    """Write to nowhere what is still written, also when Python exits."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
