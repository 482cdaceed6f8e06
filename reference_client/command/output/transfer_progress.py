"""How much of a large file is packed or sent, in lines on stderr."""

from __future__ import annotations

import time

from reference_client.command.output.printer import LOG_S, Printer

TERMINAL_S = 3.0  # between two lines on a terminal; elsewhere LOG_S
_LONG_BYTES = 2**23  # of less, only the end is said


class TransferProgress:
    """Says how much of a long piece of work is done: at first, and every few seconds.

    done: the verb, such as `uploaded`. then: said at the end of a long one.
    """

    def __init__(self, printer: Printer, done: str, *, then: str = "") -> None:
        self._printer, self._done, self._then = printer, done, then
        self._every_s = TERMINAL_S if printer.err.is_terminal else LOG_S
        self._said_at = -self._every_s
        self._last = ""

    def __call__(self, arrived: int, size: int) -> None:
        now = time.monotonic()
        is_over = arrived == size
        is_early = size < _LONG_BYTES or now < self._said_at + self._every_s
        if is_early and not is_over:
            return
        line = f"{self._done} {arrived_text(arrived, size)}"
        if line != self._last:
            self._said_at, self._last = now, line
            self._printer.say(line)
            if is_over and self._then and size >= _LONG_BYTES:
                self._printer.say(self._then)


def arrived_text(arrived: int, size: int) -> str:
    """`0.5 of 2.0 MiB`, in the largest unit of which the whole is one or more."""
    units = (("GiB", 2**30), ("MiB", 2**20), ("KiB", 2**10))
    for unit, unit_bytes in units:
        if size >= unit_bytes:
            return f"{arrived / unit_bytes:.1f} of {size / unit_bytes:.1f} {unit}"
    return f"{arrived} of {size} bytes"
