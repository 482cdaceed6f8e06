"""The use cases of accounts: register, review, sign in, change what is one's own.

HTTP handlers, pages and `proctor admin` call it. All methods raise Refused.
"""

from __future__ import annotations

import sqlite3
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import msgspec

from reference_platform.accounts import account_rules
from reference_platform.accounts.account_keys import Keys
from reference_platform.accounts.account_rules import (
    Account,
    AccountState,
    Decision,
    Role,
    SignUp,
)
from reference_platform.accounts.browser_sessions import Sessions
from reference_platform.accounts.organisations import is_taken, name_is_taken
from reference_platform.accounts.passwords import GuessLimits, Passwords
from reference_platform.mail.outbox import Outbox
from reference_platform.storage.platform_database import Database, audit
from reference_server.rules.refusal import Refused

_NOT_FOUND: Final = "There is no such account."
_WRONG: Final = "The name or the password is wrong."
_AGAIN: Final = {
    "approve": "Your account is approved. Sign in, and make a key.",
    "reinstate": "Your account is approved again. Your old keys stay revoked.",
    "reject": "Your account was not approved.",
    "suspend": "Your account is suspended, and its keys are revoked.",
}


# What an account may have before it is approved.
_TABLES_OF_ACCOUNTS: Final = (
    *("accounts", "sessions", "devices", "password_resets", "logins", "identities"),
)


@dataclass(frozen=True, slots=True)
class Accounts:
    """clock: seconds since the epoch, for tests."""

    database: Database
    passwords: Passwords
    guesses: GuessLimits
    keys: Keys
    sessions: Sessions
    outbox: Outbox
    clock: Callable[[], float] = time.time

    def get(self, account: str) -> Account:
        found = self.database.row(
            Account, "SELECT * FROM accounts WHERE account = ?", account
        )
        if found is None:
            raise Refused("not_found", _NOT_FOUND)
        return found

    def in_state(self, state: AccountState) -> Sequence[Account]:
        """The one that waits longest is the first."""
        return self.database.rows(
            Account,
            "SELECT * FROM accounts WHERE state = ? ORDER BY created_at LIMIT 500",
            state,
        )

    def with_email_of(self, account: Account) -> Sequence[str]:
        """Other accounts with this address: an administrator looks at twins."""
        others = self.database.rows(
            Account,
            "SELECT * FROM accounts WHERE lower(email) = lower(?) AND account != ?",
            *(account.email, account.account),
        )
        return [other.account for other in others]

    async def register(
        self, filled: SignUp, role: Role = "participant", address: str = ""
    ) -> Account:
        """A pending account. HST-002: an address may be that of several accounts.

        address: of the client, whose sign-ups are limited.
        """
        account_rules.check_sign_up(filled)
        self._check_sign_ups(address)
        now = self.clock()
        account = Account(
            account=filled.account,
            full_name=filled.full_name.strip(),
            organisation=filled.organisation.strip(),
            email=filled.email,
            email_changed_at=None,
            evaluation=filled.evaluation,
            is_own_model=filled.is_own_model,
            agreed_at=now,
            password_hash=await self.passwords.hash(filled.password),
            role=role,
            state="pending",
            reason="",
            created_at=now,
            decided_at=None,
        )
        try:
            with self.database.transaction():
                if is_taken(self.database, account.account):
                    raise name_is_taken("account")
                self.database.insert("accounts", account)
                self._notify_administrators(account)
        except sqlite3.IntegrityError as error:
            raise name_is_taken("account") from error
        return account

    def _check_sign_ups(self, address: str) -> None:
        """A program that registers again and again is refused as one that guesses."""
        if address:
            self.guesses.check(" sign-up", address)
            self.guesses.note_failure(" sign-up", address)

    def _notify_administrators(self, account: Account) -> None:
        for administrator in self.in_state("approved"):
            if administrator.is_administrator:
                self.outbox.add(
                    administrator.email,
                    f"{account.account} waits for review",
                    f"{account.full_name} of {account.organisation} has registered as "
                    f"{account.account}. Approve or reject the account on the page "
                    "Review.",
                )

    def decide(
        self, name: str, decision: Decision, reason: str, administrator: str
    ) -> Account:
        """HST-004: the decision is mailed and stands in the audit log.

        HST-008: a rejected or suspended account has no keys and no sessions any more.
        """
        now = self.clock()
        with self.database.transaction():
            account = self.get(name)
            if name == administrator and decision == "suspend":
                text = "An administrator cannot suspend itself."
                raise Refused("forbidden", text)
            state = account_rules.decide(account, decision, reason)
            self.database.execute(
                "UPDATE accounts SET state = ?, reason = ?, decided_at = ? "
                "WHERE account = ?",
                *(state, reason.strip(), now, name),
            )
            if state != "approved":
                self.keys.revoke_all(name, now)
                self.sessions.end_all(name)
            audit(
                self.database,
                now,
                actor=administrator,
                act=decision,
                subject=name,
                detail=reason.strip(),
            )
            because = f"\n\nReason: {reason.strip()}" if reason.strip() else ""
            self.outbox.add(account.email, _AGAIN[decision], _AGAIN[decision] + because)
        return msgspec.structs.replace(
            account, state=state, reason=reason.strip(), decided_at=now
        )

    def delete(self, name: str, administrator: str) -> None:
        """An account that was never approved, with its mail that waits. Raises Refused.

        By HST-004 these are the pending and the rejected ones, so nothing is theirs.
        """
        with self.database.transaction():
            account = self.get(name)
            if account.state not in ("pending", "rejected"):
                text = f"`delete` is not possible: the account is {account.state}."
                raise Refused("illegal_transition", text)
            for table in _TABLES_OF_ACCOUNTS:
                statement = f"DELETE FROM {table} WHERE account = ?"  # noqa: S608
                self.database.execute(statement, name)
            self.database.execute(
                "DELETE FROM mail WHERE recipient = ? AND sent_at IS NULL "
                "AND recipient NOT IN (SELECT email FROM accounts)",
                account.email,
            )
            audit(
                self.database, self.clock(), actor=administrator,
                act="delete_account", subject=name,
            )  # fmt: skip

    async def sign_in(self, name: str, password: str, address: str) -> str:
        """The cookie of a new session. HST-005: one refusal for each wrong pair."""
        self.guesses.check(name, address)
        # Counted before it is compared: tries at the same moment count, too.
        self.guesses.note_failure(name, address)
        found = self.database.row(
            Account, "SELECT * FROM accounts WHERE account = ?", name
        )
        stored = None if found is None else found.password_hash
        if not await self.passwords.is_right(stored, password):
            raise Refused("unauthenticated", _WRONG)
        self.guesses.note_success(name, address)
        return self.sessions.begin(name, self.clock())

    async def change_email(
        self, account: Account, email: str, current: str, address: str
    ) -> None:
        """HST-006. A rejected account is reviewed again.

        current: the password; a session that was left open changes no address, to which
        a new password would be mailed.
        """
        account_rules.check_email_change(account, email, self.clock())
        await self._check_password(account, current, address)
        now = self.clock()
        with self.database.transaction():
            account = self.get(account.account)
            account_rules.check_email_change(account, email, now)
            state = "pending" if account.state == "rejected" else account.state
            self.database.execute(
                "UPDATE accounts SET email = ?, email_changed_at = ?, state = ? "
                "WHERE account = ?",
                *(email, now, state, account.account),
            )
            text = f"The address of {account.account} is now {email}."
            for recipient in (account.email, email):
                self.outbox.add(recipient, "Your address was changed", text)

    async def change_password(
        self, account: Account, current: str, new: str, address: str
    ) -> None:
        """All sessions of the account end."""
        await self._check_password(account, current, address)
        await self.set_password(account, new)

    async def _check_password(
        self, account: Account, current: str, address: str
    ) -> None:
        """HST-005 also holds for one who has signed in. Raises Refused."""
        self.guesses.check(account.account, address)
        self.guesses.note_failure(account.account, address)
        if not await self.passwords.is_right(account.password_hash, current):
            raise Refused("forbidden", "The current password is wrong.")
        self.guesses.note_success(account.account, address)

    async def set_password(self, account: Account, new: str) -> None:
        if errors := account_rules.password_errors(new, account.account):
            text = f"password {errors[0][1]}."
            raise Refused("invalid_request", text, errors=errors)
        hashed = await self.passwords.hash(new)
        with self.database.transaction():
            self.database.execute(
                "UPDATE accounts SET password_hash = ? WHERE account = ?",
                *(hashed, account.account),
            )
            self.sessions.end_all(account.account)
            text = f"The password of {account.account} was changed."
            self.outbox.add(account.email, "Your password was changed", text)
