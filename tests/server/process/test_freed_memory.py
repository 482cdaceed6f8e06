"""When memory that was freed is given back to the system."""

from __future__ import annotations

import pytest

from reference_server.process import freed_memory
from reference_server.process.freed_memory import LARGE_BYTES, FreedMemory


@pytest.mark.parametrize(
    ("held", "times"),
    [
        ([LARGE_BYTES - 1, 0], 0),
        ([LARGE_BYTES, LARGE_BYTES // 2], 0),
        ([LARGE_BYTES, 0, 0], 1),
        ([LARGE_BYTES, 0, LARGE_BYTES, 1], 2),
        ([8 * LARGE_BYTES, 2 * LARGE_BYTES, 0], 2),
    ],
)
def test_it_is_given_back_when_most_of_much_is_freed(
    monkeypatch: pytest.MonkeyPatch, held: list[int], times: int
) -> None:
    calls: list[int] = []
    monkeypatch.setattr(freed_memory, "find_trim", lambda: calls.append)
    freed = FreedMemory()
    for one in held:
        freed.look(one)
    assert calls == [0] * times


def test_a_peak_between_two_looks_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[int] = []
    monkeypatch.setattr(freed_memory, "find_trim", lambda: calls.append)
    freed = FreedMemory()
    freed.note(LARGE_BYTES)
    freed.note(0)
    freed.look(0)
    assert calls == [0]


def test_a_system_without_it_is_served(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(freed_memory, "find_trim", lambda: None)
    freed = FreedMemory()
    freed.look(LARGE_BYTES)
    freed.look(0)
