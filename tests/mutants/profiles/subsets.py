"""Mutants of the profile `subsets`: runs of a part of a benchmark."""

from __future__ import annotations

from typing import Any

from reference_server.rules import submission
from reference_server.rules.manifest import Manifest
from reference_server.rules.runs import effects
from reference_server.rules.runs.run import Run, RunHead, Session
from reference_server.rules.submission import Selection
from reference_server.views import run_views
from tests.mutants import instead_of, mutant


@mutant(
    "SUB-001", "SUB-002", "SUB-004", through=instead_of(submission, "select_episodes")
)
def reads_the_tasks_of_a_selection_alone(
    right: Any, manifest: Manifest, select: Selection | None
) -> Any:
    """A run of the test split plays all splits."""
    return right(manifest, {k: v for k, v in (select or {}).items() if k == "tasks"})


@mutant("SUB-003", through=instead_of(run_views, "score_view"))
def conceals_in_the_score_that_it_is_of_a_part(
    right: Any, run: RunHead, *rest: Any
) -> Any:
    """The score of an easy task looks like that of the benchmark."""
    return {k: v for k, v in right(run, *rest).items() if k != "select"}


@mutant("SUB-005", through=instead_of(Run, "take_pending"))
def begins_an_episode_that_its_client_does_not_want(
    right: Any, self: Run, _first: Any = None
) -> Any:
    """A person prepares a robot, which moves, for a trial that no policy plays."""
    return right(self)


@mutant("SUB-005", through=instead_of(effects, "end_turn"))
def bounds_the_episodes_of_the_run_and_not_of_the_session(
    right: Any, run: Run, session: Session, *rest: Any
) -> Any:
    """A colleague's smoke test ends the run that others play to its end."""
    bounds = [s.first_episodes for s in run.workers.values() if s.first_episodes]
    session.first_episodes = min(bounds, default=None)
    return right(run, session, *rest)
