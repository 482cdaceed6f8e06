"""The sessions of a run that is read after the end of the process that had them.

Each is put together from the file that was written when it got its episode and from the
recording of its attempt. A benchmark that is not deterministic has none: what was
played of it cannot be played again.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from reference_record.contents.benchmark_manifest import is_deterministic
from reference_record.recordings.open_attempt import AttemptTurn, OpenAttempt
from reference_server.failover.kept_sessions import (
    EndedBefore,
    KeptSession,
    KeptSessions,
)
from reference_server.rules.runs import action_space
from reference_server.rules.runs.effects import add_executed, begin_turn
from reference_server.rules.runs.lifecycle import Predict
from reference_server.rules.runs.run import Episode, Run, Session


@dataclass(frozen=True, slots=True)
class FoundSession:
    """A session that can go on.

    session: as it was before its last turn. turn: that one, to be answered again; None
    if it has executed nothing of its episode, or has none yet. attempt: all that was
    executed of it; its number is None if it has to begin at step 0. ended: of the turn
    with which it got, or gets, its episode.
    """

    session: Session
    kept: KeptSession
    attempt: OpenAttempt
    turn: AttemptTurn | None
    ended: EndedBefore | None

    def begin_turn(self, now: float) -> Predict:
        """The command of the last turn, which is about to be executed again."""
        assert self.turn is not None, "nothing was executed"
        command = Predict(
            self.session.worker_id,
            self.session.session_id,
            self.turn.seq,
            self.turn.requested,
            "all" if self.turn.observe_all else "last",
        )
        self.session.answered_at = now - self.turn.think_ms / 1e3
        begin_turn(self.session, command, now)
        return command


def can_go_on(run: Run) -> bool:
    """Whether sessions of the run may outlive their process.

    Not those of this server's own workers, nor of a benchmark that comes to another
    state each time.
    """
    return not run.is_push and is_deterministic(run.manifest)


class KeptRecordings(Protocol):
    """The recordings of attempts in play, with the sessions that play them."""

    sessions: KeptSessions | None

    async def take_over(self, run: Run, episode: Episode) -> OpenAttempt | None:
        """The attempt in play; None if it cannot be read."""


async def find_sessions(
    run: Run, recordings: KeptRecordings, now: float
) -> list[FoundSession]:
    """The sessions of a run that was just read; none where nothing was kept."""
    if recordings.sessions is None or not can_go_on(run):
        return []
    found: list[FoundSession] = []
    for kept in await recordings.sessions.read(run):
        if _has_ended_episode(run, kept):
            found.append(_between_episodes(run, kept, now))
            continue
        if not _is_in_play(run, kept):
            continue
        attempt = await recordings.take_over(run, run.episodes[kept.index])
        if attempt is not None:
            session = _session_of(run, kept, attempt, now)
            found += [] if session is None else [session]
    # Who gets another episode must not get one that is in play.
    return sorted(found, key=lambda one: one.session.episode is None)


def _is_in_play(run: Run, kept: KeptSession) -> bool:
    """Whether its attempt has not ended since: it is the next one of the episode."""
    if not kept.index < len(run.episodes):
        return False
    episode = run.episodes[kept.index]
    return episode.result is None and episode.attempt == kept.attempt


def _has_ended_episode(run: Run, kept: KeptSession) -> bool:
    """Whether the result of its episode is stored, and was not answered yet."""
    if kept.ending is None or not kept.index < len(run.episodes):
        return False
    result = run.episodes[kept.index].result
    return result is not None and result.attempt == kept.attempt


def _between_episodes(run: Run, kept: KeptSession, now: float) -> FoundSession:
    """It gets its next episode when it is restored."""
    assert kept.ending is not None
    session = _session(run, kept, now)
    session.seq, session.request = kept.ending.seq, kept.ending.request
    session.episode, session.think_s = None, 0.0
    session.attempt_player = session.player
    return FoundSession(session, kept, OpenAttempt(), None, kept.ending.ended)


def _session(run: Run, kept: KeptSession, now: float) -> Session:
    return Session(
        session_id=kept.session_id,
        worker_id=kept.worker_id,
        attach_key=kept.attach_key,
        idle_timeout_s=run.idle_timeout_s,
        max_steps=run.manifest["max_steps"],
        expires_at=now + run.idle_timeout_s,
        episode=run.episodes[kept.index],
        seq=kept.seq,
        request=kept.request,
        busy="opening",
        max_attempts=kept.max_attempts,
        first_episodes=kept.first_episodes,
        player=kept.player,
        attempt_player=kept.attempt_player,
        think_s=kept.think_s,
        answered_at=now,
    )


def _session_of(
    run: Run, kept: KeptSession, attempt: OpenAttempt, now: float
) -> FoundSession | None:
    session = _session(run, kept, now)
    if attempt.attempt is None:  # it was about to begin, or to begin again
        return FoundSession(session, kept, OpenAttempt(), None, kept.ended)
    if attempt.attempt != kept.attempt:
        return None
    session.instruction = attempt.instruction
    last = attempt.turns[-1] if attempt.turns else None
    for turn in attempt.turns:
        is_own = session.steps >= kept.steps
        if is_own and turn.seq != session.seq + 1:
            return None
        if is_own and turn is last:
            return FoundSession(session, kept, attempt, last, kept.ended)
        clipped = action_space.clip_actions(turn.requested, run.manifest)
        clips = action_space.count_clipped(turn.requested, clipped, len(turn.rewards))
        add_executed(session, turn.rewards, clips)
        if is_own:
            session.seq = turn.seq
            session.think_s += turn.think_ms / 1e3
    return FoundSession(session, kept, attempt, None, kept.ended)
