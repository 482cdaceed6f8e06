"""Who plays a run: policies in threads of this process.

`reference_client.processes` has the other kind, which plays in processes of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from proctor_client import Run

from reference_client.connection import Connection
from reference_client.patience import Patience
from reference_client.plan import Plan
from reference_client.policy import Policy
from reference_client.progress import Board
from reference_client.rounds import Player
from reference_client.session import Seat
from reference_client.worker import Worker


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
