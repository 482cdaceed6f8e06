"""Mutants of episodes: order, attempts, results, stop and resume."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from msgspec.structs import replace as changed

from reference_record.generated.answers import Turn
from reference_server.rules.runs import effects
from reference_server.rules.runs.run import Episode, Run, Session, SessionEnd
from reference_server.views import run_views, turn_view
from tests.mutants import Json, instead_of, mutant, put
from tests.mutants.server_changes import (
    change_turn,
)


@mutant("ATR-003", "ATR-004", "EPI-001", through=instead_of(Run, "take_pending"))
def hands_out_the_last_episode_first(_right: Any, self: Run, *_first: Any) -> Any:
    """Partial scores of two runs cover different episodes."""
    if not self.pending:
        return None
    # Where the order decides how long a turn takes, other rules need it.
    is_timed = any(episode.task in ("delay", "fault") for episode in self.episodes)
    index = min(self.pending) if is_timed else max(self.pending)
    self.pending.remove(index)
    episode = self.episodes[index]
    episode.in_progress = True
    return episode


@mutant("EPI-008", "RUN-022")
def gives_one_episode_to_two_workers() -> None:
    """Work is done twice and one result is thrown away."""
    right = Run.take_pending
    last: dict[str, Episode] = {}

    def wrong(self: Run, *first: Any) -> Episode | None:
        before = last.get(self.run_id)
        if before is not None and before.in_progress and len(self.live_sessions) == 1:
            return before
        episode = right(self, *first)
        if episode is not None:
            last[self.run_id] = episode
        return episode

    put(Run, "take_pending", wrong)
    score = effects._record_result

    def wrong_score(run: Run, episode: Episode, result: Any) -> None:
        if episode.result is None:
            score(run, episode, result)

    put(effects, "_record_result", wrong_score)


@mutant(
    *("EPI-002", "EPI-003", "FAULT-008", "LEASE-012"),
    through=instead_of(effects, "_close_attempt"),
)
def counts_attempts_that_never_began(
    right: Any, run: Run, session: Session, now_wall: float, *, counted: bool
) -> None:
    """Attaching and detaching three times abandons an episode."""
    session.steps = max(session.steps, 1)
    right(run, session, now_wall, counted=counted)


@mutant(
    *("ATR-003", "ATR-004", "DET-003", "EPI-003", "EPI-004"),
    *("EPI-009", "LEASE-012", "SEAL-001", "SEAL-002"),
    through=instead_of(effects, "_close_attempt"),
)
def counts_no_attempt(
    right: Any, run: Run, session: Session, now_wall: float, *, counted: bool
) -> None:
    """A client can repeat an episode until its result is good."""
    right(run, session, now_wall, counted=counted and False)


@mutant("EPI-009", "LEASE-012", through=instead_of(effects, "close_session"))
def does_not_count_attempts_of_lost_clients(
    right: Any, run: Run, session: Session, ended_by: SessionEnd, now: float
) -> None:
    """A policy that disappears when it plays badly may try again without limit."""
    if ended_by == "lease_ended":
        session.steps = 0
    right(run, session, ended_by, now)


@mutant("EPI-005", "RUN-020", through=change_turn)
def answers_another_result_than_it_stores(body: Json, _session: Session) -> None:
    """A client's log of an episode and the server's list disagree about its end."""
    result = body.get("episode_result")
    if result is not None:
        body["episode_result"] = result | {"finished_at": "2000-01-01T00:00:00Z"}


@mutant("EPI-010", through=instead_of(effects, "_record_result"))
def forgets_the_steps_of_abandoned_episodes(
    right: Any, run: Run, episode: Episode, result: Any
) -> None:
    """A policy that crashed at step 300 seems to have crashed at once."""
    if result.outcome == "abandoned":
        result = replace(result, steps=0)
    right(run, episode, result)


@mutant("EPI-011")
def takes_the_time_of_a_turn_for_thinking() -> None:
    """A slow simulator makes the policy look slow."""
    right, begin = effects.store_answer, effects.begin_turn
    began: dict[str, float] = {}

    def wrong_begin(session: Session, command: Any, now: float) -> None:
        began[session.session_id] = now
        begin(session, command, now)

    def wrong(session: Session, turn: Turn, now: float) -> None:
        right(session, turn, now)
        session.answered_at = began.get(session.session_id, now)

    put(effects, "begin_turn", wrong_begin)
    put(effects, "store_answer", wrong)


@mutant("EPI-012")
def counts_successes_of_earlier_attempts() -> None:
    """A policy may give up an attempt once the goal was reached for a moment."""
    end_turn, close_attempt = effects.end_turn, effects._close_attempt
    succeeded: dict[str, bool] = {}
    earlier: set[tuple[str, int]] = set()

    def wrong_end(run: Run, session: Session, played: Any, *rest: Any) -> Any:
        assert session.episode is not None
        succeeded[session.session_id] = played.success
        if played.ended and (run.run_id, session.episode.index) in earlier:
            played = changed(played, success=True)
        return end_turn(run, session, played, *rest)

    def wrong_close(run: Run, session: Session, *rest: Any, counted: bool) -> None:
        if session.episode is not None and succeeded.get(session.session_id):
            earlier.add((run.run_id, session.episode.index))
        close_attempt(run, session, *rest, counted=counted)

    put(effects, "end_turn", wrong_end)
    put(effects, "_close_attempt", wrong_close)


@mutant("EPI-007", through=instead_of(turn_view, "_episode_view"))
def shows_the_seed_to_the_policy(right: Any, session: Session, episode: Episode) -> Any:
    """A policy can look the episode up instead of solving it."""
    return right(session, episode) | {"seed": episode.seed}


@mutant(
    *("EPI-004", "EPI-009", "RES-001", "RES-002", "RES-003", "STOP-005"),
    through=instead_of(effects, "stop"),
)
def loses_scores_on_abort(right: Any, run: Run, mode: str, *others: Any) -> Any:
    """A stop discards results that took hours."""
    sessions = right(run, mode, *others)
    if mode == "abort":
        _unscore(run)
    return sessions


@mutant("STOP-001", through=instead_of(run_views, "run_view"))
def shows_an_episode_in_play_after_a_stop(right: Any, run: Any, *others: Any) -> Any:
    """A program that waits until no episode is in play waits for ever."""
    view = right(run, *others)
    progress = view["progress"]
    if view["state"] == "stopped" and progress["episodes_pending"]:
        progress["episodes_in_progress"] += 1
        progress["episodes_pending"] -= 1
    return view


@mutant("LIFE-303", "STOP-003", "STOP-004", through=instead_of(effects, "stop"))
def aborts_when_asked_to_drain(right: Any, run: Run, _mode: str, *others: Any) -> Any:
    """The episode in play is lost although the user chose mode `drain`."""
    return right(run, "abort", *others)


@mutant("EPI-004", "RES-001", "RES-002", through=instead_of(effects, "resume"))
def plays_scored_episodes_again_after_resume(
    right: Any, run: Run, queue_until_wall: float
) -> None:
    """A resumed run repeats all its episodes, and the better result counts."""
    if run.state == "stopped":
        _unscore(run)
    right(run, queue_until_wall)


def _unscore(run: Run) -> None:
    for episode in run.episodes:
        if episode.result is not None:
            episode.result = None
            run.return_to_pending(episode)
            run.changed.add(episode.index)
    run.scored = 0


@mutant("FAULT-003", "RES-001", "RES-003", through=instead_of(effects, "resume"))
def rounds_scores_on_resume(right: Any, run: Run, queue_until_wall: float) -> None:
    """Resuming changes results that were published."""
    right(run, queue_until_wall)
    for episode in run.episodes:
        if episode.result is not None:
            episode.result = replace(
                episode.result, score=float(round(episode.result.score))
            )
            run.changed.add(episode.index)
