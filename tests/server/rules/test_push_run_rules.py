"""What the rules say of a run that this server plays: who attaches, what a fault of the
policy counts, and how the run fails.
"""

import asyncio
import contextlib
import sqlite3
from pathlib import Path

import pytest

from reference_server.rules import effects
from reference_server.rules.lifecycle import (
    Accept,
    Attach,
    Command,
    Detach,
    Heartbeat,
    Predict,
    Refuse,
    decide,
)
from reference_server.rules.run import Run, Session, State
from reference_server.storage.run_store import Store
from tests.support.server.databases import MAKE_UNVERSIONED
from tests.support.server.runs import ACTION, NOW, add_session, make_run

PUSH = {"mode": "push", "benchmark_id": "calibration", "policy": {"name": "p"}}


def push_run(state: State = "ready", length: int = 3) -> Run:
    return make_run(length, state=state, submission=PUSH)


@pytest.mark.parametrize("by_server", [False, True])
@pytest.mark.parametrize("is_push", [False, True])
def test_workers_and_server_attach_only_to_runs_of_their_mode(
    is_push: bool, by_server: bool
) -> None:
    run = push_run() if is_push else make_run()
    verdict = decide(run, Attach("w", "k", by_server=by_server), NOW)
    if is_push == by_server:
        assert verdict == Accept()
    else:
        assert isinstance(verdict, Refuse)
        assert verdict.code == "illegal_transition"
        assert verdict.members == {"state": "ready"}


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


@pytest.mark.parametrize("state", ["queued", "ready", "running", "stopping"])
def test_a_policy_that_cannot_be_called_fails_the_run(state: State) -> None:
    run = push_run()
    session = add_playing_session(run, steps=1)
    other = add_playing_session(run, "v")
    run.state = state
    assert effects.fail_run(run, "It is gone.", NOW) == [session, other]
    assert (run.state, run.reason, run.retryable) == ("failed", "It is gone.", True)
    assert [e.attempt for e in run.episodes] == [2, 1, 1]
    assert set(run.ended.values()) == {"run_failed"}


def test_a_run_that_cannot_resume_fails_as_not_retryable() -> None:
    run = push_run()
    effects.fail_run(run, "Its key is lost.", NOW, retryable=False)
    assert (run.state, run.retryable) == ("failed", False)


@pytest.mark.parametrize("state", ["stopped", "failed", "completed"])
def test_a_run_that_has_ended_does_not_fail_again(state: State) -> None:
    run = push_run(state)
    run.reason, run.retryable = "before", False
    assert effects.fail_run(run, "It is gone.", NOW) == []
    assert (run.state, run.reason, run.retryable) == (state, "before", False)


def test_the_last_attempt_of_the_last_episode_completes_the_run() -> None:
    """When closing an attempt scores the last episode, the run is completed."""
    run = push_run(length=1)
    add_playing_session(run, steps=1).episode = run.episodes[0]
    run.episodes[0].attempt = 2
    effects.fail_run(run, "It is gone.", NOW)
    result = run.episodes[0].result
    assert result is not None
    assert (run.state, result.outcome) == ("completed", "abandoned")


def test_an_older_database_gets_the_policy_fault_column(tmp_path: Path) -> None:
    path = tmp_path / "x.sqlite"

    async def open_store() -> None:
        store = Store(f"sqlite+aiosqlite:///{path}")
        await store.open()
        await store.close()

    asyncio.run(open_store())
    with contextlib.closing(sqlite3.connect(path)) as database:
        for statement in MAKE_UNVERSIONED:
            database.execute(statement)
        database.execute("ALTER TABLE episodes DROP COLUMN policy_fault")
        database.commit()
        for _ in range(2):
            asyncio.run(open_store())
            columns = database.execute("PRAGMA table_info(episodes)").fetchall()
            assert [c[1] for c in columns].count("policy_fault") == 1
