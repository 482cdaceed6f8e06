"""Mutants of the profile `attribution`: who played, and what was clipped."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from reference_server.rules import action_space, effects, lifecycle
from reference_server.rules.action_space import Values
from reference_server.rules.lifecycle import Attach, Refuse, Verdict
from reference_server.rules.run import Run, RunHead, Session
from reference_server.views import run_views
from tests.mutants import mutant, put
from tests.mutants.turns.predict import no_guard, replace_guard


@mutant("ATR-001", "ATR-002")
def lets_another_policy_finish_a_run() -> None:
    """A score under the name of a policy is partly that of another."""
    replace_guard(lifecycle._player_is_of_the_run, no_guard)


@mutant("ATR-001")
def compares_names_of_policies_alone() -> None:
    """A run of one version of a policy is finished with another."""
    right = lifecycle._player_is_of_the_run

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        verdict = right(run, command, now)
        is_name = isinstance(verdict, Refuse) and "/player/name" in dict(verdict.errors)
        return verdict if is_name else None

    replace_guard(right, wrong)


@mutant("ATR-002")
def refuses_players_that_leave_their_version_out() -> None:
    """A client that does not know the version of its policy cannot play."""
    right = lifecycle._player_is_of_the_run

    def wrong(run: Run, command: Attach, now: float) -> Verdict | None:
        policy, player = run.submission["policy"], command.player
        is_refused = right(run, command, now) is not None
        if is_refused or player is None or run.any_policy:
            return right(run, command, now)
        if player.get("version") == policy.get("version"):
            return None
        errors = (("/player/version", "must be that of the run"),)
        return Refuse("policy_mismatch", "Another version.", "ATR-001", errors)

    replace_guard(right, wrong)


@mutant("ATR-003")
def names_the_last_player_of_an_episode() -> None:
    """An episode that two policies played counts for the one that ended it."""
    right = effects.open_session

    def wrong(run: Run, command: Attach, *rest: Any) -> Session:
        session = right(run, command, *rest)
        session.attempt_player = command.player
        return session

    put(effects, "open_session", wrong)


@mutant("ATR-003")
def forgets_the_player_after_its_first_episode() -> None:
    """Most results do not say who played them."""
    right = effects.end_turn

    def wrong(run: Run, session: Session, *rest: Any) -> Any:
        ended = right(run, session, *rest)
        if ended is not None:
            session.attempt_player = None
        return ended

    put(effects, "end_turn", wrong)


@mutant("ATR-003")
def compares_the_last_two_players_alone() -> None:
    """An attempt of two policies counts for the one that came back for its end."""
    right = effects.open_session

    def wrong(run: Run, command: Attach, *rest: Any) -> Session:
        old = run.workers.get(command.worker_id)
        session = right(run, command, *rest)
        if old and not old.done and old.player == command.player:
            session.attempt_player = command.player
        return session

    put(effects, "open_session", wrong)


@mutant("ATR-003")
def forgets_after_a_fault_who_played_before() -> None:
    """A policy that broke the simulator is left out of what the next one shows."""
    right = effects.record_fault

    def wrong(run: Run, session: Session, *rest: Any, **named: Any) -> list[Session]:
        session.attempt_player = session.player
        return right(run, session, *rest, **named)

    put(effects, "record_fault", wrong)


@mutant("ATR-004")
def counts_clipped_actions_that_were_not_executed() -> None:
    """A policy with long chunks seems to send more nonsense than it does."""
    right = action_space.count_clipped

    def wrong(sent: Sequence[Values], clipped: Sequence[Values], _executed: int) -> int:
        return right(sent, clipped, len(sent))

    put(action_space, "count_clipped", wrong)


@mutant("ATR-004")
def counts_clipped_actions_of_a_broken_attempt() -> None:
    """After a fault of the simulator, more actions are clipped than executed."""
    right = effects.record_fault

    def wrong(run: Run, session: Session, *rest: Any, **more: Any) -> list[Session]:
        before = session.clipped
        ended = right(run, session, *rest, **more)
        session.clipped = before
        return ended

    put(effects, "record_fault", wrong)


@mutant("ATR-006", "PRED-006")
def adds_up_the_rewards_of_the_last_turn() -> None:
    """The return of an episode depends on the length of the policy's chunks."""
    right = effects.end_turn

    def wrong(run: Run, session: Session, *rest: Any) -> Any:
        session.reward = 0.0
        return right(run, session, *rest)

    put(effects, "end_turn", wrong)


@mutant("ATR-005")
def shows_every_run_as_one_of_a_single_policy() -> None:
    """A score of several policies looks like that of one."""
    right = run_views.run_view

    def wrong(run: RunHead, endpoint: str, position: int | None) -> dict[str, Any]:
        return right(run, endpoint, position) | {"any_policy": False}

    put(run_views, "run_view", wrong)
