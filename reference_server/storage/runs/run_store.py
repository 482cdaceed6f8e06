"""Runs and their episodes on disk.

They are stored and returned, and no rule is held: what a restart does to runs is a
table that is given. Sessions are not stored: they end with the process. Statements of
records are in `record_store.py`.
"""

from __future__ import annotations

from collections.abc import (
    Awaitable,
    Callable,
    Iterable,
    Iterator,
    Mapping,
    Sequence,
)
from functools import partial
from typing import Any

import msgspec
import sqlalchemy as sa

from reference_server.rules.capacity import Quota, WaitingRun
from reference_server.rules.manifest import Manifest
from reference_server.rules.runs.run import Episode, Run, RunHead, State
from reference_server.storage.connection.database import StoreFailed
from reference_server.storage.connection.transactions import OwnershipLost, Transactions
from reference_server.storage.runs import account_statements, rows
from reference_server.storage.runs.run_statements import (
    EPISODES_SCORED,
    HEADS,
    IS_THERE,
    MANIFEST,
    NEW_RUN,
    add_manifest,
    last_attempt,
    last_played,
    replace_episodes,
    stored_episodes,
    update_owned,
)
from reference_server.storage.tables.column_types import any_number
from reference_server.storage.tables.database_tables import episodes as _episodes
from reference_server.storage.tables.database_tables import runs as _runs
from reference_server.storage.tables.database_tables import statements as _statements
from reference_server.storage.tables.schema_version import Upgrade

__all__ = ["OwnershipLost", "RunIsKept", "Store", "StoreFailed"]

# Decoded manifests kept, for all the runs that share them.
CACHED_MANIFESTS_MAX = 64


class RunIsKept(Exception):
    """The run cannot be deleted: something else that is stored needs it."""


# Is called in the transaction that deletes a run, with its id and whether the host
# deletes it; deletes what goes with it, or raises RunIsKept.
BeforeDelete = Callable[[sa.Connection, str, bool], None]


def _delete_nothing_else(_: sa.Connection, _run_id: str, _host: bool) -> None:
    """The default of `before_delete`: no other table names the run."""


async def _complete_nothing(_run: Run) -> None:
    """The default of `before_save`: the run is already complete."""


class Store:
    """Runs on disk. Writes happen one after another; each is one transaction.

    before_save: completes a run that is about to be stored. after_save: is called with
    the run and the indices of the episodes that were stored. is_shared: other nodes
    write to the database, too.
    """

    def __init__(
        self,
        url: str,
        before_save: Callable[[Run], Awaitable[None]] = _complete_nothing,
        after_save: Callable[[Run, set[int]], None] = lambda _run, _indices: None,
        *,
        is_shared: bool = False,
    ) -> None:
        self._before_save, self._after_save = before_save, after_save
        self._before_delete: BeforeDelete = _delete_nothing_else
        self.transactions = Transactions(url, is_shared=is_shared)
        self._manifest_cache: dict[str, Manifest] = {}

    async def open(self, *, upgrade: bool = True) -> Upgrade | None:
        """Create or upgrade the tables, as Database.open does it."""
        return await self.transactions.open(upgrade=upgrade)

    async def close(self) -> None:
        await self.transactions.close()

    async def insert(
        self,
        run: Run,
        key: str | None,
        body_sha256: str,
        check: Callable[[Quota], None] | None = None,
    ) -> bool:
        """Store a new run and give it its number, unless its key is taken (CRASH-003).

        check: raises if the account, which has so much, may not have another one.
        Returns whether it was stored.
        """
        async with self.transactions.write_lock:
            row = rows.new_run_row(run)  # of the moment at which it is stored

            def store(connection: sa.Connection) -> tuple[int, int] | None:
                self.transactions.lock_account(connection, run.account)
                of_key = None if key is None else (run.account, key)
                if of_key and account_statements.find_key(connection, *of_key):
                    return None
                if check is not None:
                    check(account_statements.usage_of(connection, run.account))
                # REC-110
                row["attempts_by_submitter"] = 1 + last_attempt(connection, run)
                add_manifest(connection, run)
                number = connection.execute(NEW_RUN, row).scalar_one()
                if of_key:
                    made = body_sha256, run.run_id
                    account_statements.add_key(connection, *of_key, *made)
                return number, row["attempts_by_submitter"]

            numbers = await self.transactions.write_at_once(store)
            if numbers is not None:
                run.number, run.attempts_by_submitter = numbers
        return numbers is not None

    async def save(
        self, run: Run, check: Callable[[Quota], None] | None = None
    ) -> list[Episode]:
        """Commit the run's state and the episodes that changed since.

        Returns those of them that have a result.

        CRASH-001, CRASH-004: every answer that shows them is sent after that. check:
        raises if the account, which has so much without it, may not have it open.
        """
        await self._before_save(run)  # while others write
        async with self.transactions.write_lock:
            await self._before_save(run)  # what came since then
            # Read inside the lock and before any other await: a later save never
            # overtakes an earlier one, and state and episodes are of one moment.
            if run.lost:
                raise StoreFailed("an earlier write of the run failed")
            changed, run.changed = run.changed, set()
            row, episodes = rows.run_row(run), rows.episode_rows(run, changed)
            stored = (run.episodes[index] for index in sorted(changed))
            scored = [episode for episode in stored if episode.result is not None]
            count = run.is_played and run.played_number is None

            def store(connection: sa.Connection) -> None:
                if count or check is not None:
                    self.transactions.lock_account(connection, run.account)
                if check is not None:
                    check(account_statements.usage_of(connection, run.account))
                if count:
                    row["played_number"] = 1 + last_played(connection, run)
                update_owned(connection, run, row)
                replace_episodes(connection, episodes)

            try:
                await self.transactions.write_at_once(store)
            except Exception:
                run.changed |= changed
                raise
            run.played_number = row["played_number"]
        self._after_save(run, changed)
        return scored

    def before_delete(self, call: BeforeDelete) -> None:
        """Register the call of a module of storage/ whose tables name runs."""
        self._before_delete = call

    async def delete(
        self, run: RunHead, now_wall: float, *, by_host: bool = False
    ) -> None:
        """Delete what is stored of a run, but for what counts it (DEL-006).

        Its Idempotency-Key stays used (DEL-005), and of its statement the digest, which
        the next one names. Raises RunIsKept.
        """
        emptied = _statements.update().where(_statements.c.run_id == run.run_id)
        size = rows.stored_bytes(run)
        row = rows.deleted_run_row(now_wall)
        # Its leaves in the history of the leaderboard stay, and stay counted.
        counted = sa.func.coalesce(_runs.c.stored_bytes, size)
        kept = counted - size + row.pop("stored_bytes")
        of_run = _runs.update().where(_runs.c.number == run.number)

        def store(connection: sa.Connection) -> None:
            self.transactions.lock_order(connection)  # for the entry
            self._before_delete(connection, run.run_id, by_host)
            connection.execute(
                _episodes.delete().where(_episodes.c.number == run.number)
            )
            connection.execute(emptied.values(statement=b""))
            update_owned(connection, run, row)
            connection.execute(of_run.values(stored_bytes=kept))

        await self.transactions.write_in_turn(store)

    async def deleted_ids(self, run_ids: Sequence[str]) -> set[str]:
        """Which of these runs were deleted."""
        query = sa.select(_runs.c.run_id).where(~IS_THERE, _runs.c.run_id.in_(run_ids))
        return await self.transactions.read(lambda c: set(c.scalars(query)))

    async def in_states_since(
        self, states: Sequence[str], before: float, after: int, limit: int
    ) -> list[tuple[int, str]]:
        """(number, id) of runs in these states since then, behind a number."""
        query = sa.select(_runs.c.number, _runs.c.run_id).where(
            IS_THERE,
            _runs.c.number > after,
            _runs.c.state.in_(states),
            _runs.c.updated_at_wall < before,
        )
        query = query.order_by(_runs.c.number).limit(limit)
        return await self._numbers_and_ids(query)

    async def find_key(self, account: str, key: str) -> tuple[str, str] | None:
        """(body_sha256, run_id) of an account's Idempotency-Key, if it was used."""
        return await self.transactions.read(
            partial(account_statements.find_key, account=account, key=key)
        )

    async def load(self, run_id: str) -> Run | None:
        """The run with all its episodes."""

        def fetch(connection: sa.Connection) -> Run | None:
            for row, manifest in self._heads(connection, [run_id]):
                return rows.run_of(
                    row, manifest, stored_episodes(connection, row["number"])
                )
            return None

        return await self.transactions.read(fetch)

    async def read_window(
        self, run_id: str, start: int, end: int | None, scored: bool = False
    ) -> tuple[RunHead, list[Episode]] | None:
        """The run as it is stored, and its episodes that `Run.window` would give."""

        def fetch(connection: sa.Connection) -> tuple[RunHead, list[Episode]] | None:
            for row, manifest in self._heads(connection, [run_id]):
                head = rows.head_of(row, manifest)
                places = range(head.total)[start:end]
                window = (connection, head.number, start, start + len(places))
                if scored:
                    stored = stored_episodes(*window, EPISODES_SCORED)
                    return head, [
                        rows.episode_of(manifest, row_of_episode)
                        for row_of_episode in stored
                    ]
                stored = stored_episodes(*window)
                return head, rows.episodes_of(manifest, places, stored)
            return None

        return await self.transactions.read(fetch)

    async def heads(self, run_ids: Sequence[str]) -> dict[str, RunHead]:
        """The runs by id, without their episodes and without their options."""

        def fetch(connection: sa.Connection) -> dict[str, RunHead]:
            stored = self._heads(connection, run_ids)
            heads = [rows.listed_head_of(row, manifest) for row, manifest in stored]
            return {head.run_id: head for head in heads}

        return await self.transactions.read(fetch)

    def _heads(
        self, connection: sa.Connection, run_ids: Sequence[str]
    ) -> Iterator[tuple[rows.Row, Manifest]]:
        """Each run's row and manifest."""
        rows = connection.execute(HEADS, {"run_ids": run_ids}).mappings().all()
        for row in rows:
            yield dict(row), self._manifest(connection, row["manifest_sha256"])

    def _manifest(self, connection: sa.Connection, sha256: str) -> Manifest:
        """The one decoded copy of a manifest; several threads may call at a time."""
        manifest = self._manifest_cache.get(sha256)
        if manifest is None:
            parameters = {"manifest_sha256": sha256}
            manifest = msgspec.json.decode(
                connection.scalars(MANIFEST, parameters).one()
            )
            if len(self._manifest_cache) >= CACHED_MANIFESTS_MAX:
                self._manifest_cache.clear()
            self._manifest_cache[sha256] = manifest
        return manifest

    async def page(
        self, account: str | None, before: int | None, limit: int
    ) -> list[tuple[int, str]]:
        """(number, run_id) of an account's runs, newest first, below a number.

        AUTH-004: of this account only; None for all (AUTH-008). RUN-009: numbers
        never change.
        """
        query = sa.select(_runs.c.number, _runs.c.run_id).where(IS_THERE)
        if account is not None:
            query = query.where(_runs.c.account == account)
        if before is not None:
            query = query.where(_runs.c.number < any_number(before))
        query = query.order_by(_runs.c.number.desc()).limit(limit)
        return await self._numbers_and_ids(query)

    async def _numbers_and_ids(self, query: sa.Select[Any]) -> list[tuple[int, str]]:
        return await self.transactions.read(
            lambda c: [(number, run_id) for number, run_id in c.execute(query)]
        )

    async def newest_change(self) -> float | None:
        """When the last change of any run was stored; None without runs."""
        query = sa.select(sa.func.max(_runs.c.updated_at_wall)).where(IS_THERE)

        def fetch(connection: sa.Connection) -> float | None:
            changed_at: float | None = connection.scalar(query)
            return changed_at

        return await self.transactions.read(fetch)

    async def replace_states(self, states: Mapping[State, State], reason: str) -> None:
        """Move every run in one of these states to the state beside it."""

        def store(connection: sa.Connection) -> None:
            for before, after in states.items():
                are_before = _runs.update().where(_runs.c.state == before)
                connection.execute(are_before.values(state=after, reason=reason))

        await self.transactions.write_in_turn(store)

    async def usage_of(self, account: str) -> Quota:
        """Counts for the account all that its quota bounds."""
        return await self.transactions.read(
            partial(account_statements.usage_of, account=account)
        )

    async def in_states(self, *states: str) -> list[str]:
        """Ids of all runs in these states, oldest first."""
        in_states = _runs.c.state.in_(states)
        query = sa.select(_runs.c.run_id).where(IS_THERE, in_states)
        query = query.order_by(_runs.c.number)
        return await self.transactions.read(lambda c: list(c.scalars(query)))

    async def runs_of_manifests(self, benchmark_id: str) -> list[str]:
        """The id of one run of each manifest of a benchmark."""
        query = sa.select(sa.func.max(_runs.c.run_id))
        query = query.where(IS_THERE, _runs.c.benchmark_id == benchmark_id)
        query = query.group_by(_runs.c.manifest_sha256)
        return await self.transactions.read(lambda c: sorted(c.scalars(query)))

    async def counts_of_manifests(
        self, states: Iterable[str], most: int
    ) -> list[tuple[str, int]]:
        """One run of each manifest that runs in these states have, and their number.

        Only of the `most` manifests with the most runs.
        """
        number = sa.func.count()
        query = sa.select(sa.func.max(_runs.c.run_id), number)
        query = query.where(IS_THERE, _runs.c.state.in_(list(states)))
        query = query.group_by(_runs.c.manifest_sha256).order_by(number.desc())
        query = query.limit(most)
        return await self.transactions.read(
            lambda c: [(run_id, count) for run_id, count in c.execute(query)]
        )

    async def waiting_runs(self, *states: str) -> list[WaitingRun]:
        """All runs in these states as the queue reads them, oldest first."""
        columns = (_runs.c[name] for name in WaitingRun.__dataclass_fields__)
        query = sa.select(*columns).where(IS_THERE, _runs.c.state.in_(states))
        query = query.order_by(_runs.c.number)
        return await self.transactions.read(
            lambda c: [WaitingRun(*row) for row in c.execute(query)]
        )

    async def sizes_of_accounts(self) -> tuple[dict[str, int], dict[str, int]]:
        """Count the Idempotency-Keys and the stored bytes of each account."""
        return await self.transactions.read(account_statements.sizes_of_accounts)
