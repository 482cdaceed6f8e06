"""Programs that a test runs, the processes that it has started, and their end."""

import contextlib
import os
import signal
import subprocess
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

import psutil

from tests.support.waiting import wait_until

# For a program that imports much and then ends by itself, on a busy machine.
PROGRAM_S = 120.0


@contextlib.contextmanager
def hangups_taken() -> Iterator[None]:
    """Let SIGHUP end programs that are started here, also where `nohup` is in use."""
    before = signal.signal(signal.SIGHUP, signal.SIG_DFL)
    try:
        yield
    finally:
        signal.signal(signal.SIGHUP, before)


def descendants(pid: int) -> set[int]:
    """Ids of all that a process and its children started; none if it is gone."""
    with contextlib.suppress(psutil.NoSuchProcess):
        children = psutil.Process(pid).children(recursive=True)
        return {child.pid for child in children}
    return set()


def process_commands() -> list[str]:
    """Of all processes, whole; `ps` may cut them after 80 columns."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            words = (process / "cmdline").read_bytes().split(b"\0")
            found.append(" ".join(map(os.fsdecode, words)).strip())
    return found


def signal_all(pids: Iterable[int], number: signal.Signals) -> int:
    """Send a signal to those that are there; how many they were."""
    count = 0
    for pid in pids:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, number)
            count += 1
    return count


def wait_until_ended(pids: set[int]) -> None:
    """Waits until the processes are gone; a zombie is gone."""
    wait_until(lambda: not any(map(is_alive, pids)), f"{pids} have ended")


def is_alive(pid: int) -> bool:
    """A zombie is not alive: its parent may be slow to reap it."""
    with contextlib.suppress(FileNotFoundError, ProcessLookupError):
        stat = Path(f"/proc/{pid}/stat").read_text()
        return stat.rpartition(")")[2].split()[0] not in ("Z", "X")
    return False


def peak_bytes(pid: int) -> int:
    """The most memory that the process had at any moment, resident."""
    status = Path(f"/proc/{pid}/status").read_text()
    (line,) = (one for one in status.splitlines() if one.startswith("VmHWM:"))
    return int(line.split()[1]) * 1024


def run_program(
    command: Sequence[str | Path], **options: Any
) -> subprocess.CompletedProcess[str]:
    """A program that has ended, with its output as text; `check` is off."""
    kept: dict[str, Any] = {"check": False} | options
    return subprocess.run(command, capture_output=True, text=True, **kept)  # noqa: PLW1510
