"""The tables of the leaderboard: entries, and the leaves of its history.

An entry and the leaf that says what became of it are stored in one transaction. Leaves
are only ever added. Each write is given a function that decides how the entry may
change.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import msgspec
import sqlalchemy as sa

from reference_record.formats.strict_json import canonical_json
from reference_server.rules.board.entry_changes import (
    BoardEntry,
    Change,
    has_same_result,
    is_of_account,
    withdraw,
)
from reference_server.rules.capacity import Quota
from reference_server.storage.record_store import RecordStore
from reference_server.storage.runs import account_statements
from reference_server.storage.runs.run_statements import is_deleted
from reference_server.storage.runs.run_store import RunIsKept, Store
from reference_server.storage.tables.column_types import any_number
from reference_server.storage.tables.database_tables import entries as _entries
from reference_server.storage.tables.database_tables import history as _leaves

_NUMBERED = sa.select(_entries.c.number, _entries.c.entry)
_SIZE = sa.select(sa.func.count()).select_from(_leaves)
_ENTRY = msgspec.json.Decoder(BoardEntry)


class SameResult(Exception):
    """The account has a public entry of the same result: `earlier`."""

    def __init__(self, earlier: BoardEntry) -> None:
        super().__init__(earlier.entry_id)
        self.earlier = earlier


class RunDeleted(Exception):
    """The run of the entry was deleted meanwhile."""


class Changed(NamedTuple):
    """is_new: there was no entry. kept_bytes: what the leaf counts for the account."""

    entry: BoardEntry
    is_new: bool
    kept_bytes: int = 0


class BoardStore:
    """Entries and leaves of one server's database.

    leaf_hash: of the tree, stored beside each leaf.
    """

    def __init__(self, store: Store, leaf_hash: Callable[[bytes], bytes]) -> None:
        self._transactions, self._leaf_hash = store.transactions, leaf_hash
        self._records = RecordStore(store.transactions)
        store.before_delete(self._release_run)

    async def change(
        self,
        run_id: str,
        decide: Callable[[BoardEntry | None], Change],
        *,
        needs_run: bool = False,
        check: Callable[[Quota], None] | None = None,
    ) -> Changed:
        """Store what `decide` makes of the entry of a run.

        Raises SameResult for a second public entry of one result. needs_run: raises
        RunDeleted if there is no such run any more. check: is called
        with the usage of the account, if a leaf is added. An exception of `decide` or
        `check` rolls the transaction back. Both run in the thread that writes.
        """

        def store(connection: sa.Connection) -> Changed:
            self._transactions.lock_order(connection)
            if needs_run and is_deleted(connection, run_id):
                raise RunDeleted(run_id)
            before = _entry_of_run(connection, run_id)
            change = decide(before)
            if change.entry == before:
                return Changed(before, is_new=False)
            if _becomes_public(before, change.entry):
                _refuse_same_result(connection, change.entry)
            number = _store_entry(connection, change.entry)
            kept = 0
            if change.leaf is not None:
                if check is not None:
                    account = change.entry.account
                    check(account_statements.usage_of(connection, account))
                size = self._append(connection, change.leaf)
                if is_of_account(change.leaf):
                    kept = size
                    account_statements.count_kept(connection, run_id, kept)
            entry = replace(change.entry, number=number)
            return Changed(entry, before is None, kept)

        return await self._transactions.write_in_turn(store)

    def _append(self, connection: sa.Connection, members: Mapping[str, Any]) -> int:
        """Returns the bytes of the leaf."""
        leaf = canonical_json(members)  # BRD-023
        index = connection.scalar(_SIZE)
        hashed = self._leaf_hash(leaf)
        row = {"index": index, "leaf": leaf.decode(), "leaf_sha256": hashed}
        connection.execute(_leaves.insert().values(row))
        return len(leaf)

    async def append_of_draw(
        self,
        draw_id: str,
        decide: Callable[[Sequence[Mapping[str, Any]]], Mapping[str, Any] | int],
    ) -> int:
        """Append the leaf that `decide` makes of those of a draw; returns its index.

        decide: is given these leaves with their `index`; an index is of one of them,
        and nothing is appended. An exception of it rolls the transaction back.
        """
        pattern = f'%"draw_id":{msgspec.json.encode(draw_id).decode()}%'
        query = sa.select(_leaves.c.index, _leaves.c.leaf).where(
            _leaves.c.leaf.like(pattern)
        )

        def store(connection: sa.Connection) -> int:
            self._transactions.lock_order(connection)
            rows = connection.execute(query.order_by(_leaves.c.index)).all()
            leaves = [msgspec.json.decode(row.leaf) | {"index": row[0]} for row in rows]
            earlier = [leaf for leaf in leaves if leaf.get("draw_id") == draw_id]
            decided = decide(earlier)
            if isinstance(decided, int):
                return decided
            self._append(connection, decided)
            return int(connection.scalar(_SIZE) or 0) - 1

        return await self._transactions.write_in_turn(store)

    async def find(self, entry_id: str) -> BoardEntry | None:
        """An entry, withdrawn or not."""
        return await self._first(_NUMBERED.where(_entries.c.entry_id == entry_id))

    async def find_of_run(self, run_id: str) -> BoardEntry | None:
        """The entry of a run, withdrawn or not."""
        return await self._first(_NUMBERED.where(_entries.c.run_id == run_id))

    async def keeps_run(self, run_id: str, by_host: bool) -> bool:
        """Whether the run has an entry for which it cannot be deleted."""
        entry = await self.find_of_run(run_id)
        return entry is not None and _keeps_run(entry, by_host)

    def _release_run(
        self, connection: sa.Connection, run_id: str, by_host: bool
    ) -> None:
        """Withdraw the entry that goes with a run that is deleted."""
        entry = _entry_of_run(connection, run_id)
        if entry is None:
            return
        if _keeps_run(entry, by_host):
            raise RunIsKept(run_id)
        withdrawn = withdraw(entry, time.time()).entry
        if withdrawn != entry:  # a private one: the history has no leaf of that
            _store_entry(connection, withdrawn)

    async def page(
        self,
        account: str | None,
        benchmark_id: str | None,
        before: int | None,
        limit: int,
    ) -> list[BoardEntry]:
        """Public entries and those of an account, newest first, below a number.

        account: None for those of all.
        """
        query = _NUMBERED.where(_entries.c.is_listed)
        if account is not None:
            query = query.where(
                sa.or_(_entries.c.is_public, _entries.c.account == account)
            )
        if benchmark_id is not None:
            query = query.where(_entries.c.benchmark_id == benchmark_id)
        if before is not None:
            query = query.where(_entries.c.number < any_number(before))
        return await self._all(query.order_by(_entries.c.number.desc()).limit(limit))

    async def of_manifest(
        self, benchmark_id: str, manifest_sha256: str
    ) -> list[BoardEntry]:
        """The public entries of a manifest that are not withdrawn, oldest first."""
        query = _NUMBERED.where(
            _entries.c.manifest_sha256 == manifest_sha256,
            _entries.c.benchmark_id == benchmark_id,
            _entries.c.is_listed,
            _entries.c.is_public,
        )
        return await self._all(query.order_by(_entries.c.number))

    async def attempts(
        self, entries: Sequence[BoardEntry]
    ) -> dict[tuple[str, str], int]:
        """(account, benchmark) → how many of its runs were submitted until now."""
        accounts = {entry.account for entry in entries}
        benchmarks = {entry.benchmark_id for entry in entries}
        return await self._records.attempts_of(accounts, benchmarks)

    # --- history ---

    async def leaves(self, start: int, limit: int) -> list[str]:
        """Leaves by index, oldest first."""
        query = sa.select(_leaves.c.leaf).where(_leaves.c.index >= any_number(start))
        query = query.order_by(_leaves.c.index).limit(limit)
        return await self._transactions.read(lambda c: list(c.scalars(query)))

    async def leaf_hashes(self, start: int) -> list[bytes]:
        """The hashes of all leaves from an index on."""
        query = sa.select(_leaves.c.leaf_sha256).where(_leaves.c.index >= start)
        query = query.order_by(_leaves.c.index)
        return await self._transactions.read(lambda c: list(c.scalars(query)))

    async def _first(self, query: sa.Select[Any]) -> BoardEntry | None:
        return next(iter(await self._all(query)), None)

    async def _all(self, query: sa.Select[Any]) -> list[BoardEntry]:
        return await self._transactions.read(
            lambda connection: [_entry_of(*row) for row in connection.execute(query)]
        )


def _keeps_run(entry: BoardEntry, by_host: bool) -> bool:
    """A private entry does not keep a run that the host deletes when it is old."""
    return entry.state == "published" and (entry.is_public or not by_host)


def _becomes_public(before: BoardEntry | None, after: BoardEntry) -> bool:
    was_public = before is not None and before.is_public
    return after.is_public and after.state == "published" and not was_public


def _refuse_same_result(connection: sa.Connection, entry: BoardEntry) -> None:
    query = _NUMBERED.where(
        _entries.c.manifest_sha256 == entry.manifest_sha256,
        _entries.c.account == entry.account,
        _entries.c.is_listed,
        _entries.c.is_public,
    )
    for row in connection.execute(query.order_by(_entries.c.number)):
        earlier = _entry_of(*row)
        if has_same_result(entry, earlier):
            raise SameResult(earlier)


def _entry_of_run(connection: sa.Connection, run_id: str) -> BoardEntry | None:
    row = connection.execute(_NUMBERED.where(_entries.c.run_id == run_id)).first()
    return None if row is None else _entry_of(*row)


def _store_entry(connection: sa.Connection, entry: BoardEntry) -> int:
    """Insert or replace it; returns its number."""
    row = {
        "entry_id": entry.entry_id,
        "run_id": entry.run_id,
        "account": entry.account,
        "benchmark_id": entry.benchmark_id,
        "manifest_sha256": entry.manifest_sha256,
        "is_listed": entry.state == "published",
        "is_public": entry.is_public,
        "entry": msgspec.json.encode(entry),
    }
    if entry.number:
        same = _entries.c.number == entry.number
        connection.execute(_entries.update().where(same).values(row))
        return entry.number
    inserted = connection.execute(
        _entries.insert().values(row).returning(_entries.c.number)
    )
    return int(inserted.scalar_one())


def _entry_of(number: int, stored: bytes) -> BoardEntry:
    return replace(_ENTRY.decode(stored), number=number)
