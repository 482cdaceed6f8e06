"""The bound of everything that a server keeps on its disk, over all accounts.

At the bound nothing new begins: no run, no episode, no record that is handed in.
Episodes in play are played to their end, and nothing that is kept is deleted.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Sequence
from pathlib import Path

from reference_server.files.file_sizes import size_of
from reference_server.rules.refusal import Refused
from reference_server.telemetry.counters import COUNTERS

MEASURE_EVERY_S = 30.0

log = logging.getLogger("proctor.app")


class DiskBound:
    """Measures the files at the start and now and then; recordings count at once.

    max_bytes: 0 for no bound; then nothing is measured. paths: files and folders.
    """

    def __init__(self, max_bytes: int = 0, paths: Sequence[Path] = ()) -> None:
        self._max, self._paths = max_bytes, paths
        self._measured, self._recorded = 0, COUNTERS.recording_bytes
        self._was_full = False
        self._task: asyncio.Task[None] | None = None

    async def open(self) -> None:
        if self._max:
            await self._measure()
            self._task = asyncio.create_task(self._repeat())

    async def close(self) -> None:
        if self._task is not None:
            self._task.cancel()
            await asyncio.wait([self._task])

    @property
    def used_bytes(self) -> int:
        return self._measured + COUNTERS.recording_bytes - self._recorded

    @property
    def max_bytes(self) -> int:
        return self._max

    def check(self) -> None:
        """Refuse what would take more room."""
        if self._max and self.used_bytes >= self._max:
            raise Refused(
                "unavailable",
                f"This server keeps {self.used_bytes} bytes and may keep {self._max}: "
                "its operator frees some, or raises max_disk_bytes.",
            )

    async def _repeat(self) -> None:
        while True:
            await asyncio.sleep(MEASURE_EVERY_S)
            await self._measure()

    async def _measure(self) -> None:
        recorded = COUNTERS.recording_bytes
        self._measured = await asyncio.to_thread(size_of, self._paths)
        self._recorded = recorded
        is_full = self.used_bytes >= self._max
        if is_full and not self._was_full:
            log.warning(
                "the disk has %d bytes of this server, as many as max_disk_bytes "
                "allows: nothing new begins",
                self.used_bytes,
            )
        self._was_full = is_full
