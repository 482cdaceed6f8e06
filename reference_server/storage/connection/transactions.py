"""Reading and writing the database: one write after another, each one transaction.

It knows the tables only for what holds for every write: that it can be stored, and in
which order nodes write what has one order.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module

import sqlalchemy as sa

from reference_server.storage.connection.database import Database, Found, StoreFailed
from reference_server.storage.tables.database_tables import accounts as _accounts
from reference_server.storage.tables.database_tables import runs as _runs
from reference_server.storage.tables.schema_version import Upgrade

_OF_NO_ACCOUNT = {"account": "", "counted": 0}
# The row to lock for what belongs to the host, and not to one account.
_OF_ALL_ACCOUNTS = "*"


class OwnershipLost(StoreFailed):
    """Another node has claimed the run: nothing of it was stored, nor will be."""


class Transactions:
    """The database of one server. is_shared: other nodes write to it, too."""

    def __init__(self, url: str, *, is_shared: bool = False) -> None:
        self._is_shared = is_shared
        self._database = Database(url, is_shared=is_shared)
        self.write_lock = asyncio.Lock()
        self._last_write_failed = False

    async def open(self, *, upgrade: bool = True) -> Upgrade | None:
        """Create or upgrade the tables, as Database.open does it."""
        return await self._database.open(upgrade=upgrade)

    async def close(self) -> None:
        await self._database.close()

    async def write_at_once(self, store: Callable[[sa.Connection], Found]) -> Found:
        """A transaction of a caller that has the lock of writes."""
        with self._note_failure():
            return await self._database.write(store)

    @contextmanager
    def _note_failure(self) -> Iterator[None]:
        try:
            yield
        except StoreFailed as error:
            self._last_write_failed |= not isinstance(error, OwnershipLost)
            raise

    async def write_of_node(self, store: Callable[[sa.Connection], Found]) -> Found:
        """A transaction about nodes and owners, which no other write delays.

        But in an SQLite file, which has one writer at a time. Raises StoreFailed.
        """
        if not self._database.has_node_connections:
            return await self.write_in_turn(store)
        return await self._database.run_for_node(store)

    async def read_of_node(self, fetch: Callable[[sa.Connection], Found]) -> Found:
        """The result of `fetch`, which other reads do not delay. Raises StoreFailed."""
        if not self._database.has_node_connections:
            return await self.read(fetch)
        return await self._database.run_for_node(fetch)

    async def write_in_turn(self, store: Callable[[sa.Connection], Found]) -> Found:
        """Run `store` in a transaction after all writes before it; returns its result.

        store: an exception of it rolls the transaction back. Raises StoreFailed.
        """
        async with self.write_lock:
            return await self.write_at_once(store)

    async def read(self, fetch: Callable[[sa.Connection], Found]) -> Found:
        """The result of `fetch`, which reads one snapshot."""
        return await self._database.read(fetch)

    async def check_writable(self) -> None:
        """Raises StoreFailed if no write can begin, or none is stored after a failure.

        On a full disk writes begin. So after one that failed a row is written, and
        deleted again, until that works.
        """
        nothing = _runs.update().where(sa.false()).values(state=_runs.c.state)
        is_tried = self._last_write_failed

        def store(connection: sa.Connection) -> None:
            connection.execute(nothing)
            if is_tried:
                of_none = _accounts.c.account == ""
                connection.execute(_accounts.insert().values(_OF_NO_ACCOUNT))
                connection.execute(_accounts.delete().where(of_none))

        await self.write_in_turn(store)
        if is_tried:
            self._last_write_failed = False

    def lock_account(self, connection: sa.Connection, account: str) -> None:
        """Exclude other transactions that count the account, until this one ends."""
        if not self._is_shared:  # the lock of writes is enough
            return
        # Imported here: that of PostgreSQL takes a twentieth of the start of a server.
        dialect = import_module(f"sqlalchemy.dialects.{connection.dialect.name}")
        insert = dialect.insert(_accounts)
        insert_once = insert.values(account=account, counted=0).on_conflict_do_nothing()
        connection.execute(insert_once)
        counted = _accounts.update().where(_accounts.c.account == account)
        connection.execute(counted.values(counted=_accounts.c.counted + 1))

    def lock_order(self, connection: sa.Connection) -> None:
        """Lock the order of all accounts, first in a transaction that appends to it.

        Until the transaction ends, no other node changes what it then reads: the last
        statement, the leaves of the leaderboard, an entry.
        """
        self.lock_account(connection, _OF_ALL_ACCOUNTS)
