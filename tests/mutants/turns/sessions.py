"""Mutants of sessions: attach, detach, lease."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

from reference_server.rules import action_space, effects, lifecycle
from reference_server.rules.action_space import SpaceErrors
from reference_server.rules.lifecycle import (
    GUARDS,
    Attach,
    Detach,
    Heartbeat,
    Predict,
    Refuse,
    Replay,
    Verdict,
    Wait,
)
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run, Session, SessionEnd
from reference_server.runs import session_resources
from reference_server.runs.session_executor import SessionExecutor
from reference_server.runs.session_resources import ResourceManager, SessionResources
from reference_server.views import turn_view
from reference_server.views.run_views import timestamp
from tests.mutants import mutant, put
from tests.mutants.turns.predict import no_guard, replace_guard


@mutant(
    "ATT-002",
    "ATT-016",
    "ATT-018",
    "ENC-002",
    "ERR-015",
    "ERR-017",
    "LEASE-010",
    "SVC-005",
)
def opens_a_new_session_for_the_same_key() -> None:
    """After a lost answer to attach, the worker is refused until its lease ends."""
    replace_guard(lifecycle._same_attach_key, no_guard)


@mutant("ATT-006")
def lets_ten_workers_play() -> None:
    """A run that may have sixteen workers gets ten, and its owner waits longer."""
    right = lifecycle._below_worker_limit

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        most = min(run.max_workers, 10)
        seen: Any = SimpleNamespace(workers=run.workers, max_workers=most)
        return right(seen, command, now)

    replace_guard(right, wrong)


@mutant("ATT-006")
def counts_no_worker_that_attaches_with_takeover() -> None:
    """A script that always takes over attaches more workers than the machine bears."""
    right = lifecycle._below_worker_limit

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        return None if command.takeover else right(run, command, now)

    replace_guard(right, wrong)


@mutant("ATT-003", "ATT-008", "ATT-018")
def replaces_a_live_session_without_takeover() -> None:
    """Two clients with the same worker id throw each other out."""
    right = lifecycle._worker_is_free

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        return right(run, replace(command, takeover=True), now)

    replace_guard(right, wrong)


@mutant(
    "ATT-004",
    "ATT-016",
    "ATT-019",
    "ATT-020",
    "ATT-021",
    "ATR-003",
    "ATR-004",
    "ATR-006",
    "EPI-011",
    "LEASE-012",
    "SCORE-002",
)
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


@mutant("ATT-005", "ATT-019", "DET-004", "PRED-027")
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


@mutant("ATT-010", "ATT-017")
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


@mutant("ATT-010")
def ignores_assumptions_that_are_empty() -> None:
    """A policy that knows no unit plays on an arm that has one."""
    right = action_space.convention_errors

    def wrong(assumes: Mapping[str, Any], manifest: Mapping[str, Any]) -> SpaceErrors:
        assumed = {name: value for name, value in assumes.items() if value}
        for part in assumed.keys() & {"action", "state"}:
            assumed[part] = {
                name: {member: value for member, value in entry.items() if value}
                for name, entry in assumed[part].items()
            }
        return right(assumed, manifest)

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


@mutant("ATT-012", "ATT-014")
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


@mutant("EPI-009", "LEASE-001", "LEASE-011", "LEASE-012")
def never_ends_a_lease() -> None:
    """A crashed client keeps its session for ever."""
    _change_lease_over(lambda _session, _now: False)


@mutant("LEASE-001", "LEASE-003", "LEASE-010")
def never_ends_a_session_that_is_done() -> None:
    """Sessions that have played everything are kept for ever."""
    right = lifecycle.lease_over
    _change_lease_over(lambda session, now: not session.done and right(session, now))


@mutant("LEASE-002", "LEASE-003", "LEASE-004", "LEASE-010")
def loses_the_fraction_of_a_lease() -> None:
    """A lease of 2.9 s ends after 2."""
    right = lifecycle.lease_over

    def wrong(session: Session, now: float) -> bool:
        return right(session, now + session.idle_timeout_s % 1)

    _change_lease_over(wrong)


@mutant("LEASE-002", "LEASE-003", "LEASE-004", "LEASE-010")
def ends_leases_early() -> None:
    """A policy that thinks for longer than half its lease loses its episode."""
    right = lifecycle.lease_over

    def wrong(session: Session, now: float) -> bool:
        return right(session, now + session.idle_timeout_s / 2)

    _change_lease_over(wrong)


@mutant("LEASE-002")
def ends_leases_by_a_twentieth_early() -> None:
    """A policy with a long lease loses its episode seconds before that is over."""
    right = lifecycle.lease_over

    def wrong(session: Session, now: float) -> bool:
        return right(session, now + session.idle_timeout_s / 20)

    _change_lease_over(wrong)


@mutant("LEASE-003", "LEASE-009")
def accepts_heartbeats_without_extending_the_lease() -> None:
    """A slow policy loses its episode although it sent heartbeats."""

    def wrong(self: SessionExecutor, run: Run, command: Any) -> Session:
        self.sweep(run)
        verdict = lifecycle.decide(run, command, time.monotonic())
        if isinstance(verdict, Refuse):
            raise Refused.from_verdict(verdict)
        return run.workers[command.worker_id]

    put(SessionExecutor, "heartbeat", wrong)


@mutant("LEASE-004", "LEASE-009")
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


@mutant("ATR-002", "DET-001")
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


@mutant("DET-005", "STOP-002")
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


def _count_workers(holds_a_slot: Callable[[Session], bool]) -> None:
    """Of the sessions of other workers whose lease is not over, count these."""

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        others = [s for s in run.workers.values() if s.worker_id != command.worker_id]
        counted = [session for session in others if holds_a_slot(session)]
        left = sum(not lifecycle.lease_over(session, now) for session in counted)
        if left < run.max_workers:
            return None
        return Refuse("worker_limit", "The run has all its workers.")

    replace_guard(lifecycle._below_worker_limit, wrong)


@mutant("ATT-014")
def counts_done_sessions_as_workers() -> None:
    """A worker that finished early keeps another machine from helping out."""
    _count_workers(lambda _: True)


@mutant("ATT-014")
def counts_sessions_that_began_done_as_workers() -> None:
    """Workers that came too late keep those out that an episode waits for."""
    _count_workers(lambda session: not session.done or session.seq == 0)


@mutant("ATT-015")
def waits_for_done_sessions() -> None:
    """A drained run is not stopped before the client detaches, or for ever."""

    def wrong(run: Run) -> None:
        if not run.workers:
            reason = None if lifecycle.may_hand_out(run) else "Drained."
            effects.apply_event(run, "last_lease_ends", reason)

    put(effects, "_after_session_end", wrong)


@mutant("ATT-016", "LEASE-010")
def refuses_a_repeated_attach_in_a_drain() -> None:
    """A lost answer to attach costs the episode when the run is drained meanwhile."""
    guards = list(GUARDS[Attach])
    first, second = map(
        guards.index, (lifecycle._same_attach_key, lifecycle._event_is_legal)
    )
    guards[first], guards[second] = guards[second], guards[first]
    GUARDS[Attach] = tuple(guards)


@mutant("ATT-016")
def judges_the_assumptions_of_a_repeated_attach() -> None:
    """A client that corrects its assumptions while it repeats loses its session."""
    guards = list(GUARDS[Attach])
    guards.remove(lifecycle._conventions_agree)
    place = guards.index(lifecycle._same_attach_key)
    guards.insert(place, lifecycle._conventions_agree)
    GUARDS[Attach] = tuple(guards)


def _fence_when_refused(guard: Any) -> None:
    def wrong(run: Run, command: Any, now: float) -> Verdict | None:
        verdict: Verdict | None = guard(run, command, now)
        if verdict is not None and isinstance(command, Attach) and command.takeover:
            session = run.workers.get(command.worker_id)
            if session is not None:
                session.session_id += "-fenced"
        return verdict

    replace_guard(guard, wrong)


@mutant("ATT-017")
def fences_out_by_a_takeover_that_a_drain_refuses() -> None:
    """An episode that should be played to its end is lost to a refused request."""
    _fence_when_refused(lifecycle._event_is_legal)


@mutant("ATT-017")
def fences_out_by_a_takeover_with_wrong_assumptions() -> None:
    """A misconfigured client throws the working one out, and cannot play itself."""
    _fence_when_refused(lifecycle._conventions_agree)


@mutant("ATT-018")
def compares_the_beginnings_of_attach_keys() -> None:
    """Two clients whose keys begin alike share a session unawares."""
    right = lifecycle._same_attach_key

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        session = run.workers.get(command.worker_id)
        if session is not None and session.attach_key[:64] == command.attach_key[:64]:
            command = replace(command, attach_key=session.attach_key)
        return right(run, command, now)

    replace_guard(right, wrong)


@mutant("ATT-018")
def looks_for_attach_keys_in_the_whole_run() -> None:
    """Two workers started with one key steer one robot."""
    right = lifecycle._same_attach_key

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        for session in run.workers.values():
            if session.attach_key == command.attach_key:
                command = replace(command, worker_id=session.worker_id)
        return right(run, command, now)

    replace_guard(right, wrong)


@mutant("ATT-019")
def repeats_turns_of_the_session_before() -> None:
    """After a takeover an action is not executed, but answered as if it were."""
    before: dict[str, Session] = {}
    open_session, predict = effects.open_session, SessionExecutor.predict

    def wrong_open(run: Run, command: Attach, session_id: str, now: float) -> Session:
        old = run.workers.get(command.worker_id)
        if old is not None:
            before[session_id] = old
        return open_session(run, command, session_id, now)

    async def wrong(
        self: SessionExecutor, run: Run, command: Predict
    ) -> dict[str, Any]:
        old = before.get(command.session_id)
        sent = (command.actions, command.observe)
        is_repeat = old is not None and old.seq == command.seq > 1
        if old is not None and old.turn and is_repeat and old.request == sent:
            return old.turn | {"session_id": command.session_id}
        return await predict(self, run, command)

    put(effects, "open_session", wrong_open)
    put(SessionExecutor, "predict", wrong)


@mutant("ATR-001", "ATT-020")
def needs_a_free_slot_for_a_takeover() -> None:
    """A restarted client cannot get its worker back in a full run."""
    right = lifecycle._below_worker_limit

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        if len(run.live_sessions) >= run.max_workers:
            return Refuse("worker_limit", "The run has all its workers.")
        return right(run, command, now)

    replace_guard(right, wrong)


@mutant("ATT-021")
def refuses_a_takeover_during_a_turn() -> None:
    """A client that crashed in a long turn cannot come back before its end."""
    right = lifecycle._worker_is_free

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        verdict = right(run, command, now)
        if isinstance(verdict, Wait):
            return Refuse("worker_busy", "It plays a turn.")
        return verdict

    replace_guard(right, wrong)


@mutant("LEASE-003", "LEASE-009")
def extends_the_lease_by_less_with_a_heartbeat() -> None:
    """A client that sends heartbeats as seldom as it may loses its session."""
    right = SessionExecutor.heartbeat

    def wrong(self: SessionExecutor, run: Run, command: Heartbeat) -> Session:
        session = right(self, run, command)
        session.expires_at = time.monotonic() + 0.8 * session.idle_timeout_s
        return session

    put(SessionExecutor, "heartbeat", wrong)


@mutant("LEASE-003")
def extends_no_lease_of_a_drain_with_a_heartbeat() -> None:
    """A slow policy loses the episode that a drain lets it play to its end."""
    right = SessionExecutor.heartbeat

    def wrong(self: SessionExecutor, run: Run, command: Heartbeat) -> Session:
        before = {s: s.expires_at for s in run.workers.values()}
        session = right(self, run, command)
        if run.state == "stopping":
            session.expires_at = before[session]
        return session

    put(SessionExecutor, "heartbeat", wrong)


@mutant("LEASE-008")
def extends_the_lease_by_requests_of_the_session_before() -> None:
    """A client that was replaced keeps the session of its dead successor alive."""
    right = lifecycle._session_is_live

    def wrong(run: Run, command: Any, now: float) -> Verdict | None:
        verdict = right(run, command, now)
        if isinstance(verdict, Refuse) and verdict.code == "session_superseded":
            effects.extend_lease(run.workers[command.worker_id], now)
        return verdict

    replace_guard(right, wrong)


@mutant("LEASE-009")
def shows_the_lease_of_the_beginning_of_a_turn() -> None:
    """A client sends too many heartbeats after long turns, or gives up its session."""
    right = turn_view.add_lease_and_total

    def wrong(body: dict[str, Any], session: Session, total_s: float) -> None:
        right(body, session, total_s)
        ends = time.time() + session.idle_timeout_s - total_s
        body["lease"]["expires_at"] = timestamp(ends)

    put(turn_view, "add_lease_and_total", wrong)


@mutant("LEASE-010")
def lets_the_lease_run_through_repeats() -> None:
    """A client behind a bad line is answered, and loses its session all the same."""

    def wrong(_self: SessionExecutor, session: Session) -> dict[str, Any]:
        assert session.turn is not None
        return session.turn

    put(SessionExecutor, "_replay_turn", wrong)


@mutant("LEASE-010")
def extends_no_lease_of_a_drain_with_a_repeated_attach() -> None:
    """A client that lost its answer to attach is answered, and loses its session."""
    right = SessionExecutor.attach

    async def wrong(self: SessionExecutor, run: Run, command: Attach) -> dict[str, Any]:
        session = run.workers.get(command.worker_id)
        before = 0.0 if session is None else session.expires_at
        turn = await right(self, run, command)
        if session is not None and run.state == "stopping":
            session.expires_at = before
        return turn

    put(SessionExecutor, "attach", wrong)


@mutant("LEASE-011")
def looks_at_leases_only_when_asked() -> None:
    """A client that waits for a run does not learn that its policy is gone."""

    def wrong(_self: ResourceManager, _resources: SessionResources) -> None:
        pass

    put(ResourceManager, "_schedule_lease_check", wrong)


@mutant("EPI-009", "LEASE-012")
def does_not_count_attempts_of_lost_clients() -> None:
    """A policy that disappears when it plays badly may try again without limit."""
    right = effects.close_session

    def wrong(run: Run, session: Session, ended_by: SessionEnd, now: float) -> None:
        if ended_by == "lease_ended":
            session.steps = 0
        right(run, session, ended_by, now)

    put(effects, "close_session", wrong)


@mutant("DET-003")
def counts_no_attempt_when_it_aborts_a_turn() -> None:
    """A policy whose run is aborted in a turn gets another try for nothing."""
    right = effects.stop

    def wrong(run: Run, mode: str, now_wall: float) -> list[Session]:
        for session in run.workers.values():
            if session.busy == "playing" and mode == "abort":
                session.busy, session.steps = "turning", 0
        return right(run, mode, now_wall)

    put(effects, "stop", wrong)


@mutant("DET-004", "ATT-005")
def detaches_the_session_of_the_worker_for_any_id() -> None:
    """A confused client ends the session of another one."""
    right = SessionExecutor.detach

    async def wrong(self: SessionExecutor, run: Run, command: Detach) -> None:
        session = run.workers.get(command.worker_id)
        others = {s.session_id for s in run.workers.values()} | run.ended.keys()
        if session is not None and command.session_id not in others:
            command = replace(command, session_id=session.session_id)
        await right(self, run, command)

    put(SessionExecutor, "detach", wrong)


@mutant("DET-004")
def finds_sessions_under_any_worker() -> None:
    """A typing error in a path steers another robot."""
    right = SessionExecutor.predict

    async def wrong(
        self: SessionExecutor, run: Run, command: Predict
    ) -> dict[str, Any]:
        for session in run.workers.values():
            if session.session_id == command.session_id:
                command = replace(command, worker_id=session.worker_id)
        return await right(self, run, command)

    put(SessionExecutor, "predict", wrong)


@mutant("DET-005", "DET-003", "LEASE-012")
def never_says_what_ended_a_session() -> None:
    """A crash of the policy looks like a stop of the run."""
    right = Run.record_end

    def wrong(self: Run, session: Session, ended_by: SessionEnd) -> None:
        right(self, session, ended_by)
        if ended_by != "run_failed":
            self.ended[session.session_id] = session.ended_by = "unknown"

    put(Run, "record_end", wrong)


@mutant("LEASE-003")
def ends_done_sessions_in_spite_of_heartbeats() -> None:
    """A worker that is done and waits for others loses the answer to its last turn."""
    right = SessionExecutor._extend_lease

    def wrong(self: SessionExecutor, session: Session) -> None:
        if not session.done:
            right(self, session)

    put(SessionExecutor, "_extend_lease", wrong)
    replay = SessionExecutor._replay_turn

    def replay_rightly(self: SessionExecutor, session: Session) -> dict[str, Any]:
        right(self, session)
        return replay(self, session)

    put(SessionExecutor, "_replay_turn", replay_rightly)


@mutant("ATT-006")
def counts_no_worker_that_was_there_before() -> None:
    """Workers that come back after a drain play beside as many as the machine bears."""
    right = lifecycle._below_worker_limit
    seen: set[tuple[str, str]] = set()

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        place = run.run_id, command.worker_id
        verdict = None if place in seen else right(run, command, now)
        if verdict is None:
            seen.add(place)
        return verdict

    replace_guard(right, wrong)


@mutant("ATT-018")
def finds_the_session_of_a_key_under_a_third_worker() -> None:
    """Scripts that all use one key steer each other's robots."""
    right = lifecycle._same_attach_key

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        holders = [
            session
            for session in run.workers.values()
            if session.attach_key == command.attach_key and not session.busy
        ]
        if len(holders) > 1 and command.worker_id not in run.workers:
            return Replay(holders[0])
        return right(run, command, now)

    replace_guard(right, wrong)


@mutant("ATT-005", "DET-004")
def detaches_the_successor_of_a_session() -> None:
    """The old client cleans up, and the new one loses its episode."""
    right = SessionExecutor.detach

    async def wrong(self: SessionExecutor, run: Run, command: Detach) -> None:
        try:
            await right(self, run, command)
        except Refused as refused:
            if refused.code == "session_superseded":
                newer = run.workers[command.worker_id].session_id
                await right(self, run, replace(command, session_id=newer))
            raise

    put(SessionExecutor, "detach", wrong)


@mutant("LIFE-803")
def stops_a_drain_when_one_that_is_done_leaves() -> None:
    """A drain ends episodes that were to be played to their end."""
    right = effects.close_session

    def wrong(run: Run, session: Session, *rest: Any) -> None:
        was_done = session.done
        right(run, session, *rest)
        if was_done and run.state == "stopping":
            effects.apply_event(run, "last_lease_ends", "Drained.")

    put(effects, "close_session", wrong)
