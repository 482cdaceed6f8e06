"""Shows lines of a log that come again once, and says how often they came.

A policy that raises the same error in each call prints the same traceback for each.
Lines of the policy that repeat the ones before them are held until it is known how
often they do.
"""

from __future__ import annotations

from collections import deque

_BLOCK_MAX = 60  # lines of the longest block whose repeats are found
_SHORTEST = 3  # fewer repeated lines than these are shown as they are


class RepeatedLines:
    """The lines of one log, in their order; `add` and `flush` return what to show."""

    def __init__(self) -> None:
        self._before: list[str] = []  # the latest lines that are not held
        self._held = 0
        # The lengths of blocks before the held lines which these may repeat.
        self._lengths: list[int] = []

    def add(self, line: str) -> list[str]:
        """Take the next line."""
        shown: list[str] = []
        waiting = deque([line])
        while waiting:
            line = waiting.popleft()
            if going_on := self._going_on(line):
                self._lengths, self._held = going_on, self._held + 1
            elif self._held:
                texts, rest = self._release()
                shown += texts
                waiting.extendleft([line, *reversed(rest)])
            else:
                self._note(line)
                shown.append(line)
        return shown

    def flush(self) -> list[str]:
        """Show what is held: no other line follows, or one of another source."""
        shown: list[str] = []
        while self._held:
            texts, rest = self._release()
            shown += texts
            for line in rest:
                shown += self.add(line)
        return shown

    def pause(self) -> list[str]:
        """Show what is held unless a whole block came again, which may go on."""
        return [] if any(self._held >= n for n in self._lengths) else self.flush()

    def _going_on(self, line: str) -> list[int]:
        """The lengths of the blocks that are still repeated with this line."""
        if self._held:
            return [n for n in self._lengths if self._repeated(n, self._held) == line]
        latest_first = enumerate(reversed(self._before), 1)
        return [n for n, before in latest_first if before == line]

    def _release(self) -> tuple[list[str], list[str]]:
        """Texts to show for the first of the held lines, and the rest of them."""
        length = max(self._lengths, key=lambda n: (self._held // n * n, -n))
        times = self._held // length
        is_block = times * length >= _SHORTEST
        released = times * length if is_block else 1
        held = [self._repeated(length, place) for place in range(length)]
        rest = [self._repeated(length, i) for i in range(released, self._held)]
        if is_block:  # a later block is one that is shown, not one of its repeats
            self._before = held
        else:
            self._note(held[0])
        self._held, self._lengths = 0, []
        return [_summary(length, times)] if is_block else held[:1], rest

    def _note(self, line: str) -> None:
        self._before = [*self._before, line][-_BLOCK_MAX:]

    def _repeated(self, length: int, place: int) -> str:
        """The line at a place of the repeats of the last `length` lines."""
        return self._before[len(self._before) - length + place % length]


def _summary(length: int, times: int) -> str:
    lines = "line" if length == 1 else f"{length} lines"
    often = "once" if times == 1 else f"{times} times"
    return f"(the same {lines}, {often} more)"
