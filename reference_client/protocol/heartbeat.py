"""Extends the lease of a session while a policy computes."""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable, Iterator
from typing import Self


class HeartbeatThread:
    """Calls `send_heartbeat` whenever a third of the lease passed without a request.

    lease_s: idle_timeout_s of the session. send_heartbeat: extends the lease; returns
    False if the session has ended. Called in a thread of this context manager.
    """

    def __init__(self, lease_s: float, send_heartbeat: Callable[[], bool]) -> None:
        self._send_heartbeat = send_heartbeat
        # Checking every sixth sends a heartbeat before a third has passed.
        self._check_interval_s = lease_s / 6
        self._answered_at: float | None = None  # None: a request is in progress
        self._closed = threading.Event()
        self._thread = threading.Thread(
            target=self._run, name="proctor-heartbeat", daemon=True
        )

    @contextlib.contextmanager
    def keep_alive(self) -> Iterator[None]:
        """Send heartbeats during this context: between a response and a request."""
        self._answered_at = time.monotonic()
        try:
            yield
        finally:
            self._answered_at = None

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        # Not joined: a heartbeat in progress may take long, and is harmless.
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
