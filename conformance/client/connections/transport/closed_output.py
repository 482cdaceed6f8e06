"""The end of a program by Ctrl-C, or when its output takes no more.

That is read no more (`… | head`), or goes to a disk that is full. This module must not
import what may be missing. `make generate` copies this file to the kit.
"""

from __future__ import annotations

import contextlib
import errno
import os
import sys
from collections.abc import Callable

# As shells report a program that SIGINT or SIGPIPE has ended.
INTERRUPTED, READ_NO_MORE = 130, 141
UNWRITABLE = 2


def run_program(main: Callable[[], int]) -> int:
    """The exit code of `main`, or READ_NO_MORE without a word.

    An interruption that `main` leaves to its caller, as while it imports, is one line,
    and so is a disk that takes no output.
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
    except OSError as error:
        if not _is_of_standard_output(error):
            raise
        discard_standard_output()
        _say(f"{unwritable(error)}.")
        return UNWRITABLE
    except KeyboardInterrupt:
        _say("\nInterrupted.")
        return INTERRUPTED
    return code


def unwritable(error: OSError) -> str:
    """The sentence on a standard output that takes no more, without its full stop."""
    return f"The standard output cannot be written ({error.strerror or error})"


def _is_of_standard_output(error: OSError) -> bool:
    """Whether it is the standard output that takes no more; nothing is added to it.

    An error that names a file is of that file. Text that could not be written is still
    waiting, so that it fails again. A stream without a buffer has nothing left: its
    device refuses, or its disk is full.
    """
    if sys.stdout is None or error.filename is not None:
        return False
    try:
        sys.stdout.flush()
        place = sys.stdout.fileno()
        os.write(place, b"")
        return error.errno == errno.ENOSPC and os.fstatvfs(place).f_bavail == 0
    except OSError:
        return True


def _say(line: str) -> None:
    with contextlib.suppress(OSError, ValueError):
        sys.stderr.write(f"{line}\n")


def discard_standard_output() -> None:
    """Write to nowhere what is still written, also when Python exits."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
