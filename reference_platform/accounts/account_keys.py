"""Keys of accounts: shown once, stored as hashes, with scopes and an expiry.

A key is `prk_`, 32 letters and digits, and 6 that are their checksum: scanners for
leaked secrets recognise it, and a mistyped one needs no look-up.
"""

from __future__ import annotations

import contextlib
import re
import secrets
import sqlite3
import string
import zlib
from collections.abc import Collection, Mapping, Sequence
from typing import Final

import msgspec

from reference_platform.storage.platform_database import Database
from reference_server.http.auth import hash_of
from reference_server.rules.refusal import Refused

# run, read: at the server. account: manages keys here. host: what administrators do.
SCOPES: Final = ("read", "run", "account", "host")
PREFIX: Final = "prk_"
LIFETIME_S_MAX: Final = 366 * 86_400.0
KEYS_MAX: Final = 50
NOTED_S: Final = 60.0  # the last use is written no more often than this
_LETTERS: Final = string.digits + string.ascii_letters
_KEY: Final = re.compile(r"prk_([0-9A-Za-z]{32})([0-9A-Za-z]{6})")


class Key(msgspec.Struct, frozen=True):
    """scopes: separated by spaces. Never the secret, and its hash stays in here.

    account: who made it. organisation: for which it acts; empty: for the account.
    """

    key_id: str
    hash: str
    account: str
    label: str
    scopes: str
    made_at: float
    expires_at: float
    used_at: float | None
    revoked_at: float | None
    organisation: str

    @property
    def owner(self) -> str:
        """HST-036: whom runs and submissions belong to that are made with it."""
        return self.organisation or self.account


def new_secret() -> str:
    body = "".join(secrets.choice(_LETTERS) for _ in range(32))
    return f"{PREFIX}{body}{_checksum(body)}"


def is_well_formed(secret: str) -> bool:
    match = _KEY.fullmatch(secret)
    return match is not None and _checksum(match[1]) == match[2]


def _checksum(body: str) -> str:
    value, digits = zlib.crc32(body.encode()), ""
    for _ in range(6):
        value, digit = divmod(value, len(_LETTERS))
        digits = _LETTERS[digit] + digits
    return digits


class Keys:
    """The keys of all accounts."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def make(
        self, account: str, label: str, scopes: Collection[str], lifetime_s: float,
        now: float, *, organisation: str = "",
    ) -> tuple[Key, str]:  # fmt: skip
        """A new key and its secret, which nothing shows again (HST-007).

        HST-003 holds for every way to a key: also for a program whose sign-in was
        allowed before its account was suspended.
        """
        label = label.strip() or "key"
        if not scopes or not set(scopes) <= set(SCOPES):
            raise _wrong("scopes", f"must be some of {', '.join(SCOPES)}")
        if not 60 <= lifetime_s <= LIFETIME_S_MAX:
            raise _wrong("lifetime_s", "must be from a minute to 366 days")
        if len(label) > 100 or not label.isprintable():
            raise _wrong("label", "must be one line of at most 100 characters")
        secret = new_secret()
        key = Key(
            f"key_{secrets.token_hex(8)}", hash_of(secret), account, label,
            " ".join(scope for scope in SCOPES if scope in scopes),
            now, now + lifetime_s, None, None, organisation,
        )  # fmt: skip
        with self._database.transaction():
            if not self._database.number(_IS_APPROVED, account):
                raise Refused("forbidden", "Only an approved account has keys.")
            if len(self.of_account(account, now)) >= KEYS_MAX:
                text = f"The account has {KEYS_MAX} valid keys; revoke one."
                raise Refused("quota_exceeded", text)
            self._database.insert("keys", key)
        return key, secret

    def of_account(self, account: str, now: float) -> Sequence[Key]:
        """Those that are valid, the newest first."""
        return self._database.rows(
            Key,
            "SELECT * FROM keys WHERE account = ? AND revoked_at IS NULL "
            "AND expires_at > ? ORDER BY made_at DESC",
            *(account, now),
        )

    def revoke(self, account: str, key_id: str, now: float) -> None:
        """HST-009: another account's key is not found. Raises Refused."""
        changed = self._database.execute(
            "UPDATE keys SET revoked_at = ? "
            "WHERE key_id = ? AND account = ? AND revoked_at IS NULL",
            *(now, key_id, account),
        )
        if not changed:
            raise Refused("not_found", "The account has no such key.")

    def revoke_all(self, account: str, now: float) -> None:
        self._database.execute(
            "UPDATE keys SET revoked_at = ? WHERE account = ? AND revoked_at IS NULL",
            *(now, account),
        )

    def find(self, secret: str, now: float) -> Key | None:
        """The valid key of an approved account (HST-008)."""
        return self._database.row(
            Key, f"{_VALID} AND keys.hash = ?", now, hash_of(secret)
        )

    def valid(self, now: float) -> Sequence[Key]:
        """All that the server accepts."""
        return self._database.rows(Key, f"{_VALID} ORDER BY keys.hash", now)

    def note_used(self, used: Mapping[str, float]) -> None:
        """A time may be lost while another process writes."""
        with (
            contextlib.suppress(sqlite3.OperationalError),
            self._database.transaction(),
        ):
            for hashed, at in used.items():
                self._database.execute(
                    "UPDATE keys SET used_at = max(coalesce(used_at, 0), ?) "
                    "WHERE hash = ?",
                    *(at, hashed),
                )


_IS_APPROVED: Final = (
    "SELECT count(*) FROM accounts WHERE account = ? AND state = 'approved'"
)
_VALID: Final = (
    "SELECT keys.* FROM keys JOIN accounts USING (account) "
    "WHERE accounts.state = 'approved' AND keys.revoked_at IS NULL "
    "AND (keys.organisation = '' OR EXISTS (SELECT * FROM members "
    "WHERE members.organisation = keys.organisation "
    "AND members.account = keys.account)) AND keys.expires_at > ?"
)


def _wrong(name: str, text: str) -> Refused:
    return Refused("invalid_request", f"{name} {text}.", errors=[(f"/{name}", text)])
