"""The runs that wait in the queue: their order, and the place of each (RUN-008).

It holds ids and numbers, not runs: thousands may wait, none in memory. In a cluster it
knows the numbers of those that wait at other nodes, too. It decides nothing.
"""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Iterable

from reference_server.rules.capacity import WaitingRun


class RunQueue:
    """Runs of this server by id, and the numbers of those of other nodes."""

    def __init__(self) -> None:
        self._number_of: dict[str, int] = {}
        self._numbers: list[int] = []  # the same ones, the next one first
        self._queued_at: dict[int, float] = {}  # wall time, by the same numbers
        self._elsewhere: list[int] = []  # the next one first

    def __contains__(self, run_id: str) -> bool:
        return run_id in self._number_of

    def __len__(self) -> int:
        """The number of runs that wait at this node."""
        return len(self._number_of)

    def ids(self) -> list[str]:
        """The ids of the runs that wait here."""
        return list(self._number_of)

    def put(self, run: WaitingRun) -> None:
        """A run that was not there waits."""
        self._number_of[run.run_id] = run.number
        insort(self._numbers, run.number)
        self._queued_at[run.number] = run.updated_at_wall
        self._remove_elsewhere(run.number)

    def remove(self, run_id: str) -> None:
        """A run that was there waits no more."""
        number = self._number_of.pop(run_id)
        del self._numbers[bisect_left(self._numbers, number)]
        del self._queued_at[number]

    def clear(self) -> None:
        self._number_of.clear()
        self._numbers.clear()
        self._queued_at.clear()
        self._elsewhere.clear()

    def is_behind(self, run_id: str, number: int) -> bool:
        """Whether the run waits here, behind the one with that number."""
        return self._number_of.get(run_id, 0) > number

    def position(self, number: int) -> int:
        """1 is next."""
        here, elsewhere = (
            bisect_left(numbers, number) for numbers in (self._numbers, self._elsewhere)
        )
        return 1 + here + elsewhere

    def oldest_queued_at_wall(self) -> float | None:
        """The time since which the first run waits; None without one."""
        return self._queued_at[self._numbers[0]] if self._numbers else None

    def note_elsewhere(self, numbers: Iterable[int]) -> int | None:
        """Replace the runs of other nodes; returns the first number that changed."""
        before = self._elsewhere
        here = self._queued_at
        self._elsewhere = sorted(number for number in numbers if number not in here)
        return min(set(before) ^ set(self._elsewhere), default=None)

    def _remove_elsewhere(self, number: int) -> None:
        at = bisect_left(self._elsewhere, number)
        if self._elsewhere[at : at + 1] == [number]:
            del self._elsewhere[at]
