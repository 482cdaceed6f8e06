"""Who is examined next: accounts in turn, one record of each at a time, few at once.

An account that hands in slow records holds up itself. It knows no record and no file.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager


class NoTurn(Exception):
    """The turn of this account did not come in time."""


class ExaminationTurns:
    """at_once: how many places there are for all accounts."""

    def __init__(self, at_once: int) -> None:
        self._at_once = at_once
        # Accounts in the order of their turns; each has what waits, oldest first.
        self._waiting: dict[str, deque[asyncio.Future[None]]] = {}
        self._examined: set[str] = set()

    @property
    def waiting(self) -> int:
        """How many have no place yet."""
        return sum(map(len, self._waiting.values()))

    @asynccontextmanager
    async def place(self, account: str, wait_s: float) -> AsyncIterator[None]:
        """Hold a place. Raises NoTurn if there is none within `wait_s`."""
        turn = asyncio.get_running_loop().create_future()
        self._waiting.setdefault(account, deque()).append(turn)
        self._lend()
        try:
            await asyncio.wait([turn], timeout=wait_s)
            if not turn.done():
                raise NoTurn
            yield
        finally:
            if turn.done():
                self._give_back(account)
            else:
                self._withdraw(account, turn)

    def _withdraw(self, account: str, turn: asyncio.Future[None]) -> None:
        turns = self._waiting[account]
        turns.remove(turn)
        if not turns:
            del self._waiting[account]

    def _give_back(self, account: str) -> None:
        self._examined.remove(account)
        if turns := self._waiting.pop(account, None):  # behind all others
            self._waiting[account] = turns
        self._lend()

    def _lend(self) -> None:
        while len(self._examined) < self._at_once:
            free = (owner for owner in self._waiting if owner not in self._examined)
            account = next(free, None)
            if account is None:
                return
            turn = self._waiting[account].popleft()
            if not self._waiting[account]:
                del self._waiting[account]
            self._examined.add(account)
            turn.set_result(None)
