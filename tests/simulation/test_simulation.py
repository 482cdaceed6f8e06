"""The right server keeps its promises in every schedule; a broken one is noticed."""

from __future__ import annotations

import logging
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from reference_server.rules.runs import lifecycle
from reference_server.rules.runs.lifecycle import Predict, Replay, Wait
from reference_server.rules.runs.run import Run
from reference_server.runs.run_reader import RunReader
from reference_server.runs.run_writer import RunWriter
from reference_server.runs.sessions.session_resources import ResourceManager
from tests.simulation.schedule import play_schedule
from tests.support.paths import ROOT

# Enough for each broken server below to be noticed, several times over: the rarest is
# wrong in one schedule of a hundred. The first that is wrong ends the search.
SCHEDULES = 1000


@pytest.fixture(autouse=True)
def no_log() -> Iterator[None]:
    """Simulated servers fail all the time, and say so."""
    logging.disable(logging.CRITICAL)
    yield
    logging.disable(logging.NOTSET)


def first_finding(seeds: range = range(SCHEDULES)) -> str | None:
    """What was wrong in the first schedule in which something was."""
    for seed in seeds:
        outcome = play_schedule(seed)
        if outcome.wrong:
            return f"seed {seed}: {outcome.wrong[0]}"
    return None


@pytest.mark.slow("hundreds of schedules")
def test_schedules_keep_every_promise() -> None:
    """`python -m tests.simulation --first SEED --schedules 1` plays one again."""
    assert first_finding(range(200)) is None


def test_a_schedule_has_what_it_promises() -> None:
    """Kills, actions and repeated requests happen, so that there is much to judge."""
    outcomes = [play_schedule(seed) for seed in range(5)]
    assert sum(outcome.kills for outcome in outcomes) >= 3
    assert sum(outcome.actions for outcome in outcomes) >= 50


@pytest.mark.slow("imports the server in a new interpreter")
def test_a_seed_gives_the_same_schedule_in_another_process() -> None:
    """Other hashes of strings, other schedules before it."""
    program = (
        "import logging; logging.disable(50)\n"
        "from tests.simulation.schedule import play_schedule\n"
        "print(*[play_schedule(seed).digest for seed in (4, 3)])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=ROOT,
        env=os.environ | {"PYTHONHASHSEED": "7"},
        capture_output=True,
        text=True,
        check=True,
    )
    here = [play_schedule(seed).digest for seed in (3, 4)]
    assert done.stdout.split() == here[::-1]


# --- broken servers: each is noticed ---


def answer_before_it_is_stored(patch: pytest.MonkeyPatch) -> None:
    async def commit(self: RunWriter, run: Run) -> None:
        self.commit_later(run)

    patch.setattr(RunWriter, "commit", commit)


def show_what_is_not_stored(patch: pytest.MonkeyPatch) -> None:
    async def render(_self: object, run: Run, view: Callable[[Run], Any]) -> Any:
        return view(run)

    patch.setattr(RunReader, "render_when_stored", render)


def go_on_after_a_failed_write(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(RunWriter, "_drop_and_reload", lambda _self, _run, _why: None)


def execute_a_repeat_again(patch: pytest.MonkeyPatch) -> None:
    def play_again(verdict: Any) -> Any:
        return None if isinstance(verdict, Replay) else verdict

    right = lifecycle._repeated_seq
    replace_guard(patch, "_repeated_seq", lambda *given: play_again(right(*given)))
    expected = lifecycle._expected_seq

    def expect_repeats(run: Run, command: Predict, now: float) -> Any:
        session = run.workers[command.worker_id]
        return None if command.seq == session.seq else expected(run, command, now)

    replace_guard(patch, "_expected_seq", expect_repeats)


def execute_a_repeat_beside_the_first(patch: pytest.MonkeyPatch) -> None:
    right = lifecycle._repeated_seq

    def do_not_wait(run: Run, command: Predict, now: float) -> Any:
        verdict = right(run, command, now)
        return lifecycle.Accept() if isinstance(verdict, Wait) else verdict

    replace_guard(patch, "_repeated_seq", do_not_wait)


def keep_the_simulators_of_ended_sessions(patch: pytest.MonkeyPatch) -> None:
    def keep(self: ResourceManager, sessions: Any, **_: Any) -> None:
        for session in sessions:
            self._remove(session)

    patch.setattr(ResourceManager, "release_sessions", keep)


def admit_every_worker(patch: pytest.MonkeyPatch) -> None:
    replace_guard(patch, "_below_worker_limit", lambda *_: None)


def replace_guard(
    patch: pytest.MonkeyPatch, name: str, wrong: Callable[..., Any]
) -> None:
    """In the table of guards, where the module's name would not be looked up again."""
    right = getattr(lifecycle, name)
    for command, guards in lifecycle.GUARDS.items():
        changed = tuple(wrong if guard is right else guard for guard in guards)
        patch.setitem(lifecycle.GUARDS, command, changed)


BROKEN = (
    answer_before_it_is_stored,
    show_what_is_not_stored,
    go_on_after_a_failed_write,
    execute_a_repeat_again,
    execute_a_repeat_beside_the_first,
    keep_the_simulators_of_ended_sessions,
    admit_every_worker,
)


@pytest.mark.slow("schedules until one is wrong")
@pytest.mark.release("servers that are broken in storage, played in virtual time")
@pytest.mark.parametrize("break_server", BROKEN, ids=lambda one: one.__name__)
def test_a_broken_server_is_noticed(
    break_server: Callable[[pytest.MonkeyPatch], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    break_server(monkeypatch)
    assert first_finding() is not None
