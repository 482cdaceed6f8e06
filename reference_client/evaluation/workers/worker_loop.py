"""The loop of one worker: attach, observe, act, until no episode is left.

Runs in a thread of the evaluation (worker_pool.py) or in a process of its own
(worker_main.py).
"""

from __future__ import annotations

import time
from dataclasses import replace
from functools import partial

from proctor_client import Assumptions

from reference_client.api.action_layout import ActionLayout, ClipCount
from reference_client.api.observation import observation_of
from reference_client.api.policy import Policy, WireAction, chunk_of, expected_action
from reference_client.errors import ProctorError
from reference_client.evaluation.status_board import StatusBoard, TurnSnapshot
from reference_client.generated.messages import Fault, Turn
from reference_client.policies.error_origin import (
    describe_policy_error,
    policy_failure,
)
from reference_client.policies.servers.server_transport import reporting_repeats
from reference_client.protocol.heartbeat import HeartbeatThread
from reference_client.protocol.retry_policy import Interrupted, RetryPolicy
from reference_client.protocol.worker_session import Session, WorkerSlot, is_wanted

# Limit of consecutive sessions that end before their first turn: attaching again does
# not help then.
EMPTY_SESSIONS_MAX = 8


class WorkerLoop:
    """Plays episodes of a run with its own instance of the policy.

    board: receives what the worker waits for, its turns, and every scored episode.
    takeover: the first attach supersedes an existing session of this worker. layout:
    the action space, if every action has the same shape. episodes: how many of the
    manifest's episodes are played, from its first; None is all.
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
        layout: ActionLayout | None = None,
        episodes: int | None = None,
    ) -> None:
        self.worker_id = slot.worker_id
        self._slot = slot
        self._policy = policy
        self._retry_policy = replace(
            retry_policy.at_endpoint(slot.data.endpoint),
            report_waiting=board.waiting_reporter(slot.worker_id),
        )
        self._board = board
        self._takeover = takeover
        self._assumes = assumes
        self._layout = layout
        self._episodes = episodes
        self._clips = ClipCount()  # of the episode in play
        self._session: Session | None = None
        self._why_stopped = ""

    def play(self) -> None:
        """Returns when no episode is left, or the state of the run forbids attaching.

        A session that ends early (lease expired, server restarted) is replaced by
        another. Raises ProctorError, Interrupted, and whatever the policy raises; then
        the session is left to its lease if its end would cost an attempt.
        """
        empty_sessions = 0
        while True:
            reason = ""
            try:
                session = self._attach()
            except ProctorError as error:
                if error.code == "illegal_transition" or _has_ended_run(error):
                    return  # queued, ended or stopped: rounds.py reads the state
                raise
            try:
                self._play(session)
            except ProctorError as error:
                reason = describe_policy_error(error)
                empty_sessions = 0 if session.turn.seq > 0 else empty_sessions + 1
                if error.code == "session_ended" and (lost := session.lost(error)):
                    self._board.on_lost(lost)
                if (
                    error.code != "session_ended"
                    or empty_sessions == EMPTY_SESSIONS_MAX
                ):
                    raise
            except Interrupted:
                raise
            except BaseException as error:
                reason = policy_failure(error).detail
                raise
            else:
                return
            finally:
                self._board.end(self.worker_id)
                self.leave_session(reason)
            self._retry_policy.pause(0.05 * (2**empty_sessions - 1))

    def request_stop(self, why: str = "") -> None:
        """Keep the reason: the event `stop` of the retry policy ends every wait."""
        self._why_stopped = self._why_stopped or why

    def end_session(self) -> None:
        """End a session that was left: the evaluation goes on without this worker."""
        if self._session is not None:
            self._session.end()
            self._board.on_ended(self.worker_id)

    def leave_session(self, reason: str = "") -> None:
        """Give up the session; also called by a thread that does not wait for `play`.

        The board receives an episode that waits for the end of the lease. reason: what
        has ended the worker, where it was not stopped.
        """
        reason = reason or self._why_stopped
        left = None if self._session is None else self._session.leave(reason)
        if left is not None:
            self._board.on_left(left)

    def _attach(self) -> Session:
        self._board.begin(self.worker_id, "the first turn of an episode")
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
        self._report_fault(turn)
        is_new = (
            True  # after a takeover, the episode continues with a new policy object
        )
        report_repeat = self._board.repeat_reporter(self.worker_id)
        begin = partial(self._board.begin, self.worker_id)
        with HeartbeatThread(
            turn.lease.idle_timeout_s, session.send_heartbeat
        ) as heartbeat:
            while not turn.done and is_wanted(turn, self._episodes):
                self._board.begin(self.worker_id, "the policy, which computes actions")
                began_at = time.perf_counter()
                episode = turn.episode
                asks_for = episode and f"step {episode.step} of {episode.episode_id}"
                reporting = reporting_repeats(report_repeat, begin, asks_for or "")
                with heartbeat.keep_alive(), reporting:
                    observation = observation_of(turn)
                    if is_new or observation.step == 0:
                        self._policy.reset(observation.instruction)
                    is_new = False
                    actions = chunk_of(self._policy.act(observation), self._layout)
                thought_at = time.perf_counter()
                self._board.begin(self.worker_id, f"the answer to turn {turn.seq + 1}")
                turn = self._predict(session, actions)
                self._board.on_turn(
                    TurnSnapshot(
                        self.worker_id,
                        observation,
                        turn,
                        think_s=thought_at - began_at,
                        turn_s=time.perf_counter() - thought_at,
                        actions=actions,
                    )
                )
                self._report_fault(turn)
                self._count_clips(actions, turn)
                if turn.episode_result:
                    self._board.on_scored()

    def _predict(self, session: Session, actions: list[WireAction]) -> Turn:
        try:
            return session.predict(actions)
        except ProctorError as error:
            if error.code == "invalid_request" and self._layout is not None:
                raise error.explained(expected_action(self._layout)) from error
            raise

    def _report_fault(self, turn: Turn) -> None:
        if turn.fault:
            self._board.on_fault(turn.fault.episode_id, _why_again(turn.fault))

    def _count_clips(self, actions: list[WireAction], turn: Turn) -> None:
        """Count what the server clips of the executed actions; report at the end."""
        layout, count = self._layout, self._clips
        if layout is None:
            return
        for action in actions[: turn.executed_steps]:
            count.add_action(layout.clipped_names(action["values"]))
        if turn.fault:
            self._clips = ClipCount()
        elif turn.episode_result:
            self._clips = ClipCount()
            name = turn.episode_result.episode_id
            warning = _clip_warning(name, count, layout) if count.is_most else None
            self._board.on_clips(count, warning)


def _clip_warning(episode_id: str, count: ClipCount, layout: ActionLayout) -> str:
    ranges = ", ".join(f"{name} {layout.range_of(name)}" for name in count.numbers)
    return (
        f"warning: {episode_id}: {count.describe()}. Declared: {ranges}. Check for "
        "degrees in place of radians, and for outputs that are still normalised."
    )


def _why_again(fault: Fault) -> str:
    """The reason why an episode began again."""
    is_void = fault.is_void is True
    return fault.detail if is_void else f"the simulator broke: {fault.detail}"


def _has_ended_run(error: ProctorError) -> bool:
    """Whether the session has ended, while its episode began, with its run."""
    ended_by = error.problem.ended_by if error.problem else None
    return error.code == "session_ended" and ended_by in ("run_failed", "run_stopped")
