"""Mutants of sessions: attach, detach, lease."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from reference_server.rules import action_space, effects, lifecycle
from reference_server.rules.action_space import SpaceErrors
from reference_server.rules.lifecycle import (
    GUARDS,
    Attach,
    Detach,
    Heartbeat,
    Refuse,
    Verdict,
)
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run, Session, SessionEnd
from reference_server.runs import session_resources
from reference_server.runs.session_executor import SessionExecutor
from reference_server.runs.session_resources import ResourceManager, SessionResources
from tests.mutants import mutant, put
from tests.mutants.turns import no_guard, replace_guard


@mutant("ATT-002", "ENC-002")
def opens_a_new_session_for_the_same_key() -> None:
    """After a lost answer to attach, the worker is refused until its lease ends."""
    replace_guard(lifecycle._same_attach_key, no_guard)


@mutant("ATT-003", "ATT-008")
def replaces_a_live_session_without_takeover() -> None:
    """Two clients with the same worker id throw each other out."""
    right = lifecycle._worker_is_free

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        return right(run, replace(command, takeover=True), now)

    replace_guard(right, wrong)


@mutant("ATT-004")
def restarts_the_episode_on_takeover() -> None:
    """A takeover is a second attempt: retrying for luck pays."""
    right = effects.open_session

    def wrong(run: Run, command: Attach, session_id: str, now: float) -> Session:
        old = run.workers.pop(command.worker_id, None)
        if old is not None and old.episode is not None:
            run.return_to_pending(old.episode)
        return right(run, command, session_id, now)

    put(effects, "open_session", wrong)
    open_resources = ResourceManager.open

    def wrong_open(
        self: ResourceManager, run: Run, session: Session, before: Session | None
    ) -> SessionResources:
        resources = open_resources(self, run, session, before)
        self.return_simulator(resources, kill=True)
        return resources

    put(ResourceManager, "open", wrong_open)


@mutant("ATT-005")
def goes_on_serving_a_superseded_session() -> None:
    """Two clients steer one robot."""
    right = lifecycle._session_is_live

    def wrong(run: Run, command: Any, now: float) -> Verdict | None:
        verdict = right(run, command, now)
        if isinstance(verdict, Refuse) and verdict.code == "session_superseded":
            return None
        return verdict

    replace_guard(right, wrong)
    put(lifecycle, "_session_is_live", wrong)


@mutant("ATT-006", "ATT-007")
def allows_one_worker_too_many() -> None:
    """The limit that protects the machine does not hold."""
    right = lifecycle._below_worker_limit

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        run.max_workers += 1
        try:
            return right(run, command, now)
        finally:
            run.max_workers -= 1

    replace_guard(right, wrong)


@mutant("ATT-007")
def decides_first_and_opens_later() -> None:
    """Under load more workers attach than `max_workers` allows."""
    right = SessionExecutor.attach
    strict = GUARDS[Attach]
    loose = tuple(g for g in strict if g is not lifecycle._below_worker_limit)

    async def wrong(self: SessionExecutor, run: Run, command: Attach) -> dict[str, Any]:
        verdict = lifecycle.decide(run, command, time.monotonic())
        if not isinstance(verdict, lifecycle.Accept):
            return await right(self, run, command)
        await asyncio.sleep(0.05)
        GUARDS[Attach] = loose
        attaching = asyncio.ensure_future(right(self, run, command))
        await asyncio.sleep(0)  # up to its first wait, where the session is open
        GUARDS[Attach] = strict
        return await attaching

    put(SessionExecutor, "attach", wrong)


@mutant("ATT-010")
def ignores_assumed_conventions() -> None:
    """Radians are played as degrees, and scored."""
    replace_guard(lifecycle._conventions_agree, no_guard)


@mutant("ATT-010")
def ignores_assumed_vectors_that_are_absent() -> None:
    """A policy that steers a gripper plays on an arm without one."""
    right = action_space.convention_errors

    def wrong(assumes: Mapping[str, Any], manifest: Mapping[str, Any]) -> SpaceErrors:
        errors = right(assumes, manifest)
        return [error for error in errors if "no such name" not in error[1]]

    put(action_space, "convention_errors", wrong)


@mutant("ATT-011")
def refuses_all_assumed_conventions() -> None:
    """A client that states its conventions is refused."""

    def wrong(_run: Run, command: Attach, _now: float) -> Verdict | None:
        if command.assumes is None:
            return None
        errors = (("/assumes", "no"),)
        return Refuse("convention_mismatch", "No assumptions.", errors=errors)

    replace_guard(lifecycle._conventions_agree, wrong)


@mutant("ATT-012")
def refuses_to_attach_without_pending_episodes() -> None:
    """A late worker sees an error instead of an end."""
    right = lifecycle._below_worker_limit

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        if not run.pending and not command.takeover:
            return Refuse("no_episode", "Nothing is left.")
        return right(run, command, now)

    replace_guard(right, wrong)


def _change_lease_over(wrong: Any) -> None:
    for module in (lifecycle, effects, session_resources):
        put(module, "lease_over", wrong)


@mutant("LEASE-001")
def never_ends_a_lease() -> None:
    """A crashed client keeps its session for ever."""
    _change_lease_over(lambda _session, _now: False)


@mutant("LEASE-002")
def ends_leases_early() -> None:
    """A policy that thinks for longer than half its lease loses its episode."""
    right = lifecycle.lease_over

    def wrong(session: Session, now: float) -> bool:
        return right(session, now + session.idle_timeout_s / 2)

    _change_lease_over(wrong)


@mutant("LEASE-003")
def accepts_heartbeats_without_extending_the_lease() -> None:
    """A slow policy loses its episode although it sent heartbeats."""

    def wrong(self: SessionExecutor, run: Run, command: Any) -> Session:
        self.sweep(run)
        verdict = lifecycle.decide(run, command, time.monotonic())
        if isinstance(verdict, Refuse):
            raise Refused.from_verdict(verdict)
        return run.workers[command.worker_id]

    put(SessionExecutor, "heartbeat", wrong)


@mutant("LEASE-004")
def lets_the_lease_run_from_attach() -> None:
    """An active policy loses its session."""
    right = effects.store_answer

    def wrong(session: Session, turn: dict[str, Any], now: float) -> None:
        before = session.expires_at
        right(session, turn, now)
        # Time spent executing is still not counted: that is another rule.
        if session.seq > 0 and now < before:
            session.expires_at = before

    put(effects, "store_answer", wrong)


@mutant("LEASE-005")
def counts_its_own_time_against_the_lease() -> None:
    """A slow simulator ends the session of the policy that waits for it."""

    def wrong(session: Session, now: float) -> bool:
        return now > session.expires_at

    _change_lease_over(wrong)


@mutant("LEASE-006")
def keeps_the_slot_when_the_lease_ends() -> None:
    """A crashed client blocks the only session of its run for ever."""
    right = lifecycle._below_worker_limit

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        expired = sum(reason == "lease_ended" for reason in run.ended.values())
        run.max_workers -= expired
        try:
            return right(run, command, now)
        finally:
            run.max_workers += expired

    replace_guard(right, wrong)


@mutant("LEASE-008")
def extends_the_lease_on_refused_requests() -> None:
    """A client in an endless loop of errors keeps its session."""
    right = lifecycle._expected_seq

    def wrong(run: Run, command: Any, now: float) -> Verdict | None:
        verdict = right(run, command, now)
        if isinstance(verdict, Refuse):
            effects.extend_lease(run.workers[command.worker_id], now)
        return verdict

    replace_guard(right, wrong)


@mutant("DET-001")
def keeps_the_slot_after_detach() -> None:
    """A client that detached blocks its session until its lease would have ended."""
    right = SessionExecutor.detach
    limit = lifecycle._below_worker_limit
    unreleased_slots: dict[str, int] = {}

    async def wrong(self: SessionExecutor, run: Run, command: Detach) -> None:
        unreleased_slots[run.run_id] = unreleased_slots.get(run.run_id, 0) + 1
        await right(self, run, command)

    def wrong_limit(run: Run, command: Attach, now: float) -> Verdict | None:
        max_workers_before = run.max_workers
        run.max_workers -= unreleased_slots.get(run.run_id, 0)
        try:
            return limit(run, command, now)
        finally:
            run.max_workers = max_workers_before

    put(SessionExecutor, "detach", wrong)
    replace_guard(limit, wrong_limit)


@mutant("DET-002")
def refuses_a_second_detach() -> None:
    """A lost answer to detach looks like an error."""

    def wrong(run: Run, command: Detach, now: float) -> Verdict | None:
        heartbeat = lifecycle.Heartbeat(command.worker_id, command.session_id)
        return lifecycle._session_is_live(run, heartbeat, now)

    replace_guard(lifecycle._detach_target_exists, wrong)


@mutant("STOP-002")
def accepts_heartbeats_of_a_stopped_run() -> None:
    """A client computes for hours for a run that has ended."""
    right, remember = SessionExecutor.heartbeat, Run.record_end
    stopped: dict[str, Session] = {}

    def wrong_remember(self: Run, session: Session, ended_by: SessionEnd) -> None:
        remember(self, session, ended_by)
        if ended_by == "run_stopped":
            stopped[session.session_id] = session

    def wrong(self: SessionExecutor, run: Run, command: Heartbeat) -> Session:
        return stopped.get(command.session_id) or right(self, run, command)

    put(Run, "record_end", wrong_remember)
    put(SessionExecutor, "heartbeat", wrong)
