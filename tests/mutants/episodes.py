"""Mutants of episodes: order, attempts, stop, resume, faults."""

from __future__ import annotations

from typing import Any

from reference_server.rules import effects
from reference_server.rules.run import Episode, Run, Session
from tests.mutants import mutant, put
from tests.mutants.turns import change_turn


@mutant("EPI-001")
def hands_out_the_last_episode_first() -> None:
    """Partial scores of two runs cover different episodes."""

    def wrong(self: Run) -> Episode | None:
        if not self.pending:
            return None
        index = max(self.pending)
        self.pending.remove(index)
        episode = self.episodes[index]
        episode.in_progress = True
        return episode

    put(Run, "take_pending", wrong)


@mutant("EPI-002")
def counts_attempts_that_never_began() -> None:
    """Attaching and detaching three times abandons an episode."""
    right = effects._close_attempt

    def wrong(run: Run, session: Session, now_wall: float, *, counted: bool) -> None:
        session.steps = max(session.steps, 1)
        right(run, session, now_wall, counted=counted)

    put(effects, "_close_attempt", wrong)


@mutant("EPI-003", "EPI-004")
def counts_no_attempt() -> None:
    """A client can repeat an episode until its result is good."""
    right = effects._close_attempt

    def wrong(run: Run, session: Session, now_wall: float, *, counted: bool) -> None:
        right(run, session, now_wall, counted=counted and False)

    put(effects, "_close_attempt", wrong)


@mutant("EPI-005")
def answers_another_result_than_it_stores() -> None:
    """A client's log of an episode and the server's list disagree about its end."""

    def wrong(body: dict[str, Any], _session: Session) -> None:
        result = body.get("episode_result")
        if result is not None:
            body["episode_result"] = result | {"finished_at": "2000-01-01T00:00:00Z"}

    change_turn(wrong)


@mutant("EPI-008")
def gives_one_episode_to_two_workers() -> None:
    """Work is done twice and one result is thrown away."""
    right = Run.take_pending
    last: dict[str, Episode] = {}

    def wrong(self: Run) -> Episode | None:
        before = last.get(self.run_id)
        if before is not None and before.in_progress and len(self.live_sessions) == 1:
            return before
        episode = right(self)
        if episode is not None:
            last[self.run_id] = episode
        return episode

    put(Run, "take_pending", wrong)
    score = effects._record_result

    def wrong_score(run: Run, episode: Episode, result: Any) -> None:
        if episode.result is None:
            score(run, episode, result)

    put(effects, "_record_result", wrong_score)


@mutant("STOP-001")
def loses_scores_on_abort() -> None:
    """A stop discards results that took hours."""
    right = effects.stop

    def wrong(run: Run, mode: str, now_wall: float) -> list[Session]:
        sessions = right(run, mode, now_wall)
        if mode == "abort":
            _unscore(run)
        return sessions

    put(effects, "stop", wrong)


@mutant("RES-001", "RES-002")
def plays_scored_episodes_again_after_resume() -> None:
    """A resumed run repeats all its episodes, and the better result counts."""
    right = effects.resume

    def wrong(run: Run, queue_until_wall: float) -> None:
        if run.state == "stopped":
            _unscore(run)
        right(run, queue_until_wall)

    put(effects, "resume", wrong)


def _unscore(run: Run) -> None:
    for episode in run.episodes:
        if episode.result is not None:
            episode.result = None
            run.return_to_pending(episode)
            run.changed.add(episode.index)
    run.scored = 0


@mutant("STOP-003", "STOP-004", "LIFE-303")
def aborts_when_asked_to_drain() -> None:
    """The episode in play is lost although the submitter asked to finish it."""
    right = effects.stop

    def wrong(run: Run, _mode: str, now_wall: float) -> list[Session]:
        return right(run, "abort", now_wall)

    put(effects, "stop", wrong)


@mutant("STOP-004")
def hands_out_new_episodes_while_draining() -> None:
    """A drain never ends."""
    right = effects.end_turn

    def wrong(run: Run, session: Session, *arguments: Any) -> Episode | None:
        if run.state != "stopping":
            return right(run, session, *arguments)
        run.state = "running"
        try:
            return right(run, session, *arguments)
        finally:
            if run.state == "running":
                run.state = "stopping"

    put(effects, "end_turn", wrong)


@mutant("FAULT-001")
def counts_a_fault_as_an_attempt() -> None:
    """A crash of the server uses up an attempt of the policy."""
    right = effects.record_fault

    def wrong(run: Run, session: Session, *rest: Any, **named: Any) -> list[Session]:
        if session.episode is not None:
            session.episode.attempt += 1
        return right(run, session, *rest, **named)

    put(effects, "record_fault", wrong)


@mutant("FAULT-005", "LIFE-605")
def calls_an_unplayable_task_retryable() -> None:
    """A broken benchmark is resumed and fails again without end."""
    right = effects.record_fault

    def wrong(run: Run, *rest: Any, **named: Any) -> list[Session]:
        sessions = right(run, *rest, **named)
        if run.state == "failed":
            run.retryable = True
        return sessions

    put(effects, "record_fault", wrong)


@mutant("FAULT-004")
def ends_every_session_when_one_simulator_breaks() -> None:
    """One broken episode ends the sessions of all workers."""
    right = effects.record_fault

    def wrong(run: Run, session: Session, *rest: Any, **named: Any) -> list[Session]:
        others = [s for s in run.workers.values() if s is not session]
        for other in others:
            effects.close_session(run, other, "unknown", named["now_wall"])
        return others + right(run, session, *rest, **named)

    put(effects, "record_fault", wrong)
