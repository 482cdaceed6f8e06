"""Imports of records in the database: rows of one table, by account.

The archives are files, and not known here.
"""

from __future__ import annotations

from dataclasses import asdict, fields
from typing import Any

import msgspec
import sqlalchemy as sa

from reference_server.rules.imported_record import (
    ImportReplay,
    ImportUsage,
    RecordImport,
)
from reference_server.storage.column_types import any_number
from reference_server.storage.database_tables import record_imports as _imports
from reference_server.storage.run_store import Store

_COLUMNS = [_imports.c[field.name] for field in fields(RecordImport)]
_IS_UNFINISHED = _imports.c.state != "finished"


class ImportStore:
    """All imports. Raises StoreFailed, as the store does."""

    def __init__(self, store: Store) -> None:
        self._transactions = store.transactions

    async def add(self, record_import: RecordImport) -> None:
        """Store a new one; it gets its number from the database."""
        row = _row_of(record_import)
        del row["number"]
        async with self._transactions.write() as connection:
            await connection.execute(_imports.insert().values(row))

    async def update(self, record_import: RecordImport) -> None:
        """Store what changes of one; nothing if it was deleted."""
        where = _imports.c.import_id == record_import.import_id
        async with self._transactions.write() as connection:
            await connection.execute(
                _imports.update().where(where).values(_row_of(record_import))
            )

    async def delete(self, import_id: str) -> None:
        async with self._transactions.write() as connection:
            where = _imports.c.import_id == import_id
            await connection.execute(_imports.delete().where(where))

    async def find(self, account: str | None, import_id: str) -> RecordImport | None:
        """The import, if the account has it; None is for any account (AUTH-008)."""
        query = sa.select(*_COLUMNS).where(_imports.c.import_id == import_id)
        return await self._first(_of_account(query, account))

    async def find_archive(self, account: str, sha256: str) -> RecordImport | None:
        query = sa.select(*_COLUMNS).where(_imports.c.archive_sha256 == sha256)
        return await self._first(_of_account(query, account))

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
        query = sa.select(
            sa.func.count().filter(_IS_UNFINISHED),
            sa.func.coalesce(sa.func.sum(_imports.c.size_bytes), 0),
        ).where(_imports.c.account == account)
        waiting, size = await self._transactions.read(lambda c: c.execute(query).one())
        return ImportUsage(int(waiting), int(size))

    async def _first(self, query: sa.Select[Any]) -> RecordImport | None:
        return next(iter(await self._all(query.limit(1))), None)

    async def _all(self, query: sa.Select[Any]) -> list[RecordImport]:
        read = self._transactions.read
        rows = await read(lambda c: c.execute(query).mappings().all())
        return [_import_of(dict(row)) for row in rows]


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
