"""Which account calls: bearer tokens, stored as hashes only (AUTH-006).

It decides what a token allows, not which runs an account may see.
"""

from __future__ import annotations

import hashlib
import re
import secrets
import time
from collections.abc import Awaitable, Callable, Mapping
from dataclasses import dataclass

from starlette.requests import Request

from reference_server.rules.refusal import Refused, lacks_scope
from reference_server.settings.allowed_hosts import is_loopback

SCOPES = frozenset({"read", "run"})
HOST = "host"  # flags entries of the leaderboard (BRD-012); see `Caller.stopper`
OPERATOR = "operator"  # operates robot cells (PHY-013)
READ_ALL = "read_all"  # reads the runs of every account, with `read` (AUTH-008)
APPEND = "append"  # adds leaves about draws of seeds; of the account service alone
# Headers of a request that a proxy passed on, or that a page in a browser sends.
_NOT_A_SCRIPT = (
    *("forwarded", "x-forwarded-for", "x-real-ip", "via"),
    *("origin", "sec-fetch-site"),
)
_PORT = re.compile(r":[0-9]{1,5}$")


class BadTokens(ValueError):
    """The setting `tokens` is invalid; the text says which entry and why."""


@dataclass(frozen=True, slots=True)
class Caller:
    account: str
    scopes: frozenset[str]

    @property
    def reader(self) -> str | None:
        """Whose runs it may read: of its account; None for all (AUTH-008)."""
        return None if READ_ALL in self.scopes else self.account

    @property
    def stopper(self) -> str | None:
        """Whose runs it may stop: of its account; None for all (AUTH-008)."""
        return self.reader if HOST in self.scopes else self.account


# Who has the token that a server makes for itself.
LOCAL = Caller("local", SCOPES | {HOST, OPERATOR})
# Reads what is public; no token has an account without a name.
NO_ACCOUNT = Caller("", frozenset({"read"}))


class Tokens:
    """AUTH-006: the tokens of this server, as SHA-256 → account and scopes.

    Those of the file and of the account service come and go while the server runs; the
    others stay.
    """

    def __init__(self, by_hash: Mapping[str, Caller]) -> None:
        self._by_hash = dict(by_hash)
        self.replace_those_of_file({})
        self._of_accounts: Mapping[str, Caller] = {}
        self._used: dict[str, float] = {}
        self._sources: list[Callable[[], Awaitable[None]]] = []

    @classmethod
    def parse(cls, text: str) -> Tokens:
        """`account:scopes:token`, comma-separated; token may be `sha256=<hex>`."""
        by_hash: dict[str, Caller] = {}
        for number, entry in enumerate(filter(None, text.split(",")), start=1):
            hashed, caller = parse_entry(entry, f"entry {number} of tokens")
            by_hash[hashed] = caller
        if not by_hash:
            raise BadTokens("tokens is empty; omit it to have one generated")
        return cls(by_hash)

    @classmethod
    def of_local_account(cls, secret: str) -> Tokens:
        """One token with every scope, for the account `local`."""
        return cls({hash_of(secret): LOCAL})

    def replace_those_of_file(self, by_hash: Mapping[str, Caller]) -> None:
        """Make these tokens valid, in place of all that the file had before."""
        self._in_file = by_hash
        accepted = {**by_hash, **self._by_hash}.items()
        lines = (f"{h} {c.account} {sorted(c.scopes)}" for h, c in sorted(accepted))
        # Equal where the same tokens are accepted, but for those of accounts.
        self.digest = hash_of("\n".join(lines))

    def replace_those_of_accounts(self, by_hash: Mapping[str, Caller]) -> None:
        """Make these keys valid, in place of all that the service had before.

        A key of an account that has a token here is not valid: who registers there
        under its name would own its runs.
        """
        here = {*self._by_hash.values(), *self._in_file.values()}
        names = {caller.account for caller in here}
        self._of_accounts = {
            hashed: caller
            for hashed, caller in by_hash.items()
            if caller.account not in names
        }

    def take_used(self) -> Mapping[str, float]:
        """When keys of the service were used last, since this was called last."""
        used, self._used = self._used, {}
        return used

    def add_source(self, look_again: Callable[[], Awaitable[None]]) -> None:
        """look_again: reads what may have changed; see authenticate_again."""
        self._sources.append(look_again)

    async def authenticate_again(self, authorization: str | None, scope: str) -> Caller:
        """As authenticate, for a token that may have been added a moment ago."""
        for look_again in self._sources:
            await look_again()
        return self.authenticate(authorization, scope)

    def authenticate(self, authorization: str | None, scope: str) -> Caller:
        """The caller that a header names (AUTH-001, AUTH-005, AUTH-007)."""
        scheme = (authorization or "").partition(" ")[0]
        # A look-up by hash takes the same time for every wrong secret.
        caller = self._find(hash_of_bearer(authorization or ""))
        if scheme.lower() != "bearer" or caller is None:
            raise unauthenticated(authorization)
        if scope not in caller.scopes:
            raise lacks_scope(scope)
        return caller

    def find_again(self, hashed: str, scope: str) -> Caller | None:
        """The caller of a token that has passed before; None where it is refused now.

        hashed: the token's hash, so that it need not be computed again.
        """
        caller = self._find(hashed)
        return caller if caller is not None and scope in caller.scopes else None

    def account_of(self, token: str) -> str:
        """The account of a valid token; empty for every other one."""
        caller = self._find(hash_of(token))
        return "" if caller is None else caller.account

    def _find(self, hashed: str) -> Caller | None:
        caller = self._by_hash.get(hashed) or self._in_file.get(hashed)
        if caller is None and (caller := self._of_accounts.get(hashed)) is not None:
            self._used[hashed] = time.time()
        return caller


def unauthenticated(authorization: str | None, more: str = "") -> Refused:
    """The refusal, which distinguishes a token that is not valid from none.

    more: another thing that a token may be which is not valid there.
    """
    scheme, _, secret = (authorization or "").partition(" ")
    if scheme.lower() == "bearer" and secret.strip():
        what = "The bearer token is not valid here: it is wrong, revoked or expired"
        what += f", or {more}." if more else "."
    else:
        what = "The request came without a bearer token."
        if authorization is None:
            what += (
                " If the client sent one, a proxy before this server removed the "
                "header Authorization."
            )
    return Refused("unauthenticated", what)


def parse_entry(entry: str, where: str) -> tuple[str, Caller]:
    """The hash and the caller of `account:scopes:token`. Raises BadTokens.

    where: what the entry is called in the error.
    """
    account, _, rest = entry.strip().partition(":")
    names, _, secret = rest.partition(":")
    scopes = frozenset(names.split("+"))
    are_known = scopes <= SCOPES | {READ_ALL, HOST, OPERATOR}
    is_of_use = scopes & (SCOPES | {OPERATOR})
    if not account or not secret or not are_known or not is_of_use:
        raise BadTokens(
            f"{where} is not account:scopes:token with scopes read, run or read+run, "
            f"and +{READ_ALL} to read the runs of all accounts, +{HOST} to flag "
            f"entries of the leaderboard; or {OPERATOR}, to operate robot cells"
        )
    hashed = secret.removeprefix("sha256=").lower()
    if not secret.startswith("sha256="):
        hashed = hash_of(secret)
    elif not re.fullmatch(r"[0-9a-f]{64}", hashed):
        raise BadTokens(f"{where} is not a hexadecimal SHA-256")
    return hashed, Caller(account, scopes)


def new_secret() -> str:
    return f"proctor_{secrets.token_urlsafe(24)}"


def is_local(request: Request) -> bool:
    """FLE-024: sent by a program on this machine, to an address of this machine.

    The header Host excludes pages whose name was rebound to this machine.
    """
    host = _PORT.sub("", request.headers.get("host", "")).strip("[]")
    peer = request.client.host if request.client else ""
    is_passed_on = any(name in request.headers for name in _NOT_A_SCRIPT)
    return is_loopback(peer) and is_loopback(host) and not is_passed_on


def hash_of_bearer(authorization: str) -> str:
    """The hash of the token in a header `Authorization`."""
    return hash_of(authorization.partition(" ")[2].strip())


def hash_of(secret: str) -> str:
    """The SHA-256 digest of a token, which is stored in its place."""
    return hashlib.sha256(secret.encode()).hexdigest()
