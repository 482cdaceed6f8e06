"""Holds back deletions by age while the clock of the machine may be wrong.

By a clock that is ahead everything is old: after a power loss, for example, until the
network sets it. So nothing is deleted in the first hour after a start or after the
clock was set; and for a day where nothing would be left of what was stored before that.
A start after one with a wrong clock does not know which of the stored times are wrong.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Awaitable, Callable
from typing import Final

DAY_S: Final = 86_400.0
FIRST_AFTER_S: Final = 3600.0
ALL_AFTER_S: Final = DAY_S


class AgeGuard:
    """keep_days: the age. what: is deleted, in sentences of the log."""

    def __init__(self, keep_days: float, what: str, log: logging.Logger) -> None:
        self._keep_s, self._what, self._log = keep_days * DAY_S, what, log
        # Between the two clocks: it changes when the clock of the machine is set.
        self._offset_s: float | None = None
        self._set_at = self._set_wall = 0.0
        # A later change has the time of a clock that may be wrong.
        self._newest_before: float = 0.0
        self._newest_wall: float | None = None

    def allows(self, newest_wall: float) -> bool:
        """Whether what is old may be deleted now.

        newest_wall: when the newest of all that is stored changed.
        """
        now, now_wall = time.monotonic(), time.time()
        offset_s = now_wall - now
        if self._offset_s is None or abs(offset_s - self._offset_s) > FIRST_AFTER_S:
            self._set_at, self._set_wall = now, now_wall
            known = self._newest_wall
            self._newest_before = newest_wall if known is None else known
        self._offset_s, self._newest_wall = offset_s, newest_wall
        if self._set_wall - self._newest_before < self._keep_s:
            return now - self._set_at >= FIRST_AFTER_S
        if now - self._set_at >= ALL_AFTER_S:
            return True
        self._log.warning(
            "%s are not deleted by age yet, because none would be left: the clock says "
            "%s, and the last change of a run was stored at %s; they are deleted if "
            "the clock says so for a day",
            *(self._what, _shown(now_wall), _shown(self._newest_before)),
        )
        return False

    async def delete(
        self,
        newest_change: Callable[[], Awaitable[float | None]],
        delete_old: Callable[[], Awaitable[int]],
    ) -> None:
        """Delete what is old if that may be now, and log of how many runs it was.

        newest_change: as of `allows`; None if nothing is stored.
        """
        newest_wall = await newest_change()
        if newest_wall is None or not self.allows(newest_wall):
            return
        if number := await delete_old():
            text = "%s of %d runs that ended more than %g days ago were deleted"
            self._log.warning(text, self._what, number, self._keep_s / DAY_S)


def _shown(wall: float) -> str:
    return time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime(wall))
