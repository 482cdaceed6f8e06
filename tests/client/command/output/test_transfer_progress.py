"""Lines on how much of a file is sent: on a terminal, and in a pipe."""

from types import SimpleNamespace
from typing import Any, cast

import pytest

from reference_client.command.output import transfer_progress
from reference_client.command.output.printer import Printer
from reference_client.command.output.transfer_progress import TransferProgress

MIB = 2**20


class FakePrinter:
    def __init__(self, *, is_terminal: bool) -> None:
        self.err = SimpleNamespace(is_terminal=is_terminal)
        self.said: list[str] = []

    def say(self, line: str) -> None:
        self.said.append(line)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Any:
    clock = SimpleNamespace(now=0.0)
    clock.monotonic = lambda: clock.now
    monkeypatch.setattr(transfer_progress, "time", clock)
    return clock


def progress_of(printer: FakePrinter, then: str = "") -> TransferProgress:
    return TransferProgress(cast("Printer", printer), "uploaded", then=then)


@pytest.mark.parametrize(
    ("is_terminal", "wanted"),
    [
        (True, ["0.0", "3.0", "6.0", "9.0", "12.0", "15.0", "16.0"]),
        (False, ["0.0", "10.0", "16.0"]),
    ],
)
def test_a_long_file_has_a_line_every_few_seconds(
    is_terminal: bool, wanted: list[str], clock: Any
) -> None:
    """A mebibyte is sent in each second, in two parts."""
    printer = FakePrinter(is_terminal=is_terminal)
    progress = progress_of(printer)
    for half in range(33):
        clock.now = half / 2
        progress(half * MIB // 2, 16 * MIB)
    assert printer.said == [f"uploaded {size} of 16.0 MiB" for size in wanted]


@pytest.mark.parametrize(
    ("size", "said"),
    [
        (10, ["uploaded 10 of 10 bytes"]),
        (3 * 2**10, ["uploaded 3.0 of 3.0 KiB"]),
        (16 * MIB, ["uploaded 16.0 of 16.0 MiB", "It is checked."]),
    ],
)
def test_the_end_is_said_once(size: int, said: list[str]) -> None:
    printer = FakePrinter(is_terminal=False)
    progress = progress_of(printer, "It is checked.")
    for _ in range(2):
        progress(size, size)
    assert printer.said == said
