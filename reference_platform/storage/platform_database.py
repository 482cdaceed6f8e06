"""The database of the platform: its tables, and transactions.

One file, used by the platform and by `proctor admin` at the same time. Statements are
short, so they are executed where they are called. A lock of another process may last:
the platform waits for its end with `until_free`, which leaves the event loop to others.
Times are seconds since the epoch.
"""

from __future__ import annotations

import asyncio
import sqlite3
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, is_dataclass
from pathlib import Path
from typing import Any, Final, TypeVar

import msgspec

from reference_platform.storage.upgrades import upgrade_from_1
from reference_server.files.file_faults import describe_file_fault
from reference_server.files.private_files import create_empty

SCHEMA_VERSION: Final = 2
BUSY_MS: Final = 5000
# In an event loop, which would stand still for so long.
_BRIEF_MS: Final = 50
_LOOK_S: Final = 0.02
_TABLES: Final = """
CREATE TABLE IF NOT EXISTS accounts (
    account TEXT PRIMARY KEY, full_name TEXT NOT NULL, organisation TEXT NOT NULL,
    email TEXT NOT NULL, email_changed_at REAL, evaluation TEXT NOT NULL,
    is_own_model INTEGER NOT NULL, agreed_at REAL NOT NULL, password_hash TEXT NOT NULL,
    role TEXT NOT NULL, state TEXT NOT NULL, reason TEXT NOT NULL,
    created_at REAL NOT NULL, decided_at REAL
) STRICT;
CREATE TABLE IF NOT EXISTS keys (
    key_id TEXT PRIMARY KEY, hash TEXT NOT NULL UNIQUE, account TEXT NOT NULL,
    label TEXT NOT NULL, scopes TEXT NOT NULL, made_at REAL NOT NULL,
    expires_at REAL NOT NULL, used_at REAL, revoked_at REAL,
    organisation TEXT NOT NULL
) STRICT;
CREATE INDEX IF NOT EXISTS keys_of_account ON keys (account);
CREATE TABLE IF NOT EXISTS organisations (
    organisation TEXT PRIMARY KEY, title TEXT NOT NULL, created_at REAL NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS members (
    organisation TEXT NOT NULL, account TEXT NOT NULL, role TEXT NOT NULL,
    PRIMARY KEY (organisation, account)
) STRICT;
CREATE INDEX IF NOT EXISTS organisations_of_account ON members (account);
CREATE TABLE IF NOT EXISTS invitations (
    hash TEXT PRIMARY KEY, organisation TEXT NOT NULL, email TEXT NOT NULL,
    role TEXT NOT NULL, invited_by TEXT NOT NULL, expires_at REAL NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS draws (
    draw_id TEXT PRIMARY KEY, state TEXT NOT NULL, drawn TEXT NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS sessions (
    hash TEXT PRIMARY KEY, account TEXT NOT NULL, csrf TEXT NOT NULL,
    begun_at REAL NOT NULL, used_at REAL NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS logins (
    hash TEXT PRIMARY KEY, nonce TEXT NOT NULL, verifier TEXT NOT NULL,
    account TEXT NOT NULL, expires_at REAL NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS identities (
    issuer TEXT NOT NULL, subject TEXT NOT NULL, account TEXT NOT NULL,
    PRIMARY KEY (issuer, subject)
) STRICT;
CREATE TABLE IF NOT EXISTS devices (
    hash TEXT PRIMARY KEY, user_code TEXT NOT NULL UNIQUE, label TEXT NOT NULL,
    state TEXT NOT NULL, account TEXT NOT NULL, expires_at REAL NOT NULL,
    polled_at REAL NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS tracks (
    track_id TEXT PRIMARY KEY, document TEXT NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS entrants (
    track_id TEXT NOT NULL, account TEXT NOT NULL, state TEXT NOT NULL,
    reason TEXT NOT NULL, entered_at REAL NOT NULL, PRIMARY KEY (track_id, account)
) STRICT;
CREATE TABLE IF NOT EXISTS track_runs (
    run_id TEXT PRIMARY KEY, track_id TEXT NOT NULL, account TEXT NOT NULL,
    made_at REAL NOT NULL, state TEXT NOT NULL, score REAL,
    phase_id TEXT NOT NULL, policy_name TEXT NOT NULL
) STRICT;
CREATE INDEX IF NOT EXISTS runs_of_account ON track_runs (account, track_id);
CREATE TABLE IF NOT EXISTS submissions (
    submission_id TEXT PRIMARY KEY, account TEXT NOT NULL, track_id TEXT NOT NULL,
    kind TEXT NOT NULL, state TEXT NOT NULL, entered_at REAL NOT NULL,
    created_at REAL NOT NULL, deadline_at REAL, reason TEXT NOT NULL,
    digest TEXT NOT NULL, preset TEXT NOT NULL, policy_name TEXT NOT NULL,
    cause TEXT NOT NULL, run_id TEXT NOT NULL, verification_run_id TEXT NOT NULL,
    started_at REAL, is_counted INTEGER NOT NULL, phase_id TEXT NOT NULL,
    score REAL, commit_index INTEGER
) STRICT;
CREATE INDEX IF NOT EXISTS submissions_of_account ON submissions (account, track_id);
CREATE INDEX IF NOT EXISTS submissions_by_state ON submissions (state, entered_at);
CREATE TABLE IF NOT EXISTS images (
    digest TEXT PRIMARY KEY, account TEXT NOT NULL, size INTEGER NOT NULL,
    dockerfile TEXT NOT NULL, state TEXT NOT NULL, reason TEXT NOT NULL,
    created_at REAL NOT NULL, decided_at REAL
) STRICT;
CREATE TABLE IF NOT EXISTS audit (
    number INTEGER PRIMARY KEY AUTOINCREMENT, at REAL NOT NULL, actor TEXT NOT NULL,
    act TEXT NOT NULL, subject TEXT NOT NULL, detail TEXT NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS mail (
    number INTEGER PRIMARY KEY AUTOINCREMENT, recipient TEXT NOT NULL,
    subject TEXT NOT NULL, body TEXT NOT NULL, made_at REAL NOT NULL, sent_at REAL,
    tries INTEGER NOT NULL, error TEXT NOT NULL
) STRICT;
"""
# Made in a database of any version: programs that do not know them ignore them.
_ADDED_TABLES: Final = """
DROP TABLE IF EXISTS served_benchmarks;
DROP TABLE IF EXISTS history_entries;
DROP TABLE IF EXISTS last_read_leaf;
CREATE TABLE IF NOT EXISTS benchmarks_of_server (
    benchmark_id TEXT PRIMARY KEY, splits TEXT NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS run_figures (
    run_id TEXT PRIMARY KEY, document TEXT NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS board_entries (
    entry_id TEXT PRIMARY KEY, run_id TEXT NOT NULL, manifest_sha256 TEXT NOT NULL,
    state TEXT NOT NULL, flag TEXT
) STRICT;
CREATE INDEX IF NOT EXISTS board_entries_of_runs ON board_entries (run_id);
CREATE TABLE IF NOT EXISTS last_leaf (
    "index" INTEGER PRIMARY KEY, leaf TEXT NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS password_resets (
    hash TEXT PRIMARY KEY, account TEXT NOT NULL, made_at REAL NOT NULL, used_at REAL
) STRICT;
CREATE TABLE IF NOT EXISTS sandbox_uses (
    number INTEGER PRIMARY KEY AUTOINCREMENT, submission_id TEXT NOT NULL,
    account TEXT NOT NULL, purpose TEXT NOT NULL, ended_at REAL NOT NULL,
    seconds REAL NOT NULL, cpu_s REAL
) STRICT;
"""
Value = str | int | float | bytes | None
Record = TypeVar("Record")


class BadDatabase(Exception):
    """The file cannot be used; the text says why."""


def unusable(path: Path, error: Exception) -> str:
    """That the file cannot be used, why, and what to do."""
    why = describe_file_fault(error, path)
    text = f"the database of the platform, {path}, cannot be used ({why})"
    return f"{text}; choose another with --database"


class Database:
    """Opens the file, and makes it if it is missing. Raises BadDatabase."""

    def __init__(self, path: Path) -> None:
        try:
            create_empty(path)  # for its owner alone
            self._connection = sqlite3.connect(path, isolation_level=None)
        except (OSError, sqlite3.Error) as error:
            raise BadDatabase(unusable(path, error)) from error
        try:
            self._connection.row_factory = sqlite3.Row
            self._connection.execute(f"PRAGMA busy_timeout = {BUSY_MS}")
            self._connection.execute("PRAGMA journal_mode = WAL")
            self._connection.execute("PRAGMA synchronous = FULL")
            with self.transaction():
                self._make_tables()
        except sqlite3.Error as error:
            self._connection.close()
            raise BadDatabase(unusable(path, error)) from error
        self.path = path

    def _make_tables(self) -> None:
        for statement in filter(str.strip, _ADDED_TABLES.split(";")):
            self._connection.execute(statement)
        version = self._connection.execute("PRAGMA user_version").fetchone()[0]
        if version == SCHEMA_VERSION:
            return
        if version not in (0, 1):
            raise sqlite3.DatabaseError(f"it is of version {version}")
        if version == 1:
            upgrade_from_1(self._connection)
        for statement in filter(str.strip, _TABLES.split(";")):
            self._connection.execute(statement)
        self._connection.execute(f"PRAGMA user_version = {SCHEMA_VERSION}")

    def close(self) -> None:
        self._connection.close()

    def wait_briefly(self) -> None:
        """From now on, a statement fails soon while another process writes."""
        self._connection.execute(f"PRAGMA busy_timeout = {_BRIEF_MS}")

    async def until_free(self, seconds: float = BUSY_MS / 1000) -> None:
        """Wait until no other process writes. Raises sqlite3.OperationalError."""
        deadline = time.monotonic() + seconds
        while True:
            try:
                with self.transaction():
                    return
            except sqlite3.OperationalError:
                if time.monotonic() > deadline:
                    raise
            await asyncio.sleep(_LOOK_S)

    @contextmanager
    def transaction(self) -> Iterator[None]:
        """All statements inside are stored, or none; within another one, with it."""
        if self._connection.in_transaction:
            yield
            return
        self._connection.execute("BEGIN IMMEDIATE")
        try:
            yield
            self._connection.execute("COMMIT")
        except BaseException:
            if self._is_in_transaction():  # a full disk may have rolled it back already
                self._connection.execute("ROLLBACK")
            raise

    def _is_in_transaction(self) -> bool:
        return self._connection.in_transaction

    def rows(self, kind: type[Record], statement: str, *values: Value) -> list[Record]:
        """The rows as records of a kind, whose members are columns by their names."""
        found = self._connection.execute(statement, values).fetchall()
        return [msgspec.convert(dict(row), kind, strict=False) for row in found]

    def row(self, kind: type[Record], statement: str, *values: Value) -> Record | None:
        """The first of these rows."""
        return next(iter(self.rows(kind, statement, *values)), None)

    def number(self, statement: str, *values: Value) -> float | None:
        """The one value of the one row."""
        found: float | None = self._connection.execute(statement, values).fetchone()[0]
        return found

    def execute(self, statement: str, *values: Value) -> int:
        """How many rows were changed."""
        return self._connection.execute(statement, values).rowcount

    def insert(self, table: str, record: object) -> None:
        """A new row; raises sqlite3.IntegrityError if it exists."""
        values = _members(record)
        names, marks = ", ".join(values), ", ".join("?" * len(values))
        statement = f"INSERT INTO {table} ({names}) VALUES ({marks})"  # noqa: S608
        self._connection.execute(statement, [*values.values()])

    def data_version(self) -> int:
        """Another number after each change by another process."""
        version: int = self._connection.execute("PRAGMA data_version").fetchone()[0]
        return version + self._connection.total_changes


def _members(record: object) -> Mapping[str, Any]:
    if is_dataclass(record) and not isinstance(record, type):
        return asdict(record)
    members: Mapping[str, Any] = msgspec.structs.asdict(record)  # type: ignore[arg-type]
    return members


def audit(
    database: Database,
    at: float,
    *,
    actor: str,
    act: str,
    subject: str,
    detail: str = "",
) -> None:
    """Note what an administrator has done; in the transaction that does it."""
    database.execute(
        "INSERT INTO audit (at, actor, act, subject, detail) VALUES (?, ?, ?, ?, ?)",
        *(at, actor, act, subject, detail),
    )


class AuditLine(msgspec.Struct, frozen=True):
    number: int
    at: float
    actor: str
    act: str
    subject: str
    detail: str


def audit_lines(database: Database, newest: int) -> Sequence[AuditLine]:
    """The newest lines of the audit log, the newest first."""
    return database.rows(
        AuditLine, "SELECT * FROM audit ORDER BY number DESC LIMIT ?", newest
    )
