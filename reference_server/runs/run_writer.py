"""Runs on their way to the store: write-behind, deletion, and what a failed write does.

Memory may be ahead of the disk while a write is in progress. That is never shown: who
shows a run waits for `is_stored` (CRASH-001, EVT-009). A failed write drops the run
from memory, because the database holds the valid state, and its sessions end as in a
restart; it is loaded again soon, with or without a request for it. In a cluster each
write is fenced: a run that another node has claimed is dropped, and never written.

It decides no rule. It publishes each write to the followers (`run_events.py`).
"""

from __future__ import annotations

import asyncio
import contextvars
import logging
import math
import time
from collections.abc import Callable
from weakref import WeakKeyDictionary

from reference_server.process.background_work import BackgroundWork, shielded
from reference_server.process.backoff import Backoff
from reference_server.rules.capacity import Quota
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.rules.runs.run import Run
from reference_server.runs.memory.remote_runs import MovedRuns
from reference_server.runs.memory.run_cache import RunCache
from reference_server.runs.memory.run_events import Departure, RunEvents
from reference_server.storage.runs.run_store import (
    OwnershipLost,
    RunIsKept,
    Store,
    StoreFailed,
)
from reference_server.telemetry.counters import COUNTERS, timed
from reference_server.telemetry.repeated_failures import RepeatedFailures
from reference_server.telemetry.spans import span

log = logging.getLogger("proctor.runs")

# Raises if an account, which has so much in the database, may not have this run open.
QuotaCheck = Callable[[Quota], None]


class RunWriter:
    """Stores the runs of the cache, and drops from it what cannot be stored."""

    def __init__(
        self, store: Store, cache: RunCache, events: RunEvents, work: BackgroundWork
    ) -> None:
        self._store, self._cache, self._events = store, cache, events
        self._work = work
        self._saving: dict[str, asyncio.Task[bool]] = {}  # the last one of each run
        self._refused: WeakKeyDictionary[Run, Refused] = WeakKeyDictionary()
        self._moved = MovedRuns()
        self._reload_timers: dict[str, asyncio.TimerHandle] = {}
        self._backoff = Backoff.of_database()
        self._failures = RepeatedFailures(log)

    def close(self) -> None:
        """Load nothing again from now on."""
        for timer in self._reload_timers.values():
            timer.cancel()

    # --- writes ---

    async def insert(
        self, run: Run, key: str | None, body_sha256: str, check: QuotaCheck | None
    ) -> bool:
        """Store a new run; False if its Idempotency-Key is used. As Store.insert."""
        with timed(COUNTERS.database_writes), span("store run"):
            return await self._store.insert(run, key, body_sha256, check)

    async def commit(self, run: Run, check: QuotaCheck | None = None) -> None:
        """Store what changed, then wake the requests that wait for it (CRASH-001).

        A caller that is cancelled does not take the write with it. check: as for
        Store.save; what it raises is raised here.
        """
        if await shielded(self.commit_later(run, check)):
            return
        if (refused := self._refused.pop(run, None)) is not None:
            raise refused
        if self._moved.has(run):
            raise OwnedElsewhere(run.run_id)
        raise Refused("unavailable", "The run could not be stored.")

    def commit_later(
        self, run: Run, check: QuotaCheck | None = None
    ) -> asyncio.Task[bool]:
        """Begin to store what changed (a lease that ended, an admission).

        The task never raises; its result is whether the run was stored.
        """
        run.updated_at_wall = _changed_at(run.updated_at_wall, time.time())
        saving = asyncio.ensure_future(self._save(run, check))
        self._saving[run.run_id] = saving
        self._work.start(saving)
        return saving

    async def is_stored(self, run: Run) -> bool:
        """Whether the run as it is now is on disk, as soon as that is known.

        Waits for the last write that was begun, and for none that begins meanwhile. A
        run that another node has claimed since then was stored before that.
        """
        saving = self._saving.get(run.run_id)
        if saving is not None:
            await asyncio.wait([saving])
        return not run.lost or self.is_complete(run)

    def is_complete(self, run: Run) -> bool:
        """Whether another node has the run, and all that memory had of it is stored."""
        return self._moved.is_complete(run)

    async def _save(self, run: Run, check: QuotaCheck | None) -> bool:
        checks = () if check is None else (check,)
        try:
            with timed(COUNTERS.database_writes), span("store run"):
                scored = await self._store.save(run, *checks)
        except Refused as refused:  # by the check
            self._refused[run] = refused
            self._drop_and_reload(run, "refused")
            return False
        except OwnershipLost as error:
            COUNTERS.fenced_writes += 1
            self._failures.report("a run was stored by another node", str(error))
            self.drop_moved(run)
            return False
        except Exception as error:  # whatever it was: memory is ahead of the disk now
            if isinstance(error, StoreFailed):
                self._failures.report("a run could not be stored", str(error))
            else:
                log.exception("run %s could not be stored", run.run_id)
            self._drop_and_reload(run, "unstored")
            return False
        finally:
            if self._saving.get(run.run_id) is asyncio.current_task():
                del self._saving[run.run_id]
        self._events.stored(run, scored)
        return True

    # --- deletion ---

    async def delete(self, run: Run, *, by_host: bool = False) -> None:
        """Delete a run that nothing can play any more; DEL-004: then it is no more.

        Who requests it meanwhile waits for the end. Raises StoreFailed and RunIsKept;
        the run then is as it was before.
        """
        deleting = asyncio.ensure_future(self._delete(run, by_host))
        self._cache.hold_until(run.run_id, deleting)
        self._work.start(deleting)
        self._events.changed(run)
        await shielded(deleting)

    async def _delete(self, run: Run, by_host: bool) -> None:
        try:
            await self.is_stored(run)  # a write that was begun would come after it
            await self._store.delete(run, time.time(), by_host=by_host)
        except OwnershipLost:
            COUNTERS.fenced_writes += 1
            self.drop_moved(run)
            raise
        except (StoreFailed, RunIsKept):
            self._drop_and_reload(run, "unstored")
            raise
        self._drop(run, "deleted")

    # --- what leaves memory ---

    def drop_moved(self, run: Run, *, is_complete: bool = False) -> None:
        """Another node acts for the run: this one forgets it, and ends its sessions.

        is_complete: memory is not ahead of the store, unless a write is in progress.
        """
        if not run.lost:
            is_stored = run.run_id not in self._saving
            self._moved.note(run, is_complete=is_complete and is_stored)
            self._drop(run, "moved")

    def _drop_and_reload(self, run: Run, why: Departure) -> None:
        """Drop the run from memory, and load it again as the database has it."""
        if not run.lost:
            self._drop(run, why)
            self._reload_later(run.run_id)

    def _drop(self, run: Run, why: Departure) -> None:
        """A view of the run that was not shown yet is taken again."""
        run.lost = True
        self._cache.remove(run)
        self._events.left(run, why)

    def is_reloading(self, run_id: str) -> bool:
        """Whether the run will be loaded again without a request for it."""
        return run_id in self._reload_timers

    def _reload_later(self, run_id: str) -> None:
        """Load it again: a queued run is admitted without a request for it."""
        # A request may have loaded it meanwhile, and its next write have failed, too.
        if not self._work.is_closed and run_id not in self._reload_timers:
            loop = asyncio.get_running_loop()
            # Nothing that a timer does belongs to the request that set it.
            pause_s = self._backoff.next_s()
            timer = loop.call_later(
                pause_s, self._reload, run_id, context=contextvars.Context()
            )
            self._reload_timers[run_id] = timer

    def _reload(self, run_id: str) -> None:
        del self._reload_timers[run_id]
        self.load_in_background(run_id)

    def load_in_background(self, run_id: str) -> None:
        """Load a run without a request for it, as soon as the store has it."""
        if not self._work.is_closed:
            self._work.start(self._load(run_id))

    async def _load(self, run_id: str) -> None:
        try:
            if (run := await self._cache.get(run_id)) is not None:
                self._cache.keep(run)
            self._backoff.reset()
        except OwnedElsewhere:
            log.debug("another node has run %s", run_id)
        except StoreFailed as error:
            self.report_unread(run_id, error)

    def report_unread(self, run_id: str, error: StoreFailed) -> None:
        """The database did not answer: the run is read again, and again."""
        self._failures.report("a run could not be loaded", str(error))
        self._reload_later(run_id)


def _changed_at(before_wall: float, now_wall: float) -> float:
    """The time of a change of a run: later than that of the change before.

    RUN-021: a clock that is set back does not set the run back. The later time also
    marks a run that changed since its submission: another node takes a run from the
    queue only while its two times are equal (`node_store.py`).
    """
    return max(math.nextafter(before_wall, math.inf), now_wall)
