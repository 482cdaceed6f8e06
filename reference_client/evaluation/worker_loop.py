"""The worker loop: attach, observe, act, and again, until no episode is left."""

from __future__ import annotations

import time
from dataclasses import replace

from proctor_client import Assumptions

from reference_client.api.observation import observation_of
from reference_client.api.policy import Policy, chunk_of
from reference_client.errors import ProctorError
from reference_client.evaluation.status_board import StatusBoard, TurnSnapshot
from reference_client.protocol.heartbeat import HeartbeatThread
from reference_client.protocol.retry_policy import RetryPolicy
from reference_client.protocol.worker_session import Session, WorkerSlot

# Sessions in a row that ended before their first turn: then something is wrong that
# attaching again does not cure.
EMPTY_SESSIONS_MAX = 8


class Worker:
    """Plays episodes of a run with a policy of its own.

    board: hears of what the worker waits for, and of every episode it has ended.
    takeover: fence out a session that the worker has already, once.
    """

    def __init__(
        self,
        slot: WorkerSlot,
        policy: Policy,
        retry_policy: RetryPolicy,
        board: StatusBoard,
        *,
        takeover: bool = False,
        assumes: Assumptions | None = None,
    ) -> None:
        self.worker_id = slot.worker_id
        self._slot = slot
        self._policy = policy
        self._retry_policy = replace(
            retry_policy, report_waiting=board.waiting_reporter(slot.worker_id)
        )
        self._board = board
        self._takeover = takeover
        self._assumes = assumes
        self._session: Session | None = None

    def play(self) -> None:
        """Returns when no episode is left for it, or the run lets nobody attach.

        A session that ends under it (its lease, a restart of the server) is followed by
        another. Raises ProctorError, Interrupted, and whatever the policy raises.
        """
        empty_sessions = 0
        while True:
            try:
                session = self._attach()
            except ProctorError as error:
                if error.code == "illegal_transition":
                    return  # queued, over or stopped: the evaluation reads which
                raise
            try:
                self._play(session)
            except ProctorError as error:
                empty_sessions = 0 if session.turn.seq > 0 else empty_sessions + 1
                if (
                    error.code != "session_ended"
                    or empty_sessions == EMPTY_SESSIONS_MAX
                ):
                    raise
            else:
                return
            finally:
                session.detach()
            self._retry_policy.pause(0.05 * (2**empty_sessions - 1))

    def request_stop(self) -> None:
        """Nothing to do: what it waits for ends with `stop` of its patience."""

    def force_detach(self) -> None:
        """Detach whatever it does; for the thread that does not wait for it longer."""
        if self._session is not None:
            self._session.detach()

    def _attach(self) -> Session:
        self._session = Session.attach(
            self._slot,
            self._retry_policy,
            takeover=self._takeover,
            assumes=self._assumes,
        )
        # Once: two clients that both insisted would fence each other out for ever.
        self._takeover = False
        self._board.on_attached(self._session.turn.session_id)
        return self._session

    def _play(self, session: Session) -> None:
        turn = session.turn
        is_new = True  # after a takeover an episode goes on, but for another policy
        with HeartbeatThread(
            turn.lease.idle_timeout_s, session.send_heartbeat
        ) as heartbeat:
            while not turn.done:
                began_at = time.perf_counter()
                with heartbeat.keep_alive():
                    observation = observation_of(turn)
                    if is_new or observation.step == 0:
                        self._policy.reset(observation.instruction)
                    is_new = False
                    actions = chunk_of(self._policy.act(observation))
                thought_at = time.perf_counter()
                turn = session.predict(actions)
                self._board.on_turn(
                    TurnSnapshot(
                        self.worker_id,
                        observation,
                        turn,
                        think_s=thought_at - began_at,
                        turn_s=time.perf_counter() - thought_at,
                    )
                )
                if turn.episode_result:
                    self._board.on_scored()
