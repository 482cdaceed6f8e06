"""The workers of a run as threads of this process.

`worker_processes.py` runs each worker in a process of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from proctor_client import Run

from reference_client.api.policy import Policy
from reference_client.evaluation.plan import Plan
from reference_client.evaluation.rounds import Player
from reference_client.evaluation.status_board import Board
from reference_client.evaluation.worker_thread import Worker
from reference_client.protocol.connection import Connection
from reference_client.protocol.retry_policy import Patience
from reference_client.protocol.worker_session import Seat


@dataclass(frozen=True, slots=True)
class Engagement:
    """The run that is to be played, and what its players need."""

    plan: Plan
    run: Run
    connection: Connection
    patience: Patience
    board: Board

    def seat(self, worker_id: str) -> Seat:
        return Seat(self.connection.data(self.run.endpoint), self.run, worker_id)


class Staff(Protocol):
    """Makes one player for each worker; `dismiss` is called whatever happens."""

    def prepare(self, worker_ids: Sequence[str]) -> None:
        """Load the policies, before there is a run. Raises what they raise."""

    def players(self, engagement: Engagement) -> list[Player]:
        """One for each worker that was prepared."""

    def dismiss(self) -> None:
        """Free what is left of them."""


class Threads:
    """Each worker has an instance of the policy, all of them in this process."""

    def __init__(self, make: Callable[[], Policy]) -> None:
        self._make = make
        self._policies: list[Policy] = []
        self._worker_ids: Sequence[str] = ()

    def prepare(self, worker_ids: Sequence[str]) -> None:
        self._worker_ids = worker_ids
        self._policies = [self._make() for _ in worker_ids]

    def players(self, engagement: Engagement) -> list[Player]:
        plan = engagement.plan
        return [
            Worker(
                engagement.seat(worker_id),
                policy,
                engagement.patience,
                engagement.board,
                takeover=plan.takeover,
                assumes=plan.assumes,
            )
            for worker_id, policy in zip(self._worker_ids, self._policies, strict=True)
        ]

    def dismiss(self) -> None:
        """Threads end with their sessions."""
