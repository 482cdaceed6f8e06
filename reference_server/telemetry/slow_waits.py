"""Long waits of sessions, logged while they last.

A simulator that hangs sends nothing, so its turn is silent until it is killed. A line
after 5 s, and at each doubling of that time, says who waits for what. A turn only notes
what it begins; one timer looks at all sessions.
"""

from __future__ import annotations

import asyncio
import contextvars
import logging
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from reference_server.telemetry.log_output import log_event

LOOK_S = 1.0
FIRST_S = 5.0

log = logging.getLogger("proctor.sessions")


@dataclass(slots=True)
class LongWait:
    """The thing that a session waits for; nothing while `what` is empty.

    since: by the monotonic clock. logged_at_s: how long it waits when it is logged.
    """

    run_id: str
    worker_id: str
    what: str = ""
    since: float = 0.0
    logged_at_s: float = FIRST_S

    def begin(self, what: str) -> None:
        """`what` as in "waits for …"."""
        self.what, self.since = what, time.monotonic()
        self.logged_at_s = FIRST_S

    def end(self) -> None:
        self.what = ""

    def log_if_long(self, now: float) -> None:
        waited_s = now - self.since
        if not self.what or waited_s < self.logged_at_s:
            return
        while self.logged_at_s <= waited_s:
            self.logged_at_s *= 2
        log_event(
            log,
            f"waits for {self.what}",
            run_id=self.run_id,
            worker_id=self.worker_id,
            waited_s=int(waited_s),
        )


class WaitLog:
    """Logs the long waits of `waits`, as long as there are sessions."""

    def __init__(self, waits: Callable[[], Iterable[LongWait]]) -> None:
        self._waits = waits
        self._timer: asyncio.TimerHandle | None = None

    def start(self) -> None:
        """Look at the waits until there is none; does nothing while it looks."""
        if self._timer is None:
            self._timer = asyncio.get_running_loop().call_later(
                LOOK_S, self._look, context=contextvars.Context()
            )

    def stop(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _look(self) -> None:
        self._timer = None
        now, waits = time.monotonic(), list(self._waits())
        for wait in waits:
            wait.log_if_long(now)
        if waits:
            self.start()
