"""Mutants of a restart: what it forgets of the runs."""

from __future__ import annotations

import asyncio
from typing import Any

from reference_server.files.seed_secret import SeedSecret
from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import (
    STATES_AFTER_RESTART,
)
from reference_server.rules.runs.run import Run
from reference_server.runs import (
    registry,
)
from reference_server.runs.registry import RunRegistry
from reference_server.runs.run_writer import RunWriter
from reference_server.storage.runs import rows
from reference_server.storage.tables import database_tables
from tests.mutants import instead_of, mutant, put


@mutant("CRASH-001", "CRASH-003", "CRASH-004")
def stores_results_after_sending_them() -> None:
    """A crash loses results that the client has received."""
    right = RunWriter.commit

    async def later(self: RunWriter, run: Run, *checks: Any) -> None:
        await asyncio.sleep(3)
        await right(self, run, *checks)

    async def wrong(self: RunWriter, run: Run, *checks: Any) -> None:
        if not run.changed:
            await right(self, run, *checks)
            return
        self._work.start(later(self, run, *checks))
        self._events.changed(run)

    put(RunWriter, "commit", wrong)


@mutant("CRASH-005")
def leaves_runs_running_on_restart() -> None:
    """No worker plays the run, it says that it is played, and a drain never ends."""
    after: dict[Any, Any] = {**STATES_AFTER_RESTART, "running": "running"}
    put(registry, "STATES_AFTER_RESTART", after)
    right = effects.lose_sessions

    def wrong(run: Run) -> None:
        if run.state != "running":
            right(run)

    put(effects, "lose_sessions", wrong)


@mutant("CRASH-002", "CRASH-004", through=instead_of(rows, "run_of"))
def counts_attempts_over_a_crash(right: Any, *stored: Any) -> Any:
    """A crash of the server uses up an attempt of every running policy."""
    run = right(*stored)
    # Resting runs are read from the store at other times, too.
    is_crash = run.state not in ("stopped", "failed", "completed")
    for episode in run.episodes:
        if is_crash and episode.result is None:
            episode.attempt += 1
    return run


@mutant("CRASH-004", through=instead_of(effects, "expire"))
def stores_no_attempt_that_a_lease_has_ended(
    right: Any, run: Run, now: float, now_wall: float
) -> Any:
    """A policy that disappears when it plays badly gets attempts back by a crash."""
    before = set(run.changed)
    expired = right(run, now, now_wall)
    is_scored = {i for i in run.changed if run.episodes[i].result is not None}
    run.changed &= before | is_scored
    return expired


@mutant("CRASH-003", through=instead_of(RunRegistry, "open"))
async def forgets_idempotency_keys_on_restart(right: Any, self: RunRegistry) -> None:
    """A submit that is repeated after a crash evaluates everything twice."""
    forgotten = database_tables.idempotency_keys.delete()
    await self._store.transactions.write_in_turn(lambda c: c.execute(forgotten))
    await right(self)


@mutant("CRASH-003")
def draws_another_secret_of_seeds_on_restart() -> None:
    """Runs with sealed seeds cannot be compared with those of before a restart."""
    put(SeedSecret, "open", lambda _: None)
