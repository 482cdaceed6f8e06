"""Mutants of faults: what they cost, how they are counted, what a turn says of them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from reference_server.rules import effects, lifecycle
from reference_server.rules.lifecycle import (
    Attach,
    Command,
    Predict,
    Refuse,
    Verdict,
    decide,
)
from reference_server.rules.run import Episode, Result, Run, Session, SessionEnd
from reference_server.runs import session_executor
from reference_server.views import run_views
from tests.mutants import mutant, put
from tests.mutants.turns.predict import change_turn, replace_guard


@mutant("FAULT-007")
def counts_attempts_when_a_fault_fails_the_run() -> None:
    """A broken simulator costs the workers beside it an attempt."""
    right = effects._end_sessions

    def wrong(run: Run, sessions: Any, *rest: Any, counted: bool) -> None:
        right(run, sessions, *rest, counted=counted or rest[0] == "run_failed")

    put(effects, "_end_sessions", wrong)


@mutant("FAULT-008")
def adds_the_steps_before_a_fault_to_the_result() -> None:
    """A result claims more steps than its attempt was allowed."""
    record_fault, record_result = effects.record_fault, effects._record_result
    lost: dict[tuple[str, int], int] = {}

    def wrong_fault(run: Run, session: Session, *rest: Any, **named: Any) -> Any:
        assert session.episode is not None
        place = run.run_id, session.episode.index
        lost[place] = lost.get(place, 0) + session.steps
        return record_fault(run, session, *rest, **named)

    def wrong_result(run: Run, episode: Episode, result: Result) -> None:
        steps = result.steps + lost.get((run.run_id, episode.index), 0)
        record_result(run, episode, replace(result, steps=steps))

    put(effects, "record_fault", wrong_fault)
    put(effects, "_record_result", wrong_result)


@mutant("FAULT-009")
def forgets_faults_on_resume() -> None:
    """A simulator that breaks again and again seems to have broken once."""
    right = effects.resume

    def wrong(run: Run, queue_until_wall: float) -> None:
        is_resumed = run.state in ("stopped", "failed")
        right(run, queue_until_wall)
        for episode in run.episodes if is_resumed else []:
            if episode.result is None and episode.faults:
                episode.faults = episode.faults_forgiven = 0
                run.changed.add(episode.index)

    put(effects, "resume", wrong)


@mutant("FAULT-010")
def counts_the_faults_of_all_episodes_together() -> None:
    """A long run fails although no episode has broken often."""
    right = effects.record_fault

    def wrong(run: Run, session: Session, *rest: Any, **named: Any) -> list[Session]:
        episode = session.episode
        assert episode is not None
        others = sum(
            e.faults - e.faults_forgiven for e in run.episodes if e is not episode
        )
        episode.faults_forgiven -= others
        try:
            return right(run, session, *rest, **named)
        finally:
            episode.faults_forgiven += others

    put(effects, "record_fault", wrong)


@mutant("FAULT-010")
def forgives_faults_when_a_session_ends() -> None:
    """An episode that always breaks is played for ever."""
    right = effects._close_attempt

    def wrong(run: Run, session: Session, now_wall: float, *, counted: bool) -> None:
        if session.episode is not None:
            session.episode.faults_forgiven = session.episode.faults
        right(run, session, now_wall, counted=counted)

    put(effects, "_close_attempt", wrong)


@mutant("FAULT-010")
def forgives_faults_on_takeover() -> None:
    """An episode that always breaks is played for ever by a client that restarts."""
    right = effects.open_session

    def wrong(run: Run, command: Attach, session_id: str, now: float) -> Session:
        is_takeover = command.worker_id in run.workers
        session = right(run, command, session_id, now)
        if is_takeover and session.episode is not None:
            session.episode.faults_forgiven = session.episode.faults
        return session

    put(effects, "open_session", wrong)


@mutant("FAULT-011")
def executes_a_turn_that_faulted_again() -> None:
    """A lost answer breaks the simulator a second time."""

    def wrong(run: Run, command: Command, now: float) -> Verdict:
        session = run.workers.get(getattr(command, "worker_id", ""))
        if (
            isinstance(command, Predict)
            and session is not None
            and command.seq == session.seq
            and "fault" in (session.turn or {})
        ):
            session.seq -= 1
        return decide(run, command, now)

    put(session_executor, "decide", wrong)


@mutant("FAULT-011")
def executes_another_body_for_a_turn_that_faulted() -> None:
    """A client with two requests on their way loses count of its turns at a fault."""
    right = lifecycle._repeated_seq

    def wrong(run: Run, command: Predict, now: float) -> Verdict | None:
        verdict = right(run, command, now)
        session = run.workers[command.worker_id]
        if isinstance(verdict, Refuse) and "fault" in (session.turn or {}):
            session.seq -= 1
            return None
        return verdict

    replace_guard(right, wrong)


@mutant("FAULT-012")
def reports_steps_of_a_chunk_that_broke() -> None:
    """A client counts steps that the episode has not taken."""

    def wrong(body: dict[str, Any], _session: Session) -> None:
        if "fault" in body:
            body.update(executed_steps=1, rewards=[0.0])

    change_turn(wrong)


@mutant("FAULT-012")
def reports_the_fault_of_a_beginning_beside_a_result() -> None:
    """A client takes the steps of an episode that was scored for lost."""

    def wrong(body: dict[str, Any], session: Session) -> None:
        ended = body.get("episode_result")
        if ended and ended["faults"] > 1 and session.episode is not None:
            fault = {"episode_id": session.episode.episode_id, "faults": 1}
            body["fault"] = fault | {"detail": "The simulator broke."}

    change_turn(wrong)


@mutant("DET-005", "FAULT-014")
def calls_a_failure_a_stop_to_other_workers() -> None:
    """A client believes that a person has stopped the run."""
    right = Run.record_end

    def wrong(self: Run, session: Session, ended_by: SessionEnd) -> None:
        is_other = ended_by == "run_failed" and session.busy is None
        right(self, session, "run_stopped" if is_other else ended_by)

    put(Run, "record_end", wrong)


@mutant("FAULT-009")
def lists_the_faults_since_the_last_resume_of_a_result() -> None:
    """A list of episodes hides how often a simulator broke."""
    right = run_views.episode_view

    def wrong(episode: Episode) -> dict[str, Any]:
        view = right(episode)
        if episode.result is not None:
            view["faults"] -= episode.faults_forgiven
        return view

    put(run_views, "episode_view", wrong)
