"""Whether the clock may decide what is deleted by its age.

A machine that has lost its power, or was resumed from a snapshot, may start with a
clock that is far ahead until the network sets it: then every run seems old.
"""

from __future__ import annotations

import logging
import time

from reference_server.storage.runs.run_store import Store

log = logging.getLogger("proctor.storage")

AHEAD_S = 86_400.0
WAIT_S = 3600.0


class DeletionClock:
    """The clock of this machine, from the start of the server on."""

    def __init__(self, store: Store) -> None:
        self._store, self._since = store, time.monotonic()

    async def is_trusted(self) -> bool:
        """Not in the first hour, if no run has changed for a day by this clock."""
        if time.monotonic() - self._since >= WAIT_S:
            return True
        newest = await self._store.newest_change_wall()
        ahead_s = 0.0 if newest is None else time.time() - newest
        if ahead_s < AHEAD_S:
            return True
        log.warning(
            "by the clock of this machine the last change of a run was %.0f days ago: "
            "in the first hour nothing is deleted for its age; see that the clock is "
            "right",
            ahead_s / 86_400,
        )
        return False
