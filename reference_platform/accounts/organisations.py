"""Organisations: groups of accounts that take part under one name.

A member acts for an organisation with a key of it: its runs, submissions and quotas
are those of the organisation. All methods raise Refused. For other accounts than its
members an organisation does not exist (HST-033).
"""

from __future__ import annotations

import re
import secrets
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final, Literal, NamedTuple

import msgspec

from reference_platform.accounts.account_rules import RESERVED, Account, is_email
from reference_platform.mail.outbox import Outbox
from reference_platform.storage.platform_database import Database
from reference_server.http.auth import hash_of
from reference_server.rules.refusal import Refused

MemberRole = Literal["owner", "admin", "member"]
Act = Literal["submit", "invite", "remove_member", "remove", "change_role"]
INVITATION_S: Final = 14 * 86_400.0
OWNED_MAX: Final = 20
OPEN_INVITATIONS_MAX: Final = 20
_NAME: Final = re.compile(r"[a-z][a-z0-9]{2,31}")
_NOT_FOUND: Final = "The account is in no such organisation."
_MEMBERS: Final = "SELECT * FROM members WHERE "
# role → what a member with it may do (HST-034).
ALLOWED: Final[Mapping[MemberRole, frozenset[Act]]] = {
    "owner": frozenset(("submit", "invite", "remove_member", "remove", "change_role")),
    "admin": frozenset(("submit", "invite", "remove_member")),
    "member": frozenset(("submit",)),
}


class Owner(NamedTuple):
    """Whom runs and submissions belong to: an account or an organisation."""

    name: str
    is_organisation: bool = False


class Member(msgspec.Struct, frozen=True):
    organisation: str
    account: str
    role: MemberRole


class Invitation(msgspec.Struct, frozen=True):
    """hash: of the code that its mail has."""

    hash: str
    organisation: str
    email: str
    role: MemberRole
    invited_by: str
    expires_at: float


@dataclass(frozen=True, slots=True)
class Organisations:
    """The organisations of all accounts."""

    database: Database
    outbox: Outbox
    clock: Callable[[], float]

    # --- what an account is in ---

    def of_account(self, account: str) -> Sequence[Member]:
        where = "account = ? ORDER BY organisation"
        return self.database.rows(Member, _MEMBERS + where, account)

    def names_of(self, account: str) -> Sequence[str]:
        """The names that an account may act for, its own first."""
        return [account, *(member.organisation for member in self.of_account(account))]

    def owner(self, account: str, name: str) -> Owner:
        """The account itself, or an organisation that it may submit for."""
        if name in ("", account):
            return Owner(account)
        self._check(name, account, "submit")
        return Owner(name, is_organisation=True)

    def members(self, organisation: str, account: str) -> Sequence[Member]:
        self._member(organisation, account)
        where = "organisation = ? ORDER BY account"
        return self.database.rows(Member, _MEMBERS + where, organisation)

    def title(self, organisation: str) -> str:
        statement = "SELECT title AS text FROM organisations WHERE organisation = ?"
        return "".join(
            r.text for r in self.database.rows(_Text, statement, organisation)
        )

    def emails_of(self, owner: str) -> Sequence[str]:
        """The addresses of an account, or of the owners of an organisation."""
        statement = (
            "SELECT email AS text FROM accounts WHERE account = ? OR account IN "
            "(SELECT account FROM members WHERE organisation = ? AND role = 'owner')"
        )
        return [row.text for row in self.database.rows(_Text, statement, owner, owner)]

    # --- changes ---

    def create(self, organisation: str, title: str, account: Account) -> Member:
        """Its first owner. The names of accounts and organisations are one space."""
        _check_approved(account)
        errors = []
        if not _NAME.fullmatch(organisation) or organisation in RESERVED:
            text = "must be 3 to 32 lowercase letters and digits, a letter first"
            errors.append(("/organisation", text))
        if not (title.strip() and len(title) <= 200 and title.isprintable()):
            errors.append(("/title", "must be one line of 1 to 200 characters"))
        if errors:
            texts = "; ".join(f"{pointer[1:]} {text}" for pointer, text in errors)
            raise Refused("invalid_request", f"{texts}.", errors=errors)
        member = Member(organisation, account.account, "owner")
        with self.database.transaction():
            owned = [m for m in self.of_account(account.account) if m.role == "owner"]
            if len(owned) >= OWNED_MAX:
                text = f"The account owns {OWNED_MAX} organisations, the most it may."
                act = "Make another account the owner of one, and leave it."
                raise Refused("quota_exceeded", text, act=act)
            if is_taken(self.database, organisation):
                raise name_is_taken("organisation")
            self.database.execute(
                "INSERT INTO organisations VALUES (?, ?, ?)",
                *(organisation, title.strip(), self.clock()),
            )
            self.database.insert("members", member)
        return member

    def invite(
        self, organisation: str, actor: str, email: str, role: MemberRole
    ) -> Invitation:
        """The address gets a mail with a code, with which any account becomes a member.

        Only an owner invites one who may do more than a member.
        """
        if not is_email(email):
            wrong = [("/email", "must be an e-mail address")]
            raise Refused("invalid_request", "email must be an address.", errors=wrong)
        code, now = secrets.token_urlsafe(24), self.clock()
        invitation = Invitation(
            hash_of(code), organisation, email, role, actor, now + INVITATION_S
        )
        with self.database.transaction():
            self._check(organisation, actor, "invite")
            if role != "member":
                self._check(organisation, actor, "change_role")
            self.database.execute("DELETE FROM invitations WHERE expires_at < ?", now)
            statement = "SELECT count(*) FROM invitations WHERE organisation = ?"
            waiting = self.database.number(statement, organisation)
            if (waiting or 0) >= OPEN_INVITATIONS_MAX:
                text = f"{organisation} has {OPEN_INVITATIONS_MAX} open invitations."
                act = "Wait until one of them is accepted or expires."
                raise Refused("quota_exceeded", text, act=act)
            self.database.insert("invitations", invitation)
            self.outbox.add(
                email,
                f"{actor} invites you to {organisation}",
                f"{actor} invites you to the organisation {organisation}, as {role}. "
                "Sign in, open the page Organisations, and enter this code within 14 "
                f"days:\n\n{code}",
            )
        return invitation

    def invitations(self, organisation: str, account: str) -> Sequence[Invitation]:
        """Those that wait; for members who may invite."""
        if "invite" not in ALLOWED[self._member(organisation, account).role]:
            return []
        return self.database.rows(
            Invitation,
            "SELECT * FROM invitations WHERE organisation = ? AND expires_at > ?",
            *(organisation, self.clock()),
        )

    def accept(self, code: str, account: Account) -> Member:
        """A code is used once. Who is a member already keeps its role."""
        _check_approved(account)
        with self.database.transaction():
            invitation = self.database.row(
                Invitation,
                "SELECT * FROM invitations WHERE hash = ? AND expires_at > ?",
                *(hash_of(code.strip()), self.clock()),
            )
            if invitation is None:
                text = "There is no such invitation; it may be used or too old."
                raise Refused("not_found", text)
            member = Member(invitation.organisation, account.account, invitation.role)
            self.database.execute(
                "DELETE FROM invitations WHERE hash = ?", invitation.hash
            )
            for already in self.of_account(account.account):
                if already.organisation == member.organisation:
                    return already
            self.database.insert("members", member)
        return member

    def set_role(
        self, organisation: str, actor: str, account: str, role: MemberRole
    ) -> Member:
        with self.database.transaction():
            self._check(organisation, actor, "change_role")
            before = self._member(organisation, account)
            if role != "owner":
                self._check_other_owner(before)
            self.database.execute(
                "UPDATE members SET role = ? WHERE organisation = ? AND account = ?",
                *(role, organisation, account),
            )
        return Member(organisation, account, role)

    def remove(self, organisation: str, actor: str, account: str) -> None:
        """A member leaves, or is removed; its keys of it end (HST-035)."""
        with self.database.transaction():
            self._member(organisation, actor)
            member = self._member(organisation, account)
            act: Act = "remove_member" if member.role == "member" else "remove"
            if actor != account:
                self._check(organisation, actor, act)
            if len(self.members(organisation, account)) > 1:
                self._check_other_owner(member)
            else:  # its name stays taken
                statement = "DELETE FROM invitations WHERE organisation = ?"
                self.database.execute(statement, organisation)
            self.database.execute(
                "DELETE FROM members WHERE organisation = ? AND account = ?",
                *(organisation, account),
            )
            self.database.execute(
                "UPDATE keys SET revoked_at = ? WHERE organisation = ? "
                "AND account = ? AND revoked_at IS NULL",
                *(self.clock(), organisation, account),
            )

    def _check_other_owner(self, member: Member) -> None:
        members = self.members(member.organisation, member.account)
        if [m.account for m in members if m.role == "owner"] == [member.account]:
            text = "The organisation has no other owner; make one first."
            raise Refused("illegal_transition", text)

    def _check(self, organisation: str, account: str, act: Act) -> None:
        """HST-034."""
        role = self._member(organisation, account).role
        if act not in ALLOWED[role]:
            text = f"As {role} of {organisation} you may not do this."
            raise Refused("forbidden", text)

    def _member(self, organisation: str, account: str) -> Member:
        where = "organisation = ? AND account = ?"
        member = self.database.row(Member, _MEMBERS + where, organisation, account)
        if member is None:
            raise Refused("not_found", _NOT_FOUND)
        return member


class _Text(msgspec.Struct):
    text: str


def _check_approved(account: Account) -> None:
    if account.state != "approved":
        raise Refused("forbidden", "Only an approved account is in organisations.")


def is_taken(database: Database, name: str) -> bool:
    """Whether an account or an organisation has this name."""
    statement = (
        "SELECT (SELECT count(*) FROM accounts WHERE account = ?) "
        "+ (SELECT count(*) FROM organisations WHERE organisation = ?)"
    )
    return bool(database.number(statement, name, name))


def name_is_taken(member: str) -> Refused:
    """member: of the body, which has the name."""
    text = "is the name of another account or organisation"
    return Refused(
        "invalid_request", f"{member} {text}.", errors=[(f"/{member}", text)]
    )
