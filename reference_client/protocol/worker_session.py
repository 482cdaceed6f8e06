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

from proctor_client import (
    Assumptions,
    AttachWorker,
    Heartbeat,
    Lease,
    Observe,
    Player,
    Run,
    Service,
)

from reference_client.api.policy import WireAction
from reference_client.errors import ProctorError, from_failure
from reference_client.generated.messages import Turn
from reference_client.printable_text import printable
from reference_client.protocol.credentials import without_secrets
from reference_client.protocol.data_plane import DataPlane
from reference_client.protocol.retry_policy import FAILURES, Interrupted, RetryPolicy
from reference_client.protocol.silence import LostSession, SilenceMeter
from reference_record.texts.shortened_text import shortened

# Added to the lease when waiting for a busy worker; limit of the retries of a detach,
# after which the lease ends the session.
MARGIN_S = 3.0

# Time to say why an episode is left, and the longest text that a server reads.
_REASON_S, _REASON_MAX = 1.0, 500

# The codes that mean that the session has ended.
SESSION_END_CODES = frozenset({"session_ended", "session_superseded"})


@dataclass(frozen=True, slots=True)
class WorkerSlot:
    """A worker of a run, the data plane to use, and what the worker declares.

    first_episodes: how many of the run's first episodes are wanted, so that the server
    begins no other one; None for all, and for a server that does not read it.
    reads_reasons: whether the server reads why an episode is left.
    """

    data: DataPlane
    run: Run
    worker_id: str
    player: Player | None = None
    first_episodes: int | None = None
    reads_reasons: bool = False

    @classmethod
    def at_service(
        cls,
        data: DataPlane,
        run: Run,
        worker_id: str,
        service: Service,
        *,
        player: Player | None,
        episodes: int | None,
    ) -> Self:
        """The slot at a server, by the profiles that it announces.

        episodes: how many of the first ones are wanted; None is all.
        """
        if episodes is not None:
            reads_episodes = "subsets" in service.profiles  # else it begins one more
            total = run.progress.episodes_total
            episodes = min(episodes, total) if reads_episodes else None
        return cls(
            data,
            run,
            worker_id,
            player,
            first_episodes=episodes,
            reads_reasons="reasons" in service.profiles,  # RSN-001
        )


def is_wanted(turn: Turn, episodes: int | None) -> bool:
    """Whether to play on: an episode that was begun is always played to its end.

    episodes: how many of the first ones are wanted; None is all.
    """
    if episodes is None or not turn.episode or turn.episode.step > 0:
        return True
    return turn.episode.index < episodes


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
        retry_policy = retry_policy.at_endpoint(slot.run.endpoint)
        slot.data.limit_silence(slot.run.idle_timeout_s, retry_policy.total_s)
        try:
            turn = _attach(slot, retry_policy, request)
        except ProctorError as error:
            if "/first_episodes" not in dict(error.errors):
                raise
            # The server is older than the field. Without it only an episode begins that
            # is not wanted.
            request.first_episodes = None
            turn = _attach(slot, retry_policy, request)
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

    def detach(self, reason: str = "") -> None:
        """End the session. Never raises; does nothing if the session has ended.

        May be called by any thread, and when the evaluation is interrupted. reason: why
        an episode is left.
        """
        if self._ended:
            return
        self._ended = True
        detach(self._slot, self._retry_policy.url, self.turn.session_id, reason)

    def end(self) -> None:
        """End the session also if it was left to its lease; never raises."""
        self._ended = True
        detach(self._slot, self._retry_policy.url, self.turn.session_id)

    def leave(self, reason: str = "") -> LeftEpisode | None:
        """Give the session up without the loss of an attempt; never raises.

        Detaches where that costs nothing: the session is done, or no action was
        executed in the attempt. Else the session is left to its lease, and the episode
        that waits is returned. reason: why, for those who look at the run.
        """
        if self._ended:
            return None
        slot, episode = self._slot, self.turn.episode
        if episode and (lease := _give_reason(slot, self.turn.session_id, reason)):
            self._until = lease.expires_at.isoformat()
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


def _give_reason(slot: WorkerSlot, session_id: str, reason: str) -> Lease | None:
    """Say why the episode in play is left; never raises. Returns the renewed lease."""
    if not (reason and slot.reads_reasons):
        return None
    line = " ".join(without_secrets(reason, slot.data.token).split())
    text = shortened(printable(line), _REASON_MAX)
    try:
        return slot.data.heartbeat(
            slot.run.run_id,
            slot.worker_id,
            Heartbeat(session_id=session_id, reason=text),
            _request_timeout=_REASON_S,
        )
    except FAILURES:
        return None


def detach(slot: WorkerSlot, url: str, session_id: str, reason: str = "") -> None:
    """End a session by its id; never raises. url: of the server. reason: why."""
    _give_reason(slot, session_id, reason)
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


def _attach(slot: WorkerSlot, retry_policy: RetryPolicy, request: AttachWorker) -> Turn:
    run = slot.run
    return retry_policy.call(
        lambda: slot.data.attach_worker(run.run_id, slot.worker_id, request),
        limits_s={"worker_busy": run.idle_timeout_s + MARGIN_S},
    )
