"""`proctor login`: the device grant of RFC 8628, from a terminal without a browser.

The program shows a code; a person who is signed in confirms it on a page; the program,
which asks meanwhile, gets a key once.
"""

from __future__ import annotations

import secrets
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Literal

import msgspec

from reference_platform.accounts.account_keys import Key, Keys
from reference_platform.storage.platform_database import Database
from reference_server.http.auth import hash_of
from reference_server.rules.refusal import Refused

LIFE_S: Final = 900.0
INTERVAL_S: Final = 2.0
WAITING_MAX: Final = 10_000
KEY_LIFETIME_S: Final = 90 * 86_400.0
# `proctor` needs no more: keys and organisations are managed on the pages.
SCOPES: Final = ("read", "run")
# Without vowels no word appears, and none of these looks like another.
_LETTERS: Final = "BCDFGHJKLMNPQRSTVWXZ"
# Those of RFC 8628, section 3.5, with which a program asks again.
Pending = Literal["authorization_pending", "slow_down"]


class Device(msgspec.Struct, frozen=True):
    """label: what the program says that it is, such as the name of its machine."""

    hash: str
    user_code: str
    label: str
    state: Literal["waiting", "approved", "denied"]
    account: str
    expires_at: float
    polled_at: float


@dataclass(frozen=True, slots=True)
class Devices:
    database: Database
    keys: Keys
    clock: Callable[[], float] = time.time

    def begin(self, label: str) -> tuple[str, Device]:
        """The secret with which the program asks, and what was stored."""
        now = self.clock()
        if not label.isprintable() or len(label) > 100:
            raise Refused("invalid_request", "label must be one short line.")
        code, letters = secrets.token_urlsafe(32), secrets.SystemRandom()
        shown = "".join(letters.choice(_LETTERS) for _ in range(8))
        device = Device(
            hash_of(code), f"{shown[:4]}-{shown[4:]}", label, "waiting", "",
            now + LIFE_S, 0.0,
        )  # fmt: skip
        with self.database.transaction():
            self.database.execute("DELETE FROM devices WHERE expires_at < ?", now)
            waiting = self.database.number("SELECT count(*) FROM devices")
            if waiting is not None and waiting >= WAITING_MAX:
                raise Refused("unavailable", "Too many programs wait for a sign-in.")
            self.database.insert("devices", device)
        return code, device

    def find(self, user_code: str) -> Device:
        """The one that waits under a code, as a person types it. Raises Refused."""
        letters = "".join(letter for letter in user_code.upper() if letter.isalpha())
        device = self.database.row(
            Device,
            "SELECT * FROM devices WHERE user_code = ? AND state = 'waiting' "
            "AND expires_at > ?",
            *(f"{letters[:4]}-{letters[4:]}", self.clock()),
        )
        if device is None:
            raise Refused("not_found", "No program waits for this code, or not longer.")
        return device

    def decide(self, user_code: str, account: str, *, approve: bool) -> None:
        device = self.find(user_code)
        self.database.execute(
            "UPDATE devices SET state = ?, account = ? WHERE hash = ?",
            *("approved" if approve else "denied", account, device.hash),
        )

    def poll(self, code: str) -> tuple[Key, str] | Pending:
        """The key and its secret, once; or why there is none yet (HST-018)."""
        now = self.clock()
        device = self.database.row(
            Device,
            "SELECT * FROM devices WHERE hash = ? AND expires_at > ?",
            *(hash_of(code), now),
        )
        if device is None:
            text = "The code is unknown, or too old."
            raise Refused("not_found", text, act="Begin the sign-in again.")
        if device.state == "waiting":
            self.database.execute(
                "UPDATE devices SET polled_at = ? WHERE hash = ?", now, device.hash
            )
            is_early = now - device.polled_at < INTERVAL_S / 2
            return "slow_down" if is_early else "authorization_pending"
        refused = Refused(
            "forbidden",
            "The account has refused the program.",
            act="Begin the sign-in again, and press Allow on the page.",
        )
        with self.database.transaction():
            taken = self.database.execute(
                "DELETE FROM devices WHERE hash = ?", device.hash
            )
            if device.state == "approved" and taken:
                label = f"proctor login {device.label}".strip()
                try:
                    return self.keys.make(
                        device.account, label, SCOPES, KEY_LIFETIME_S, now
                    )
                except Refused as error:  # the code is used up nevertheless
                    refused = error
        raise refused
