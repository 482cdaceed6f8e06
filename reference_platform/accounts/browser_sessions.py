"""Sessions of browsers, as rows: the cookie is a secret, stored as its hash alone.

Each sign-in begins a new session, whatever cookie came with it.
"""

from __future__ import annotations

import contextlib
import secrets
import sqlite3
from typing import Final

import msgspec

from reference_platform.storage.platform_database import Database
from reference_server.http.auth import hash_of

SESSIONS_PER_ACCOUNT_MAX: Final = 50
LIFE_S: Final = 12 * 3600.0
IDLE_S: Final = 2 * 3600.0
# `used_at` is written no more often than this.
NOTED_S: Final = 60.0


class Session(msgspec.Struct, frozen=True):
    """csrf: what the forms of this session carry."""

    hash: str
    account: str
    csrf: str
    begun_at: float
    used_at: float


class Sessions:
    def __init__(self, database: Database) -> None:
        self._database = database

    def begin(self, account: str, now: float) -> str:
        """The cookie of a new session."""
        cookie = secrets.token_urlsafe(32)
        session = Session(hash_of(cookie), account, secrets.token_urlsafe(32), now, now)
        with self._database.transaction():
            self._database.execute(
                "DELETE FROM sessions WHERE begun_at < ? OR used_at < ?",
                *(now - LIFE_S, now - IDLE_S),
            )
            self._database.insert("sessions", session)
            self._database.execute(
                "DELETE FROM sessions WHERE account = ? AND hash NOT IN (SELECT hash "
                "FROM sessions WHERE account = ? ORDER BY begun_at DESC LIMIT ?)",
                *(account, account, SESSIONS_PER_ACCOUNT_MAX),
            )
        return cookie

    def find(self, cookie: str, now: float) -> Session | None:
        session = self._database.row(
            Session,
            "SELECT * FROM sessions WHERE hash = ? AND begun_at > ? AND used_at > ?",
            *(hash_of(cookie), now - LIFE_S, now - IDLE_S),
        )
        if session is not None and now - session.used_at > NOTED_S:
            # It is written later if another process writes now.
            with contextlib.suppress(sqlite3.OperationalError):
                self._database.execute(
                    "UPDATE sessions SET used_at = ? WHERE hash = ?", now, session.hash
                )
        return session

    def end(self, cookie: str) -> None:
        self._database.execute("DELETE FROM sessions WHERE hash = ?", hash_of(cookie))

    def end_all(self, account: str) -> None:
        self._database.execute("DELETE FROM sessions WHERE account = ?", account)
