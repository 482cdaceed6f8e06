"""The end of a program by a signal, or when its output takes no more.

That is read no more (`… | head`), or goes to a disk that is full. This module must not
import what may be missing. `make generate` copies this file to the kit.
"""

from __future__ import annotations

import contextlib
import errno
import os
import signal
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FrameType
from typing import Any, NoReturn

# As shells report a program that SIGINT or SIGPIPE has ended.
INTERRUPTED, READ_NO_MORE = 130, 141
UNWRITABLE = 2
# A closed terminal sends the third, which Windows lacks as it does those below.
_ASKING = ("SIGINT", "SIGTERM", "SIGHUP")
# Batch systems give notice with them, to all processes of a job and more than once: of
# the end of its time, and of the seconds of a processor that a process may use.
NOTICES = ("SIGUSR1", "SIGUSR2", "SIGXCPU")

Handler = Callable[[int, FrameType | None], object]


def ending_signals() -> list[signal.Signals]:
    """The signals that ask a program to end, without those that `nohup` ignores."""
    there = [getattr(signal, name, None) for name in (*_ASKING, *NOTICES)]
    return [n for n in there if n is not None and signal.getsignal(n) != signal.SIG_IGN]


def take_ending_signals(handle: Handler) -> dict[int, Any]:
    """Let a function handle them, each notice once; gives the handlers before."""

    def handle_once(number: int, frame: FrameType | None) -> None:
        signal.signal(number, signal.SIG_IGN)
        handle(number, frame)

    return {
        number: signal.signal(number, handle_once if number.name in NOTICES else handle)
        for number in ending_signals()
    }


@contextlib.contextmanager
def ending_signals_taken(handle: Handler) -> Iterator[None]:
    """The same for a block, after which they have their handlers again.

    A notice that came stays ignored, since it may be repeated while the program ends.
    """
    before = take_ending_signals(handle)
    try:
        yield
    finally:
        for number, handler in before.items():
            # A notice that came is ignored since.
            if signal.getsignal(number) != signal.SIG_IGN:
                signal.signal(number, handler)


def ended_by(number: int) -> int:
    """The signal by which a server ends: it is known everywhere as an end in order."""
    return signal.SIGTERM if signal.Signals(number).name in NOTICES else number


def leave_signals_to_parent() -> None:
    """Ignore what all processes of a terminal or a job are sent, but for SIGTERM.

    The parent ends this process, with SIGTERM or by closing its input.
    """
    for number in ending_signals():
        if number != signal.SIGTERM:
            signal.signal(number, signal.SIG_IGN)


@contextlib.contextmanager
def interrupted_by_signals() -> Iterator[None]:
    """Raise KeyboardInterrupt in the block at each of them."""
    received: list[int] = []

    def handle(number: int, _frame: FrameType | None) -> None:
        received.append(number)
        interrupt(number)

    try:
        with ending_signals_taken(handle):
            yield
    except KeyboardInterrupt:
        if received:  # a library may have raised its own instead
            interrupt(received[-1])
        raise


def interrupt(number: int) -> NoReturn:
    """Raise KeyboardInterrupt, with the name of the signal; Ctrl-C needs none."""
    is_ctrl_c = number == signal.SIGINT
    raise KeyboardInterrupt(*() if is_ctrl_c else (signal.Signals(number).name,))


def code_of_interruption(interruption: KeyboardInterrupt) -> int:
    """As shells report a program that the signal has ended."""
    name = str(interruption) or "SIGINT"
    return 128 + getattr(signal, name, signal.SIGINT)


def run_program(main: Callable[[], int]) -> int:
    """The exit code of `main`, or READ_NO_MORE without a word.

    An interruption that `main` leaves to its caller, as while it imports, is one line,
    and so are a disk that takes no output and a working folder that is gone.
    """
    _open_missing_streams()
    try:
        Path.cwd()
    except OSError as error:
        _say(f"The working folder cannot be used ({error.strerror}): cd to another.")
        return UNWRITABLE
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
    except KeyboardInterrupt as interruption:
        _say("\nInterrupted.")
        return code_of_interruption(interruption)
    return code


def _open_missing_streams() -> None:
    """Let a standard stream that a batch system has closed lead to nowhere.

    Otherwise Python has None in its place, and the next file that is opened its number.
    """
    for name in ("stdin", "stdout", "stderr"):
        if getattr(sys, name) is None:  # it gets the lowest number, which is its own
            mode = "r" if name == "stdin" else "w"
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_RDWR), mode))


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
