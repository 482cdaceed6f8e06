"""Every verdict of the protocol: the table as stated, then guard by guard."""

import typing
from typing import Any

import pytest

from reference_server.rules.runs.lifecycle import (
    Accept,
    Attach,
    Command,
    Delete,
    Detach,
    Event,
    Heartbeat,
    NoChange,
    Predict,
    Refuse,
    Replay,
    Resume,
    Stop,
    Wait,
    availability,
    changes_state,
    decide,
    legal,
)
from reference_server.rules.runs.run import Player, Run, State
from tests.support.server.runs import ACTION, NOW, add_session, make_run


def predict(seq: int = 4, *actions: dict[str, list[float]], **changes: Any) -> Predict:
    fields: dict[str, Any] = {"worker_id": "w", "session_id": "session-of-w"}
    fields |= {"seq": seq, "actions": list(actions) or [ACTION]}
    return Predict(**fields | changes)


def expect_refuse(run: Run, command: Command, now: float = NOW) -> Refuse:
    verdict = decide(run, command, now)
    assert isinstance(verdict, Refuse), verdict
    return verdict


# --- commands of the control plane ---


@pytest.mark.parametrize(
    "command", [Attach("w", "key"), Stop("abort"), Stop("drain"), Resume()], ids=str
)
@pytest.mark.parametrize("state", typing.get_args(State))
def test_the_table_decides(state: State, command: Command) -> None:
    run = make_run(state=state, retryable=False, reason="it broke")
    match command:
        case Attach():
            event: Event = "attach_worker"
        case Stop(mode):
            event = "stop_abort" if mode == "abort" else "stop_drain"
        case _:
            event = "resume_run"
    if legal(run, event):
        assert decide(run, command, NOW) == Accept()
        return
    refused = expect_refuse(run, command)
    assert refused.code == "illegal_transition"
    assert refused.members == {"state": state}
    assert ("it broke" in refused.detail) == (state == "failed")


@pytest.mark.parametrize("state", typing.get_args(State))
@pytest.mark.parametrize("is_played", [False, True])
def test_what_may_be_deleted(state: State, is_played: bool) -> None:
    run = make_run(state=state, is_played=is_played)
    run.is_played = is_played
    if state in ("running", "stopping"):
        for command in (Delete(), Delete(may_be_played=True)):
            refused = expect_refuse(run, command)
            assert (refused.code, refused.members) == (
                "illegal_transition",
                {"state": state},
            )
        return
    assert decide(run, Delete(may_be_played=True), NOW) == Accept()
    if is_played:
        assert expect_refuse(run, Delete()).code == "not_deletable"
    else:
        assert decide(run, Delete(), NOW) == Accept()


@pytest.mark.parametrize("state", ["queued", "ready", "stopped", "failed", "completed"])
def test_retention_deletes_what_ended_before_its_time(state: State) -> None:
    """DEL-007: played or not; a run that may still be played is not old."""
    run = make_run(state=state, is_played=True)
    run.is_played = True
    ended = state in ("stopped", "failed", "completed")
    later, same = run.updated_at_wall + 1, run.updated_at_wall
    found = decide(run, Delete(ended_before_wall=later), NOW)
    assert (found == Accept()) == ended
    refused = expect_refuse(run, Delete(ended_before_wall=same))
    assert refused.code == "not_deletable"


# --- attach ---


OVER = {"expires_at": NOW - 1}
DONE = {"done": True, "episode": None}
SAME, OTHER, TAKEOVER = (
    Attach("w", "key"),
    Attach("w", "another"),
    Attach("w", "another", takeover=True),
)


@pytest.mark.parametrize(
    ("held", "command", "expected"),
    [
        (None, SAME, "Accept"),
        # A lost answer to attach costs nothing: the same key gets the same session.
        ({}, SAME, "Replay"),
        ({}, Attach("w", "key", takeover=True), "Replay"),
        ({"busy": "opening"}, SAME, "Wait"),
        (OVER, SAME, "Accept"),
        ({}, Attach("v", "key"), "Accept"),
        # Another key cannot disturb a live session, unless it takes over.
        ({}, OTHER, "worker_busy"),
        ({"busy": "playing"}, OTHER, "worker_busy"),
        ({}, TAKEOVER, "Accept"),
        ({"busy": "playing"}, TAKEOVER, "Wait"),
        (OVER, OTHER, "Accept"),
        (OVER, TAKEOVER, "Accept"),
        # A session that is done blocks no worker, once its last turn is answered.
        (DONE, OTHER, "Accept"),
        (DONE, TAKEOVER, "Accept"),
        (DONE | {"busy": "turning"}, OTHER, "Wait"),
        (DONE | {"busy": "turning"}, TAKEOVER, "Wait"),
    ],
)
def test_a_worker_has_one_session(
    held: dict[str, Any] | None, command: Attach, expected: str
) -> None:
    run = make_run(state="running")
    session = None if held is None else add_session(run, **held)
    verdict = decide(run, command, NOW)
    if isinstance(verdict, Refuse):
        assert (verdict.code, verdict.requirement) == (expected, "ATT-003")
    else:
        assert type(verdict).__name__ == expected
    if isinstance(verdict, Replay | Wait):
        assert verdict.session is session


def test_no_more_workers_than_the_run_may_have() -> None:
    run = make_run(max_workers=2)
    add_session(run, "a")
    add_session(run, "b")
    refused = expect_refuse(run, Attach("c", "key"))
    assert (refused.code, refused.requirement) == ("worker_limit", "ATT-006")


POLICY = {"name": "p", "version": "1"}


@pytest.mark.parametrize(
    ("player", "pointers"),
    [
        (None, []),
        ({"name": "p"}, []),
        ({"name": "p", "version": "1", "client": "c"}, []),
        ({"name": "q", "version": "1"}, ["/player/name"]),
        ({"name": "p", "version": "2"}, ["/player/version"]),
        ({"name": "", "version": ""}, ["/player/name", "/player/version"]),
    ],
)
def test_cannot_attach_for_another_policy(
    player: Player | None, pointers: list[str]
) -> None:
    command = Attach("w", "key", player=player)
    submission: dict[str, Any] = {"benchmark_id": "calibration", "policy": POLICY}
    run = make_run(submission=submission)
    if pointers:
        refused = expect_refuse(run, command)
        assert (refused.code, refused.requirement) == ("policy_mismatch", "ATR-001")
        assert [at for at, _ in refused.errors] == pointers
    else:
        assert decide(run, command, NOW) == Accept()
    run = make_run(submission=submission | {"any_policy": True})
    assert decide(run, command, NOW) == Accept()


# --- sessions ---


def session_commands(session_id: str = "session-of-w") -> list[Command]:
    play = predict(session_id=session_id)
    return [play, Heartbeat("w", session_id), Detach("w", session_id)]


def ended_by_reasons(
    run: Run, session_id: str = "session-of-w", now: float = NOW
) -> list[str]:
    """`ended_by` as predict and heartbeat report it; detach finds nothing to do."""
    play, beat, detach = session_commands(session_id)
    assert decide(run, detach, now) == NoChange()  # DET-002
    refused = [expect_refuse(run, play, now), expect_refuse(run, beat, now)]
    assert {one.code for one in refused} == {"session_ended"}
    return [one.members["ended_by"] for one in refused]


def test_refusals_of_an_ended_session_state_the_reason() -> None:
    run = make_run()
    assert ended_by_reasons(run) == ["unknown", "unknown"]
    run.record_end(add_session(run), "run_stopped")
    run.workers.clear()
    assert ended_by_reasons(run) == ["run_stopped", "run_stopped"]
    add_session(run, session_id="successor")
    assert ended_by_reasons(run) == ["run_stopped", "run_stopped"]


def test_a_session_ends_with_its_lease() -> None:
    run = make_run()
    add_session(run)
    assert ended_by_reasons(run, now=NOW + 10.1) == ["lease_ended", "lease_ended"]


# --- predict: order ---


@pytest.mark.parametrize(
    ("held", "command", "expected"),
    [
        ({}, predict(3), "Replay"),
        ({"busy": "playing"}, predict(3), "Wait"),
        (DONE, predict(3), "Replay"),  # PRED-010
        ({}, predict(3, ACTION, ACTION), "seq_conflict PRED-003"),
        ({}, predict(3, ACTION | {"grip": [0.0]}), "seq_conflict PRED-003"),
        ({}, predict(3, observe="all"), "seq_conflict PRED-003"),
        ({"busy": "playing"}, predict(3, observe="all"), "seq_conflict PRED-003"),
        ({}, predict(4), "Accept"),
        ({"busy": "turning"}, predict(4), "Wait"),
        ({}, predict(1), "seq_out_of_order PRED-004"),
        ({}, predict(2), "seq_out_of_order PRED-004"),
        ({}, predict(5), "seq_out_of_order PRED-004"),
        ({"busy": "playing"}, predict(5), "seq_out_of_order PRED-004"),
        ({}, predict(2**53 - 1), "seq_out_of_order PRED-004"),
        ({"seq": 0, "request": None}, predict(1), "Accept"),
        ({"seq": 0, "request": None}, predict(0), "seq_out_of_order PRED-004"),
        (DONE, predict(4), "no_episode PRED-011"),
        # Who it is comes before the order, and the order before the content.
        ({}, predict(9, {}), "seq_out_of_order PRED-004"),
        (DONE, predict(4, {}), "no_episode PRED-011"),
        ({}, predict(9, {}, session_id="old"), "session_superseded ATT-005"),
    ],
)
def test_a_turn_is_played_once_and_in_order(
    held: dict[str, Any], command: Predict, expected: str
) -> None:
    run = make_run()
    session = add_session(run, **held)
    verdict = decide(run, command, NOW)
    if isinstance(verdict, Refuse):
        assert f"{verdict.code} {verdict.requirement}" == expected
    else:
        assert type(verdict).__name__ == expected
    if isinstance(verdict, Replay | Wait):
        assert verdict.session is session


def test_an_action_must_fit() -> None:
    run = make_run()
    add_session(run)
    refused = expect_refuse(run, predict(4, ACTION, ACTION | {"grip": [2.0]}))
    assert (refused.code, refused.requirement) == ("invalid_request", None)
    assert [at for at, _ in refused.errors] == ["/actions/1/values/grip/0"]


@pytest.mark.parametrize("state", typing.get_args(State))
def test_workers_may_attach_now_later_or_never(state: State) -> None:
    """The states are the table's: attach is legal, or will be with capacity."""
    run = make_run(state=state, retryable=False)
    if legal(run, "attach_worker"):
        expected = "open"
    elif legal(run, "capacity"):
        expected = "waiting"
    else:
        expected = "completed" if state == "completed" else "closed"
    assert availability(run) == expected


# --- all together ---


def test_the_state_comes_before_conventions_and_those_before_workers() -> None:
    wrong = {"control_rate_hz": 99.0}
    run = make_run(max_workers=1)
    add_session(run, "other")
    refused = expect_refuse(run, Attach("w", "another", False, wrong))
    assert refused.code == "convention_mismatch"
    add_session(run)
    assert expect_refuse(run, Attach("w", "another")).code == "worker_busy"
    run.state = "stopping"
    refused = expect_refuse(run, Attach("w", "another", False, wrong))
    assert refused.code == "illegal_transition"


# --- what follows from the table ---


@pytest.mark.parametrize(
    ("state", "retryable", "changes"),
    [
        ("running", None, False),
        ("stopped", None, True),
        ("failed", True, True),
        ("failed", False, False),
        ("completed", None, False),
    ],
)
def test_a_resume_changes_only_runs_that_do_not_go_on(
    state: State, retryable: bool | None, changes: bool
) -> None:
    run = make_run(state=state, retryable=retryable)
    assert changes_state(run, "resume_run") == changes
