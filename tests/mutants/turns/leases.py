"""Mutants of leases: what extends them, and what their end does."""

from __future__ import annotations

import time
from typing import Any

from reference_server.rules.refusal import Refused
from reference_server.rules.runs import effects, lifecycle
from reference_server.rules.runs.lifecycle import (
    Attach,
    Refuse,
)
from reference_server.rules.runs.run import Run, Session
from reference_server.runs.sessions import session_resources
from reference_server.runs.sessions.session_executor import SessionExecutor
from reference_server.runs.sessions.session_resources import (
    ResourceManager,
    SessionResources,
)
from tests.mutants import Json, instead_of, mutant, put
from tests.mutants.server_changes import (
    instead_of_guard,
)


def replace_lease_over(wrong: Any) -> None:
    """Let every part of the server judge by `wrong` whether a lease has ended."""
    for module in (lifecycle, effects, session_resources):
        put(module, "lease_over", wrong)


@mutant(*("EPI-009", "LEASE-001", "LEASE-011", "LEASE-012"), through=replace_lease_over)
def never_ends_a_lease(_session: Session, _now: float) -> bool:
    """A crashed client keeps its session for ever."""
    return False


@mutant(
    *("LEASE-002", "LEASE-003", "LEASE-004", "LEASE-010"), through=replace_lease_over
)
def ends_leases_early(session: Session, now: float) -> bool:
    """A policy that thinks for longer than half its lease loses its episode."""
    over_at = session.expires_at - session.idle_timeout_s / 2
    return not session.busy and now > over_at


@mutant("LEASE-005", through=replace_lease_over)
def counts_its_own_time_against_the_lease(session: Session, now: float) -> bool:
    """A slow simulator ends the session of the policy that waits for it."""
    return now > session.expires_at


@mutant("LEASE-013", through=instead_of(SessionExecutor, "heartbeat"))
def refuses_heartbeats_of_a_done_session(
    right: Any, self: SessionExecutor, run: Run, command: Any
) -> Any:
    """A client that lost its last turn cannot keep it until it has read it."""
    session = run.workers.get(command.worker_id)
    if session is not None and session.done:
        raise Refused("no_episode", "No episode is left for this session.")
    return right(self, run, command)


@mutant("LEASE-003", "LEASE-009", through=instead_of(SessionExecutor, "heartbeat"))
def accepts_heartbeats_without_extending_the_lease(
    _right: Any, self: SessionExecutor, run: Run, command: Any
) -> Any:
    """A slow policy loses its episode although it sent heartbeats."""
    self.sweep(run)
    verdict = lifecycle.decide(run, command, time.monotonic())
    if isinstance(verdict, Refuse):
        raise Refused.from_verdict(verdict)
    return run.workers[command.worker_id]


@mutant("LEASE-004", "LEASE-009", through=instead_of(effects, "store_answer"))
def lets_the_lease_run_from_attach(
    right: Any, session: Session, turn: Json, now: float
) -> None:
    """An active policy loses its session."""
    before = session.expires_at
    right(session, turn, now)
    # Time spent executing is still not counted: that is another rule.
    if session.seq > 0 and now < before:
        session.expires_at = before


@mutant("LEASE-010", through=instead_of(SessionExecutor, "_replay_turn"))
def lets_the_lease_run_through_repeats(
    _right: Any, _self: SessionExecutor, session: Session
) -> Any:
    """A client behind a bad line is answered, and loses its session all the same."""
    assert session.turn is not None
    return session.turn


@mutant("LEASE-008", through=instead_of_guard(lifecycle._expected_seq))
def extends_the_lease_on_refused_requests(
    right: Any, run: Run, command: Any, now: float
) -> Any:
    """A client in an endless loop of errors keeps its session."""
    verdict = right(run, command, now)
    if isinstance(verdict, Refuse):
        effects.extend_lease(run.workers[command.worker_id], now)
    return verdict


@mutant("LEASE-006", through=instead_of_guard(lifecycle._below_worker_limit))
def keeps_the_slot_when_the_lease_ends(
    right: Any, run: Run, command: Attach, now: float
) -> Any:
    """A crashed client blocks the only session of its run for ever."""
    expired = sum(reason == "lease_ended" for reason in run.ended.values())
    run.max_workers -= expired
    try:
        return right(run, command, now)
    finally:
        run.max_workers += expired


@mutant("LEASE-011", through=instead_of(ResourceManager, "_schedule_lease_check"))
def looks_at_leases_only_when_asked(
    _right: Any, _self: ResourceManager, _resources: SessionResources
) -> None:
    """A client that waits for a run does not learn that its policy is gone."""
