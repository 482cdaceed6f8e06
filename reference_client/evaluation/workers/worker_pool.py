"""The workers of a run as threads of this process.

`worker_processes.py` runs each worker in a process of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from proctor_client import Player, Run, Service

from reference_client.api.action_layout import ActionLayout
from reference_client.api.policy import Policy
from reference_client.evaluation.dry_turn import play_dry_turn
from reference_client.evaluation.parameters import EvaluationPlan
from reference_client.evaluation.rounds import RunWorker
from reference_client.evaluation.status_board import StatusBoard
from reference_client.evaluation.workers.worker_loop import WorkerLoop
from reference_client.policies.policy_loader import close_policy
from reference_client.protocol.connection import Connection
from reference_client.protocol.retry_policy import RetryPolicy
from reference_client.protocol.worker_session import WorkerSlot
from reference_record.generated import answers


@dataclass(frozen=True, slots=True)
class EvaluationContext:
    """The run to play, and what its workers need.

    benchmark: as JSON; None if the server does not have it any more.
    player: what the workers declare, where the server reads it.
    """

    plan: EvaluationPlan
    run: Run
    service: Service
    connection: Connection
    retry_policy: RetryPolicy
    board: StatusBoard
    benchmark: answers.Benchmark | None
    player: Player | None

    @property
    def layout(self) -> ActionLayout | None:
        if self.benchmark is None:
            return None
        return ActionLayout.of(self.run.benchmark_id, self.benchmark["action_space"])

    def slot(self, worker_id: str) -> WorkerSlot:
        data = self.connection.data(self.run.endpoint)
        return WorkerSlot.at_service(
            data,
            self.run,
            worker_id,
            self.service,
            player=self.player,
            episodes=self.plan.episodes,
        )


class WorkerPool(Protocol):
    """Makes the workers of an evaluation; `close` is always called."""

    def prepare(self, worker_ids: Sequence[str]) -> None:
        """Load the policies, before the run is created. Raises what they raise."""

    def play_dry_turn(self, benchmark: answers.Benchmark) -> str | None:
        """Call one policy once, before the run is created. Raises what is wrong.

        Returns why that could not be tried to its end, if so.
        """

    def make_workers(self, context: EvaluationContext) -> list[RunWorker]:
        """Make one worker for each id that was given to `prepare`."""

    def close(self) -> None:
        """Release the resources of the workers."""


class ThreadWorkerPool:
    """Each worker has its own instance of the policy, all in this process."""

    def __init__(self, make: Callable[[], Policy]) -> None:
        self._make = make
        self._policies: list[Policy] = []
        self._worker_ids: Sequence[str] = ()

    def prepare(self, worker_ids: Sequence[str]) -> None:
        self._worker_ids = worker_ids
        self._policies = [self._make() for _ in worker_ids]

    def play_dry_turn(self, benchmark: answers.Benchmark) -> str | None:
        return play_dry_turn(self._policies[0], benchmark)

    def make_workers(self, context: EvaluationContext) -> list[RunWorker]:
        plan = context.plan
        return [
            WorkerLoop(
                context.slot(worker_id),
                policy,
                context.retry_policy,
                context.board,
                takeover=plan.takeover,
                assumes=plan.assumes,
                layout=context.layout,
                episodes=plan.episodes,
            )
            for worker_id, policy in zip(self._worker_ids, self._policies, strict=True)
        ]

    def close(self) -> None:
        """Threads end with their sessions; connections to policy servers are closed."""
        for policy in self._policies:
            close_policy(policy)
