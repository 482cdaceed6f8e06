"""Programs that the cluster runs, and how they end: nothing of them is left.

The children of a program are found in /proc. Where there is none, as on macOS, they
must end by themselves.
"""

import asyncio
import contextlib
import os
import signal
import time
from asyncio.subprocess import Process
from collections.abc import Collection, Coroutine, Sequence
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

ASK_AGAIN_S = 0.05
CHILDREN_END_S = 10.0
Made = TypeVar("Made")


class NotStarted(Exception):
    """A part of the cluster cannot run; the text is one sentence, without a dot."""


async def at_once(*starts: Coroutine[Any, Any, Made]) -> list[Made]:
    """Run all and give their results. If one fails, the others are cancelled."""
    try:
        async with asyncio.TaskGroup() as group:
            tasks = [group.create_task(start) for start in starts]
    except BaseExceptionGroup as failed:
        raise failed.exceptions[0] from None
    return [task.result() for task in tasks]


async def start_apart(
    ends: contextlib.AsyncExitStack,
    end_s: float,
    command: Sequence[str | Path],
    log: Path,
    *,
    end_signal: signal.Signals | None = None,
    **settings: Any,
) -> Process:
    """Start a program whose messages are appended to a file, and which `ends` ends.

    It has a session of its own: a terminal's Ctrl-C is not for it, as it ends after the
    nodes that need it. end_signal: the signal that lets it end in order, if there is
    one. Processes of its session that are left after end_s are killed.
    """
    streams: dict[str, Any] = {"stdin": asyncio.subprocess.DEVNULL}
    with log.open("ab") as output:
        streams |= {"stdout": output, "stderr": output, **settings}
        process = await asyncio.create_subprocess_exec(
            *command, start_new_session=True, **streams
        )

    async def end() -> None:
        if process.stdin is not None:
            process.stdin.close()
        if end_signal is not None and process.returncode is None:
            process.send_signal(end_signal)
        with contextlib.suppress(TimeoutError):
            await asyncio.wait_for(process.wait(), end_s)
        if process.returncode is None:
            process.kill()
        await process.wait()
        of_session = [one.pid for one in _living() if one.session == process.pid]
        await _wait_or_kill(set(of_session), 0)

    ends.push_async_callback(end)
    return process


async def end_children(processes: Collection[Process]) -> None:
    """Terminate the processes; their children are killed unless they end themselves."""
    living = _living()
    started = {process.pid for process in processes}
    while more := {one.pid for one in living if one.parent in started} - started:
        started |= more
    for process in processes:
        with contextlib.suppress(ProcessLookupError):
            process.terminate()
    for process in processes:
        await process.wait()
    await _wait_or_kill(started, CHILDREN_END_S)


async def _wait_or_kill(pids: set[int], within_s: float) -> None:
    """Returns when all have ended."""
    deadline = time.monotonic() + within_s
    while left := pids & {one.pid for one in _living()}:
        if time.monotonic() > deadline:
            for pid in left:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
        await asyncio.sleep(ASK_AGAIN_S)


class _Listed(NamedTuple):
    pid: int
    parent: int
    session: int


def _living() -> list[_Listed]:
    """All processes of this machine but zombies."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        # A process may end while it is looked at.
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            stat = (folder / "stat").read_text().rpartition(")")[2].split()
            if stat[0] not in ("Z", "X"):
                found.append(_Listed(int(folder.name), int(stat[1]), int(stat[3])))
    return found
