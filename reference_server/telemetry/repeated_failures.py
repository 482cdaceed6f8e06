"""Log lines about failures that repeat: one line for each cause and minute.

A full disk fails each write of each run; a log that says so hundreds of times hides
everything else, and takes room on what may be the same disk.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Callable

PERIOD_S = 60.0
# Causes that are remembered. Texts of a database are few, but not ours.
_CAUSES_MAX = 64


class RepeatedFailures:
    """Reports to one log. clock: seconds, for tests."""

    def __init__(
        self, log: logging.Logger, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._log = log
        self._clock = clock
        # (failure, cause) → when it was logged, and how often it was left out since.
        self._reported: dict[tuple[str, str], tuple[float, int]] = {}

    def report(self, what: str, cause: str) -> None:
        """Log `what` with its cause, unless it was in the last minute."""
        now, key = self._clock(), (what, cause)
        reported_at, unsaid = self._reported.get(key, (-PERIOD_S, 0))
        if now < reported_at + PERIOD_S:
            self._reported[key] = (reported_at, unsaid + 1)
            return
        if key not in self._reported and len(self._reported) >= _CAUSES_MAX:
            self._reported.clear()
        self._reported[key] = (now, 0)
        more = f" ({unsaid} more since the last such line)" if unsaid else ""
        self._log.error("%s: %s%s", what, cause, more)
