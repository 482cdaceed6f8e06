"""The worker loop: attach, observe, act, and again, until no episode is left."""

from __future__ import annotations

import time
from dataclasses import replace

from proctor_client import Assumptions

from reference_client.api.errors import ProctorError
from reference_client.api.observation import observation_of
from reference_client.api.policy import Policy, chunk_of
from reference_client.evaluation.status_board import Board, Glimpse
from reference_client.protocol.heartbeat import Heart
from reference_client.protocol.retry_policy import Patience
from reference_client.protocol.worker_session import Seat, Session

# Sessions in a row that ended before their first turn: then something is wrong that
# attaching again does not cure.
BARREN_SESSIONS_MAX = 8


class Worker:
    """Plays episodes of a run with a policy of its own.

    board: hears of what the worker waits for, and of every episode it has ended.
    takeover: fence out a session that the worker has already, once.
    """

    def __init__(
        self,
        seat: Seat,
        policy: Policy,
        patience: Patience,
        board: Board,
        *,
        takeover: bool = False,
        assumes: Assumptions | None = None,
    ) -> None:
        self.worker_id = seat.worker_id
        self._seat = seat
        self._policy = policy
        self._patience = replace(patience, tell=board.teller(seat.worker_id))
        self._board = board
        self._takeover = takeover
        self._assumes = assumes
        self._session: Session | None = None

    def play(self) -> None:
        """Returns when no episode is left for it, or the run lets nobody attach.

        A session that ends under it (its lease, a restart of the server) is followed by
        another. Raises ProctorError, Interrupted, and whatever the policy raises.
        """
        barren = 0
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
                barren = 0 if session.turn.seq > 0 else barren + 1
                if error.code != "session_ended" or barren == BARREN_SESSIONS_MAX:
                    raise
            else:
                return
            finally:
                session.detach()
            self._patience.pause(0.05 * (2**barren - 1))

    def part(self) -> None:
        """Nothing to do: what it waits for ends with `stop` of its patience."""

    def let_go(self) -> None:
        """Detach whatever it does; for the thread that does not wait for it longer."""
        if self._session is not None:
            self._session.detach()

    def _attach(self) -> Session:
        self._session = Session.attach(
            self._seat,
            self._patience,
            takeover=self._takeover,
            assumes=self._assumes,
        )
        # Once: two clients that both insisted would fence each other out for ever.
        self._takeover = False
        self._board.attached(self._session.turn.session_id)
        return self._session

    def _play(self, session: Session) -> None:
        turn = session.turn
        is_new = True  # after a takeover an episode goes on, but for another policy
        with Heart(turn.lease.idle_timeout_s, session.beat) as heart:
            while not turn.done:
                began_at = time.perf_counter()
                with heart.thinking():
                    observation = observation_of(turn)
                    if is_new or observation.step == 0:
                        self._policy.reset(observation.instruction)
                    is_new = False
                    actions = chunk_of(self._policy.act(observation))
                thought_at = time.perf_counter()
                turn = session.predict(actions)
                self._board.looked(
                    Glimpse(
                        self.worker_id,
                        observation,
                        turn,
                        think_s=thought_at - began_at,
                        turn_s=time.perf_counter() - thought_at,
                    )
                )
                if turn.episode_result:
                    self._board.scored()
