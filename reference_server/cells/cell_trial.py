"""An attempt that is to be played at a cell, from the queue to its judgement."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from reference_server.cells.cell_rules import CellState, Judgement


class RobotLink(Protocol):
    """Takes what is sent to the robot at any time."""

    def signal(self, kind: str) -> None:
        """Send `stop` or `alive` at once."""


class TrialQueue(Protocol):
    """Where a trial waits; cell_queue.py has it."""

    def remove(self, trial: CellTrial) -> None: ...
    def wait_text(self) -> str: ...


class TrialCell(Protocol):
    """Where a trial is played; robot_cell.py has it."""

    state: CellState
    trial: CellTrial | None

    def may_take(self) -> bool: ...
    def take(self, trial: CellTrial) -> None: ...
    def leave(self, trial: CellTrial, why: str) -> None: ...
    def fault(self, trial: CellTrial, why: str) -> None: ...
    def wait_text(self) -> str: ...


class TrialVoid(Exception):
    """The trial does not count, and is played again; the text is the reason."""


class TrialLeft(Exception):
    """The session of the trial has ended."""


@dataclass(eq=False, slots=True)
class CellTrial:
    """task: the setup that it needs. is_drawn: a second person judges it, too.

    hold: called with True when the lease of its session must not run, with False when
    it begins again. is_heard: whether its client still waits. queue: where it waits.
    at_cell: that took it last. voided: why it does not count. was_stopped: during its
    reset. judgement: once it is there.
    """

    run_id: str
    episode_id: str
    attempt: int
    task: str
    is_drawn: bool
    hold: Callable[[bool], None]
    is_heard: Callable[[], bool]
    queue: TrialQueue
    at_cell: TrialCell | None = None
    link: RobotLink | None = None
    voided: str = ""
    was_stopped: bool = False
    has_left: bool = False
    judgement: Judgement | None = None

    def leave(self, why: str) -> None:
        """The session has ended: stop the robot, then free the cell."""
        self.has_left = True
        self.queue.remove(self)
        if self.at_cell is not None:
            self.at_cell.leave(self, why)

    def fault(self, why: str) -> None:
        """The robot broke: stop it, then free the cell."""
        self.queue.remove(self)
        if self.at_cell is not None:
            self.at_cell.fault(self, why)

    def wait_text(self) -> str:
        """The reason why the trial waits for a person; empty if it does not."""
        if self.at_cell is not None and self.at_cell.trial is self:
            return self.at_cell.wait_text()
        return self.queue.wait_text()
