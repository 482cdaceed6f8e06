"""Work that no request waits for, or that outlives the request that began it."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable
from typing import TypeVar

Result = TypeVar("Result")


async def shielded(work: Awaitable[Result]) -> Result:
    """The result of `work`, which goes on when its caller is cancelled.

    Its exception is for the caller; one that has gone needs no traceback. From Python
    3.14 on, asyncio.shield logs one.
    """
    task = asyncio.ensure_future(work)
    task.add_done_callback(lambda done: done.cancelled() or done.exception())
    await asyncio.wait([task])
    return task.result()


class BackgroundWork:
    """All of it ends before the server does.

    is_closed: the server ends. A part that begins work by itself begins no more of it.
    """

    def __init__(self) -> None:
        self._tasks: set[asyncio.Future[object]] = set()
        self.is_closed = False

    def start(self, work: Awaitable[object]) -> None:
        """Start work that no request waits for."""
        task = asyncio.ensure_future(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def run_to_end(self, work: Awaitable[Result]) -> Result:
        """The result of `work`, which goes on when its caller is cancelled.

        It is for a write and the change in memory that follows: both happen, or
        neither.
        """
        task = asyncio.ensure_future(work)
        self.start(task)
        return await shielded(task)

    async def wait(self) -> None:
        """Wait until all work has ended."""
        while self._tasks:  # one may begin another
            await asyncio.wait(self._tasks)
