"""What a server keeps of runs besides the runs: each piece for itself."""

from __future__ import annotations

import pytest

from reference_server.rules.runs.run import Run, Session, SessionEnd
from reference_server.runs.memory import ended_sessions, recent_runs
from reference_server.runs.memory.ended_sessions import EndedSessions
from reference_server.runs.memory.recent_runs import RecentRuns
from reference_server.runs.memory.run_changes import RunChanges
from tests.support.server.server_parts import calibration_run


def _run(run_id: str, *tasks: str) -> Run:
    return calibration_run(*(tasks or ("count",)), run_id=run_id)


def _kept(recent: RecentRuns, runs: dict[str, Run]) -> list[str]:
    """Ids of the runs that only `recent` keeps alive."""
    return [run_id for run_id, run in runs.items() if recent._runs.get(run_id) is run]


# --- recent runs ---


def test_the_run_that_was_used_longest_ago_is_dropped_first(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(recent_runs, "CACHED_RUNS_MAX", 2)
    recent, runs = RecentRuns(), {name: _run(name) for name in "abc"}
    for name in "aba":
        recent.keep(runs[name])
    recent.keep(runs["c"])
    assert _kept(recent, runs) == ["a", "c"]


def test_one_run_of_many_episodes_is_kept_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(recent_runs, "CACHED_EPISODES_MAX", 2)
    recent = RecentRuns()
    runs = {"a": _run("a"), "long": _run("long", *["count"] * 3), "b": _run("b")}
    for run in runs.values():
        recent.keep(run)
    assert _kept(recent, runs) == ["b"]
    recent.keep(runs["long"])
    assert _kept(recent, runs) == ["long"]
    recent.drop("long")
    recent.drop("long")
    for name in "ab":  # nothing is counted of what was dropped
        recent.keep(runs[name])
    assert _kept(recent, runs) == ["a", "b"]


def test_a_run_that_was_read_again_replaces_the_older_copy() -> None:
    recent, newer = RecentRuns(), _run("a")
    recent.keep(_run("a"))
    recent.keep(newer)
    assert _kept(recent, {"a": newer}) == ["a"]


# --- ended sessions ---


def _session(session_id: str, ended_by: SessionEnd | None) -> Session:
    session = Session(session_id, "w", "key", 60.0, 10, 0.0)
    session.ended_by = ended_by
    return session


def test_those_of_the_run_whose_last_one_is_oldest_are_forgotten_first(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(ended_sessions, "SESSIONS_MAX", 3)
    ended = EndedSessions()
    for number, run_id in enumerate("aba"):
        ended.note(run_id, _session(str(number), "detached"))
    ended.note("c", _session("3", None))
    assert [ended.of(run_id) for run_id in "abc"] == [
        {"0": "detached", "2": "detached"},
        {},
        {"3": "unknown"},
    ]
    ended.forget("a")
    ended.forget("a")
    assert (dict(ended.of("a")), len(ended)) == ({}, 1)


def test_a_run_has_the_sessions_that_ended_last(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(ended_sessions, "ENDED_SESSIONS_MAX", 2)
    ended = EndedSessions()
    for name in "abca":
        ended.note("run", _session(name, "lease_ended"))
    assert list(ended.of("run")) == ["c", "a"]
    assert len(ended) == 2


# --- changes ---


async def test_all_who_wait_for_a_run_see_one_change_of_it() -> None:
    changes = RunChanges()
    first, second, other = (changes.next_of(name) for name in "aab")
    assert first is second
    changes.wake("a")
    changes.wake("c")
    assert first.is_set()
    assert not first.is_elsewhere
    assert not other.is_set()
    assert changes.next_of("a") is not first


async def test_those_who_wait_are_sent_to_another_node() -> None:
    changes = RunChanges()
    waiting = [changes.next_of(name) for name in "ab"]
    changes.wake_all(is_elsewhere=True)
    assert [one.is_elsewhere for one in waiting] == [True, True]


async def test_who_waits_no_more_is_forgotten() -> None:
    changes = RunChanges()
    change = changes.next_of("a")
    assert len(changes) == 1
    del change
    assert len(changes) == 0
