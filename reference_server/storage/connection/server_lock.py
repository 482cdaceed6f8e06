"""The lock of the one server that uses a database: a second one is refused.

For SQLite the lock is a file beside the database, locked by the operating system. In
PostgreSQL it is an advisory lock, held by a connection of its own. Both are released
when the process ends, however it ends: after `kill -9` the next server starts at once.
"""

from __future__ import annotations

import asyncio
import contextlib
import fcntl
import logging
import os
import socket
import time
from collections.abc import Callable
from pathlib import Path
from typing import Protocol

import sqlalchemy as sa
from sqlalchemy.ext.asyncio import AsyncConnection

from reference_server.files import private_files
from reference_server.files.file_faults import describe_file_fault
from reference_server.process.backoff import Backoff
from reference_server.storage.connection import postgresql
from reference_server.storage.connection.database import (
    StoreFailed,
    database_file,
    url_of,
)

log = logging.getLogger("proctor.storage")

# How long a server that ends may still have it.
WAIT_S = 2.0
_POLL_S = 0.02
# How often its connection is asked whether it is alive, and how long that may take.
CHECK_S = CHECK_TIMEOUT_S = 5.0
_KEY = 0x50726F63_746F7221
# The first bytes of a file that has tables.
_SQLITE = b"SQLite format 3\0"
_LOCK_NOT_AVAILABLE = "55P03"
_HOLDER = sa.text(
    "SELECT a.application_name, pid FROM pg_locks l "
    "JOIN pg_stat_activity a USING (pid) "
    "WHERE l.locktype = 'advisory' AND l.granted AND l.classid = :high "
    "AND l.objid = :low AND l.objsubid = 1 AND l.database = "
    "(SELECT oid FROM pg_database WHERE datname = current_database())"
)


class ServerLock(Protocol):
    """Raises StoreFailed if another server has it, or the database is not there."""

    async def acquire(self) -> None: ...

    async def release(self) -> None: ...


def lock_of(
    database: str, on_taken: Callable[[], None], *, is_shared: bool = False
) -> ServerLock:
    """The lock of the database with this URL.

    is_shared: other nodes of a cluster may have it at the same time.
    on_taken: is called if another server got it while the connection was lost: this
    one must end.
    """
    try:
        url = url_of(database)
    except (sa.exc.SQLAlchemyError, ImportError) as error:
        raise StoreFailed(str(error)) from error
    file = database_file(url)
    if file is None:
        return PostgresqlLock(url, on_taken, is_shared=is_shared)
    return FileLock(file, is_shared=is_shared)


class FileLock:
    """A lock on a file beside that of the database."""

    def __init__(self, database: Path, *, is_shared: bool = False) -> None:
        self._kind = fcntl.LOCK_SH if is_shared else fcntl.LOCK_EX
        self._database = database
        self._descriptor: int | None = None
        path = database.resolve()  # two names of one file have one lock
        self._path = path.with_name(f"{path.name}.lock")

    async def acquire(self) -> None:
        try:
            _check_is_sqlite(self._database)
            private_files.create_empty(self._path)
            # Not inherited: a simulator that survives the server does not hold it.
            self._descriptor = os.open(self._path, os.O_RDWR | os.O_CLOEXEC)
            has_it = await self._wait(self._descriptor)
            holder = os.pread(self._descriptor, 200, 0).decode(errors="replace")
            if has_it:
                os.ftruncate(self._descriptor, 0)
                os.pwrite(self._descriptor, _name_of_this_server().encode(), 0)
        except OSError as error:
            await self.release()
            why = describe_file_fault(error, self._database)
            raise StoreFailed(why) from error
        if not has_it:
            await self.release()
            raise StoreFailed(_in_use(holder))

    async def _wait(self, descriptor: int) -> bool:
        deadline = time.monotonic() + WAIT_S
        while not self._try(descriptor):
            if time.monotonic() > deadline:
                return False
            await asyncio.sleep(_POLL_S)
        return True

    def _try(self, descriptor: int) -> bool:
        try:
            fcntl.flock(descriptor, self._kind | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True

    async def release(self) -> None:
        """The file stays: who waits for it must not wait for a file that is gone."""
        if self._descriptor is not None:
            os.close(self._descriptor)
            self._descriptor = None


class PostgresqlLock:
    """Holds the lock by a connection; if that is lost, takes the lock again at once."""

    def __init__(
        self, url: sa.URL, on_taken: Callable[[], None], *, is_shared: bool = False
    ) -> None:
        functions = sa.func.pg_advisory_lock_shared, sa.func.pg_advisory_lock
        self._take = functions[0 if is_shared else 1]
        self._url, self._on_taken = url, on_taken
        self._engine = postgresql.engine_of_lock(url, _name_of_this_server())
        self._connection: AsyncConnection | None = None
        self._held_by: int | None = None  # the process of PostgreSQL
        self._lost = asyncio.Event()
        self._watching: asyncio.Task[None] | None = None

    async def acquire(self) -> None:
        await self._lock()
        self._watching = asyncio.create_task(self._watch())

    async def release(self) -> None:
        if self._watching is not None:
            self._watching.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._watching
        await self._disconnect()
        await self._engine.dispose()

    async def _lock(self) -> None:
        try:
            self._connection = await self._engine.connect()
            raw = await self._connection.get_raw_connection()
            self._lost.clear()
            assert raw.driver_connection is not None
            raw.driver_connection.add_termination_listener(self._note_lost)
            await self._connection.exec_driver_sql(
                f"SET lock_timeout = {round(WAIT_S * 1000)}"
            )
            await self._connection.execute(sa.select(self._take(_KEY)))
            self._held_by = raw.driver_connection.get_server_pid()
        except (sa.exc.SQLAlchemyError, OSError) as error:
            failed = StoreFailed(postgresql.describe(self._url, error))
            if postgresql.code_of(error) == _LOCK_NOT_AVAILABLE:
                name, process = await self._holder()
                # PostgreSQL may learn later than this server that it was lost.
                if process is None or process != self._held_by:
                    failed = _Taken(_in_use(name))
            await self._disconnect()
            raise failed from error

    async def _holder(self) -> tuple[str, int | None]:
        """The holder's name, and the PostgreSQL process that has the lock for it."""
        assert self._connection is not None
        halves = {"high": _KEY >> 32, "low": _KEY & 0xFFFFFFFF}
        try:
            row = (await self._connection.execute(_HOLDER, halves)).first()
        except (sa.exc.SQLAlchemyError, OSError):
            row = None
        return ("", None) if row is None else (row[0] or "", row[1])

    async def _disconnect(self) -> None:
        connection, self._connection = self._connection, None
        if connection is not None:
            with contextlib.suppress(sa.exc.SQLAlchemyError, OSError):
                await connection.close()

    def _note_lost(self, _connection: object) -> None:
        self._lost.set()

    async def _wait_until_lost(self) -> None:
        """Also if no end of the connection is reported to this machine."""
        while not self._lost.is_set():
            with contextlib.suppress(TimeoutError):
                async with asyncio.timeout(CHECK_S):
                    await self._lost.wait()
                    return
            assert self._connection is not None
            raw = (await self._connection.get_raw_connection()).driver_connection
            assert raw is not None
            try:
                await raw.fetchval("SELECT 1", timeout=CHECK_TIMEOUT_S)
            except Exception as error:  # noqa: BLE001  asyncpg is imported if used
                log.warning("the connection that locks the database: %r", error)
                raw.terminate()  # a close would wait for an answer
                self._lost.set()

    async def _watch(self) -> None:
        backoff = Backoff.of_database()
        while True:
            await self._wait_until_lost()
            await self._disconnect()
            try:
                await self._lock()
                log.warning("the connection that locks the database was made again")
                backoff.reset()
            except _Taken as error:
                log.critical("the database was taken: %s; this server ends", error)
                self._on_taken()
                return
            except StoreFailed:  # requests report it
                self._lost.set()
                await asyncio.sleep(backoff.next_s())


class _Taken(StoreFailed):
    """Another server has the lock."""


def _check_is_sqlite(path: Path) -> None:
    """Raises StoreFailed for a file of something else: beside it no lock is made."""
    if not path.exists():
        return
    with path.open("rb") as file:
        begin = file.read(len(_SQLITE))
    if begin not in (b"", _SQLITE):
        raise StoreFailed(f"{path} is not a database")


def _in_use(name: str) -> str:
    by = f" ({name})" if name else ""
    return f"another server uses it{by}; end that one first"


def _name_of_this_server() -> str:
    """A name of at most 63 bytes, because PostgreSQL cuts longer ones."""
    return f"proctor, process {os.getpid()} on {socket.gethostname()}"[:63]
