"""Whether this server can do its work now: what `/readyz` answers.

Each part has a check that raises when the part cannot work. Unknown callers may ask at
any rate: the checks run at most once a second, none of them twice at once, and their
time is bounded. It knows no HTTP and none of the parts.
"""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Awaitable, Callable, Mapping

from reference_server.process.background_work import shielded
from reference_server.telemetry.repeated_failures import RepeatedFailures

log = logging.getLogger("proctor.app")

# How long what was found is answered again.
FRESH_S = 1.0
# A part that does not say within this time that it can work is not ready.
CHECK_TIMEOUT_S = 2.0
DRAINING = "draining"

Check = Callable[[], Awaitable[None]]


class Readiness:
    """checks: name of a part → its check. is_draining: whether the server ends."""

    def __init__(
        self, checks: Mapping[str, Check], is_draining: Callable[[], bool]
    ) -> None:
        self._checks = dict(checks)
        self._is_draining = is_draining
        self._checking: asyncio.Task[tuple[str, ...]] | None = None
        self._checked_at = 0.0
        self._waiting: dict[str, asyncio.Future[None]] = {}
        self._failures = RepeatedFailures(log)

    async def missing(self) -> tuple[str, ...]:
        """Names of what is not ready; empty if the server is."""
        if self._is_draining():
            return (DRAINING,)
        running = self._checking
        if running is None or (
            running.done() and time.monotonic() > self._checked_at + FRESH_S
        ):
            running = self._checking = asyncio.create_task(self._check_all())
        return await shielded(running)

    async def _check_all(self) -> tuple[str, ...]:
        for name, waiting in list(self._waiting.items()):
            if waiting.done():  # too late: what it found is old
                self._waiting.pop(name).exception()
        for name, check in self._checks.items():
            # One that still waits, for a lock for example, is not asked again.
            if name not in self._waiting:
                self._waiting[name] = asyncio.ensure_future(check())
        await asyncio.wait(self._waiting.values(), timeout=CHECK_TIMEOUT_S)
        missing = tuple(name for name in self._checks if not self._works(name))
        self._checked_at = time.monotonic()
        return missing

    def _works(self, name: str) -> bool:
        if not self._waiting[name].done():
            why = f"it does not answer within {CHECK_TIMEOUT_S:g} s"
        else:
            error = self._waiting.pop(name).exception()
            if error is None:
                return True
            why = str(error) or type(error).__name__
        self._failures.report(f"not ready: {name}", why)
        return False
