"""What commands and events do to a run: each effect by itself."""

from dataclasses import dataclass
from typing import Any

import pytest

from reference_server.rules.runs import effects
from reference_server.rules.runs import run as run_state
from reference_server.rules.runs.effects import ChunkOutcome
from reference_server.rules.runs.lifecycle import Attach, Predict
from reference_server.rules.runs.run import (
    Leaving,
    Player,
    Result,
    Run,
    Session,
    State,
)
from reference_server.views.turn_view import turn_view
from tests.support.server.runs import ACTION, NOW, add_session, make_run

WALL = 5000.0


@dataclass(frozen=True)
class Played:
    executed: int
    rewards: tuple[float, ...]
    ended: bool
    terminated: bool
    truncated: bool
    success: bool
    score: float


def chunk_result(
    executed: int = 1, *, ended: bool = False, **changes: Any
) -> ChunkOutcome:
    facts = {"terminated": ended, "truncated": False, "success": False, "score": 0.5}
    rewards = (0.5,) * executed
    return Played(executed, rewards, ended, **facts | changes)


def start_session(run: Run, worker_id: str = "w") -> Session:
    session = effects.open_session(run, Attach(worker_id, "key"), "s", NOW)
    effects.store_answer(session, turn_view(session, observation=None), NOW)
    return session


def play_turn(
    run: Run, session: Session, outcome: ChunkOutcome
) -> run_state.Episode | None:
    command = Predict(session.worker_id, session.session_id, session.seq + 1, [ACTION])
    effects.begin_turn(session, command, NOW)
    ended = effects.end_turn(run, session, outcome, WALL)
    effects.store_answer(session, turn_view(session, observation=None), NOW)
    return ended


# --- sessions ---


def restored(run: Run, index: int | None, worker: str = "w") -> tuple[bool, Session]:
    """A session that a restart has found, with the episode that it had, if any."""
    session = Session("s", worker, "key", 60.0, 10, NOW)
    session.episode = None if index is None else run.episodes[index]
    return effects.restore_session(run, session), session


def test_a_session_goes_on_after_a_restart_with_its_episode() -> None:
    run = make_run(3)
    is_restored, session = restored(run, 1)
    assert is_restored
    assert run.state == "running"
    assert run.live_sessions == [session]
    assert (run.pending, run.episodes[1].in_progress) == ([0, 2], True)
    is_restored, between = restored(run, None, "between")
    assert is_restored
    assert between.episode is run.episodes[0]
    assert start_session(run, "new").episode is run.episodes[2]


def test_a_session_that_may_not_go_on_changes_nothing() -> None:
    run = make_run(2, max_workers=3)
    taken = start_session(run, "w")
    assert not restored(run, 1, "w")[0], "another session has the worker"
    assert not restored(run, 0, "x")[0], "another session has the episode"
    assert restored(run, 1, "x")[0]
    assert not restored(run, None, "y")[0], "no episode is left"
    effects.close_session(run, taken, "detached", WALL)
    run.max_workers = 1
    assert not restored(run, 0, "y")[0], "the run has its workers"
    stopped = make_run(2, state="stopped")
    assert not restored(stopped, 0)[0]
    assert stopped.state == "stopped"


def test_attach_with_nothing_left_is_done_at_once() -> None:
    run = make_run(1)
    start_session(run, "a")
    late = start_session(run, "b")
    assert late.done
    assert late.episode is None
    assert run.state == "running"


@pytest.mark.parametrize(
    ("first", "played"), [(1, [0]), (2, [0, 1]), (9, [0, 1, 2]), (None, [0, 1, 2])]
)
def test_a_session_begins_the_first_episodes_that_are_wanted(
    first: int | None, played: list[int]
) -> None:
    """The rest of the run stays for others, also behind a restart."""
    run = make_run(3, max_workers=2)
    bounded = Attach("w", "key", first_episodes=first)
    session = effects.open_session(run, bounded, "session", NOW)
    for _ in played:
        assert not session.done
        play_turn(run, session, chunk_result(1, ended=True))
    assert session.done
    assert [e.index for e in run.episodes if e.result] == played
    assert run.state == ("ready" if run.pending else "completed")
    found = Session("s", "v", "key", 60.0, 10, NOW, first_episodes=first)
    assert not effects.restore_session(run, found)


# --- episodes ---


def attach_as(run: Run, player: Player | None) -> Session:
    """A session of worker `w`; a live one is taken over."""
    command = Attach("w", "key", takeover=True, player=player)
    return effects.open_session(run, command, "session", NOW)


def test_a_result_has_the_player_of_its_attempt() -> None:
    run = make_run(4)
    one, other = Player(name="one"), Player(name="other")
    ended = chunk_result(1, ended=True)
    play_turn(run, attach_as(run, one), ended)
    play_turn(run, attach_as(run, other), ended)
    play_turn(run, attach_as(run, other), ended)
    attach_as(run, one)
    play_turn(run, attach_as(run, other), ended)
    players = [e.result.player if e.result else None for e in run.episodes]
    assert players == [one, None, other, None]


def test_a_reason_is_stored_when_it_is_another_one() -> None:
    """RSN-001: that of a session without an episode belongs to none."""
    run = make_run(state="running")
    playing = add_session(run, episode=run.take_pending())
    done = add_session(run, "v", episode=None, done=True)
    given = [(playing, "a"), (playing, "a"), (playing, None), (playing, "b")]
    stored = [effects.note_reason(run, *one) for one in (*given, (done, "c"))]
    assert stored == [True, False, False, True, False]
    left = Leaving(1, "b")
    assert [e.last_left for e in run.episodes] == [left, *[None] * (run.total - 1)]
    assert run.changed == {0}


def test_an_old_session_cannot_close_its_successor() -> None:
    run = make_run()
    old = start_session(run)
    new = effects.open_session(run, Attach("w", "b", True), "s2", NOW)
    old.episode = None
    effects.close_session(run, old, "unknown", WALL)
    assert run.workers == {"w": new}


def test_expire_does_not_report_a_session_that_is_done() -> None:
    run = make_run(1)
    session = start_session(run)
    play_turn(run, session, chunk_result(1, ended=True))
    assert effects.expire(run, NOW + 99, WALL) == ([session], False)
    assert run.workers == {}


def test_a_stop_after_the_last_turn_costs_the_next_episode_no_attempt() -> None:
    """The result is being stored: the next episode is in hand, and not begun."""
    run = make_run()
    session = start_session(run)
    effects.begin_turn(session, Predict("w", "s", 1, [ACTION]), NOW)
    effects.end_turn(run, session, chunk_result(1, ended=True), WALL)
    assert session.episode is run.episodes[1]
    effects.stop(run, "abort", WALL)
    assert [e.attempt for e in run.episodes] == [1, 1, 1]


# --- stop and resume ---


def test_a_resume_queues_the_run_and_forgives_faults() -> None:
    run = make_run(
        3, state="failed", retryable=True, failed_by="policy", reason="It broke."
    )
    scored = Result("success", 1.0, 1, 1, True, False, 0.0, WALL)
    run.episodes[0].faults, run.episodes[0].result = 1, scored
    run.episodes[1].faults = 2
    effects.resume(run, WALL + 3)
    assert (run.state, run.reason, run.retryable) == ("queued", None, None)
    assert run.failed_by is None
    assert run.queue_until_wall == WALL + 3
    assert [e.faults_forgiven for e in run.episodes] == [0, 2, 0]
    assert run.changed == {1}


@pytest.mark.parametrize("state", ["queued", "ready", "running"])
def test_a_resume_of_an_active_run_changes_nothing(state: State) -> None:
    run = make_run(state=state)
    effects.resume(run, WALL + 3)
    assert (run.state, run.queue_until_wall) == (state, 0.0)


# --- faults ---


@pytest.mark.parametrize(("unplayable", "faults"), [(False, 2), (True, 1)])
def test_a_fault_too_many_fails_the_run(unplayable: bool, faults: int) -> None:
    run = make_run()
    a, b = start_session(run, "a"), start_session(run, "b")
    play_turn(run, b, chunk_result())
    for _ in range(faults):
        ended = effects.record_fault(
            run, a, "died", unplayable=unplayable, now_wall=WALL
        )
    assert ended == [a, b]
    assert (run.state, run.retryable) == ("failed", not unplayable)
    assert run.failed_by == "simulator"
    assert "e0000" in (run.reason or "")
    assert "died" in (run.reason or "")
    assert ("cannot be played" in (run.reason or "")) == unplayable
    assert (a.ended_by, b.ended_by, run.workers) == ("run_failed", "run_failed", {})
    assert a.done
    assert b.done
    assert [e.attempt for e in run.episodes] == [1, 1, 1]


@pytest.mark.parametrize(
    ("simulator", "advice"),
    [
        ({}, ""),
        ({"sources": {}}, ""),
        ({"sources": {"lab.py": "0f"}}, "submit another run"),
    ],
)
def test_an_environment_with_files_is_mended_by_another_run(
    simulator: Any, advice: str
) -> None:
    """A mended file has another digest, so going on with this run cannot succeed."""
    run = make_run()
    run.manifest["simulator"] = simulator
    session = start_session(run)
    effects.record_fault(run, session, "died", unplayable=True, now_wall=WALL)
    assert run.reason is not None
    assert advice in run.reason
    assert run.reason.endswith("died") == (not advice)


@pytest.mark.parametrize(
    ("forgiven", "said"),
    [
        (0, "Episode e0000 faulted 2 times: died"),
        (3, "Episode e0000 faulted 2 times since its run was resumed, 5 in all: died"),
    ],
)
def test_the_reason_counts_the_faults_that_failed_the_run(
    forgiven: int, said: str
) -> None:
    run = make_run()
    run.episodes[0].faults = run.episodes[0].faults_forgiven = forgiven
    session = start_session(run)
    for _ in range(run.manifest["max_faults"]):
        effects.record_fault(run, session, "died", unplayable=False, now_wall=WALL)
    assert (run.state, run.reason) == ("failed", said)


# --- the queue ---


def test_a_lease_does_not_run_while_it_is_held() -> None:
    """PHY-014: it begins anew when the person has judged."""
    run = make_run()
    session = start_session(run)
    session.busy = None
    long_after = session.expires_at + 1000
    effects.hold_lease(session, True, NOW)
    assert effects.expire(run, long_after, WALL).closed == []
    effects.hold_lease(session, False, long_after)
    assert session.expires_at == long_after + run.idle_timeout_s
    late = session.expires_at + 1
    assert effects.expire(run, late, WALL).closed == [session]


def test_a_void_attempt_is_a_fault_that_is_forgiven() -> None:
    """PHY-016: however often a trial is void, the run does not fail."""
    run = make_run()
    session = start_session(run)
    play_turn(run, session, chunk_result(2))
    for _ in range(run.manifest["max_faults"] + 1):
        effects.void_attempt(run, session)
    episode = run.episodes[0]
    assert (session.steps, episode.attempt, run.state) == (0, 1, "running")
    assert episode.faults == episode.faults_forgiven == run.manifest["max_faults"] + 1
    assert (run.changed, session.busy) == ({0}, "turning")


def test_a_queued_run_is_admitted_when_its_time_has_come() -> None:
    run = make_run(state="queued", queue_until_wall=WALL + 1)
    states = [(effects.admit(run, WALL + s), run.state) for s in (0, 1)]
    assert states == [(False, "queued"), (True, "ready")]


# --- a lease without turns ---


def test_what_is_no_turn_extends_a_lease_for_a_time_only() -> None:
    session = start_session(make_run())
    play_turn(make_run(), session, chunk_result())
    session.answered_at = NOW
    session.expires_at = NOW + 10
    effects.extend_without_turn(session, NOW + 9, 60)
    assert session.expires_at == NOW + 19
    effects.extend_without_turn(session, NOW + 55, 60)
    assert session.expires_at == NOW + 60
    session.expires_at = NOW + 70  # what was promised holds
    effects.extend_without_turn(session, NOW + 65, 60)
    assert session.expires_at == NOW + 70


def test_a_turn_in_execution_is_one() -> None:
    session = start_session(make_run())
    session.busy, session.answered_at = "playing", NOW - 100
    effects.extend_without_turn(session, NOW, 60)
    assert session.expires_at == NOW + session.idle_timeout_s


def test_the_number_of_remembered_ended_sessions_is_bounded() -> None:
    run = make_run()
    for number in range(run_state.ENDED_SESSIONS_MAX + 1):
        run.record_end(Session(f"s{number}", "w", "k", 1.0, 1, NOW), "detached")
    assert len(run.ended) == run_state.ENDED_SESSIONS_MAX
    assert "s0" not in run.ended
    assert "s1" in run.ended


# --- what a restart or a lost run does ---


@pytest.mark.parametrize(
    ("state", "before", "after", "reason"),
    [
        ("running", None, "ready", "The sessions ended without a result."),
        ("stopping", "Maintenance.", "stopped", "Maintenance."),
        ("ready", None, "ready", None),
    ],
)
def test_a_run_that_was_loaded_has_no_session(
    state: State, before: str | None, after: State, reason: str | None
) -> None:
    run = make_run(state=state, reason=before)
    effects.lose_sessions(run)
    assert (run.state, run.reason) == (after, reason)


def test_an_aborted_session_counts_no_attempt_and_needs_no_write() -> None:
    run = make_run()
    session = start_session(run)
    play_turn(run, session, chunk_result())
    assert not effects.abort_session(run, session, WALL)
    assert (run.state, run.episodes[0].attempt, run.changed) == ("ready", 1, set())
    assert session.ended_by == "unknown"


def test_an_aborted_session_of_a_stopping_run_needs_a_write() -> None:
    run = make_run()
    session = start_session(run)
    effects.stop(run, "drain", WALL)
    assert effects.abort_session(run, session, WALL)
    drained = "Stopped by its submitter, after the episodes in progress."
    assert (run.state, run.reason) == ("stopped", drained)


@pytest.mark.parametrize(("limit", "outcome"), [(3, "abandoned"), (4, None)])
def test_a_session_may_have_a_limit_of_attempts_of_its_own(
    limit: int, outcome: str | None
) -> None:
    """EBE-030: whatever the manifest's; the attempts are counted all the same."""
    run = make_run()
    episode = run.take_pending()
    assert episode is not None
    episode.attempt = 3
    session = add_session(run, episode=episode, steps=1, max_attempts=limit)
    effects.close_session(run, session, "detached", NOW)
    assert (episode.result and episode.result.outcome) == outcome
    assert episode.attempt == (3 if outcome else 4)


def test_only_the_first_action_is_the_first() -> None:
    run = make_run()
    assert [effects.mark_played(run), effects.mark_played(run)] == [True, False]
    assert not effects.mark_played(make_run(played_number=3))
