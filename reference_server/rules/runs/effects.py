"""Changes that an accepted command or an event makes to a run.

`lifecycle.py` decides whether a command is accepted, this file changes the run. Both
are pure: each function changes the run it is given, at the time it is given, and
nothing else. Every change of state goes through the table TRANSITIONS.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from typing import NamedTuple, Protocol

from reference_record.generated.answers import Turn
from reference_server.rules.manifest import Manifest
from reference_server.rules.runs.lifecycle import (
    PLAYABLE_STATES,
    TRANSITIONS,
    Attach,
    Event,
    Predict,
    changes_state,
    lease_over,
    legal,
    may_hand_out,
)
from reference_server.rules.runs.run import (
    Episode,
    Leaving,
    Result,
    Run,
    RunFault,
    Session,
    SessionEnd,
)

# A lease is for a client that may vanish. A worker of the server's own cannot, and its
# calls have their own bounds: this is longer than all of them together.
SERVER_LEASE_S = 86_400.0


class ChunkOutcome(Protocol):
    """The part of the simulator's reply to a chunk that the rules read.

    executed: how many of its actions. rewards: one for each of these. ended: the
    episode has ended. The others describe the episode after the last executed action.
    """

    @property
    def executed(self) -> int: ...
    @property
    def rewards(self) -> Sequence[float]: ...
    @property
    def ended(self) -> bool: ...
    @property
    def terminated(self) -> bool: ...
    @property
    def truncated(self) -> bool: ...
    @property
    def success(self) -> bool: ...
    @property
    def score(self) -> float: ...


class Expiry(NamedTuple):
    """closed: the sessions whose lease is over. freed_slot: one of them held a slot."""

    closed: list[Session]
    freed_slot: bool


def apply_event(run: Run, event: Event, reason: str | None = None) -> None:
    """Change the state as the table says; an event without a row changes nothing."""
    if not legal(run, event):
        return
    after = TRANSITIONS[(run.state, event)]
    if after != run.state:
        run.state, run.reason = after, reason
        run.retryable = run.failed_by = None


# --- commands ---


def open_session(run: Run, command: Attach, session_id: str, now: float) -> Session:
    """Take the worker's slot and an episode; the caller starts the simulator.

    A live session of the worker is fenced out and its episode goes over as it stands
    (ATT-004), but no seq and no turn (ATT-019); else the session begins with seq 0 and
    an episode of its own (ATT-001, EPI-008). The session is busy until `store_answer`
    is called.
    """
    old = run.workers.pop(command.worker_id, None)
    idle_timeout_s = SERVER_LEASE_S if command.by_server else run.idle_timeout_s
    session = Session(
        session_id=session_id,
        worker_id=command.worker_id,
        attach_key=command.attach_key,
        idle_timeout_s=idle_timeout_s,
        max_steps=run.manifest["max_steps"],
        expires_at=now + idle_timeout_s,
        busy="opening",
        max_attempts=command.max_attempts,
        first_episodes=command.first_episodes,
        player=command.player,
        attempt_player=command.player,
    )
    if old is not None and not old.done:
        session.episode, session.instruction = old.episode, old.instruction
        session.steps, session.think_s = old.steps, old.think_s
        session.clipped, session.reward = old.clipped, old.reward
        if old.attempt_player != command.player:  # ATR-003
            session.attempt_player = None
    else:
        session.episode = run.take_pending(session.first_episodes)
    session.done = session.episode is None  # ATT-012
    run.workers[command.worker_id] = session
    apply_event(run, "attach_worker")
    if session.done:
        _after_session_end(run)
    return session


def restore_session(run: Run, session: Session) -> bool:
    """Let a session go on after a restart; whether it may.

    CRASH-002: with the attempt that it had. One that had none yet gets the next
    episode. The session is busy until `store_answer` is called.
    """
    is_free = session.worker_id not in run.workers and may_hand_out(run)
    if not is_free or len(run.workers) >= run.max_workers:
        return False
    if session.episode is None:
        session.episode = run.take_pending(session.first_episodes)
        if session.episode is None:
            return False
    elif session.episode.index in run.pending:
        run.pending.remove(session.episode.index)
        heapq.heapify(run.pending)
        session.episode.in_progress = True
    else:
        return False
    run.workers[session.worker_id] = session
    apply_event(run, "attach_worker")
    return True


def mark_played(run: Run) -> bool:
    """An action is about to be executed (DEL-006); whether it is the first one."""
    is_first, run.is_played = not run.is_played, True
    return is_first


def begin_turn(session: Session, command: Predict, now: float) -> None:
    """The chunk is about to be executed; from here its seq is used up.

    EPI-011: the policy has thought since the last turn was answered.
    """
    session.seq = command.seq
    session.request = (command.actions, command.observe)
    session.turn = None
    session.busy = "playing"
    session.think_s += max(0.0, now - session.answered_at)


def end_turn(
    run: Run,
    session: Session,
    played: ChunkOutcome,
    now_wall: float,
    clipped: int = 0,
) -> Episode | None:
    """Account for an executed chunk. Returns the episode it ended, if it did.

    clipped: how many of its executed actions were clipped (ATR-004).

    Then `session.episode` is the next one, or the session is done (PRED-008, PRED-009).
    In a stopping run the episode is played to its end and scored (STOP-003).
    """
    session.busy = "turning"
    if not played.ended:
        add_executed(session, played.rewards, clipped)
        return None
    episode = _episode_of(session)
    _record_result(run, episode, result_of(session, played, now_wall, clipped))
    _forget_attempt(session)
    session.think_s = 0.0
    session.attempt_player = session.player
    # STOP-004: a stopping run hands out nothing any more.
    session.episode = (
        run.take_pending(session.first_episodes) if may_hand_out(run) else None
    )
    if session.episode is None:
        session.done = True
        _after_session_end(run)
    return episode


def add_executed(session: Session, rewards: Sequence[float], clipped: int) -> None:
    """Count executed actions of the attempt in play. rewards: one for each."""
    session.steps += len(rewards)
    session.clipped += clipped
    session.reward += sum(rewards)


def result_of(
    session: Session, played: ChunkOutcome, now_wall: float, clipped: int = 0
) -> Result:
    """The result that `end_turn` gives the session's episode, which has ended."""
    return Result(
        outcome="success" if played.success else "failure",
        score=played.score,
        attempt=_episode_of(session).attempt,
        steps=session.steps + played.executed,
        terminated=played.terminated,
        truncated=played.truncated,
        think_s=session.think_s,
        finished_at_wall=now_wall,
        player=session.attempt_player,
        clipped_actions=session.clipped + clipped,
        total_reward=session.reward + sum(played.rewards),
    )


def store_answer(session: Session, turn: Turn, now: float) -> None:
    """Store the turn for a repeated request (PRED-002); the lease starts again."""
    session.turn = turn
    session.busy = None
    session.answered_at = now
    extend_lease(session, now)


def extend_lease(session: Session, now: float) -> None:
    """LEASE-004: an answered turn extends the lease."""
    session.expires_at = now + session.idle_timeout_s


def extend_without_turn(session: Session, now: float, heartbeat_s_max: float) -> None:
    """LEASE-003, LEASE-010; LIM-006: no further than so long after the last turn.

    Never back: what an earlier answer has promised holds (LEASE-002).
    """
    turn_at = now if session.busy else session.answered_at
    until = min(now + session.idle_timeout_s, turn_at + heartbeat_s_max)
    session.expires_at = max(session.expires_at, until)


def note_reason(run: Run, session: Session, reason: str | None) -> bool:
    """RSN-001: why the worker leaves what it plays; whether that has to be stored.

    RSN-002: a text for people, which nothing else depends on.
    """
    episode = session.episode
    if reason is None or episode is None:
        return False
    left = Leaving(episode.attempt, reason)
    if left == episode.last_left:
        return False
    episode.last_left = left
    run.changed.add(episode.index)
    return True


def close_session(
    run: Run, session: Session, ended_by: SessionEnd, now_wall: float
) -> None:
    """End a session; its attempt is closed unscored (EPI-002, EPI-003, EPI-004).

    Its slot is free at once (DET-001, LEASE-006), also during a turn (DET-003).
    """
    if run.workers.get(session.worker_id) is session:
        del run.workers[session.worker_id]
    run.record_end(session, ended_by)
    _close_attempt(run, session, now_wall, counted=ended_by != "run_failed")
    if not session.done:
        session.done = True
        _after_session_end(run)


def abort_session(run: Run, session: Session, now_wall: float) -> bool:
    """End a session by no fault of its policy: no attempt is counted.

    Returns whether that has to be stored: a restart finds a run in play ready again
    (CRASH-002), so that nothing is lost if only this is not.
    """
    session.busy, session.steps = "turning", 0
    close_session(run, session, "unknown", now_wall)
    return bool(run.changed) or run.state not in PLAYABLE_STATES


def end_by_policy(run: Run, session: Session, fault: str, now_wall: float) -> None:
    """The policy that this server calls went wrong: its attempt ends (PUSH-010)."""
    episode = session.episode
    if episode is not None:
        episode.policy_fault = fault
        run.changed.add(episode.index)
    close_session(run, session, "detached", now_wall)


def fail_run(
    run: Run,
    reason: str,
    now_wall: float,
    *,
    failed_by: RunFault,
    retryable: bool = True,
) -> list[Session]:
    """The policy cannot be called (PUSH-012). Returns the sessions that ended.

    Attempts in play count, as when a client goes away.
    retryable: whether a resume can help.
    """
    sessions = list(run.workers.values())
    _end_sessions(run, sessions, "run_failed", now_wall, counted=True)
    if legal(run, "fault"):
        apply_event(run, "fault", reason)
        run.retryable, run.failed_by = retryable, failed_by
    return sessions


def expire(run: Run, now: float, now_wall: float) -> Expiry:
    """Close every session whose lease is over (LEASE-001, LEASE-012)."""
    over = [s for s in run.workers.values() if lease_over(s, now)]
    if not over:
        return Expiry(over, freed_slot=False)
    freed_slot = any(not session.done for session in over)
    for session in over:
        close_session(run, session, "lease_ended", now_wall)
    return Expiry(over, freed_slot)


def lose_sessions(run: Run) -> None:
    """A run that was just loaded has no session any more (CRASH-002)."""
    lost = "The sessions ended without a result."
    reason = lost if may_hand_out(run) else run.reason  # RSN-004
    apply_event(run, "last_lease_ends", reason)


def stop(
    run: Run,
    mode: str,
    now_wall: float,
    by: str = "its submitter",
    reason: str | None = None,
) -> list[Session]:
    """Returns the sessions that the stop ended (STOP-001, STOP-002, STOP-005).

    EPI-009: if they held the last attempts, the run has completed and is not stopped.
    RSN-004: the text that the run shows has the reason.
    """
    sessions = list(run.workers.values()) if mode == "abort" else []
    after = ", after the episodes in progress" if mode == "drain" else ""
    text = f"Stopped by {by}{after}" + (f": {reason}" if reason else ".")
    _end_sessions(run, sessions, "run_stopped", now_wall, counted=True)
    apply_event(run, "stop_abort" if mode == "abort" else "stop_drain", text)
    return sessions


def resume(run: Run, queue_until_wall: float) -> None:
    """RES-001, RES-002: back to the queue; every result stays (FAULT-003).

    PUSH-013: also when the policy server failed the run. FAULT-009: `faults` goes on
    counting. FAULT-010: what is forgiven does not count. LIFE-810: the time in the
    queue begins anew.
    """
    if not changes_state(run, "resume_run"):
        return
    for episode in run.episodes:
        if episode.result is None and episode.faults > episode.faults_forgiven:
            episode.faults_forgiven = episode.faults
            run.changed.add(episode.index)
    run.queue_until_wall = queue_until_wall
    apply_event(run, "resume_run")


# --- events ---


def record_fault(
    run: Run, session: Session, detail: str, *, unplayable: bool, now_wall: float
) -> list[Session]:
    """The simulator broke under a session.

    The episode begins again in the same attempt (FAULT-001), unless it has faulted
    `max_faults` times or can never be played: then the run fails, and the sessions
    that ended with it are returned (FAULT-002, FAULT-005, FAULT-014, FAULT-015).
    FAULT-008: what the attempt has executed is forgotten. FAULT-007: a fault that fails
    the run costs no worker an attempt.
    """
    episode = _episode_of(session)
    episode.faults += 1
    run.changed.add(episode.index)
    _forget_attempt(session)
    verb = "cannot be played"
    if not unplayable:
        # LIFE-806, LIFE-807, FAULT-010: those before the last resume do not count.
        since_resume = episode.faults - episode.faults_forgiven
        if since_resume < run.manifest["max_faults"]:
            return []
        verb = f"faulted {since_resume} times"
        if episode.faults_forgiven:
            verb += f" since its run was resumed, {episode.faults} in all"
    sessions = list(run.workers.values())
    _end_sessions(run, sessions, "run_failed", now_wall, counted=False)
    text = f"Episode {episode.episode_id} {verb}: {detail}"
    apply_event(run, "fault", text + _advice_after_fault(run.manifest))
    run.retryable, run.failed_by = not unplayable, "simulator"
    return sessions


def _advice_after_fault(manifest: Manifest) -> str:
    """A mended file makes another manifest, with which this run cannot go on."""
    if not manifest.get("simulator", {}).get("sources"):
        return ""
    return (
        ". If the cure is a change of the environment's files, restart the server and "
        "submit another run: this one goes on with the files as they were"
    )


def hold_lease(session: Session, held: bool, now: float) -> None:
    """PHY-014: the lease does not run while it is held, and begins anew after that."""
    session.held = held
    if not held:
        extend_lease(session, now)


def void_attempt(run: Run, session: Session) -> None:
    """PHY-016: what was executed counts for nothing, and the attempt begins again.

    It is one of the episode's faults, which is forgiven: it can never fail the run.
    """
    episode = _episode_of(session)
    session.busy = "turning"
    episode.faults += 1
    episode.faults_forgiven += 1
    run.changed.add(episode.index)
    _forget_attempt(session)


def admit(run: Run, now_wall: float) -> bool:
    """LIFE-801: a queued run that got a place becomes ready; whether it did.

    LIFE-810: not before its time. LIFE-811: one that was stopped is not queued.
    """
    if run.queue_until_wall > now_wall or not legal(run, "capacity"):
        return False
    apply_event(run, "capacity")
    return True


def _forget_attempt(session: Session) -> None:
    """Reset the counts of an attempt that has ended, or begins again."""
    session.steps, session.clipped, session.reward = 0, 0, 0.0


def _episode_of(session: Session) -> Episode:
    assert session.episode is not None, "a session without an episode plays nothing"
    return session.episode


def _record_result(run: Run, episode: Episode, result: Result) -> None:
    run.record_result(episode, result)
    episode.in_progress = False
    if run.scored == len(run.episodes):  # LIFE-804, LIFE-805, EPI-009
        apply_event(run, "all_scored")


def _end_sessions(
    run: Run,
    sessions: Sequence[Session],
    ended_by: SessionEnd,
    now_wall: float,
    *,
    counted: bool,
) -> None:
    """End sessions together; the state is the caller's to move."""
    for session in sessions:
        _close_attempt(run, session, now_wall, counted=counted)
        session.done = True
        run.workers.pop(session.worker_id, None)
        run.record_end(session, ended_by)


def _close_attempt(
    run: Run, session: Session, now_wall: float, *, counted: bool
) -> None:
    """EPI-012: what it has executed is forgotten with the session."""
    episode, session.episode = session.episode, None
    if episode is None or episode.result is not None:
        return
    begun = session.steps > 0 or session.busy == "playing"
    if not (counted and begun):  # EPI-002, CRASH-002, LIM-011
        run.return_to_pending(episode)
        return
    run.changed.add(episode.index)
    limit = session.max_attempts or run.manifest["max_attempts"]  # EBE-030
    if episode.attempt < limit:  # EPI-003; else EPI-004
        episode.attempt += 1
        run.return_to_pending(episode)
        return
    abandoned = Result(  # EPI-010
        outcome="abandoned",
        score=0.0,
        attempt=episode.attempt,
        steps=session.steps,
        terminated=False,
        truncated=False,
        think_s=session.think_s,
        finished_at_wall=now_wall,
        player=session.attempt_player,
        clipped_actions=session.clipped,
        total_reward=session.reward,
    )
    _record_result(run, episode, abandoned)


def _after_session_end(run: Run) -> None:
    """ATT-015: sessions that are done do not count as left."""
    if not run.live_sessions:
        # A run that goes on as ready has no reason to state; one that stops has that of
        # the drain (RSN-004).
        reason = None if may_hand_out(run) else run.reason
        apply_event(run, "last_lease_ends", reason)
