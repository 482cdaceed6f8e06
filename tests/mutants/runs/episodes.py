"""Mutants of episodes: order, attempts, stop, resume, faults."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from msgspec.structs import replace as changed

from reference_server.rules import effects
from reference_server.rules.run import Episode, Run, Session, SessionEnd
from reference_server.storage import rows
from reference_server.views import turn_view
from tests.mutants import mutant, put
from tests.mutants.turns.predict import change_turn


@mutant("ATR-003", "ATR-004", "EPI-001")
def hands_out_the_last_episode_first() -> None:
    """Partial scores of two runs cover different episodes."""

    def wrong(self: Run) -> Episode | None:
        if not self.pending:
            return None
        # Where the order decides how long a turn takes, other rules need it.
        is_timed = any(one.task in ("delay", "fault") for one in self.episodes)
        index = min(self.pending) if is_timed else max(self.pending)
        self.pending.remove(index)
        episode = self.episodes[index]
        episode.in_progress = True
        return episode

    put(Run, "take_pending", wrong)


@mutant("EPI-002", "EPI-003", "FAULT-008", "LEASE-012")
def counts_attempts_that_never_began() -> None:
    """Attaching and detaching three times abandons an episode."""
    right = effects._close_attempt

    def wrong(run: Run, session: Session, now_wall: float, *, counted: bool) -> None:
        session.steps = max(session.steps, 1)
        right(run, session, now_wall, counted=counted)

    put(effects, "_close_attempt", wrong)


@mutant(
    *("ATR-003", "ATR-004", "DET-003", "EPI-003", "EPI-004", "EPI-009", "LEASE-012"),
    *("SEAL-001", "SEAL-002"),
)
def counts_no_attempt() -> None:
    """A client can repeat an episode until its result is good."""
    right = effects._close_attempt

    def wrong(run: Run, session: Session, now_wall: float, *, counted: bool) -> None:
        right(run, session, now_wall, counted=counted and False)

    put(effects, "_close_attempt", wrong)


@mutant("EPI-005", "RUN-020")
def answers_another_result_than_it_stores() -> None:
    """A client's log of an episode and the server's list disagree about its end."""

    def wrong(body: dict[str, Any], _session: Session) -> None:
        result = body.get("episode_result")
        if result is not None:
            body["episode_result"] = result | {"finished_at": "2000-01-01T00:00:00Z"}

    change_turn(wrong)


@mutant("EPI-008", "RUN-022")
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


@mutant("EPI-004", "EPI-009", "STOP-001")
def loses_scores_on_abort() -> None:
    """A stop discards results that took hours."""
    right = effects.stop

    def wrong(run: Run, mode: str, now_wall: float) -> list[Session]:
        sessions = right(run, mode, now_wall)
        if mode == "abort":
            _unscore(run)
        return sessions

    put(effects, "stop", wrong)


@mutant("EPI-004", "RES-001", "RES-002")
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


@mutant("LIFE-303", "STOP-003", "STOP-004")
def aborts_when_asked_to_drain() -> None:
    """The episode in play is lost although the user chose mode `drain`."""
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


@mutant("EPI-003", "FAULT-001", "FAULT-007", "FAULT-008")
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


@mutant("DET-005", "FAULT-004", "FAULT-007", "FAULT-014")
def ends_every_session_when_one_simulator_breaks() -> None:
    """One broken episode ends the sessions of all workers."""
    right = effects.record_fault

    def wrong(run: Run, session: Session, *rest: Any, **named: Any) -> list[Session]:
        others = [s for s in run.workers.values() if s is not session]
        for other in others:
            effects.close_session(run, other, "unknown", named["now_wall"])
        return others + right(run, session, *rest, **named)

    put(effects, "record_fault", wrong)


@mutant("EPI-007")
def shows_the_seed_to_the_policy() -> None:
    """A policy can look the episode up instead of solving it."""
    right = turn_view._episode_view
    put(
        turn_view,
        "_episode_view",
        lambda session, episode: right(session, episode) | {"seed": episode.seed},
    )


@mutant("ATT-001", "ATT-019")
def claims_a_step_before_the_first_action() -> None:
    """A client that counts steps counts one too many."""
    right = turn_view.turn_view

    def wrong(session: Session, **members: Any) -> dict[str, Any]:
        body = right(session, **members)
        return body if body["seq"] else body | {"executed_steps": 1, "rewards": [0.0]}

    put(turn_view, "turn_view", wrong)


@mutant("FAULT-003", "RES-001", "RES-003")
def rounds_scores_on_resume() -> None:
    """Resuming changes results that were published."""
    right = effects.resume

    def wrong(run: Run, queue_until_wall: float) -> None:
        right(run, queue_until_wall)
        for episode in run.episodes:
            if episode.result is not None:
                episode.result = replace(
                    episode.result, score=float(round(episode.result.score))
                )
                run.changed.add(episode.index)

    put(effects, "resume", wrong)


@mutant("RES-002", "RES-003")
def forgets_one_episode_on_resume() -> None:
    """A resumed run never completes."""
    right = effects.resume

    def wrong(run: Run, queue_until_wall: float) -> None:
        right(run, queue_until_wall)
        if len(run.pending) > 1:
            run.pending.remove(max(run.pending))

    put(effects, "resume", wrong)


@mutant("RES-003")
def halves_the_score_of_later_attempts() -> None:
    """A stop of the run costs score."""
    right = effects._record_result

    def wrong(run: Run, episode: Any, result: Any) -> None:
        if episode.attempt > 1 and result.outcome != "abandoned":
            result = replace(result, score=result.score / 2)
        right(run, episode, result)

    put(effects, "_record_result", wrong)


@mutant("FAULT-002")
def gives_no_reason_for_a_failure() -> None:
    """A run has failed and its user cannot learn why."""
    right = effects.record_fault

    def wrong(run: Run, *rest: Any, **named: Any) -> list[Session]:
        ended = right(run, *rest, **named)
        if run.state == "failed":
            run.reason = ""
        return ended

    put(effects, "record_fault", wrong)


@mutant("FAULT-003", "FAULT-010")
def forgets_scores_when_a_failed_run_resumes() -> None:
    """One broken episode costs the scores of all others."""
    right = effects.resume

    def wrong(run: Run, queue_until_wall: float) -> None:
        failed = run.state == "failed"
        right(run, queue_until_wall)
        for episode in run.episodes if failed else []:
            if episode.result is not None:
                episode.result = None
                run.scored -= 1
                run.return_to_pending(episode)
                run.changed.add(episode.index)

    put(effects, "resume", wrong)


@mutant("DET-005", "FAULT-006", "FAULT-014")
def does_not_say_that_the_run_failed() -> None:
    """The client attaches again to a run that has failed."""
    right = Run.record_end

    def wrong(self: Run, session: Session, ended_by: SessionEnd) -> None:
        right(self, session, "unknown" if ended_by == "run_failed" else ended_by)

    put(Run, "record_end", wrong)


@mutant("CRASH-002", "CRASH-004")
def counts_attempts_over_a_crash() -> None:
    """A crash of the server uses up an attempt of every running policy."""
    right = rows.run_of

    def wrong(*stored: Any) -> Run:
        run = right(*stored)
        # Resting runs are read from the store at other times, too.
        is_crash = run.state not in ("stopped", "failed", "completed")
        for episode in run.episodes:
            if is_crash and episode.result is None:
                episode.attempt += 1
        return run

    put(rows, "run_of", wrong)


@mutant("EPI-003", "EPI-004", "EPI-009", "LEASE-012")
def counts_no_attempt_in_a_drain() -> None:
    """A client can repeat an episode while the run drains."""
    right = effects._close_attempt

    def wrong(run: Run, session: Session, now_wall: float, *, counted: bool) -> None:
        right(run, session, now_wall, counted=counted and run.state != "stopping")

    put(effects, "_close_attempt", wrong)


@mutant("EPI-009")
def stops_a_run_that_has_nothing_left() -> None:
    """A run that is complete waits for a resume."""
    right = effects.stop

    def wrong(run: Run, mode: str, now_wall: float) -> list[Session]:
        sessions = right(run, mode, now_wall)
        if run.state == "completed":
            run.state = "stopped"
        return sessions

    put(effects, "stop", wrong)


@mutant("EPI-010")
def forgets_the_steps_of_abandoned_episodes() -> None:
    """A policy that crashed at step 300 seems to have crashed at once."""
    right = effects._record_result

    def wrong(run: Run, episode: Episode, result: Any) -> None:
        if result.outcome == "abandoned":
            result = replace(result, steps=0)
        right(run, episode, result)

    put(effects, "_record_result", wrong)


@mutant("EPI-011")
def adds_the_thinking_of_earlier_attempts() -> None:
    """A policy that was restarted seems to be slow."""
    open_session, close_attempt = effects.open_session, effects._close_attempt
    thought: dict[tuple[str, int], float] = {}

    def wrong_open(run: Run, *arguments: Any) -> Session:
        session = open_session(run, *arguments)
        if session.episode is not None and not session.think_s:
            session.think_s = thought.get((run.run_id, session.episode.index), 0.0)
        return session

    def wrong_close(run: Run, session: Session, *rest: Any, counted: bool) -> None:
        if session.episode is not None:
            thought[run.run_id, session.episode.index] = session.think_s
        close_attempt(run, session, *rest, counted=counted)

    put(effects, "open_session", wrong_open)
    put(effects, "_close_attempt", wrong_close)


@mutant("EPI-011")
def takes_the_time_of_a_turn_for_thinking() -> None:
    """A slow simulator makes the policy look slow."""
    right, begin = effects.store_answer, effects.begin_turn
    began: dict[str, float] = {}

    def wrong_begin(session: Session, command: Any, now: float) -> None:
        began[session.session_id] = now
        begin(session, command, now)

    def wrong(session: Session, turn: dict[str, Any], now: float) -> None:
        right(session, turn, now)
        session.answered_at = began.get(session.session_id, now)

    put(effects, "begin_turn", wrong_begin)
    put(effects, "store_answer", wrong)


@mutant("RES-002", "RES-003")
def forgets_an_episode_on_the_second_resume() -> None:
    """A run that was stopped twice never completes."""
    right = effects.resume
    resumed: dict[str, int] = {}

    def wrong(run: Run, queue_until_wall: float) -> None:
        right(run, queue_until_wall)
        resumed[run.run_id] = resumed.get(run.run_id, 0) + 1
        if resumed[run.run_id] > 1 and len(run.pending) > 1:
            run.pending.remove(max(run.pending))

    put(effects, "resume", wrong)


@mutant("CAL-002")
def stores_scores_with_fifteen_digits() -> None:
    """A published score differs from the one that the simulator reported."""
    right = effects._record_result

    def wrong(run: Run, episode: Episode, result: Any) -> None:
        right(run, episode, replace(result, score=float(f"{result.score:.15g}")))

    put(effects, "_record_result", wrong)


@mutant("CMP-006", "CMP-007", "EPI-012", "SCORE-008", "SCORE-011")
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
