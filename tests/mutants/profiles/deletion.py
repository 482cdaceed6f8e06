"""Mutants of deletion: what may be deleted, what is left of it, what is counted."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from typing import Any

import sqlalchemy as sa

from reference_server.rules import effects, lifecycle
from reference_server.rules.lifecycle import Attach, Delete, Refuse, Verdict
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run, RunHead, Session
from reference_server.runs import service
from reference_server.runs.registry import RunRegistry
from reference_server.runs.service import RunService
from reference_server.storage import database_tables, rows, store
from reference_server.storage.store import Store
from reference_server.views import run_views
from tests.mutants import mutant, put

Guard = Callable[[Run, Any, float], Verdict | None]


def put_guards(*guards: Guard) -> None:
    """Let these decide whether a run may be deleted."""
    lifecycle.GUARDS[Delete] = guards


@mutant("DEL-001", "DEL-003", "DEL-004", "DEL-005")
def deletes_only_stopped_runs() -> None:
    """A user has to stop a run that no worker plays before it can be removed."""
    right = lifecycle._is_not_in_play

    def wrong(run: Run, command: Delete, now: float) -> Verdict | None:
        if run.state in ("queued", "ready"):
            return Refuse("illegal_transition", "Stop it first.")
        return right(run, command, now)

    put_guards(wrong, lifecycle._is_deletable)


@mutant("DEL-001", "DEL-002")
def counts_an_attach_as_an_action() -> None:
    """A run to which a worker attached by mistake can never be removed."""
    right = effects.open_session

    def wrong(run: Run, command: Attach, session_id: str, now: float) -> Session:
        session = right(run, command, session_id, now)
        if session.episode is not None:
            run.is_played = True
        return session

    put(effects, "open_session", wrong)


@mutant("DEL-002")
def deletes_runs_in_play() -> None:
    """A request by mistake destroys an evaluation while it is played."""
    put_guards(lifecycle._is_deletable)


@mutant("DEL-003", "DEL-008")
def says_a_played_run_has_another_state() -> None:
    """A client takes the refusal for one that a stop would cure."""
    right = lifecycle._is_deletable

    def wrong(run: Run, command: Delete, now: float) -> Verdict | None:
        refused = right(run, command, now)
        return refused and Refuse("illegal_transition", "It was played.")

    put_guards(lifecycle._is_not_in_play, wrong)


@mutant("DEL-008")
def says_a_published_run_has_another_state() -> None:
    """A client takes the refusal for one that a stop would cure."""

    def wrong() -> Refused:
        return Refused("illegal_transition", "It was published.")

    put(service, "_has_entry", wrong)
    # Else DEL-003 refuses what was played before its entry is looked at.
    put_guards(lifecycle._is_not_in_play)


@mutant("DEL-004", "DEL-005")
def shows_a_deleted_run_while_it_is_in_memory() -> None:
    """What a user deleted can be read until the server is restarted."""

    def wrong(self: RunRegistry, run: Run) -> None:
        self._index_by_state(run, None)

    put(RunRegistry, "_forget", wrong)


@mutant("AUTH-003", "DEL-002", "DEL-003", "DEL-004", "DEL-008")
def deletes_what_is_deleted() -> None:
    """A user who mistypes an id is not warned."""
    right = RunService.delete_run

    async def wrong(self: RunService, account: str, run_id: str) -> None:
        with contextlib.suppress(Refused):
            await right(self, account, run_id)

    put(RunService, "delete_run", wrong)


@mutant("DEL-005")
def uses_the_key_of_a_deleted_run_again() -> None:
    """A repeat that comes late makes a run that no user wants any more."""
    right = Store.delete

    async def wrong(self: Store, run: RunHead, now_wall: float, **how: bool) -> None:
        await right(self, run, now_wall, **how)
        async with self._write_lock, self._transaction() as connection:
            keys = database_tables.idempotency_keys
            await connection.execute(keys.delete().where(keys.c.run_id == run.run_id))

    put(Store, "delete", wrong)


@mutant("DEL-006")
def counts_what_was_only_submitted() -> None:
    """Who submitted by mistake seems to have tried often."""
    right = run_views.run_view

    def wrong(run: RunHead, endpoint: str, position: int | None) -> Any:
        view = right(run, endpoint, position)
        if "runs_played_before" in view and run.attempts_by_submitter:
            view["runs_played_before"] = run.attempts_by_submitter - 1
        return view

    put(run_views, "run_view", wrong)


@mutant("DEL-006")
def counts_only_what_is_played_at_its_end() -> None:
    """A run in play does not say how often its submitter has tried before."""
    right = run_views.run_view

    def wrong(run: RunHead, endpoint: str, position: int | None) -> Any:
        view = right(run, endpoint, position)
        if run.state != "completed":
            view.pop("runs_played_before", None)
        return view

    put(run_views, "run_view", wrong)


@mutant("DEL-006")
def counts_what_every_account_has_played() -> None:
    """The first run of an account seems to be one of many tries."""

    def wrong(run: RunHead) -> sa.Select[Any]:
        runs = database_tables.runs.c
        of_benchmark = runs.benchmark_id == run.manifest["benchmark_id"]
        return sa.select(sa.func.max(runs.played_number)).where(of_benchmark)

    put(store, "_last_played", wrong)


@mutant("CRASH-003")
def forgets_on_restart_how_often_was_played() -> None:
    """After a crash of the host, the twentieth try looks like one without a number."""
    names = [name for name in rows._COPIED_COLUMNS if name != "played_number"]
    put(rows, "_COPIED_COLUMNS", tuple(names))
