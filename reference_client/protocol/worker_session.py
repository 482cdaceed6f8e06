"""One attachment of a worker to a run, from attach to detach.

Here stands what makes a lost answer harmless: a request is repeated as it was, under
its attach_key or seq, and the server answers it once more without doing it once more.
"""

from __future__ import annotations

import threading
import uuid
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from proctor_client import Assumptions, AttachWorker, Heartbeat, Observe, Run

from reference_client.api.policy import WireAction
from reference_client.errors import ProctorError, from_failure
from reference_client.generated.messages import Turn
from reference_client.protocol.data_plane import DataPlane
from reference_client.protocol.retry_policy import FAILURES, Interrupted, RetryPolicy

# How much longer than its lease a busy worker is waited for, and how long a detach is
# tried: a lease ends what no detach reaches.
MARGIN_S = 3.0

# A session that is over, whoever ended it.
SESSION_END_CODES = frozenset({"session_ended", "session_superseded"})


@dataclass(frozen=True, slots=True)
class WorkerSlot:
    """Which worker of which run plays, and where."""

    data: DataPlane
    run: Run
    worker_id: str


class Session:
    """A live session; `turn` is its latest.

    Every method raises ProctorError as the spec's operation refuses, and Interrupted.
    """

    def __init__(self, slot: WorkerSlot, retry_policy: RetryPolicy, turn: Turn) -> None:
        self._slot = slot
        self._retry_policy = retry_policy
        self._ended = False
        self.turn = turn

    @classmethod
    def attach(
        cls,
        slot: WorkerSlot,
        retry_policy: RetryPolicy,
        *,
        takeover: bool = False,
        assumes: Assumptions | None = None,
    ) -> Self:
        """Waits while the run has all its workers, and while a former session lives."""
        request = AttachWorker(
            attach_key=uuid.uuid4().hex, takeover=takeover, assumes=assumes
        )
        run = slot.run
        turn = retry_policy.call(
            lambda: slot.data.attach_worker(run.run_id, slot.worker_id, request),
            limits_s={"worker_busy": run.idle_timeout_s + MARGIN_S},
        )
        return cls(slot, retry_policy, turn)

    def predict(
        self, actions: Sequence[WireAction], *, observe: Observe | None = None
    ) -> Turn:
        """Has a chunk executed, exactly once; returns the turn.

        observe: `all` for an observation after each step, the last of an episode too.
        """
        slot, before = self._slot, self.turn
        try:
            self.turn = self._retry_policy.call(
                lambda: slot.data.predict(
                    slot.run.run_id,
                    slot.worker_id,
                    before.session_id,
                    before.seq + 1,
                    actions,
                    observe=observe,
                )
            )
        except ProctorError as error:
            self._ended = error.code in SESSION_END_CODES
            raise
        return self.turn

    def send_heartbeat(self) -> bool:
        """Extend the lease; returns whether the session lives, as far as is known.

        Sent once: when it is lost, the next beat comes in time.
        """
        slot = self._slot
        try:
            slot.data.heartbeat(
                slot.run.run_id,
                slot.worker_id,
                Heartbeat(session_id=self.turn.session_id),
                _request_timeout=max(1.0, self.turn.lease.idle_timeout_s / 6),
            )
        except FAILURES as failure:
            return (
                from_failure(failure, self._retry_policy.url).code
                not in SESSION_END_CODES
            )
        return True

    def detach(self) -> None:
        """Free the worker's slot at once. Never raises; does nothing when it is over.

        May be called by any thread, and also when the evaluation is interrupted.
        """
        if self._ended:
            return
        self._ended = True
        detach(self._slot, self._retry_policy.url, self.turn.session_id)


def detach(slot: WorkerSlot, url: str, session_id: str) -> None:
    """End a session, whoever opened it; never raises. `url` is the server's."""
    short_retry_policy = RetryPolicy(
        url, MARGIN_S, threading.Event(), lambda _why: None
    )
    try:
        short_retry_policy.call(
            lambda: slot.data.detach_worker(
                slot.run.run_id,
                slot.worker_id,
                session_id,
                _request_timeout=MARGIN_S,
            )
        )
    except (ProctorError, Interrupted):
        return
