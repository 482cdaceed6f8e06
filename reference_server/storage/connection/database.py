"""The connection to the database: transactions, reads of one moment, failures.

A path is an SQLite file; a URL may name PostgreSQL. It knows how both are opened and no
table; what a database must have is in `schema_version.py`.
"""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import AsyncIterator, Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import sqlalchemy as sa
from sqlalchemy.ext.asyncio import AsyncConnection, AsyncEngine, create_async_engine

from reference_server.files import private_files
from reference_server.files.file_faults import describe_file_fault
from reference_server.storage.connection import postgresql
from reference_server.storage.tables import schema_version
from reference_server.telemetry.spans import span

Found = TypeVar("Found")

# Reads of the database file that run at once.
READER_THREADS = 4
PORT_MAX = 65535
# How often an upgrade looks for nodes of an older version.
LOOK_S = 0.2
# A lease that ends so much later than at the first look was renewed. Answers of a busy
# database may be as late.
RENEWED_S = 2.0

log = logging.getLogger("proctor.storage")


class StoreFailed(Exception):
    """The database failed; nothing of the transaction was stored.

    If the connection was lost while it was committed, that is not known: what was to be
    stored must be read again.
    """


class Database:
    """One database, by its SQLAlchemy URL. All of it raises StoreFailed.

    is_shared: other nodes use it, too.
    """

    def __init__(self, url: str, *, is_shared: bool = False) -> None:
        # Not the loop's own threads: a slow DNS look-up may occupy those.
        self._reader_threads = ThreadPoolExecutor(READER_THREADS, "store")
        # One: a write whose caller was cancelled ends before the next one begins.
        self._writer_thread = ThreadPoolExecutor(1, "store-writer")
        try:
            self.url = url_of(url)
            self.is_postgresql = self.url.get_backend_name() == "postgresql"
            if self.is_postgresql:
                self._open_postgresql(is_shared=is_shared)
                return
            # No async driver, which would switch to its thread and back for each step
            # of a query: one switch is enough for all queries of one read or write.
            self._reader = sa.create_engine(self.url)
            self._writer = sa.create_engine(self.url)
        except (sa.exc.SQLAlchemyError, ImportError) as error:
            raise StoreFailed(_one_line(error)) from error
        sa.event.listen(self._reader, "connect", _set_query_only)
        sa.event.listen(self._reader, "begin", _begin)
        sa.event.listen(self._writer, "connect", _tune_sqlite)

    def _open_postgresql(self, *, is_shared: bool) -> None:
        options = postgresql.engine_options(is_shared=is_shared)
        self._engine = create_async_engine(self.url, **options)
        self._snapshots = self._engine.execution_options(
            isolation_level="REPEATABLE READ", postgresql_readonly=True
        )
        self._reads = asyncio.Semaphore(
            postgresql.READS_MAX - (postgresql.FOR_NODES if is_shared else 0)
        )
        # A slow write or read must not let the lease of a node end.
        self._node_engine: AsyncEngine | None = None
        if is_shared:
            options = postgresql.node_engine_options()
            self._node_engine = create_async_engine(self.url, **options)

    @property
    def file(self) -> Path | None:
        """The file of the database, as `database_file` returns it."""
        return database_file(self.url)

    async def open(self, *, upgrade: bool = True) -> schema_version.Upgrade | None:
        """Give it the tables of this version; what was upgraded, if anything was.

        upgrade: False: a database that has other tables is a failure.
        """
        path = self.file
        if path is not None:
            try:
                private_files.create_empty(path)
            except OSError as error:
                raise StoreFailed(self._describe(error)) from error
        try:
            done = await self._prepare(partial(schema_version.prepare, upgrade=upgrade))
        except schema_version.OtherVersion as error:
            raise StoreFailed(str(error)) from error
        except schema_version.UpgradeFailed as error:
            why = self._describe(error.reason)
            raise StoreFailed(
                f"the upgrade failed; nothing was changed: {why}"
            ) from error
        if path is not None:  # only now it is known to be a database
            for suffix in ("", "-wal", "-shm"):
                private_files.restrict(path.with_name(path.name + suffix))
        return done

    async def _prepare(
        self, prepare: Callable[[sa.Connection], schema_version.Upgrade | None]
    ) -> schema_version.Upgrade | None:
        """Wait until the leases of nodes that were killed are over.

        Not in a transaction, which would keep nodes that live from renewing theirs.
        """
        until: float | None = None
        while True:
            try:
                if not self.is_postgresql:
                    return await self.write(prepare)
                # An upgrade of many rows takes longer than any request may.
                engine = postgresql.engine_without_timeout(self.url)
                async with self.transaction_of(engine) as connection:
                    return await connection.run_sync(prepare)
            except schema_version.NodesLive as error:
                now_until = time.monotonic() + error.within_s
                if until is None:
                    until = now_until
                    log.warning(
                        "nodes of an older version may live: the upgrade waits up to "
                        "%.0f s for their leases to end",
                        error.within_s,
                    )
                if now_until > until + RENEWED_S:
                    raise
                await asyncio.sleep(LOOK_S)

    async def close(self) -> None:
        """Waits for a write that was begun, also if its caller was cancelled."""
        await asyncio.to_thread(self._writer_thread.shutdown)
        self._reader_threads.shutdown(wait=False)
        if not self.is_postgresql:
            self._reader.dispose()
            self._writer.dispose()
            return
        await self._engine.dispose()
        if self._node_engine is not None:
            await self._node_engine.dispose()

    async def write(self, store: Callable[[sa.Connection], Found]) -> Found:
        """Run `store` in one transaction; returns its result once that is committed."""
        if self.is_postgresql:
            async with self.transaction_of(self._engine) as connection:
                return await connection.run_sync(store)
        work = partial(_run_in_transaction, self._writer, store)
        return await self._run_in(self._writer_thread, work)

    async def read(self, fetch: Callable[[sa.Connection], Found]) -> Found:
        """The result of `fetch`, which reads one snapshot and writes nothing."""
        if self.is_postgresql:
            async with (
                self._place_to_read(),
                self.transaction_of(self._snapshots) as connection,
            ):
                return await connection.run_sync(fetch)
        work = partial(_run_in_connection, self._reader, fetch)
        return await self._run_in(self._reader_threads, work)

    @property
    def has_node_connections(self) -> bool:
        """Whether `run_for_node` may be called."""
        return self.is_postgresql and self._node_engine is not None

    async def run_for_node(self, work: Callable[[sa.Connection], Found]) -> Found:
        """A transaction for the lease and the claims of a node, on its own connections.

        It does not wait for those of requests, and only shortly for locks of other
        nodes.
        """
        assert self._node_engine is not None
        async with self.transaction_of(self._node_engine) as connection:
            return await connection.run_sync(work)

    async def _run_in(
        self, threads: ThreadPoolExecutor, work: Callable[[], Found]
    ) -> Found:
        try:
            with span("database transaction"):
                return await asyncio.get_running_loop().run_in_executor(threads, work)
        except (sa.exc.SQLAlchemyError, OSError) as error:
            raise StoreFailed(self._describe(error)) from error

    @asynccontextmanager
    async def _place_to_read(self) -> AsyncIterator[None]:
        """Take a place for a read in PostgreSQL."""
        try:
            async with asyncio.timeout(postgresql.POOL_TIMEOUT_S):
                await self._reads.acquire()
        except TimeoutError as error:
            raise StoreFailed(self._describe(error)) from error
        try:
            yield
        finally:
            self._reads.release()

    @asynccontextmanager
    async def transaction_of(
        self, engine: AsyncEngine
    ) -> AsyncIterator[AsyncConnection]:
        """A transaction of PostgreSQL, committed when no exception ends the block."""
        try:
            with span("database transaction"):
                async with engine.begin() as connection:
                    yield connection
        except (sa.exc.SQLAlchemyError, OSError) as error:
            # An unreachable server is reported by its driver, not by SQLAlchemy.
            raise StoreFailed(self._describe(error)) from error

    def _describe(self, error: Exception) -> str:
        if self.is_postgresql:
            return postgresql.describe(self.url, error)
        return describe_file_fault(error, self.file)


def url_of(database: str) -> sa.URL:
    """The URL with the driver that is used. Raises SQLAlchemyError."""
    try:
        url = sa.make_url(postgresql.with_dialect(database))
    except ValueError:  # its text repeats what may be of a password
        url = None
    if url is None or not 0 < (url.port or 1) <= PORT_MAX:
        raise sa.exc.ArgumentError("the port in the URL is no number from 1 to 65535")
    backend = url.get_backend_name()
    is_postgresql = backend == "postgresql"
    return postgresql.with_driver(url) if is_postgresql else url.set(drivername=backend)


def database_file(url: sa.URL) -> Path | None:
    """The file of an SQLite database; None if it is PostgreSQL."""
    return Path(url.database or "") if url.get_backend_name() == "sqlite" else None


def _run_in_connection(
    engine: sa.Engine, fetch: Callable[[sa.Connection], Found]
) -> Found:
    with engine.connect() as connection:
        return fetch(connection)


def _run_in_transaction(
    engine: sa.Engine, store: Callable[[sa.Connection], Found]
) -> Found:
    with engine.begin() as connection:
        return store(connection)


def _tune_sqlite(connection: Any, _record: object) -> None:
    cursor = connection.cursor()
    # WAL lets readers pass a writer; FULL makes a commit survive a power cut too.
    for pragma in ("journal_mode=WAL", "synchronous=FULL", "foreign_keys=ON"):
        cursor.execute(f"PRAGMA {pragma}")
    cursor.close()


def _set_query_only(connection: Any, _record: object) -> None:
    connection.isolation_level = None  # `_begin` begins the transaction
    connection.execute("PRAGMA query_only=ON").close()


def _begin(connection: sa.Connection) -> None:
    """All that is read until the end is of one moment."""
    connection.exec_driver_sql("BEGIN")


def _one_line(error: Exception) -> str:
    return str(error).partition("\n")[0]
