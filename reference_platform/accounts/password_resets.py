"""A forgotten password: a code by mail lets its reader set another one, once.

No answer says whether an account exists. A code is stored as a hash, ends after half an
hour, and ends with the next password. The mail has a link only where the host has named
its address: the one of a request could be that of another site.
"""

from __future__ import annotations

import secrets
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import msgspec

from reference_platform.accounts.account_rules import Account
from reference_platform.accounts.accounts import Accounts
from reference_platform.storage.platform_database import Database
from reference_server.http.auth import hash_of
from reference_server.rules.refusal import Refused

LIFE_S: Final = 1800.0
DAY_S: Final = 86_400.0
MAILS_PER_DAY: Final = 3
_WRONG: Final = "The code is wrong, was used, or is older than half an hour."


class _Reset(msgspec.Struct, frozen=True):
    """account: empty where there is none of the name that was given."""

    hash: str
    account: str
    made_at: float
    used_at: float | None


@dataclass(frozen=True, slots=True)
class PasswordResets:
    database: Database
    accounts: Accounts
    public_url: str = ""
    clock: Callable[[], float] = time.time

    def begin(self, name: str, address: str) -> None:
        """HST-042: the same for a name without an account. Raises Refused.

        address: of the client, whose tries are limited (HST-005), as are those for one
        account; a person whose account others ask for gets few mails.
        """
        guesses, subject = self.accounts.guesses, f"{name} reset"
        guesses.check(subject, address)
        guesses.note_failure(subject, address)
        code, now = secrets.token_urlsafe(32), self.clock()
        with self.database.transaction():
            self.database.execute(
                "DELETE FROM password_resets WHERE made_at < ?", now - DAY_S
            )
            account = self.database.row(
                Account, "SELECT * FROM accounts WHERE account = ?", name
            )
            reset = _Reset(hash_of(code), account.account if account else "", now, None)
            mails = self.database.number(
                "SELECT count(*) FROM password_resets WHERE account = ?", reset.account
            )
            self.database.insert("password_resets", reset)
            if account is not None and (mails or 0) < MAILS_PER_DAY:
                text = self._text(account.account, code)
                self.accounts.outbox.add(account.email, "A new password", text)

    def _text(self, name: str, code: str) -> str:
        where = "Open the page “Forgotten password” of the host, and enter this code:"
        if self.public_url:
            url = f"{self.public_url.rstrip('/')}/hosting/reset?code={code}"
            where = f"Set it at {url}, or enter this code there:"
        return (
            f"A new password of the account {name} was asked for. {where}\n\n"
            f"{code}\n\nIt ends after half an hour. Was it not you? Ignore this mail."
        )

    async def finish(self, code: str, password: str, address: str) -> str:
        """Set the password; the name of the account. Raises Refused."""
        self.accounts.guesses.count_of_address(address)
        reset = self.database.row(
            _Reset,
            "SELECT * FROM password_resets WHERE hash = ? AND made_at > ? "
            "AND used_at IS NULL AND account != ''",
            *(hash_of(code.strip()), self.clock() - LIFE_S),
        )
        if reset is None:
            raise Refused("forbidden", _WRONG)
        account = self.accounts.get(reset.account)
        await self.accounts.set_password(account, password)
        self.database.execute(
            "UPDATE password_resets SET used_at = ? WHERE account = ?",
            *(self.clock(), account.account),
        )
        return account.account
