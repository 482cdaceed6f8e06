"""How far an export is: a bar on a terminal, a line every ten seconds elsewhere."""

from __future__ import annotations

import time
from typing import Self

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
from rich.progress import Progress as Bars

from reference_sim.exports.job import printable

LOG_S = 10.0


class ProgressBar:
    """Counts steps on the standard error. A context manager."""

    def __init__(self, what: str) -> None:
        self._what, self._total, self._done = what, 0, 0
        self._console = Console(stderr=True, highlight=False, markup=False)
        self._logged_at = time.monotonic()
        self._bars: Bars | None = None
        if self._console.is_terminal:
            columns = TextColumn("{task.description}"), BarColumn(bar_width=None)
            left = MofNCompleteColumn(), TimeRemainingColumn()
            self._bars = Bars(*columns, *left, console=self._console)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._bars is not None:
            self._bars.stop()

    def begin(self, steps: int) -> None:
        """Show the bar. steps: how many there will be."""
        self._total = steps
        if self._bars is not None and steps:
            self._bars.start()
            self._task = self._bars.add_task(self._what, total=steps)

    def advance(self) -> None:
        self._done += 1
        if self._bars is not None:
            self._bars.update(self._task, completed=self._done)
        elif time.monotonic() - self._logged_at > LOG_S:
            self._logged_at = time.monotonic()
            self.say(f"{self._what}: {self._done} of {self._total} steps")

    def say(self, line: str) -> None:
        self._console.print(f"proctor: {printable(line)}", soft_wrap=True)
