"""One task that does one piece of work after another.

A task for each piece would cost a round of the event loop to begin it.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from typing import Any

from reference_sim.process.immediate_future import ImmediateFuture

Work = Callable[[], Coroutine[Any, Any, None]]


class SerialTask:
    """The task; it exists from the first piece of work on, until it is closed.

    tasks: those that the server waits for when it ends. The task is among them while it
    works.
    """

    def __init__(
        self, loop: asyncio.AbstractEventLoop, tasks: set[asyncio.Task[None]]
    ) -> None:
        self._loop, self._tasks = loop, tasks
        self._task: asyncio.Task[None] | None = None
        self._waiting: ImmediateFuture[None] | None = None  # for the next work
        self._next: Work | None = None
        self._is_closed = False

    def begin(self, work: Work) -> None:
        """Begin the work at once; inside the work before, when that has ended."""
        self._next = work
        if self._task is None or self._task.done():
            self._task = self._loop.create_task(self._run())
            self._task.add_done_callback(self._tasks.discard)
            self._tasks.add(self._task)
        elif self._waiting is not None:
            waiting, self._waiting = self._waiting, None
            self._tasks.add(self._task)
            waiting.set_result(None)

    def close(self) -> None:
        """End, when the work that was begun has ended."""
        self._is_closed = True
        if self._waiting is not None:
            waiting, self._waiting = self._waiting, None
            self._loop.call_soon(waiting.set_result, None)

    async def _run(self) -> None:
        while True:
            while (work := self._next) is not None:
                self._next = None
                await work()
                if self._has_next():  # others are served between the two
                    await asyncio.sleep(0)
            if self._is_closed:
                return
            if self._task is not None:
                self._tasks.discard(self._task)
            self._waiting = ImmediateFuture(self._loop)
            await self._waiting

    def _has_next(self) -> bool:
        return self._next is not None
