"""Work that is done when the server starts, and again every hour.

Work that fails is logged, and tried again an hour later. This module knows nothing of
the work.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Awaitable, Callable

log = logging.getLogger("proctor.app")

HOUR_S = 3600.0


class HourlyWork:
    """Repeats `work`, or nothing if that is None.

    what: the sentence that the log has when the work fails.
    """

    def __init__(self, work: Callable[[], Awaitable[None]] | None, what: str) -> None:
        self._work, self._what = work, what
        self._task: asyncio.Task[None] | None = None

    def open(self) -> None:
        if self._work is not None:
            self._task = asyncio.create_task(self._repeat(self._work))

    async def close(self) -> None:
        """Ends it between two awaits; returns when it has ended."""
        if self._task is not None:
            self._task.cancel()
            await asyncio.wait([self._task])

    async def _repeat(self, work: Callable[[], Awaitable[None]]) -> None:
        while True:
            try:
                await work()
            except Exception:  # of any part: the next time may be better
                log.exception("%s", self._what)
            await asyncio.sleep(HOUR_S)
