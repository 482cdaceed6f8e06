"""Mutants of a turn: exactly once, chunks, refusals of actions, what a turn carries."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from reference_server.rules import action_space, effects, lifecycle
from reference_server.rules.lifecycle import (
    GUARDS,
    Heartbeat,
    Predict,
    Refuse,
    Replay,
    Verdict,
    Wait,
)
from reference_server.rules.run import Run, Session
from reference_server.runs.session_executor import SessionExecutor
from reference_server.views import turn_view
from tests.mutants import mutant, put

SpaceErrors = list[tuple[str, str]]


def replace_guard(guard: Any, other: Any) -> None:
    """Replace one guard wherever it stands."""
    for command, guards in GUARDS.items():
        GUARDS[command] = tuple(other if g is guard else g for g in guards)


def no_guard(_run: Run, _command: Any, _now: float) -> Verdict | None:
    return None


def change_turn(change: Any) -> None:
    """Let `change(body, session)` spoil every turn before it leaves."""
    right = turn_view.turn_view

    def wrong(session: Session, **members: Any) -> dict[str, Any]:
        body = right(session, **members)
        change(body, session)
        return body

    put(turn_view, "turn_view", wrong)


@mutant(
    "FAULT-011",
    "LEASE-002",
    "LEASE-010",
    "PRED-002",
    "PRED-003",
    "PRED-005",
    "PRED-010",
    "PRED-024",
    "PRED-025",
    "PRED-026",
    "PRED-027",
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


@mutant("FAULT-011", "PRED-003", "PRED-025", "PRED-026", "PRED-027")
def answers_another_body_under_the_same_seq() -> None:
    """The client believes its new actions were executed; the old ones were."""

    def wrong(run: Run, command: Predict, _now: float) -> Verdict | None:
        session = run.workers[command.worker_id]
        if command.seq != session.seq or session.seq == 0:
            return None
        return Wait(session) if session.busy else Replay(session)

    replace_guard(lifecycle._repeated_seq, wrong)


@mutant("ATT-019", "PRED-004", "PRED-027")
def accepts_a_seq_from_the_future() -> None:
    """A client with a wrong seq gets no error."""
    replace_guard(lifecycle._expected_seq, no_guard)


@mutant("ATT-019", "PRED-004", "PRED-027")
def names_the_wrong_expected_seq() -> None:
    """A client cannot resynchronise its seq."""
    right = lifecycle._expected_seq

    def wrong(run: Run, command: Predict, now: float) -> Verdict | None:
        verdict = right(run, command, now)
        if isinstance(verdict, Refuse):
            wrong_seq = verdict.members["expected_seq"] + 1
            return replace(verdict, members={"expected_seq": wrong_seq})
        return verdict

    replace_guard(right, wrong)


@mutant("PRED-005")
def refuses_a_repeat_in_flight() -> None:
    """A client with a short timeout cannot retry a slow turn."""
    right = lifecycle._repeated_seq

    def wrong(run: Run, command: Predict, now: float) -> Verdict | None:
        verdict = right(run, command, now)
        if isinstance(verdict, Wait):
            return Refuse("seq_conflict", "Still executing.")
        return verdict

    replace_guard(right, wrong)


@mutant("PRED-013")
def accepts_vectors_of_any_length() -> None:
    """A policy for another robot moves this one."""
    right = action_space._vector_errors

    def wrong(at: str, vector: Any, entry: Mapping[str, Any]) -> SpaceErrors:
        padded = [*vector, *[0.0] * entry["size"]][: entry["size"]]
        return right(at, padded, entry)

    put(action_space, "_vector_errors", wrong)
    _before_playing(
        lambda values, space: {
            name: [*vector, *[0.0] * space[name]["size"]][: space[name]["size"]]
            for name, vector in values.items()
        }
    )


@mutant("PRED-014")
def ignores_unknown_names() -> None:
    """A misspelt part of an action is not sent to the robot, without an error."""
    right = action_space.action_errors

    def wrong(actions: Any, manifest: Mapping[str, Any]) -> SpaceErrors:
        space = manifest["action_space"]
        known = [{k: v for k, v in a.items() if k in space} for a in actions]
        return right(known, manifest)

    put(action_space, "action_errors", wrong)
    _before_playing(
        lambda values, space: {k: v for k, v in values.items() if k in space}
    )


@mutant("EPI-011", "PRED-014")
def fills_in_missing_names() -> None:
    """A forgotten part of an action becomes zero, with any effect."""
    right = action_space.action_errors

    def wrong(actions: Any, manifest: Mapping[str, Any]) -> SpaceErrors:
        space = manifest["action_space"]
        for values in actions:
            if isinstance(values, dict):
                for name, entry in space.items():
                    values.setdefault(name, [0.0] * entry["size"])
        return right(actions, manifest)

    put(action_space, "action_errors", wrong)


@mutant("PRED-015")
def accepts_chunks_of_any_length() -> None:
    """One client can keep a simulator for any time."""
    right = action_space.action_errors

    def wrong(actions: Any, manifest: Mapping[str, Any]) -> SpaceErrors:
        return right(actions, {**manifest, "max_chunk": len(actions)})

    put(action_space, "action_errors", wrong)


@mutant("PRED-017")
def clips_what_it_should_refuse() -> None:
    """A policy in the wrong unit gets a score instead of an error."""
    right = action_space._vector_errors

    def wrong(at: str, vector: Any, entry: Mapping[str, Any]) -> SpaceErrors:
        return right(at, vector, {**entry, "out_of_range": "clip"})

    put(action_space, "_vector_errors", wrong)
    _before_playing(
        lambda values, space: {
            name: action_space._clip(
                vector, (space[name]["minimum"], space[name]["maximum"])
            )
            if space[name]["out_of_range"] == "refuse"
            else vector
            for name, vector in values.items()
        }
    )


@mutant("PRED-018")
def refuses_what_it_should_clip() -> None:
    """A policy that slightly exceeds a limit is refused."""
    right = action_space._vector_errors

    def wrong(at: str, vector: Any, entry: Mapping[str, Any]) -> SpaceErrors:
        if entry["out_of_range"] == "clip":
            return right(at, vector, {**entry, "out_of_range": "refuse"})
        return right(at, vector, entry)

    put(action_space, "_vector_errors", wrong)


@mutant("PRED-013", "PRED-014", "PRED-017", "PRED-019")
def checks_only_the_first_action() -> None:
    """Half a chunk is executed before the invalid action is found."""
    right = action_space.action_errors

    def wrong(actions: Any, manifest: Mapping[str, Any]) -> SpaceErrors:
        found = right(actions[:1], manifest)
        if len(actions) > manifest["max_chunk"]:
            return right(actions, manifest)
        return found

    put(action_space, "action_errors", wrong)


@mutant("PRED-024")
def uses_up_the_seq_of_a_refused_turn() -> None:
    """After one invalid request every corrected one is out of order."""
    right = lifecycle._actions_fit

    def wrong(run: Run, command: Predict, now: float) -> Verdict | None:
        verdict = right(run, command, now)
        if isinstance(verdict, Refuse):
            session = run.workers[command.worker_id]
            session.seq = command.seq
            session.request = None
        return verdict

    replace_guard(right, wrong)


@mutant("PRED-002")
def forgets_a_turn_after_a_heartbeat() -> None:
    """A client that sends heartbeats cannot repeat a turn whose answer was lost."""
    right = SessionExecutor.heartbeat

    def wrong(self: SessionExecutor, run: Run, command: Heartbeat) -> Session:
        session = right(self, run, command)
        session.request = None
        return session

    put(SessionExecutor, "heartbeat", wrong)


@mutant("PRED-003")
def compares_the_first_action_of_a_repeat() -> None:
    """The client believes the rest of its new chunk was executed."""
    right = lifecycle._repeated_seq

    def wrong(run: Run, command: Predict, now: float) -> Verdict | None:
        sent = run.workers[command.worker_id].request
        if sent is not None and len(sent[0]) == len(command.actions):
            command = replace(command, actions=[command.actions[0], *sent[0][1:]])
        return right(run, command, now)

    replace_guard(right, wrong)


@mutant("PRED-003")
def compares_repeats_after_clipping() -> None:
    """A client does not notice that it sends other numbers than it executed."""
    right = lifecycle._repeated_seq

    def wrong(run: Run, command: Predict, now: float) -> Verdict | None:
        sent = run.workers[command.worker_id].request
        if sent is not None and not action_space.action_errors(
            command.actions, run.manifest
        ):
            clipped = action_space.clip_actions(command.actions, run.manifest)
            if clipped == action_space.clip_actions(sent[0], run.manifest):
                command = replace(command, actions=sent[0])
        return right(run, command, now)

    replace_guard(right, wrong)


@mutant("PRED-025")
def compares_repeats_as_text() -> None:
    """A client whose library sorts members differently cannot repeat a turn."""
    right = lifecycle._repeated_seq

    def wrong(run: Run, command: Predict, now: float) -> Verdict | None:
        session = run.workers[command.worker_id]
        is_same = session.request is not None and repr(session.request[0]) == repr(
            command.actions
        )
        if command.seq == session.seq > 0 and not is_same:
            return Refuse("seq_conflict", "Another text.")
        return right(run, command, now)

    replace_guard(right, wrong)


@mutant("PRED-026")
def answers_another_body_during_a_turn() -> None:
    """The client believes its new actions were executed; the old ones were."""
    right = lifecycle._repeated_seq

    def wrong(run: Run, command: Predict, now: float) -> Verdict | None:
        session = run.workers[command.worker_id]
        if session.busy and command.seq == session.seq:
            late.add((session.session_id, session.seq))
            return Wait(session)
        if (session.session_id, command.seq) in late and command.seq == session.seq:
            return Replay(session)
        return right(run, command, now)

    late: set[tuple[str, int]] = set()
    replace_guard(right, wrong)


@mutant("PRED-027")
def says_no_episode_before_it_looks_at_seq() -> None:
    """A client cannot learn that its last turn was another one."""
    guards = list(GUARDS[Predict])
    guards.remove(lifecycle._has_an_episode)

    def wrong(run: Run, command: Predict, now: float) -> Verdict | None:
        session = run.workers[command.worker_id]
        is_repeat = (command.seq, command.actions) == (
            session.seq,
            session.request and session.request[0],
        )
        return None if is_repeat else lifecycle._has_an_episode(run, command, now)

    guards.insert(guards.index(lifecycle._repeated_seq), wrong)
    GUARDS[Predict] = tuple(guards)


@mutant("PRED-007")
def never_says_that_it_stopped_early() -> None:
    """A client believes that its whole chunk was executed."""
    change_turn(lambda body, _: body.update(stopped_early=False))


@mutant("FAULT-012", "PRED-008", "PRED-012")
def forgets_the_result_of_an_episode() -> None:
    """A client learns a score only by another request."""
    change_turn(lambda body, _: body.pop("episode_result", None))


@mutant("ATT-012", "PRED-009", "STOP-004", "SUB-001")
def never_says_done() -> None:
    """A client waits for an observation that never comes."""
    change_turn(lambda body, _: body.update(done=False))


@mutant("LEASE-002", "LEASE-009", "LEASE-010", "PRED-010", "PRED-011", "PRED-027")
def forgets_the_session_with_its_last_turn() -> None:
    """After a lost last answer a client cannot learn how the run ended."""
    right = effects.store_answer

    def wrong(session: Session, turn: dict[str, Any], now: float) -> None:
        right(session, turn, now)
        if session.done:
            session.session_id += "-gone"
            session.expires_at = 0.0

    put(effects, "store_answer", wrong)


@mutant("PRED-011")
def repeats_done_for_any_seq() -> None:
    """A client that does not look at `done` runs for ever."""

    def wrong(run: Run, command: Predict, _now: float) -> Verdict | None:
        session = run.workers[command.worker_id]
        return Replay(session) if session.done else None

    replace_guard(lifecycle._has_an_episode, wrong)


@mutant("PRED-012", "PRED-018")
def returns_only_the_last_observation() -> None:
    """A client that wants every frame of a chunk gets one."""

    def wrong(body: dict[str, Any], _session: Session) -> None:
        if body.get("observations"):
            body["observations"] = body["observations"][-1:]

    change_turn(wrong)


@mutant("CAL-008", "PRED-021")
def sums_the_rewards_of_a_chunk() -> None:
    """Per-step rewards are lost."""

    def wrong(body: dict[str, Any], _session: Session) -> None:
        if len(body["rewards"]) > 1:
            body["rewards"] = [sum(body["rewards"])]

    change_turn(wrong)


@mutant("PRED-022")
def plays_one_worker_at_a_time() -> None:
    """Sixteen workers are as slow as one."""
    right = SessionExecutor._play
    lock = asyncio.Lock()

    async def wrong(self: SessionExecutor, *arguments: Any) -> dict[str, Any]:
        async with lock:
            return await right(self, *arguments)

    put(SessionExecutor, "_play", wrong)


@mutant("PRED-023")
def reports_more_time_than_passed() -> None:
    """Latency reports cannot be trusted."""
    right = turn_view.add_lease_and_total

    def wrong(body: dict[str, Any], session: Session, total_s: float) -> None:
        right(body, session, total_s)
        body["timing"]["simulate_s"] = total_s * 2 + 1

    put(turn_view, "add_lease_and_total", wrong)


@mutant("PRED-020")
def calls_a_truncated_episode_terminated() -> None:
    """A timeout looks like an end that the task decided."""

    def wrong(body: dict[str, Any], _session: Session) -> None:
        if body["truncated"]:
            body.update(truncated=False, terminated=True)

    change_turn(wrong)


def _before_playing(change: Any) -> None:
    """Let `change(values, action_space)` alter every action on its way."""
    right = action_space.clip_actions

    def wrong(actions: Any, manifest: Mapping[str, Any]) -> Any:
        space = manifest["action_space"]
        return right([change(values, space) for values in actions], manifest)

    put(action_space, "clip_actions", wrong)


@mutant("PRED-004")
def expects_a_seq_too_high_during_a_turn() -> None:
    """A client that lost count during a turn never finds the right seq again."""
    right = lifecycle._expected_seq

    def wrong(run: Run, command: Predict, now: float) -> Verdict | None:
        verdict = right(run, command, now)
        if isinstance(verdict, Refuse) and run.workers[command.worker_id].busy:
            wrong_seq = verdict.members["expected_seq"] + 1
            return replace(verdict, members={"expected_seq": wrong_seq})
        return verdict

    replace_guard(right, wrong)
