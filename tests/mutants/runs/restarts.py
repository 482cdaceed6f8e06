"""Mutants of a restart: what they forget of the runs."""

from __future__ import annotations

from typing import Any, TypedDict

import msgspec
import sqlalchemy as sa

from reference_server.rules import effects
from reference_server.rules.lifecycle import ACTIVE_STATES, STATES_AFTER_RESTART
from reference_server.rules.run import Run
from reference_server.runs import registry
from reference_server.runs.registry import RunRegistry
from reference_server.storage import database_tables, rows
from reference_server.system.seed_secret import SeedSecret
from tests.mutants import mutant, put


@mutant("CRASH-003")
def forgets_idempotency_keys_on_restart() -> None:
    """A submit that is repeated after a crash evaluates everything twice."""
    right = RunRegistry.open

    async def wrong(self: RunRegistry) -> None:
        async with self._store._transaction() as connection:
            await connection.execute(database_tables.idempotency_keys.delete())
        await right(self)

    put(RunRegistry, "open", wrong)


@mutant("CRASH-003")
def lists_stored_runs_without_their_selection() -> None:
    """A part of a benchmark looks like all of it, in the list alone."""
    names = [
        name for name in rows._ListedSubmission.__annotations__ if name != "select"
    ]
    listed = TypedDict("listed", dict.fromkeys(names, Any), total=False)  # type: ignore[misc]
    put(rows, "_LISTED_SUBMISSION", msgspec.json.Decoder(listed))


@mutant("CRASH-001", "CRASH-002", "CRASH-003", "CRASH-004")
def cannot_read_its_own_data() -> None:
    """After a crash a host has no server any more, and submitters have no scores."""
    right = RunRegistry.open

    async def wrong(self: RunRegistry) -> None:
        await right(self)
        if await self._store.in_states(*ACTIVE_STATES):
            raise ValueError("runs that cannot be read")

    put(RunRegistry, "open", wrong)


@mutant("CRASH-003", "CRASH-004")
def starts_stopped_runs_on_restart() -> None:
    """A run that its submitter stopped can be played again after a crash."""
    after: dict[Any, Any] = {**STATES_AFTER_RESTART, "stopped": "ready"}
    put(registry, "STATES_AFTER_RESTART", after)


@mutant("CRASH-002")
def leaves_runs_running_on_restart() -> None:
    """No worker plays the run, it says that it is played, and a drain never ends."""
    after: dict[Any, Any] = {**STATES_AFTER_RESTART, "running": "running"}
    put(registry, "STATES_AFTER_RESTART", after)
    right = effects.lose_sessions

    def wrong(run: Run) -> None:
        if run.state != "running":
            right(run)

    put(effects, "lose_sessions", wrong)


@mutant("CRASH-004")
def forgets_a_drain_on_restart() -> None:
    """A run that was to stop is played on after a crash."""
    after: dict[Any, Any] = {**STATES_AFTER_RESTART, "stopping": "ready"}
    put(registry, "STATES_AFTER_RESTART", after)


@mutant("CRASH-004")
def forgets_attempts_on_restart() -> None:
    """A crash of the server gives a policy its attempts back."""
    right = rows.run_of

    def wrong(*stored: Any) -> Run:
        run = right(*stored)
        for episode in run.episodes:
            if episode.result is None:
                episode.attempt = 1
        return run

    put(rows, "run_of", wrong)


@mutant("CRASH-004")
def stores_no_attempt_that_a_lease_has_ended() -> None:
    """A policy that disappears when it plays badly gets attempts back by a crash."""
    right = effects.expire

    def wrong(run: Run, now: float, now_wall: float) -> effects.Expiry:
        before = set(run.changed)
        expired = right(run, now, now_wall)
        is_scored = {i for i in run.changed if run.episodes[i].result is not None}
        run.changed &= before | is_scored
        return expired

    put(effects, "expire", wrong)


@mutant("CRASH-003")
def draws_another_secret_of_seeds_on_restart() -> None:
    """Runs with sealed seeds cannot be compared with those of before a restart."""
    put(SeedSecret, "open", lambda _: None)


@mutant("CRASH-004")
def counts_forgiven_faults_again_on_restart() -> None:
    """A run that was resumed after its faults fails at the first one after a crash."""
    right = rows.run_of

    def wrong(*stored: Any) -> Run:
        run = right(*stored)
        for episode in run.episodes:
            if episode.result is None and episode.faults > 1:
                episode.faults_forgiven = 0
        return run

    put(rows, "run_of", wrong)


@mutant("CRASH-003")
def cuts_names_at_the_end_of_a_line() -> None:
    """A crash changes whose policy a run was of."""
    right, runs = RunRegistry.open, database_tables.runs

    async def wrong(self: RunRegistry) -> None:
        async with self._store._transaction() as connection:
            columns = sa.select(runs.c.run_id, runs.c.submission)
            for run_id, stored in (await connection.execute(columns)).all():
                submission = msgspec.json.decode(stored)
                policy = submission.get("policy", {"name": "deleted"})
                policy["name"] = policy["name"].splitlines()[0]
                changed = {"submission": msgspec.json.encode(submission)}
                this = runs.update().where(runs.c.run_id == run_id)
                await connection.execute(this.values(**changed))
        await right(self)

    put(RunRegistry, "open", wrong)
