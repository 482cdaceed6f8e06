"""Requests that wait for the next change of a run, wherever it happens."""

from __future__ import annotations

import asyncio
from weakref import WeakValueDictionary

from reference_server.rules.runs.run import Run
from reference_server.runs.memory.run_events import Departure, RunFollower


class RunChange(asyncio.Event):
    """The next change of a run. is_elsewhere: it will happen on another node."""

    is_elsewhere = False

    def __init__(self, run_id: str) -> None:
        super().__init__()
        self.run_id = run_id


class RunChanges(RunFollower):
    """The next change of each run that a request waits for."""

    def __init__(self) -> None:
        # Referenced only by the requests that wait.
        self._events: WeakValueDictionary[str, RunChange] = WeakValueDictionary()

    def __len__(self) -> int:
        return len(self._events)

    def run_ids(self) -> list[str]:
        """The ids of the runs that requests wait for."""
        return list(self._events)

    def next_of(self, run_id: str) -> RunChange:
        """Take it before the run is read: then no change is missed."""
        return self._events.setdefault(run_id, RunChange(run_id))

    def changed(self, run: Run) -> None:
        self.wake(run.run_id)

    def left(self, run: Run, why: Departure) -> None:
        self.wake(run.run_id, is_elsewhere=why == "moved")

    def wake(self, run_id: str, *, is_elsewhere: bool = False) -> None:
        """The run has changed, or will do so on another node only."""
        event = self._events.pop(run_id, None)
        if event is not None:
            event.is_elsewhere = is_elsewhere
            event.set()

    def wake_all(self, *, is_elsewhere: bool = False) -> None:
        for run_id in self.run_ids():
            self.wake(run_id, is_elsewhere=is_elsewhere)
