"""Mutants of deletion: what may be deleted, what is left of it, what is counted."""

from __future__ import annotations

import contextlib
from typing import Any

import sqlalchemy as sa

from reference_server.rules.refusal import Refused
from reference_server.rules.runs import lifecycle
from reference_server.rules.runs.lifecycle import Delete, Refuse
from reference_server.rules.runs.run import Run, RunHead
from reference_server.runs import service
from reference_server.runs.memory.run_events import Departure
from reference_server.runs.run_writer import RunWriter
from reference_server.runs.service import RunService
from reference_server.storage.runs import rows, run_store
from reference_server.storage.runs.run_store import Store
from reference_server.storage.tables import database_tables
from tests.mutants import instead_of, mutant, put
from tests.mutants.server_changes import instead_of_guard, no_guard, replace_guard


@mutant(
    *("DEL-001", "DEL-003", "DEL-004", "DEL-005"),
    through=instead_of_guard(lifecycle._is_not_in_play),
)
def deletes_only_stopped_runs(right: Any, run: Run, command: Delete, now: float) -> Any:
    """A user has to stop a run that no worker plays before it can be removed."""
    if run.state in ("queued", "ready"):
        return Refuse("illegal_transition", "Stop it first.")
    return right(run, command, now)


@mutant("DEL-002")
def deletes_runs_in_play() -> None:
    """A request by mistake destroys an evaluation while it is played."""
    replace_guard(lifecycle._is_not_in_play, no_guard)


@mutant(
    "DEL-003",
    "DEL-008",
    through=instead_of_guard(lifecycle._is_deletable),
    needs={"board"},
)
def says_a_played_run_has_another_state(
    right: Any, run: Run, command: Delete, now: float
) -> Any:
    """A client takes the refusal for one that a stop would cure."""
    refused = right(run, command, now)
    return refused and Refuse("illegal_transition", "It was played.")


@mutant("DEL-008", needs={"board"})
def says_a_published_run_has_another_state() -> None:
    """A client takes the refusal for one that a stop would cure."""

    def wrong() -> Refused:
        return Refused("illegal_transition", "It was published.")

    put(service, "_has_entry", wrong)
    # Otherwise DEL-003 refuses a run that was played before its entry is looked for.
    replace_guard(lifecycle._is_deletable, no_guard)


@mutant("DEL-004", "DEL-005", through=instead_of(RunWriter, "_drop"))
def shows_a_deleted_run_while_it_is_in_memory(
    _right: Any, self: RunWriter, run: Run, why: Departure
) -> None:
    """A run that its user deleted can be read until the server is restarted."""
    self._events.left(run, why)


@mutant(
    *("AUTH-003", "DEL-002", "DEL-003", "DEL-004", "DEL-008", "RUN-010"),
    through=instead_of(RunService, "delete_run"),
    needs={"board"},
)
async def deletes_what_is_deleted(
    right: Any, self: RunService, account: str, run_id: str
) -> None:
    """A user who mistypes an id is not warned."""
    with contextlib.suppress(Refused):
        await right(self, account, run_id)


@mutant("DEL-005", through=instead_of(Store, "delete"))
async def uses_the_key_of_a_deleted_run_again(
    right: Any, self: Store, run: RunHead, now_wall: float, **how: bool
) -> None:
    """A repeat that comes late makes a run that no user wants any more."""
    await right(self, run, now_wall, **how)
    keys = database_tables.idempotency_keys
    again = keys.delete().where(keys.c.run_id == run.run_id)
    await self.transactions.write_in_turn(lambda c: c.execute(again))


@mutant("DEL-006", through=instead_of(run_store, "last_played"))
def counts_what_every_account_has_played(
    _right: Any, connection: sa.Connection, run: RunHead
) -> int:
    """The first run of an account seems to be one of many tries."""
    runs = database_tables.runs.c
    of_benchmark = runs.benchmark_id == run.manifest["benchmark_id"]
    query = sa.select(sa.func.max(runs.played_number)).where(of_benchmark)
    return connection.scalar(query) or 0


@mutant("CRASH-003")
def forgets_on_restart_how_often_was_played() -> None:
    """After a crash of the host, the twentieth try looks like one without a number."""
    names = [name for name in rows._COPIED_COLUMNS if name != "played_number"]
    put(rows, "_COPIED_COLUMNS", tuple(names))
