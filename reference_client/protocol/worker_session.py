"""A session of a worker: from attach to its end.

A session that ends in the middle of an episode costs an attempt once an action was
executed. So an interrupted evaluation leaves such a session to its lease: a takeover
within the lease continues the episode at its step.

A lost response is harmless: the request is repeated unchanged, with its attach_key or
seq, and the server repeats the response without executing the request again.
"""

from __future__ import annotations

import threading
import uuid
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from proctor_client import Assumptions, AttachWorker, Heartbeat, Observe, Player, Run

from reference_client.api.policy import WireAction
from reference_client.errors import ProctorError, from_failure
from reference_client.generated.messages import Turn
from reference_client.protocol.data_plane import DataPlane
from reference_client.protocol.retry_policy import FAILURES, Interrupted, RetryPolicy
from reference_client.protocol.silence import LostSession, SilenceMeter

# Added to the lease when waiting for a busy worker; limit of the retries of a detach,
# after which the lease ends the session.
MARGIN_S = 3.0

# The codes that mean that the session has ended.
SESSION_END_CODES = frozenset({"session_ended", "session_superseded"})


@dataclass(frozen=True, slots=True)
class WorkerSlot:
    """A worker of a run, the data plane to use, and what the worker declares.

    first_episodes: how many of the run's first episodes are wanted, so that the server
    begins no other one; None for all, and for a server that does not read it.
    """

    data: DataPlane
    run: Run
    worker_id: str
    player: Player | None = None
    first_episodes: int | None = None


@dataclass(frozen=True, slots=True)
class LeftEpisode:
    """An episode in the middle of which an evaluation has left its session.

    step: at which it waits, or later if the last request was not answered. attempt: the
    one in play. until: when the lease ends, as the server wrote it.
    """

    worker_id: str
    episode_id: str
    step: int
    attempt: int
    until: str


class Session:
    """A live session; `turn` is its latest turn.

    Methods raise ProctorError for refusals, and Interrupted.
    """

    def __init__(self, slot: WorkerSlot, retry_policy: RetryPolicy, turn: Turn) -> None:
        self._slot = slot
        self._retry_policy = retry_policy
        self._ended = False
        self._is_unanswered = False  # a predict was sent and its answer has not come
        self._until = turn.lease.expires_at
        self._silence = SilenceMeter()
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
        """Waits while the run is at its worker limit, or an earlier session lives."""
        request = AttachWorker(
            attach_key=uuid.uuid4().hex,
            # The field is unknown to a server without the profile `sessions`.
            takeover=takeover or None,
            assumes=assumes,
            player=slot.player,
            first_episodes=slot.first_episodes,
        )
        run = slot.run
        retry_policy = retry_policy.at_endpoint(run.endpoint)
        slot.data.limit_silence(run.idle_timeout_s, retry_policy.total_s)
        turn = retry_policy.call(
            lambda: slot.data.attach_worker(run.run_id, slot.worker_id, request),
            limits_s={"worker_busy": run.idle_timeout_s + MARGIN_S},
        )
        return cls(slot, retry_policy, turn)

    def predict(
        self, actions: Sequence[WireAction], *, observe: Observe | None = None
    ) -> Turn:
        """Execute a chunk exactly once; returns the turn.

        observe: `all` for an observation after each step, including the last.
        """
        slot, before = self._slot, self.turn

        def send() -> Turn:
            self._is_unanswered = True
            return slot.data.predict(
                slot.run.run_id,
                slot.worker_id,
                before.session_id,
                before.seq + 1,
                actions,
                observe=observe,
            )

        self._silence.sent()
        try:
            self.turn = self._retry_policy.call(send)
        except ProctorError as error:
            self._ended = error.code in SESSION_END_CODES
            self._is_unanswered = error.side_effects != "none"
            raise
        self._silence.answered()
        self._is_unanswered = False
        self._until = self.turn.lease.expires_at
        return self.turn

    def send_heartbeat(self) -> bool:
        """Extend the lease; returns False if the session is known to have ended.

        Not repeated: if it is lost, the next heartbeat is early enough.
        """
        if self._ended:
            return False
        slot = self._slot
        try:
            lease = slot.data.heartbeat(
                slot.run.run_id,
                slot.worker_id,
                Heartbeat(session_id=self.turn.session_id),
                _request_timeout=max(1.0, self.turn.lease.idle_timeout_s / 6),
            )
        except FAILURES as failure:
            error = from_failure(failure, self._retry_policy.url)
            if error.code in SESSION_END_CODES:
                return False
            self._silence.failed()
            return True
        self._silence.answered()
        self._until = lease.expires_at.isoformat()
        return True

    def lost(self, error: ProctorError) -> LostSession | None:
        """How this worker has lost the session by its silence; None if it has not.

        error: the refusal `session_ended`. A server that no longer knows the reason is
        believed to have ended the lease if that has passed.
        """
        ended_by = error.problem.ended_by if error.problem else None
        episode, lease_s = self.turn.episode, self.turn.lease.idle_timeout_s
        silence = self._silence.silence(lease_s)
        is_known = ended_by == "lease_ended"
        is_likely = ended_by in (None, "unknown") and silence[0] > lease_s
        if not episode or not (is_known or is_likely):
            return None
        return LostSession(
            self._slot.worker_id,
            episode.episode_id,
            episode.step,
            episode.attempt,
            lease_s,
            *silence,
        )

    def detach(self) -> None:
        """End the session. Never raises; does nothing if the session has ended.

        May be called by any thread, and when the evaluation is interrupted.
        """
        if self._ended:
            return
        self._ended = True
        detach(self._slot, self._retry_policy.url, self.turn.session_id)

    def end(self) -> None:
        """End the session also if it was left to its lease; never raises."""
        self._ended = True
        detach(self._slot, self._retry_policy.url, self.turn.session_id)

    def leave(self) -> LeftEpisode | None:
        """Give the session up without the loss of an attempt; never raises.

        Detaches where that costs nothing: the session is done, or no action was
        executed in the attempt. Else the session is left to its lease, and the episode
        that waits is returned.
        """
        if self._ended:
            return None
        episode = self.turn.episode
        is_free = not episode or (episode.step == 0 and not self._is_unanswered)
        if self.turn.done or is_free:
            self.detach()
            return None
        self._ended = True
        assert episode
        return LeftEpisode(
            self._slot.worker_id,
            episode.episode_id,
            episode.step,
            episode.attempt,
            self._until,
        )


def detach(slot: WorkerSlot, url: str, session_id: str) -> None:
    """End a session by its id; never raises. url: of the server."""
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
