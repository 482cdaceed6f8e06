"""Holds back deletions by age while the clock of the machine may be wrong.

By a clock that is ahead everything is old: after a power loss, for example, until the
network sets it. So nothing is deleted in the first hour, and where nothing would be
left, the clock has to say so for a day.
"""

from __future__ import annotations

import logging
import time
from typing import Final

from reference_record.texts.timestamps import timestamp

DAY_S: Final = 86_400.0
FIRST_AFTER_S: Final = 3600.0
ALL_AFTER_S: Final = DAY_S


class AgeGuard:
    """keep_days: the age. what: is deleted, in sentences of the log."""

    def __init__(self, keep_days: float, what: str, log: logging.Logger) -> None:
        self._keep_s, self._what, self._log = keep_days * DAY_S, what, log
        self._made_at = time.monotonic()
        self._all_old_since: float | None = None

    def allows(self, newest_wall: float) -> bool:
        """Whether what is old may be deleted now.

        newest_wall: when the newest of all that is stored changed.
        """
        now, now_wall = time.monotonic(), time.time()
        if now_wall - newest_wall < self._keep_s:
            self._all_old_since = None
            return now - self._made_at >= FIRST_AFTER_S
        if self._all_old_since is None:
            self._all_old_since = now
        if now - self._all_old_since >= ALL_AFTER_S:
            return True
        self._log.warning(
            "%s are not deleted by age yet, because none would be left: the clock says "
            "%s, and the last change of a run was stored at %s; they are deleted if "
            "the clock says so for a day",
            *(self._what, timestamp(now_wall), timestamp(newest_wall)),
        )
        return False

    def report(self, number: int) -> None:
        """Log that so many were deleted."""
        if number:
            text = "%s of %d runs that ended more than %g days ago were deleted"
            self._log.warning(text, self._what, number, self._keep_s / DAY_S)
