"""Mutants of sessions: attach, takeover, detach."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from reference_record.contents import contradicted_assumptions
from reference_server.rules.runs import effects, lifecycle
from reference_server.rules.runs.lifecycle import (
    GUARDS,
    Attach,
    Detach,
    Refuse,
    Verdict,
    Wait,
)
from reference_server.rules.runs.run import Run, Session
from reference_server.runs.service import RunService
from reference_server.runs.sessions.session_executor import SessionExecutor
from reference_server.runs.sessions.session_resources import (
    ResourceManager,
    SessionResources,
)
from tests.mutants import Json, Row, instead_of, mutant, mutants, put
from tests.mutants.server_changes import (
    change_turn,
    instead_of_guard,
    no_guard,
    replace_guard,
)


@mutant(
    *("ATT-002", "ATT-016", "ATT-018", "ENC-002"),
    *("ERR-015", "ERR-017", "LEASE-010", "SVC-005"),
)
def opens_a_new_session_for_the_same_key() -> None:
    """After a lost answer to attach, the worker is refused until its lease ends."""
    replace_guard(lifecycle._same_attach_key, no_guard)


@mutant("ATT-018", through=instead_of_guard(lifecycle._same_attach_key))
def looks_for_attach_keys_in_the_whole_run(
    right: Any, run: Run, command: Attach, now: float
) -> Any:
    """Two workers started with one key steer one robot."""
    for session in run.workers.values():
        if session.attach_key == command.attach_key:
            command = replace(command, worker_id=session.worker_id)
    return right(run, command, now)


@mutant("ATT-016", "LEASE-010")
def refuses_a_repeated_attach_in_a_drain() -> None:
    """A lost answer to attach costs the episode when the run is drained meanwhile."""
    guards = list(GUARDS[Attach])
    first, second = map(
        guards.index, (lifecycle._same_attach_key, lifecycle._event_is_legal)
    )
    guards[first], guards[second] = guards[second], guards[first]
    GUARDS[Attach] = tuple(guards)


@mutant(
    "ATT-003", "ATT-008", "ATT-018", through=instead_of_guard(lifecycle._worker_is_free)
)
def replaces_a_live_session_without_takeover(
    right: Any, run: Run, command: Attach, now: float
) -> Any:
    """Two clients with the same worker id throw each other out."""
    return right(run, replace(command, takeover=True), now)


@mutant("ERR-021", through=instead_of(RunService, "attach_worker"))
async def ignores_capital_letters_of_workers(
    right: Any, self: RunService, account: str, run_id: str, command: Attach
) -> Any:
    """Two workers of a client that counts in letters take one slot from each other."""
    worker_id = command.worker_id.lower()
    return await right(self, account, run_id, replace(command, worker_id=worker_id))


@mutant("ATT-022", through=change_turn)
def repeats_rewards_in_a_takeover(body: Json, session: Session) -> None:
    """A client counts the rewards before a takeover a second time."""
    if body["seq"] == 0 and session.episode is not None:
        body["rewards"] = [0.0] * body["episode"]["step"]


@mutant(
    *("ATT-004", "ATT-019", "ATT-020", "ATT-021", "ATR-003"),
    *("ATR-004", "ATR-006", "EPI-011", "LEASE-012"),
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


@mutant("ATT-005", "DET-004", "PRED-027")
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


@mutant("ATT-021", through=instead_of_guard(lifecycle._worker_is_free))
def refuses_a_takeover_during_a_turn(
    right: Any, run: Run, command: Attach, now: float
) -> Any:
    """A client that crashed in a long turn cannot come back before its end."""
    verdict = right(run, command, now)
    if isinstance(verdict, Wait):
        return Refuse("worker_busy", "It plays a turn.")
    return verdict


@mutant("ATT-017", through=instead_of_guard(lifecycle._event_is_legal))
def fences_out_by_a_takeover_that_a_drain_refuses(
    right: Any, run: Run, command: Any, now: float
) -> Any:
    """An episode that should be played to its end is lost to a refused request."""
    verdict = right(run, command, now)
    if verdict is not None and isinstance(command, Attach) and command.takeover:
        session = run.workers.get(command.worker_id)
        if session is not None:
            session.session_id += "-fenced"
    return verdict


@mutant("ATR-001", "ATT-020", through=instead_of_guard(lifecycle._below_worker_limit))
def needs_a_free_slot_for_a_takeover(
    right: Any, run: Run, command: Attach, now: float
) -> Any:
    """A restarted client cannot get its worker back in a full run."""
    if len(run.live_sessions) >= run.max_workers:
        return Refuse("worker_limit", "The run has all its workers.")
    return right(run, command, now)


@mutant("ATT-006", "ATT-007", through=instead_of_guard(lifecycle._below_worker_limit))
def allows_one_worker_too_many(
    right: Any, run: Run, command: Attach, now: float
) -> Any:
    """The limit that protects the machine does not hold."""
    run.max_workers += 1
    try:
        return right(run, command, now)
    finally:
        run.max_workers -= 1


@mutant("ATT-007")
def decides_first_and_opens_later() -> None:
    """Under load more workers attach than `max_workers` allows."""
    strict = GUARDS[Attach]
    loose = tuple(g for g in strict if g is not lifecycle._below_worker_limit)

    async def wrong(
        right: Any, self: SessionExecutor, run: Run, command: Attach
    ) -> Any:
        verdict = lifecycle.decide(run, command, time.monotonic())
        if not isinstance(verdict, lifecycle.Accept):
            return await right(self, run, command)
        await asyncio.sleep(0.05)
        GUARDS[Attach] = loose
        attaching = asyncio.ensure_future(right(self, run, command))
        await asyncio.sleep(0)  # up to its first wait, where the session is open
        GUARDS[Attach] = strict
        return await attaching

    instead_of(SessionExecutor, "attach")(wrong)


@mutant("ATT-014", through=instead_of_guard(lifecycle._below_worker_limit))
def counts_done_sessions_as_workers(
    _right: Any, run: Run, command: Attach, now: float
) -> Any:
    """A worker that finished early keeps another machine from helping out."""
    others_live = [
        session
        for session in run.workers.values()
        if session.worker_id != command.worker_id
        and not lifecycle.lease_over(session, now)
    ]
    if len(others_live) < run.max_workers:
        return None
    return Refuse("worker_limit", "The run has all its workers.")


@mutant("ATT-010", "ATT-017", "CONV-004", "CONV-005", "CONV-006")
def ignores_assumed_conventions() -> None:
    """Radians are played as degrees, and scored."""
    replace_guard(lifecycle._conventions_agree, no_guard)


@mutant(
    *("ATT-010", "CONV-005"),
    through=instead_of(contradicted_assumptions, "contradictions"),
)
def ignores_assumed_vectors_that_are_absent(
    right: Any, assumes: Mapping[str, Any], benchmark: Mapping[str, Any]
) -> Any:
    """A policy that steers a gripper plays on an arm without one."""
    errors = right(assumes, benchmark)
    return [error for error in errors if "no such vector" not in error[1]]


@mutants(
    Row(
        "ignores_assumed_parts",
        ("ATT-010", "CONV-005", "CONV-006"),
        "A policy that sends a quaternion as x, y, z, w steers a hand elsewhere.",
        lambda assumed: {k: v for k, v in assumed.items() if k != "parts"},
    ),
    Row(
        "believes_the_parts_alone",
        ("CONV-004", "CONV-005", "CONV-006"),
        "A wrong unit of the whole vector is played where a part is named, too.",
        lambda assumed: {"parts": assumed["parts"]} if "parts" in assumed else assumed,
    ),
    Row(
        "ignores_what_is_assumed_of_all_parts",
        ("ATT-010", "CONV-004", "CONV-005", "CONV-006"),
        "A client that states the unit of its joints is refused nowhere.",
        lambda assumed: {k: v for k, v in assumed.items() if k in ("size", "parts")},
    ),
)
def compares_less(change: Callable[[Mapping[str, Any]], Mapping[str, Any]]) -> None:
    """Some members of the assumption of a vector are not compared."""
    right = contradicted_assumptions._of_vector

    def wrong(at: str, assumed: Mapping[str, Any], vector: Mapping[str, Any]) -> Any:
        return right(at, change(assumed), vector)

    put(contradicted_assumptions, "_of_vector", wrong)


@mutants(
    Row(
        "names_the_first_contradiction_alone",
        ("CONV-005", "CONV-006"),
        "A user corrects one convention after the other, with a run for each.",
        lambda errors: errors[:1],
    ),
    Row(
        "does_not_say_what_is_declared",
        ("CONV-006",),
        "The refusal says that a unit is wrong, and not which one is right.",
        lambda errors: [(at, "is contradicted") for at, _ in errors],
    ),
)
def reports_less(change: Callable[[Any], Any]) -> None:
    """The refusal has less than the contradictions."""
    right = contradicted_assumptions.contradictions

    def wrong(assumes: Mapping[str, Any], benchmark: Mapping[str, Any]) -> Any:
        return change(list(right(assumes, benchmark)))

    put(contradicted_assumptions, "contradictions", wrong)


@mutant(
    "ATT-011",
    "CONV-005",
    "CONV-006",
    through=instead_of_guard(lifecycle._conventions_agree),
)
def refuses_all_assumed_conventions(
    _right: Any, _run: Run, command: Attach, _now: float
) -> Any:
    """A client that states its conventions is refused."""
    if command.assumes is None:
        return None
    errors = (("/assumes", "no"),)
    return Refuse("convention_mismatch", "No assumptions.", errors=errors)


@mutant("ATT-015", through=instead_of(effects, "_after_session_end"))
def waits_for_done_sessions(_right: Any, run: Run) -> None:
    """A drained run is not stopped before the client detaches, or for ever."""
    if not run.workers:
        reason = None if lifecycle.may_hand_out(run) else run.reason
        effects.apply_event(run, "last_lease_ends", reason)


@mutant("ATR-002", "ATT-006", "DET-001")
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


@mutant("DET-002", through=instead_of_guard(lifecycle._detach_target_exists))
def refuses_a_second_detach(_right: Any, run: Run, command: Detach, now: float) -> Any:
    """A lost answer to detach looks like an error."""
    heartbeat = lifecycle.Heartbeat(command.worker_id, command.session_id)
    return lifecycle._session_is_live(run, heartbeat, now)


@mutant("DET-004", "ATT-005", through=instead_of(SessionExecutor, "detach"))
async def detaches_the_session_of_the_worker_for_any_id(
    right: Any, self: SessionExecutor, run: Run, command: Detach
) -> None:
    """A confused client ends the session of another one."""
    session = run.workers.get(command.worker_id)
    session_ids = {s.session_id for s in run.workers.values()} | run.ended.keys()
    if session is not None and command.session_id not in session_ids:
        command = replace(command, session_id=session.session_id)
    await right(self, run, command)
