"""One server at a time uses a database; what it says of one that it cannot use."""

from __future__ import annotations

import asyncio
import importlib.util
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import sqlalchemy as sa

from reference_server.process.backoff import Backoff
from reference_server.storage.connection import server_lock
from reference_server.storage.connection.database import Database
from reference_server.storage.connection.server_lock import lock_of
from reference_server.storage.runs.run_store import Store, StoreFailed
from tests.support.paths import ROOT
from tests.support.server.databases import UsedDatabase
from tests.support.server.postgresql_server import PostgresqlServer
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until

# A process that has the lock and waits to be killed.
HOLDER = """
import asyncio, sys
from reference_server.storage.connection.server_lock import lock_of
async def hold():
    lock = lock_of(sys.argv[1], lambda: None)
    await lock.acquire()
    print("locked", flush=True)
    await asyncio.Event().wait()
asyncio.run(hold())
"""


def ignore() -> None:
    """When the lock is taken."""


@pytest.fixture(autouse=True)
def _do_not_wait_long(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Backoff, "next_s", lambda _: 0.02)


def start_holder(url: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-c", HOLDER, url]
    holder = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True)
    assert holder.stdout is not None
    assert holder.stdout.readline() == "locked\n"
    return holder


def test_a_second_server_is_refused_until_the_first_is_killed(
    database: UsedDatabase, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(server_lock, "WAIT_S", 0.05)

    async def acquire_and_release() -> None:
        lock = lock_of(database.url, ignore)
        try:
            await lock.acquire()
        finally:
            await lock.release()

    with start_holder(database.url) as holder:
        with pytest.raises(StoreFailed, match=f"another server .*process {holder.pid}"):
            asyncio.run(acquire_and_release())
        monkeypatch.setattr(server_lock, "WAIT_S", TIMEOUT_S)
        os.kill(holder.pid, signal.SIGKILL)  # it is not awaited: the lock is
        asyncio.run(acquire_and_release())
    asyncio.run(acquire_and_release())


async def test_two_names_of_a_file_have_one_lock(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(server_lock, "WAIT_S", 0.0)
    (tmp_path / "link.sqlite").symlink_to(tmp_path / "proctor.sqlite")
    first, second = (
        lock_of(f"sqlite:///{tmp_path / name}", ignore)
        for name in ("proctor.sqlite", "link.sqlite")
    )
    await first.acquire()
    with pytest.raises(StoreFailed, match="another server uses it"):
        await second.acquire()
    await first.release()
    await second.acquire()
    await second.release()


def test_beside_another_file_no_lock_is_made(tmp_path: Path) -> None:
    path = tmp_path / "photo"
    path.write_bytes(b"of something else")
    lock = lock_of(f"sqlite:///{path}", ignore)
    with pytest.raises(StoreFailed, match="is not a database"):
        asyncio.run(lock.acquire())
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.slow("starts PostgreSQL")
async def test_a_lost_connection_is_made_again(
    postgresql: PostgresqlServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It has the lock again; a server that finds it taken ends."""
    monkeypatch.setattr(server_lock, "WAIT_S", 0.05)
    database = UsedDatabase(postgresql.create(), server=postgresql)
    end = (
        "SELECT pg_terminate_backend(pid) FROM pg_stat_activity "
        "WHERE application_name LIKE 'proctor, %'"
    )
    holders = "SELECT pid FROM pg_locks WHERE locktype = 'advisory' AND granted"

    def is_held() -> bool:
        return len(database.execute(holders)) == 1

    async def fail() -> None:
        raise StoreFailed("there is no PostgreSQL")

    taken = asyncio.Event()
    lock, other = (lock_of(database.url, one) for one in (taken.set, ignore))
    await lock.acquire()
    held_by = database.execute(holders)
    database.execute(end)
    await asyncio.to_thread(
        wait_until,
        lambda: is_held() and database.execute(holders) != held_by,
        "it is held again",
    )
    with pytest.raises(StoreFailed):
        await other.acquire()
    # This server does not reach PostgreSQL, and another one does.
    with monkeypatch.context() as patch:
        patch.setattr(lock, "_lock", fail)
        database.execute(end)
        await asyncio.to_thread(wait_until, lambda: not is_held(), "it is released")
        await other.acquire()
    assert not taken.is_set()
    async with asyncio.timeout(TIMEOUT_S):
        await taken.wait()
    await lock.release()
    await other.release()


@pytest.mark.slow("starts PostgreSQL")
async def test_a_connection_that_is_silent_is_made_again(
    postgresql: PostgresqlServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """While PostgreSQL still has the lock for it, no other server has taken it."""
    for name in ("WAIT_S", "CHECK_S", "CHECK_TIMEOUT_S"):
        monkeypatch.setattr(server_lock, name, 0.05)
    database = UsedDatabase(postgresql.create(), server=postgresql)
    granted = (
        "SELECT l.pid FROM pg_locks l JOIN pg_database d ON d.oid = l.database "
        "WHERE locktype = 'advisory' AND datname = current_database() AND "
    )
    taken = asyncio.Event()
    lock = lock_of(database.url, taken.set)
    await lock.acquire()
    ((pid,),) = database.execute(granted + "granted")
    os.kill(pid, signal.SIGSTOP)
    try:
        await asyncio.to_thread(
            wait_until,
            lambda: database.execute(granted + "NOT granted") != [],
            "another connection waits for the lock",
        )
    finally:
        os.kill(pid, signal.SIGCONT)
    await asyncio.to_thread(
        wait_until,
        lambda: database.execute(granted + "granted") not in ([], [(pid,)]),
        "another connection has the lock",
    )
    assert not taken.is_set()
    await lock.release()


@pytest.mark.slow("starts PostgreSQL")
async def test_what_is_wrong_with_postgresql_is_said(
    postgresql: PostgresqlServer,
) -> None:
    """In one line, and without the password."""
    right = postgresql.create()
    name = right.partition("@/")[2].partition("?")[0]

    async def fail(url: str, text: str) -> None:
        for work in (lock_of(url, ignore).acquire, Store(url).open):
            with pytest.raises(StoreFailed, match=text) as caught:
                await work()
            assert "\n" not in str(caught.value)
            assert "wrong" not in str(caught.value)

    wrong = postgresql.url(name, password="wrong")
    await fail(wrong, "refuses the user postgres: password authentication failed")
    await fail(postgresql.url("nowhere"), "create it: createdb nowhere")
    nowhere = "postgresql://u:wrong@127.0.0.1:1/x"
    await fail(nowhere, "no PostgreSQL at 127.0.0.1:1")
    missing = "postgresql://u:wrong@nowhere.invalid/x"
    await fail(missing, "no PostgreSQL at nowhere.invalid:5432")


@pytest.mark.slow("starts PostgreSQL")
async def test_a_url_without_a_name_means_that_of_the_environment_or_of_the_user(
    postgresql: PostgresqlServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def used() -> str | None:
        database = Database(postgresql.url(""))
        try:
            query = sa.select(sa.func.current_database())
            return await database.read(lambda connection: connection.scalar(query))
        finally:
            await database.close()

    assert await used() == "postgres"
    name = postgresql.create().partition("@/")[2].partition("?")[0]
    monkeypatch.setenv("PGDATABASE", name)
    assert await used() == name
    monkeypatch.setenv("PGDATABASE", "nowhere")
    with pytest.raises(StoreFailed, match="create it: createdb nowhere"):
        await used()


@pytest.mark.parametrize(
    ("url", "text"),
    [
        ("postgresql+psycopg://h/x", "psycopg is not supported; write postgresql://"),
        ("postgres://h/x?sslmode=require&colour=red", "unknown option colour"),
        ("postgresql://u:secret@h:5432x/x", "^the port in the URL is no number from"),
        ("postgresql://u:secret", "^the port in the URL is no number from"),
        ("postgresql://u:secret@h:65536/x", "^the port in the URL is no number from"),
        ("postgresql://u:x@secret/y@h:5/x", "more than one @: write @ as %40 and / as"),
        ("postgresql://u:x@secret:y@a,b/x", "more than one @: write @ as %40"),
        ("postgresql://u:x@secret@h", "more than one @: write @ as %40"),
    ],
)
def test_a_url_that_cannot_be_used_is_refused(url: str, text: str) -> None:
    for use in (Store, lambda one: lock_of(one, ignore)):
        with pytest.raises(StoreFailed, match=text) as caught:
            use(url)
        assert "secret" not in str(caught.value)


def test_a_missing_driver_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda _name: None)
    advice = re.escape(f"pip install '{ROOT}[server,postgresql]'")
    with pytest.raises(StoreFailed, match=advice):
        Store("postgresql://h/x")
