"""Mutants of a turn: exactly once, in order, and what it carries."""

from __future__ import annotations

import asyncio
from dataclasses import replace
from typing import Any

from reference_record.generated.answers import Turn
from reference_server.rules.runs import effects, lifecycle
from reference_server.rules.runs.lifecycle import (
    GUARDS,
    Predict,
    Refuse,
    Replay,
    Verdict,
    Wait,
)
from reference_server.rules.runs.run import Run, Session
from reference_server.runs.sessions.session_executor import SessionExecutor
from reference_server.views import turn_view
from tests.mutants import Json, instead_of, mutant, put
from tests.mutants.server_changes import (
    change_turn,
    instead_of_guard,
)


@mutant(
    *("FAULT-011", "LEASE-002", "LEASE-010", "PRED-002", "PRED-003", "PRED-005"),
    *("PRED-010", "PRED-025", "PRED-026", "PRED-027"),
)
def executes_a_repeated_turn_again() -> None:
    """A lost answer makes the robot execute a chunk twice."""

    def wrong(run: Run, command: Predict, _now: float) -> Verdict | None:
        session = run.workers[command.worker_id]
        if command.seq == session.seq + 1 or command.seq == session.seq > 0:
            return Wait(session) if session.busy else None
        return lifecycle._expected_seq(run, command, _now)

    GUARDS[Predict] = (
        lifecycle._session_is_live,
        wrong,
        lifecycle._has_an_episode,
        lifecycle._actions_fit,
    )


@mutant(
    *("FAULT-011", "PRED-003", "PRED-025", "PRED-026"),
    through=instead_of_guard(lifecycle._repeated_seq),
)
def answers_another_body_under_the_same_seq(
    _right: Any, run: Run, command: Predict, _now: float
) -> Any:
    """The client believes its new actions were executed; the old ones were."""
    session = run.workers[command.worker_id]
    if command.seq != session.seq or session.seq == 0:
        return None
    return Wait(session) if session.busy else Replay(session)


@mutant("PRED-005", through=instead_of_guard(lifecycle._repeated_seq))
def refuses_a_repeat_in_flight(
    right: Any, run: Run, command: Predict, now: float
) -> Any:
    """A client with a short timeout cannot retry a slow turn."""
    verdict = right(run, command, now)
    if isinstance(verdict, Wait):
        return Refuse("seq_conflict", "Still executing.")
    return verdict


@mutant("PRED-025", through=instead_of_guard(lifecycle._repeated_seq))
def compares_repeats_as_text(right: Any, run: Run, command: Predict, now: float) -> Any:
    """A client whose library sorts members differently cannot repeat a turn."""
    session = run.workers[command.worker_id]
    is_same = session.request is not None and repr(session.request[0]) == repr(
        command.actions
    )
    if command.seq == session.seq > 0 and not is_same:
        return Refuse("seq_conflict", "Another text.")
    return right(run, command, now)


@mutant("PRED-004", through=instead_of_guard(lifecycle._expected_seq))
def names_the_wrong_expected_seq(
    right: Any, run: Run, command: Predict, now: float
) -> Any:
    """A client cannot resynchronise its seq."""
    verdict = right(run, command, now)
    if isinstance(verdict, Refuse):
        wrong_seq = verdict.members["expected_seq"] + 1
        return replace(verdict, members={"expected_seq": wrong_seq})
    return verdict


@mutant("PRED-024", through=instead_of_guard(lifecycle._actions_fit))
def uses_up_the_seq_of_a_refused_turn(
    right: Any, run: Run, command: Predict, now: float
) -> Any:
    """After one invalid request every corrected one is out of order."""
    verdict = right(run, command, now)
    if isinstance(verdict, Refuse):
        session = run.workers[command.worker_id]
        session.seq = command.seq
        session.request = None
    return verdict


@mutant("PRED-011", through=instead_of_guard(lifecycle._has_an_episode))
def repeats_done_for_any_seq(
    _right: Any, run: Run, command: Predict, _now: float
) -> Any:
    """A client that does not look at `done` runs for ever."""
    session = run.workers[command.worker_id]
    return Replay(session) if session.done else None


@mutant(
    *("LEASE-002", "LEASE-003", "LEASE-009", "LEASE-010", "LEASE-013"),
    *("PRED-010", "MODEL-003"),
    through=instead_of(effects, "store_answer"),
)
def forgets_the_session_with_its_last_turn(
    right: Any, session: Session, turn: Json, now: float
) -> None:
    """After a lost last answer a client cannot learn how the run ended."""
    right(session, turn, now)
    if session.done:
        session.session_id += "-gone"
        session.expires_at = 0.0


@mutant("ATT-001", "ATT-022", through=instead_of(turn_view, "turn_view"))
def claims_a_step_before_the_first_action(
    right: Any, session: Session, **members: Any
) -> Any:
    """A client that counts steps counts one too many."""
    body = right(session, **members)
    return body if body["seq"] else body | {"executed_steps": 1, "rewards": [0.0]}


@mutant("EPI-013", through=change_turn)
def shows_fewer_steps_to_a_later_attempt(body: Json, _session: Session) -> None:
    """A policy that plans for the whole episode plans for too short a one."""
    episode = body.get("episode")
    if episode and episode["attempt"] > 1:
        body["episode"] = episode | {"max_steps": episode["max_steps"] - 1}


@mutant("PRED-028", through=change_turn)
def never_says_that_it_stopped_early(body: Json, _session: Session) -> None:
    """A client believes that its whole chunk was executed."""
    body["stopped_early"] = False


@mutant("PRED-008", "PRED-012", through=change_turn)
def forgets_the_result_of_an_episode(body: Json, _session: Session) -> None:
    """A client learns a score only by another request."""
    body.pop("episode_result", None)


@mutant("ATT-012", "PRED-009", "STOP-004", "SUB-001", through=change_turn)
def never_says_done(body: Json, _session: Session) -> None:
    """A client waits for an observation that never comes."""
    body["done"] = False


@mutant("PRED-012", through=change_turn)
def returns_only_the_last_observation(body: Json, _session: Session) -> None:
    """A client that wants every frame of a chunk gets one."""
    if body.get("observations"):
        body["observations"] = body["observations"][-1:]


@mutant("CAL-008", "PRED-021", through=change_turn)
def sums_the_rewards_of_a_chunk(body: Json, _session: Session) -> None:
    """Per-step rewards are lost."""
    if len(body["rewards"]) > 1:
        body["rewards"] = [sum(body["rewards"])]


@mutant("PRED-020", through=change_turn)
def calls_a_truncated_episode_terminated(body: Json, _session: Session) -> None:
    """A timeout looks like an end that the task decided."""
    if body["truncated"]:
        body.update(truncated=False, terminated=True)


@mutant("PRED-023", through=instead_of(turn_view, "add_lease_and_total"))
def reports_more_time_than_passed(
    right: Any, body: Json, session: Session, total_s: float
) -> None:
    """Latency reports cannot be trusted."""
    right(body, session, total_s)
    body["timing"]["simulate_s"] = total_s * 2 + 1


@mutant("PRED-022")
def plays_one_worker_at_a_time() -> None:
    """Sixteen workers are as slow as one."""
    right = SessionExecutor._play
    lock = asyncio.Lock()

    async def wrong(self: SessionExecutor, *arguments: Any) -> Turn:
        async with lock:
            return await right(self, *arguments)

    put(SessionExecutor, "_play", wrong)
