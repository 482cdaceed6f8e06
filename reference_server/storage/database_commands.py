"""`proctor admin db`: upgrade, check and back up the database of a server.

`check` and `backup` may run while the server does; `upgrade` needs it stopped.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import shutil
import sqlite3
import subprocess
from pathlib import Path

import sqlalchemy as sa

from reference_record.command_line.click_commands import (
    Command,
    Group,
    Options,
    argument,
)
from reference_server.files import private_files
from reference_server.files.file_faults import describe_file_fault
from reference_server.storage.connection import postgresql
from reference_server.storage.connection.database import Database, StoreFailed
from reference_server.storage.connection.existing_database import require_database
from reference_server.storage.connection.server_lock import lock_of
from reference_server.storage.tables import schema_version
from reference_server.storage.tables.database_tables import episodes, manifests, runs

_OF_MANIFEST = runs.c.manifest_sha256 == manifests.c.manifest_sha256
_OF_RUN = episodes.c.number == runs.c.number
_COUNT = sa.select(sa.func.count())
# Description of an inconsistency → query that counts its rows.
_INCONSISTENT = {
    "runs without their manifest": _COUNT.select_from(
        runs.outerjoin(manifests, _OF_MANIFEST)
    ).where(manifests.c.manifest_sha256.is_(None)),
    "episodes without their run": _COUNT.select_from(
        episodes.outerjoin(runs, _OF_RUN)
    ).where(runs.c.number.is_(None)),
}


def database_area() -> Group:
    """The area of `proctor admin`; `do_with_database` is the function of a command."""
    file = argument("file", "a file that does not exist")
    commands = [
        Command(
            "upgrade",
            "give the database the tables of this version",
            [],
            do_with_database=upgrade,
        ),
        Command(
            "check",
            "is it there, of which version, and is its content consistent",
            [],
            do_with_database=check,
        ),
        Command(
            "backup",
            "copy it, also while it is used",
            [file],
            do_with_database=back_up,
        ),
    ]
    return Group("db", "the database: upgrade, check, back up", commands)


def upgrade(url: str, _args: Options) -> None:
    """Upgrade the database as the next start of the server would do it."""
    done = asyncio.run(_upgrade(url))
    version = schema_version.VERSIONS[-1]
    before = "" if done is None else f" (before: {done.before or 'none'})"
    print(f"the database is of version {version}{before}")


async def _upgrade(url: str) -> schema_version.Upgrade | None:
    lock, database = lock_of(url, lambda: None), Database(url)
    try:
        await lock.acquire()
        require_database(url)
        return await database.open()
    finally:
        await database.close()
        await lock.release()


def check(url: str, _args: Options) -> None:
    """Prints what is found. Raises StoreFailed if anything is wrong."""
    version, problems = asyncio.run(_look(url))
    print(f"version: {version or 'none'} (this server: {schema_version.VERSIONS[-1]})")
    for problem in problems:
        print(f"problem: {problem}")
    if problems:
        raise StoreFailed("the database is not as it should be; restore a backup")
    if version != schema_version.VERSIONS[-1]:
        raise StoreFailed("the version is another one; see `proctor admin db upgrade`")
    print("content: consistent")


async def _look(url: str) -> tuple[str | None, list[str]]:
    database = Database(url)
    try:
        require_database(url)
        version = await database.read(schema_version.read_version)
        if version not in schema_version.VERSIONS:
            return version, []
        return version, await database.read(_problems)
    finally:
        await database.close()


def _problems(connection: sa.Connection) -> list[str]:
    problems = []
    if connection.dialect.name == "sqlite":
        answers = connection.exec_driver_sql("PRAGMA integrity_check").scalars()
        problems = [answer for answer in answers if answer != "ok"]
    for name, query in _INCONSISTENT.items():
        if count := connection.scalar(query):
            problems.append(f"{count} {name}")
    return problems


def back_up(url: str, args: Options) -> None:
    """Write a copy of one moment to a file that only its owner may read."""
    path = Path(args.file)
    if not private_files.create_empty(path):
        raise StoreFailed(f"{path} exists already")
    try:
        copy_database(url, path)
    except BaseException:
        path.unlink()
        raise
    print(f"{path}: {path.stat().st_size} bytes")


def copy_database(url: str, path: Path) -> None:
    """Write a copy of one moment into an empty file. Raises StoreFailed."""
    database = Database(url)
    try:
        require_database(url)
        if database.file is None:
            _dump_postgresql(database.url, path)
        else:
            _copy_sqlite(database.file, path)
    finally:
        asyncio.run(database.close())


def _copy_sqlite(source: Path, target: Path) -> None:
    """Copy the committed content of the file; a server may write to it meanwhile."""
    try:
        with (
            contextlib.closing(
                sqlite3.connect(f"{source.absolute().as_uri()}?mode=ro", uri=True)
            ) as original,
            contextlib.closing(sqlite3.connect(target)) as copy,
        ):
            original.backup(copy)
    except sqlite3.Error as error:
        folder = target.absolute().parent
        raise StoreFailed(describe_file_fault(error, folder)) from error


def _dump_postgresql(url: sa.URL, target: Path) -> None:
    """Call pg_dump with the password in its environment, not on its command line."""
    plain = postgresql.url_of_programs(url)
    command = ["pg_dump", "--format=custom", f"--file={target}", f"--dbname={plain}"]
    if shutil.which("pg_dump") is None:
        raise StoreFailed(
            "pg_dump is not installed here; run it where it is: " + " ".join(command)
        )
    secret = {} if url.password is None else {"PGPASSWORD": str(url.password)}
    done = subprocess.run(
        command, env=os.environ | secret, capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise StoreFailed(" ".join(done.stderr.split()) or "pg_dump failed")
