"""Memory that was freed goes back to the system after much of it was held.

The C library keeps what is freed below other blocks, for ever if need be: a flood of
bodies would stay in the size of the process. Where it cannot be asked (it is not
glibc), nothing is done.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable

# Less than that is not worth a look through the whole heap, which takes milliseconds.
LARGE_BYTES = 2**22


def find_trim() -> Callable[[int], object] | None:
    """The function of the C library, if it has it."""
    try:
        return getattr(ctypes.CDLL(None), "malloc_trim", None)
    except (OSError, TypeError):
        return None


class FreedMemory:
    """To be looked at now and then."""

    def __init__(self) -> None:
        self._trim = find_trim()
        self._highest = 0

    def note(self, held: int) -> None:
        """So much is held, or was since the last look."""
        self._highest = max(self._highest, held)

    def look(self, held: int) -> None:
        """Give back what was freed, if most of what was held is held no more."""
        self.note(held)
        if self._highest >= LARGE_BYTES and 2 * held < self._highest:
            self._highest = held
            if self._trim is not None:
                self._trim(0)
