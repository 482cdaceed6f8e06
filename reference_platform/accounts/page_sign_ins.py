"""Accounts that are signed in here are signed in at the pages of the server, too.

A browser takes a code from here to the sign-in of the server, which changes it for a
token: once, and only for the browser that began there. The token ends with the session
here, with the approval of the account, and with its membership.
"""

from __future__ import annotations

import json
import secrets
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from reference_platform.accounts.account_keys import new_secret
from reference_platform.accounts.browser_sessions import IDLE_S, LIFE_S
from reference_platform.storage.platform_database import Database
from reference_server.http.auth import hash_of

CODE_S: Final = 60.0
# The most codes of one session: no browser begins more sign-ins at once.
CODES_MAX: Final = 16
# Selects the readers that may still read; ?: a JSON array of [session_hash, owner].
_MAY_READ: Final = (
    "WITH readers AS (SELECT json_extract(value, '$[0]') AS session_hash, "
    "json_extract(value, '$[1]') AS owner FROM json_each(?)) "
    "SELECT session_hash, owner FROM readers "
    "JOIN sessions ON sessions.hash = session_hash JOIN accounts USING (account) "
    "WHERE accounts.state = 'approved' AND begun_at > ? AND used_at > ? "
    "AND (accounts.account = owner OR EXISTS (SELECT * FROM members "
    "WHERE members.organisation = owner AND members.account = accounts.account))"
)


@dataclass(frozen=True, slots=True)
class _Reader:
    """session_hash: of the session here. owner: the account, or an organisation."""

    session_hash: str
    owner: str


class PageSignIns:
    """The codes and the tokens of this process, in memory alone."""

    def __init__(self, database: Database) -> None:
        self._database = database
        # Code → its reader, the browser for which it is, and when it ends.
        self._codes: dict[str, tuple[_Reader, str, float]] = {}
        self._tokens: dict[_Reader, str] = {}

    def make_code(self, session_hash: str, owner: str, state: str, now: float) -> str:
        """state: by which the sign-in of the server knows the browser again."""
        self._codes = {code: row for code, row in self._codes.items() if row[2] > now}
        readers = ((code, row[0]) for code, row in self._codes.items())
        own = [code for code, reader in readers if reader.session_hash == session_hash]
        for old in own[: max(0, len(own) - CODES_MAX + 1)]:
            del self._codes[old]
        code = secrets.token_urlsafe(32)
        self._codes[code] = _Reader(session_hash, owner), state, now + CODE_S
        return code

    def take_token(self, code: str, state: str, now: float) -> str | None:
        """The token for a code that was not used; None for every other one."""
        reader, expected, ends_at = self._codes.pop(code, (None, "", 0.0))
        if reader is None or ends_at <= now or state != expected:
            return None
        return self._tokens.setdefault(reader, new_secret())

    def valid(self, now: float) -> Mapping[str, str]:
        """The owners, by the hashes of the tokens."""
        if not self._tokens:  # asked many times a second, mostly with none
            return {}
        asked = json.dumps([(one.session_hash, one.owner) for one in self._tokens])
        rows = self._database.rows(
            _Reader, _MAY_READ, asked, now - LIFE_S, now - IDLE_S
        )
        self._tokens = {reader: self._tokens[reader] for reader in rows}
        return {hash_of(token): one.owner for one, token in self._tokens.items()}
