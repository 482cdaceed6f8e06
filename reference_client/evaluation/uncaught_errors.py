"""A program that does not catch a ProctorError ends with its text, and no traceback.

A wrong token is a mistake outside of the program; forty lines of it would hide what to
do. PROCTOR_DEBUG=1 prints the traceback. Errors of another kind, and those of a policy,
are printed as Python does.
"""

from __future__ import annotations

import os
import sys
from types import TracebackType

from reference_client.errors import PolicyFailed, ProctorError
from reference_client.printable_text import LenientStream


def shorten_report() -> None:
    """Print the text alone of a ProctorError that ends this program.

    A program that prints such errors in its own way goes on doing that.
    """
    if sys.excepthook is sys.__excepthook__ and not os.environ.get("PROCTOR_DEBUG"):
        sys.excepthook = _print_text


def without_own_frames(interrupt: KeyboardInterrupt) -> KeyboardInterrupt:
    """The interrupt without the calls in which it met this client.

    Its notes are the last words of the traceback, and the program's own lines stay.
    """
    if os.environ.get("PROCTOR_DEBUG"):
        return interrupt
    return interrupt.with_traceback(None)


def _print_text(
    kind: type[BaseException], error: BaseException, traceback: TracebackType | None
) -> None:
    if not isinstance(error, ProctorError) or isinstance(error, PolicyFailed):
        sys.__excepthook__(kind, error, traceback)
        return
    notes = getattr(error, "__notes__", [])
    LenientStream(sys.stderr).write("\n".join([f"proctor: {error}", *notes]) + "\n")
