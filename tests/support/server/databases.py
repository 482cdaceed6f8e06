"""A database of one test, SQLite or PostgreSQL, and a look at it from outside."""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from tests.support.server.postgresql_server import PostgresqlServer

WRITES = (("UPDATE", "runs"), ("INSERT", "runs"), ("INSERT", "episodes"))

# Columns of runs that came with versions.
RUN_COLUMNS = ("owner", "fence", "failed_by")
# What the first database with a version has, and none before it.
MAKE_UNVERSIONED = (
    "DROP TABLE alembic_version",
    *(f"DROP TABLE {name}" for name in ("nodes", "accounts", "cluster_facts")),
    *(f"ALTER TABLE runs DROP COLUMN {name}" for name in RUN_COLUMNS),
    "ALTER TABLE episodes DROP COLUMN last_left",
)


@dataclass(frozen=True)
class UsedDatabase:
    """Opened by `url`. server: of PostgreSQL; path: of SQLite."""

    url: str
    path: Path | None = None
    server: PostgresqlServer | None = None

    @classmethod
    def of_file(cls, path: Path) -> UsedDatabase:
        return cls(f"sqlite:///{path}", path)

    @property
    def setting(self) -> str:
        """As `database` of a server names it."""
        return str(self.path or self.url)

    @property
    def name(self) -> str:
        return self.url.partition("@/")[2].partition("?")[0]

    def execute(self, *statements: str) -> list[tuple[Any, ...]]:
        """The rows of the last one, run behind the server's back in one transaction."""
        if self.server is not None:
            return self.server.execute(self.name, *statements)
        assert self.path is not None
        with contextlib.closing(sqlite3.connect(self.path)) as database, database:
            for statement in statements[:-1]:
                database.execute(statement)
            return database.execute(statements[-1]).fetchall()

    def count(self, table: str) -> int:
        return int(self.execute(f"SELECT count(*) FROM {table}")[0][0])  # noqa: S608

    def make_unversioned(self) -> None:
        """As the last server that had no versions left it, with the rows it has."""
        self.execute(*MAKE_UNVERSIONED)

    @contextmanager
    def reject_writes(self) -> Iterator[None]:
        """While it lasts the database takes no write and can still be read."""
        if self.server is None:
            does = "BEGIN SELECT RAISE(ABORT, 'the disk is full'); END"
        else:
            self.execute(
                "CREATE FUNCTION full_disk() RETURNS trigger AS $$ BEGIN RAISE "
                "EXCEPTION 'the disk is full'; END $$ LANGUAGE plpgsql"
            )
            does = "FOR EACH ROW EXECUTE FUNCTION full_disk()"
        self.execute(
            *(
                f"CREATE TRIGGER full_{event}_{table} BEFORE {event} ON {table} {does}"
                for event, table in WRITES
            )
        )
        yield
        for event, table in WRITES:
            of = "" if self.server is None else f" ON {table}"
            self.execute(f"DROP TRIGGER full_{event}_{table}{of}")


@pytest.fixture(scope="session")
def postgresql() -> Iterator[PostgresqlServer]:
    """One server for all tests of a process; only slow tests use it."""
    with PostgresqlServer() as server:
        yield server


@pytest.fixture(
    params=["sqlite", pytest.param("postgresql", marks=pytest.mark.slow("PostgreSQL"))]
)
def database(request: pytest.FixtureRequest, tmp_path: Path) -> UsedDatabase:
    """An empty database of each kind."""
    if request.param == "sqlite":
        return UsedDatabase.of_file(tmp_path / "proctor.sqlite")
    server: PostgresqlServer = request.getfixturevalue("postgresql")
    return UsedDatabase(server.create(), server=server)
