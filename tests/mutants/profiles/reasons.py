"""Mutants of the profile `reasons`: why an episode was left, a run stopped."""

from __future__ import annotations

from typing import Any

from reference_server.rules.runs import effects
from reference_server.rules.runs.run import Run, Session
from tests.mutants import instead_of, mutant


@mutant("RSN-001", "RSN-003", through=instead_of(effects, "_close_attempt"))
def forgets_why_an_attempt_was_closed(
    right: Any, run: Run, session: Session, *rest: Any, **counted: Any
) -> Any:
    """The page of an abandoned run says no more than that a lease has expired."""
    if session.episode is not None:
        session.episode.last_left = None
        run.changed.add(session.episode.index)
    return right(run, session, *rest, **counted)


@mutant("RSN-001", "RSN-002", "RSN-003", through=instead_of(effects, "note_reason"))
def counts_an_attempt_whose_worker_has_given_a_reason(
    right: Any, run: Run, session: Session, reason: str | None
) -> Any:
    """A worker that says why it waits loses an attempt."""
    if reason is not None and session.episode is not None:
        session.episode.attempt += 1
    return right(run, session, reason)


@mutant("RSN-003", through=instead_of(effects, "note_reason"))
def keeps_reasons_in_memory(
    right: Any, run: Run, session: Session, reason: str | None
) -> Any:
    """The reasons of a night are gone when the host restarts its server."""
    if right(run, session, reason) and session.episode is not None:
        run.changed.discard(session.episode.index)
    return False


@mutant("RSN-004", through=instead_of(effects, "stop"))
def hides_why_a_run_was_stopped(
    right: Any, run: Run, mode: str, now_wall: float, *_by_and_reason: Any
) -> Any:
    """A run that its host has ended says that its submitter stopped it."""
    return right(run, mode, now_wall)


@mutant("RSN-004", through=instead_of(effects, "_after_session_end"))
def forgets_the_reason_after_a_drain(right: Any, run: Run) -> None:
    """The reason is there while the last episode is played, and then gone."""
    right(run)
    if run.state == "stopped":
        run.reason = None
