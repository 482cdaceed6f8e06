"""Mutants of the profile `attribution`: who played, and what was clipped."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from reference_server.rules.runs import action_space, effects, lifecycle
from reference_server.rules.runs.action_space import Values
from reference_server.rules.runs.lifecycle import Attach
from reference_server.rules.runs.run import Run, RunHead, Session
from reference_server.views import run_views
from tests.mutants import instead_of, mutant
from tests.mutants.server_changes import no_guard, replace_guard


@mutant("ATR-001", "ATR-002")
def lets_another_policy_finish_a_run() -> None:
    """A score under the name of a policy is partly that of another."""
    replace_guard(lifecycle._player_is_of_the_run, no_guard)


@mutant("ATR-003", through=instead_of(effects, "open_session"))
def names_the_last_player_of_an_episode(
    right: Any, run: Run, command: Attach, *rest: Any
) -> Any:
    """An episode that two policies played counts for the one that ended it."""
    session = right(run, command, *rest)
    session.attempt_player = command.player
    return session


@mutant("ATR-004", through=instead_of(action_space, "count_clipped"))
def counts_clipped_actions_that_were_not_executed(
    right: Any, sent: Sequence[Values], clipped: Sequence[Values], _executed: int
) -> Any:
    """A policy with long chunks seems to send more nonsense than it does."""
    return right(sent, clipped, len(sent))


@mutant("ATR-006", "PRED-006", through=instead_of(effects, "end_turn"))
def adds_up_the_rewards_of_the_last_turn(
    right: Any, run: Run, session: Session, *rest: Any
) -> Any:
    """The return of an episode depends on the length of the policy's chunks."""
    session.reward = 0.0
    return right(run, session, *rest)


@mutant("ATR-005", through=instead_of(run_views, "run_view"))
def shows_every_run_as_one_of_a_single_policy(
    right: Any, run: RunHead, endpoint: str, position: int | None
) -> Any:
    """A score of several policies looks like that of one."""
    return right(run, endpoint, position) | {"any_policy": False}
