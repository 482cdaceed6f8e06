"""Accounts are examined in turn, one record of each at a time."""

from __future__ import annotations

import asyncio

import pytest

from reference_server.records.examination_turns import ExaminationTurns, NoTurn

LONG_S = 60.0


class Examinations:
    """Examinations that end when the test says so. begun: accounts, in that order."""

    def __init__(self, at_once: int) -> None:
        self.turns = ExaminationTurns(at_once)
        self.begun: list[str] = []
        self._ends: list[asyncio.Event] = []
        self._tasks: list[asyncio.Task[None]] = []

    def add(self, accounts: str) -> None:
        """One character is an account."""
        self._tasks += [asyncio.create_task(self._examine(one)) for one in accounts]

    async def _examine(self, account: str) -> None:
        async with self.turns.place(account, LONG_S):
            ended = asyncio.Event()
            self.begun.append(account)
            self._ends.append(ended)
            await ended.wait()

    async def end(self, number: int) -> None:
        self._ends[number].set()
        await settle()

    def cancel(self, number: int) -> None:
        self._tasks[number].cancel()


async def settle() -> None:
    for _ in range(10):
        await asyncio.sleep(0)


async def test_an_account_waits_for_itself_alone() -> None:
    all_of_them = Examinations(at_once=2)
    all_of_them.add("aaab")
    await settle()
    assert all_of_them.begun == ["a", "b"]
    await all_of_them.end(1)
    assert all_of_them.begun == ["a", "b"]
    all_of_them.add("c")
    await settle()
    assert all_of_them.begun == ["a", "b", "c"]
    await all_of_them.end(0)
    assert all_of_them.begun == ["a", "b", "c", "a"]
    assert all_of_them.turns.waiting == 1


async def test_accounts_are_served_in_turn() -> None:
    all_of_them = Examinations(at_once=1)
    all_of_them.add("aaabbc")
    await settle()
    for number in range(5):
        await all_of_them.end(number)
    assert "".join(all_of_them.begun) == "abcaba"


async def test_who_waits_too_long_gives_up_and_holds_nothing() -> None:
    all_of_them = Examinations(at_once=1)
    all_of_them.add("a")
    await settle()
    with pytest.raises(NoTurn):
        async with all_of_them.turns.place("b", 0.0):
            pass
    assert all_of_them.turns.waiting == 0
    await all_of_them.end(0)
    all_of_them.add("b")
    await settle()
    assert all_of_them.begun == ["a", "b"]


@pytest.mark.parametrize("has_its_turn", [False, True])
async def test_who_is_cut_off_holds_nothing(has_its_turn: bool) -> None:
    """Also at the moment at which it gets its place."""
    all_of_them = Examinations(at_once=1)
    all_of_them.add("abc")
    await settle()
    if has_its_turn:
        all_of_them._ends[0].set()
        await asyncio.sleep(0)
    all_of_them.cancel(1)
    await settle()
    if not has_its_turn:
        await all_of_them.end(0)
    assert all_of_them.begun == ["a", "c"]
    await all_of_them.end(1)
    assert all_of_them.turns.waiting == 0
