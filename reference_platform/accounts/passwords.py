"""Passwords, as Argon2 hashes, and limits on guessing them.

A wrong name takes as long as a wrong password: no client learns which accounts exist.
"""

from __future__ import annotations

import asyncio
import time
from collections import OrderedDict
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Final

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

from reference_server.rules.refusal import Refused

# A hash takes 64 MiB and a processor, so that few are computed at a time.
AT_ONCE: Final = 2
# More failures than these in the period are refused. A pair is an account and an
# address; the limit of an account is higher, because other clients can use it up.
PERIOD_S: Final = 900.0
LIMITS: Final = {"pair": 5, "address": 30, "account": 100}
BUCKETS_MAX: Final = 50_000


class Passwords:
    """Hashes passwords, off the event loop."""

    def __init__(self, hasher: PasswordHasher | None = None) -> None:
        self._hasher = hasher or PasswordHasher()
        self._places = asyncio.Semaphore(AT_ONCE)
        # Compared with where there is no account.
        self._of_no_account = self._hasher.hash("a password of no account")

    async def hash(self, password: str) -> str:
        async with self._places:
            return await asyncio.to_thread(self._hasher.hash, password)

    async def is_right(self, password_hash: str | None, password: str) -> bool:
        """password_hash: None or empty if there is no account, or no password of it."""
        async with self._places:
            compared = password_hash or self._of_no_account
            is_same = await asyncio.to_thread(self._is_same, compared, password)
        return is_same and bool(password_hash)

    def _is_same(self, password_hash: str, password: str) -> bool:
        try:
            return self._hasher.verify(password_hash, password)
        except (VerificationError, InvalidHashError):
            return False


class GuessLimits:
    """HST-005: counts failures, and refuses more of them before anything is compared.

    clock: seconds, for tests.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        # (kind, who) → begin of the period and failures in it; the oldest go first.
        self._failures: OrderedDict[tuple[str, str], tuple[float, int]] = OrderedDict()

    def check(self, account: str, address: str) -> None:
        """Raises Refused when there were too many failures."""
        self._check(_buckets(account, address))

    def count_of_address(self, address: str) -> None:
        """One more of what a client may do without an account. Raises Refused."""
        key = ("address", address)
        self._check([key])
        self._note([key])

    def _check(self, keys: Sequence[tuple[str, str]]) -> None:
        for key in keys:
            begun_at, failures = self._failures.get(key, (0.0, 0))
            left_s = begun_at + PERIOD_S - self._clock()
            if failures >= LIMITS[key[0]] and left_s > 0:
                text = f"There were too many wrong tries; wait {int(left_s) + 1} s."
                raise Refused("quota_exceeded", text, retry_after_s=left_s)

    @contextmanager
    def guard_code(self, account: str, kind: str, address: str) -> Iterator[None]:
        """For the use of a code: refuses it to one who has tried too many wrong ones.

        kind: of code. A code that is not found inside counts as a wrong one.
        """
        who = f"{account} {kind}"
        self.check(who, address)
        try:
            yield
        except Refused as refused:
            if refused.code == "not_found":
                self.note_failure(who, address)
            raise

    def note_failure(self, account: str, address: str) -> None:
        self._note(_buckets(account, address))

    def _note(self, keys: Sequence[tuple[str, str]]) -> None:
        now = self._clock()
        for key in keys:
            begun_at, failures = self._failures.pop(key, (now, 0))
            if now >= begun_at + PERIOD_S:
                begun_at, failures = now, 0
            self._failures[key] = begun_at, failures + 1
        while len(self._failures) > BUCKETS_MAX:
            self._failures.popitem(last=False)

    def note_success(self, account: str, address: str) -> None:
        """Take back what `note_failure` counted of it, and forget the pair."""
        pair, *others = _buckets(account, address)
        self._failures.pop(pair, None)
        for key in others:
            if key in self._failures:
                begun_at, failures = self._failures[key]
                self._failures[key] = begun_at, max(failures - 1, 0)


def _buckets(account: str, address: str) -> list[tuple[str, str]]:
    pair = ("pair", f"{account} {address}")
    return [pair, ("address", address), ("account", account)]
