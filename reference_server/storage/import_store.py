"""Imports of records in the database: rows of one table, by account.

The archives are files, and not known here.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, fields
from typing import Any

import msgspec
import sqlalchemy as sa

from reference_server.rules.imported_record import (
    ImportReplay,
    ImportUsage,
    RecordImport,
)
from reference_server.storage.runs.run_store import Store
from reference_server.storage.tables.column_types import any_number
from reference_server.storage.tables.database_tables import record_imports as _imports

_COLUMNS = [_imports.c[field.name] for field in fields(RecordImport)]
_IS_UNFINISHED = _imports.c.state != "finished"


class ImportStore:
    """All imports. Raises StoreFailed, as the store does."""

    def __init__(self, store: Store) -> None:
        self._transactions = store.transactions

    async def add(
        self,
        record_import: RecordImport,
        check: Callable[[ImportUsage], None] = lambda _: None,
    ) -> RecordImport | None:
        """Store a new one, which gets its number from the database.

        check: raises if the account, which has so much, may not have it. Returns the
        one with this archive that the account has already; then nothing is stored.
        """
        account, row = record_import.account, _row_of(record_import)
        del row["number"]
        same = _of_archive(account, record_import.archive_sha256)

        def store(connection: sa.Connection) -> RecordImport | None:
            self._transactions.lock_account(connection, account)
            if (found := connection.execute(same).mappings().first()) is not None:
                return _import_of(dict(found))
            check(_usage_of(connection, account))
            connection.execute(_imports.insert().values(row))
            return None

        return await self._transactions.write_in_turn(store)

    async def update(self, record_import: RecordImport) -> None:
        """Store what changes of one; nothing if it was deleted."""
        where = _imports.c.import_id == record_import.import_id
        changed = _imports.update().where(where).values(_row_of(record_import))
        await self._transactions.write_in_turn(lambda c: c.execute(changed))

    async def delete(self, import_id: str) -> None:
        removed = _imports.delete().where(_imports.c.import_id == import_id)
        await self._transactions.write_in_turn(lambda c: c.execute(removed))

    async def find(self, account: str | None, import_id: str) -> RecordImport | None:
        """The import, if the account has it; None is for any account (AUTH-008)."""
        query = sa.select(*_COLUMNS).where(_imports.c.import_id == import_id)
        return await self._first(_of_account(query, account))

    async def find_archive(self, account: str, sha256: str) -> RecordImport | None:
        return await self._first(_of_archive(account, sha256))

    async def oldest_unfinished(self) -> list[RecordImport]:
        """The oldest unfinished import of each account, oldest first."""
        oldest = sa.select(sa.func.min(_imports.c.number)).where(_IS_UNFINISHED)
        numbers = oldest.group_by(_imports.c.account).scalar_subquery()
        query = sa.select(*_COLUMNS).where(_imports.c.number.in_(numbers))
        return await self._all(query.order_by(_imports.c.number))

    async def page(
        self, account: str | None, before: int | None, limit: int
    ) -> list[RecordImport]:
        """The imports below a number, newest first."""
        query = _of_account(sa.select(*_COLUMNS), account)
        if before is not None:
            query = query.where(_imports.c.number < any_number(before))
        return await self._all(query.order_by(_imports.c.number.desc()).limit(limit))

    async def ids(self) -> set[str]:
        query = sa.select(_imports.c.import_id)
        return await self._transactions.read(lambda c: set(c.scalars(query)))

    async def usage(self, account: str) -> ImportUsage:
        return await self._transactions.read(lambda c: _usage_of(c, account))

    async def _first(self, query: sa.Select[Any]) -> RecordImport | None:
        return next(iter(await self._all(query.limit(1))), None)

    async def _all(self, query: sa.Select[Any]) -> list[RecordImport]:
        read = self._transactions.read
        rows = await read(lambda c: c.execute(query).mappings().all())
        return [_import_of(dict(row)) for row in rows]


def _of_archive(account: str, sha256: str) -> sa.Select[Any]:
    query = sa.select(*_COLUMNS).where(_imports.c.archive_sha256 == sha256)
    return _of_account(query, account)


def _usage_of(connection: sa.Connection, account: str) -> ImportUsage:
    query = sa.select(
        sa.func.count().filter(_IS_UNFINISHED),
        sa.func.coalesce(sa.func.sum(_imports.c.size_bytes), 0),
    ).where(_imports.c.account == account)
    waiting, size = connection.execute(query).one()
    return ImportUsage(int(waiting), int(size))


def _of_account(query: sa.Select[Any], account: str | None) -> sa.Select[Any]:
    return query if account is None else query.where(_imports.c.account == account)


def _row_of(record_import: RecordImport) -> dict[str, Any]:
    row = {
        field.name: getattr(record_import, field.name)
        for field in fields(record_import)
    }
    row["replay"] = record_import.replay and msgspec.json.encode(
        asdict(record_import.replay)
    )
    return row


def _import_of(row: dict[str, Any]) -> RecordImport:
    replay = row.pop("replay")
    decoded = None if replay is None else msgspec.json.decode(replay, type=ImportReplay)
    return RecordImport(**row, replay=decoded)
