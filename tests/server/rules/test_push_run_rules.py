"""What the rules say of a run that this server plays: who attaches, what a fault of the
policy counts, and how the run fails.
"""

import pytest

from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import (
    Accept,
    Attach,
    Command,
    Detach,
    Heartbeat,
    Predict,
    Refuse,
    decide,
)
from reference_server.rules.runs.run import Run, Session, State
from tests.support.server.runs import ACTION, NOW, add_session, make_run

PUSH = {"mode": "push", "benchmark_id": "calibration", "policy": {"name": "p"}}


def push_run(state: State = "ready", length: int = 3) -> Run:
    return make_run(length, state=state, submission=PUSH)


def session_commands(by_server: bool) -> list[Command]:
    return [
        Predict("w", "session-of-w", 4, [ACTION], by_server=by_server),
        Heartbeat("w", "session-of-w", by_server),
        Detach("w", "session-of-w", by_server),
    ]


def test_commands_for_a_session_of_the_server_are_refused() -> None:
    """A policy server is sent the session's id; it does not play the session."""
    run = push_run("running")
    add_session(run)
    for command in session_commands(by_server=True):
        assert decide(run, command, NOW) == Accept()
    for command in session_commands(by_server=False):
        verdict = decide(run, command, NOW)
        assert isinstance(verdict, Refuse)
        assert (verdict.code, verdict.requirement) == ("illegal_transition", "PUSH-003")
        assert verdict.members == {"state": "running"}


@pytest.mark.parametrize(
    ("by_server", "lease_s"), [(False, 10.0), (True, effects.SERVER_LEASE_S)]
)
def test_a_worker_of_the_server_needs_no_heartbeat(
    by_server: bool, lease_s: float
) -> None:
    run = push_run()
    command = Attach("w", "k", by_server=by_server)
    session = effects.open_session(run, command, "s", NOW)
    assert (session.idle_timeout_s, session.expires_at) == (lease_s, NOW + lease_s)


def add_playing_session(run: Run, worker_id: str = "w", steps: int = 0) -> Session:
    episode = run.take_pending()
    return add_session(run, worker_id, episode=episode, steps=steps)


@pytest.mark.parametrize(("steps", "attempt"), [(0, 1), (4, 2)])
def test_a_fault_of_the_policy_ends_its_attempt(steps: int, attempt: int) -> None:
    """It counts from its first executed action, like any other (EPI-002, EPI-003)."""
    run = push_run()
    session = add_playing_session(run, steps=steps)
    effects.end_by_policy(run, session, "It said nonsense.", NOW)
    episode = run.episodes[0]
    assert (episode.attempt, episode.policy_fault) == (attempt, "It said nonsense.")
    assert run.changed == {0}
    assert sorted(run.pending) == [0, 1, 2]
    assert (run.state, run.workers) == ("ready", {})


def test_a_fault_after_the_last_episode_is_not_recorded() -> None:
    run = push_run()
    session = add_session(run, episode=None, done=True)
    effects.end_by_policy(run, session, "It said nonsense.", NOW)
    assert [e.policy_fault for e in run.episodes] == [None] * 3


def test_a_run_that_cannot_resume_fails_as_not_retryable() -> None:
    run = push_run()
    effects.fail_run(run, "Its key is lost.", NOW, failed_by="server", retryable=False)
    assert (run.state, run.retryable, run.failed_by) == ("failed", False, "server")


@pytest.mark.parametrize("state", ["stopped", "failed", "completed"])
def test_a_run_that_has_ended_does_not_fail_again(state: State) -> None:
    run = push_run(state)
    run.reason, run.retryable = "before", False
    assert effects.fail_run(run, "It is gone.", NOW, failed_by="policy") == []
    assert (run.state, run.reason, run.retryable) == (state, "before", False)
