"""The trials that wait for the cells of a benchmark: one queue for all its robots."""

from __future__ import annotations

import asyncio
import contextlib
from collections import Counter
from collections.abc import Callable, Iterable

from reference_server.cells.act_log import ActLine
from reference_server.cells.cell_trial import (
    CellTrial,
    TrialCell,
    TrialLeft,
    TrialVoid,
)
from reference_server.cells.trial_order import next_run

LOOK_S = 1.0  # how often a wait looks whether the client is still there


class CellQueue:
    """cells: in the order in which a trial is offered to those that are free."""

    def __init__(
        self, benchmark_id: str, order_seed: int, acts: Iterable[ActLine]
    ) -> None:
        self.benchmark_id, self._order_seed = benchmark_id, order_seed
        self.cells: list[TrialCell] = []
        self._waiting: list[CellTrial] = []
        self._changed = asyncio.Event()
        trials = {
            (line["run"], line["cell"], line["trial"])
            for line in acts
            if "trial" in line and line.get("benchmark", line["cell"]) == benchmark_id
        }
        self.trials_by_run = Counter(run for run, _, _ in trials)

    @property
    def waiting(self) -> int:
        return len(self._waiting)

    async def take(self, trial: CellTrial) -> None:
        """Wait until a cell has taken the trial. Raises TrialLeft and TrialVoid."""
        trial.voided, trial.was_stopped, trial.judgement = "", False, None
        if trial.at_cell is None or trial.at_cell.trial is not trial:
            trial.at_cell = None
            self._waiting.append(trial)
            self.offer()
        await self.wait(lambda: trial.at_cell is not None, trial)

    def offer(self) -> None:
        """Let each cell that is free take a trial, and wake those that wait."""
        for cell in self.cells:
            if self._waiting and cell.may_take():
                cell.take(self._next())
        self._changed.set()
        self._changed = asyncio.Event()

    def _next(self) -> CellTrial:
        """PHY-020: the trials at all cells count."""
        waiting = [
            (trial.run_id, self.trials_by_run[trial.run_id]) for trial in self._waiting
        ]
        trial = self._waiting.pop(next_run(waiting, self._order_seed))
        self.trials_by_run[trial.run_id] += 1
        return trial

    def remove(self, trial: CellTrial) -> None:
        """The trial waits no longer."""
        if trial in self._waiting:
            self._waiting.remove(trial)
            self.offer()

    async def wait(self, is_so: Callable[[], bool], trial: CellTrial) -> None:
        """Wait for a change of a trial, waiting or taken."""
        while not trial.has_left and not trial.voided:
            if is_so():
                return
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(self._changed.wait(), LOOK_S)
            cell = trial.at_cell
            is_judging = cell is not None and cell.state.phase == "judging"
            is_judged = trial.judgement is not None or is_judging
            if not is_judged and not trial.is_heard():
                trial.leave("its client is away")
        if trial.voided and not trial.has_left:
            raise TrialVoid(trial.voided)
        raise TrialLeft

    def wait_text(self) -> str:
        """The reason why a trial waits for a cell."""
        before = len(self._waiting) - 1
        queue = f"; {before} others wait, too" if before > 0 else ""
        causes = Counter(_cause(cell) for cell in self.cells)
        if len(self.cells) == 1:
            return f"The robot {next(iter(causes))}{queue}."
        listed = ", ".join(f"{count} {cause}" for cause, count in causes.items())
        return f"The benchmark has {len(self.cells)} robots: {listed}{queue}."


def _cause(cell: TrialCell) -> str:
    """Why it takes no trial now."""
    if cell.state.phase == "done":
        return "waits until its operator presses Next"
    if cell.state.phase == "free" and cell.state.is_paused:
        return "is paused by its operator"
    return "is used for another attempt"
