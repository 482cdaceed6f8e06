"""Mutants of faults: what they cost, how they are counted, what a turn says of them."""

from __future__ import annotations

from typing import Any

from reference_server.rules.runs import effects
from reference_server.rules.runs.run import Episode, Run, Session, SessionEnd
from reference_server.views import run_views
from tests.mutants import Json, instead_of, mutant
from tests.mutants.server_changes import (
    change_turn,
)


@mutant(
    *("EPI-003", "FAULT-001", "FAULT-007", "FAULT-008"),
    through=instead_of(effects, "record_fault"),
)
def counts_a_fault_as_an_attempt(
    right: Any, run: Run, session: Session, *rest: Any, **named: Any
) -> Any:
    """A crash of the server uses up an attempt of the policy."""
    if session.episode is not None:
        session.episode.attempt += 1
    return right(run, session, *rest, **named)


@mutant("FAULT-007", through=instead_of(effects, "_end_sessions"))
def counts_attempts_when_a_fault_fails_the_run(
    right: Any, run: Run, sessions: Any, *rest: Any, counted: bool
) -> None:
    """A broken simulator costs the workers beside it an attempt."""
    right(run, sessions, *rest, counted=counted or rest[0] == "run_failed")


@mutant(
    *("DET-005", "FAULT-004", "FAULT-007", "FAULT-014"),
    through=instead_of(effects, "record_fault"),
)
def ends_every_session_when_one_simulator_breaks(
    right: Any, run: Run, session: Session, *rest: Any, **named: Any
) -> Any:
    """One broken episode ends the sessions of all workers."""
    bystanders = [s for s in run.workers.values() if s is not session]
    for bystander in bystanders:
        effects.close_session(run, bystander, "unknown", named["now_wall"])
    return bystanders + right(run, session, *rest, **named)


@mutant("FAULT-010", through=instead_of(effects, "record_fault"))
def counts_the_faults_of_all_episodes_together(
    right: Any, run: Run, session: Session, *rest: Any, **named: Any
) -> Any:
    """A long run fails although no episode has broken often."""
    episode = session.episode
    assert episode is not None
    faults_elsewhere = sum(
        e.faults - e.faults_forgiven for e in run.episodes if e is not episode
    )
    episode.faults_forgiven -= faults_elsewhere
    try:
        return right(run, session, *rest, **named)
    finally:
        episode.faults_forgiven += faults_elsewhere


@mutant("FAULT-005", "LIFE-605", through=instead_of(effects, "record_fault"))
def calls_an_unplayable_task_retryable(
    right: Any, run: Run, *rest: Any, **named: Any
) -> Any:
    """A broken benchmark is resumed and fails again without end."""
    sessions = right(run, *rest, **named)
    if run.state == "failed":
        run.retryable = True
    return sessions


@mutant("FAULT-002", through=instead_of(effects, "record_fault"))
def gives_no_reason_for_a_failure(
    right: Any, run: Run, *rest: Any, **named: Any
) -> Any:
    """A run has failed and its user cannot learn why."""
    ended = right(run, *rest, **named)
    if run.state == "failed":
        run.reason = ""
    return ended


@mutant("DET-005", "FAULT-006", "FAULT-014", through=instead_of(Run, "record_end"))
def does_not_say_that_the_run_failed(
    right: Any, self: Run, session: Session, ended_by: SessionEnd
) -> None:
    """The client attaches again to a run that has failed."""
    right(self, session, "unknown" if ended_by == "run_failed" else ended_by)


@mutant("FAULT-012", through=change_turn)
def reports_steps_of_a_chunk_that_broke(body: Json, _session: Session) -> None:
    """A client counts steps that the episode has not taken."""
    if "fault" in body:
        body.update(executed_steps=1, rewards=[0.0])


@mutant("FAULT-009", through=instead_of(run_views, "episode_view"))
def lists_the_faults_since_the_last_resume_of_a_result(
    right: Any, episode: Episode
) -> Any:
    """A list of episodes hides how often a simulator broke."""
    view = right(episode)
    if episode.result is not None:
        view["faults"] -= episode.faults_forgiven
    return view
