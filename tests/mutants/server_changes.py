"""Changes of the server that mutants of several files share."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from reference_server.rules.runs.lifecycle import (
    GUARDS,
    Verdict,
)
from reference_server.rules.runs.run import Episode, Run, Session
from reference_server.views import run_views, turn_view
from tests.mutants import put


def replace_guard(guard: Any, other: Any) -> None:
    """Replace one guard wherever it stands."""
    for command, guards in GUARDS.items():
        GUARDS[command] = tuple(other if g is guard else g for g in guards)


def instead_of_guard(guard: Any) -> Callable[[Any], None]:
    """Replace a guard by a function whose first argument is the right one."""
    return lambda wrong: replace_guard(guard, functools.partial(wrong, guard))


def no_guard(_run: Run, _command: Any, _now: float) -> Verdict | None:
    return None


def change_turn(change: Any) -> None:
    """Let `change(body, session)` spoil every turn before it leaves."""
    right = turn_view.turn_view

    def wrong(session: Session, **members: Any) -> Any:
        body = right(session, **members)
        change(body, session)
        return body

    put(turn_view, "turn_view", wrong)


def change_run(change: Any) -> None:
    """Let `change(body, run)` spoil every run that is shown."""
    right: Any = run_views.run_view

    def wrong(run: Run, *rest: Any) -> Any:
        body = right(run, *rest)
        change(body, run)
        return body

    put(run_views, "run_view", wrong)


def change_results(change: Any) -> None:
    """Let `change(result, episode)` spoil the results of lists and of turns."""
    right: Any = run_views.result_view

    def wrong(episode: Episode) -> Any:
        shown = right(episode)
        change(shown, episode)
        return shown

    for module in (run_views, turn_view):
        put(module, "result_view", wrong)
