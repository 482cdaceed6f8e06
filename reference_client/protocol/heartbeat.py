"""Keeping a lease alive while a policy thinks."""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable, Iterator
from types import TracebackType
from typing import Self


class HeartbeatThread:
    """Calls `send_heartbeat` while thinking goes on for longer than a third of the lease.

    lease_s: idle_timeout_s of the session. beat: extends the lease; returns whether
    there is one to extend. It is called in a thread that lives as long as the context.
    """

    def __init__(self, lease_s: float, send_heartbeat: Callable[[], bool]) -> None:
        self._send_heartbeat = send_heartbeat
        # A look every sixth: a beat comes before a third has passed without one.
        self._check_interval_s = lease_s / 6
        self._answered_at: float | None = None  # None: the server has the word
        self._closed = threading.Event()
        self._thread = threading.Thread(
            target=self._run, name="proctor-heartbeat", daemon=True
        )

    @contextlib.contextmanager
    def keep_alive(self) -> Iterator[None]:
        """Around what the policy does between an answer and the next request."""
        self._answered_at = time.monotonic()
        try:
            yield
        finally:
            self._answered_at = None

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        # Not joined: a beat under way may take its time, and does no harm.
        self._closed.set()

    def _run(self) -> None:
        sent_at = -self._check_interval_s
        while not self._closed.wait(self._check_interval_s):
            answered_at = self._answered_at
            if answered_at is None:
                continue
            if time.monotonic() - max(answered_at, sent_at) < self._check_interval_s:
                continue
            if not self._send_heartbeat():
                return
            sent_at = time.monotonic()
