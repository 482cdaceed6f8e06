"""Runs the checks in several processes, which are forked when all is imported.

A process takes the next check, or the next group of checks that belong together, when
it is free; it sends what the reports of pytest carry. Knows nothing of servers.

The largest groups are handed out first: they take longest, and one mostly waits.
"""

import contextlib
import multiprocessing
import os
import sys
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from multiprocessing.connection import Connection, wait
from multiprocessing.context import ForkProcess
from typing import Any

import pytest

from conformance.runner.ending_signals import EndingSignals

Properties = list[tuple[str, Any]]
# Frameworks of macOS may end a process that was forked.
CAN_FORK = hasattr(os, "fork") and sys.platform != "darwin"
_END_S = 60.0
# The messages of a process beside properties, and the answers beside groups.
_FREE, _ENDED = "free", "ended"
_END, _PLAY_ON = "end", "play on"


@dataclass
class _Worker:
    process: ForkProcess
    connection: Connection


class WorkerProcesses:
    """A pytest plugin that hands the collected checks out to processes.

    collect: takes the properties of the report of each check; in a worker it is
    replaced by the function that `redirect` gets.
    """

    def __init__(
        self,
        count: int,
        collect: Callable[[Properties], None],
        redirect: Callable[[Callable[[Properties], None]], None],
        must_stop: Callable[[], bool],
        play_on: Callable[[pytest.Session, int, int], None],
    ) -> None:
        """Prepare to fork; play_on: gets the rest of the time of a process.

        It also gets the number of the process, from 1, and how many there are.
        """
        self._count = count
        self._collect = collect
        self._redirect = redirect
        self._must_stop = must_stop
        self._play_on = play_on

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool | None:
        """Fork the processes and hand the checks out."""
        if session.testsfailed or session.config.option.collectonly:
            return None  # pytest knows what to do
        groups = deque(sorted(_groups(session.items), key=len, reverse=True))
        workers: list[_Worker] = []
        count = min(self._count, len(groups))
        try:
            while len(workers) < count:
                workers.append(self._fork(session, len(workers) + 1, count))
            self._hand_out(workers, groups)
        except BaseException:
            for worker in workers:
                worker.process.terminate()
            raise
        finally:
            for worker in workers:
                worker.connection.close()
            for worker in workers:
                worker.process.join(_END_S)
        return True

    def _fork(self, session: pytest.Session, number: int, count: int) -> _Worker:
        ours, theirs = multiprocessing.Pipe()
        play_on = partial(self._play_on, session, number, count)
        process = multiprocessing.get_context("fork").Process(
            target=self._work,
            args=(session, ours, theirs, play_on),
            daemon=True,
        )
        process.start()
        theirs.close()
        return _Worker(process, ours)

    def _hand_out(self, workers: list[_Worker], groups: deque[list[int]]) -> None:
        busy = list(workers)
        while busy:
            ready = wait([worker.connection for worker in busy])
            for worker in [w for w in busy if w.connection in ready]:
                try:
                    message = worker.connection.recv()
                except EOFError:
                    raise RuntimeError("a process of the kit has ended") from None
                if message == _ENDED:
                    busy.remove(worker)
                elif message != _FREE:
                    self._collect(message)
                elif self._must_stop():
                    worker.connection.send(_END)
                else:
                    worker.connection.send(groups.popleft() if groups else _PLAY_ON)

    def _work(
        self,
        session: pytest.Session,
        parents: Connection,
        connection: Connection,
        play_on: Callable[[], None],
    ) -> None:
        """Run the checks that the first process names, until it names no more."""
        EndingSignals(once=True).install()
        parents.close()  # so that its end is noticed when the first process has died
        self._redirect(connection.send)
        # The end of the connection is that of the first process.
        with contextlib.suppress(EOFError, KeyboardInterrupt, ConnectionError):
            connection.send(_FREE)
            while (command := connection.recv()) not in (_END, _PLAY_ON):
                for index in command:
                    item = session.items[index]
                    item.ihook.pytest_runtest_protocol(item=item, nextitem=None)
                connection.send(_FREE)
            if command == _PLAY_ON:
                play_on()
            connection.send(_ENDED)
        session.config.hook.pytest_sessionfinish(session=session, exitstatus=0)
        session.config.hook.pytest_unconfigure(config=session.config)


def _groups(items: list[pytest.Item]) -> Iterator[list[int]]:
    """Give the places of checks that one process runs, in the order of the first."""
    groups: dict[object, list[int]] = {}
    for index, item in enumerate(items):
        mark = item.get_closest_marker("one_process")
        groups.setdefault(mark.args[0] if mark else index, []).append(index)
    yield from groups.values()
