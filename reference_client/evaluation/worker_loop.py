"""The loop of one worker: attach, observe, act, until no episode is left.

Runs in a thread of the evaluation (worker_pool.py) or in a process of its own
(worker_main.py).
"""

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

# Limit of consecutive sessions that end before their first turn: attaching again does
# not help then.
EMPTY_SESSIONS_MAX = 8


class WorkerLoop:
    """Plays episodes of a run with its own instance of the policy.

    board: receives what the worker waits for, its turns, and every scored episode.
    takeover: the first attach supersedes an existing session of this worker.
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
        """Returns when no episode is left, or the state of the run forbids attaching.

        A session that ends early (lease expired, server restarted) is replaced by
        another. Raises ProctorError, Interrupted, and whatever the policy raises.
        """
        empty_sessions = 0
        while True:
            try:
                session = self._attach()
            except ProctorError as error:
                if error.code == "illegal_transition":
                    return  # queued, ended or stopped: rounds.py reads the state
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
        """Nothing to do: every wait ends with the event `stop` of the retry policy."""

    def force_detach(self) -> None:
        """End the session; called by the thread that no longer waits for `play`."""
        if self._session is not None:
            self._session.detach()

    def _attach(self) -> Session:
        self._session = Session.attach(
            self._slot,
            self._retry_policy,
            takeover=self._takeover,
            assumes=self._assumes,
        )
        # Once only: two clients that both take over would supersede each other forever.
        self._takeover = False
        self._board.on_attached(self._session.turn.session_id)
        return self._session

    def _play(self, session: Session) -> None:
        turn = session.turn
        is_new = (
            True  # after a takeover, the episode continues with a new policy object
        )
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
