"""The runs in memory and their way to and from the store.

One Run object per run for as long as it is referenced, so that every decision sees the
same state (MODEL-002). It stores what the rules changed, wakes requests that wait for a
change, and admits queued runs when there is capacity. It decides no rule, and knows no
HTTP and no SQL.

Memory may be ahead of the disk while a write is in progress. That is never shown: a
view is taken from memory and returned once it is stored (`render_when_stored`;
CRASH-001, EVT-009). A failed write drops the run from memory, because the database
holds the valid state, and its sessions end as in a restart.
"""

from __future__ import annotations

import asyncio
import logging
import time
from bisect import bisect_left, insort
from collections import OrderedDict
from collections.abc import Awaitable, Callable, Sequence
from functools import partial
from typing import TypeVar
from weakref import WeakValueDictionary

from reference_server.rules import effects
from reference_server.rules.lifecycle import (
    ACTIVE_STATES,
    RESTART_REASON,
    RESTING_STATES,
    STATES_AFTER_RESTART,
    WAITING_STATES,
)
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Episode, Run, RunHead, State
from reference_server.rules.submission import (
    KeyUse,
    key_conflict,
    may_see_run,
    queue_until,
)
from reference_server.runs import steady_clock
from reference_server.storage.store import Store, StoreFailed
from reference_server.system.repeated_failures import RepeatedFailures

log = logging.getLogger("proctor.runs")

# Runs kept in memory although no request uses them at the moment.
CACHED_RUNS_MAX = 256
# How long after a failed write its run is loaded again without a request for it.
RELOAD_S = 1.0

Rendered = TypeVar("Rendered")


class RunRegistry:
    """All runs of this server, by id.

    on_run_lost: ends the sessions of a run whose write failed.
    on_change: is called with a run whose state may have changed.
    """

    def __init__(
        self,
        store: Store,
        active_max: int,
        on_run_lost: Callable[[Run], None],
        on_change: Callable[[Run], None],
    ) -> None:
        self._store = store
        self._on_run_lost, self._on_change = on_run_lost, on_change
        self._active_max = active_max
        self._in_memory: WeakValueDictionary[str, Run] = WeakValueDictionary()
        self._recent: OrderedDict[str, Run] = OrderedDict()
        self._queued: dict[str, Run] = {}
        self._queue: list[int] = []  # their numbers, the next one first
        self._active: set[str] = set()
        self._loading: dict[str, asyncio.Task[Run | None]] = {}
        self._saving: dict[str, asyncio.Task[bool]] = {}  # the last one of each run
        # Referenced only by the requests that wait for a change.
        self._change_events: WeakValueDictionary[str, asyncio.Event] = (
            WeakValueDictionary()
        )
        self._admission_timer: asyncio.TimerHandle | None = None
        self._reload_timers: dict[str, asyncio.TimerHandle] = {}
        self._tasks: set[asyncio.Future[object]] = set()
        self._ending = self._closed = False
        self._failures = RepeatedFailures(log)

    async def open(self) -> None:
        """Apply what a restart does, then load what waits for capacity."""
        await self._store.replace_states(STATES_AFTER_RESTART, RESTART_REASON)
        self._active = set(await self._store.in_states(*ACTIVE_STATES))
        for run_id in await self._store.in_states(*WAITING_STATES):
            await self.get(run_id)

    def release_waiters(self) -> None:
        """The server will shut down: end every wait for a change."""
        self._ending = True
        for run_id in list(self._change_events):
            self._wake(run_id)

    async def close(self) -> None:
        """Wait until every write that was begun has ended; no other begins."""
        self._closed = True
        for timer in (self._admission_timer, *self._reload_timers.values()):
            if timer is not None:
                timer.cancel()
        while self._tasks:  # one may begin another
            await asyncio.wait(self._tasks)

    async def get(self, run_id: str, account: str | None = None) -> Run:
        """The run, if the account may see it (AUTH-003, RUN-010)."""
        run = self._in_memory.get(run_id) or await self._load(run_id)
        if run is None or not (account is None or may_see_run(account, run.account)):
            raise _no_run(run_id)
        self._cache(run)
        return run

    async def read_view(
        self,
        run_id: str,
        account: str,
        view: Callable[[RunHead, Sequence[Episode]], Rendered],
        start: int = 0,
        end: int | None = 0,
        *,
        scored: bool = False,
    ) -> Rendered:
        """What `view` makes of the run and of its episodes from start to end.

        scored: of those that have a result, in the order in which they were scored.
        A run that is not in memory stays out of it, and no more of it is read than is
        shown: the size and the number of finished runs cost nothing.
        """
        if run_id not in self._in_memory:
            found = await self._store.read_window(run_id, start, end, scored)
            if found is not None and self._is_current(found[0]):
                if not may_see_run(account, found[0].account):
                    raise _no_run(run_id)
                return view(*found)
        run = await self.get(run_id, account)
        window = partial(Run.window, start=start, end=end, scored=scored)
        return await self.render_when_stored(run, lambda run: view(run, window(run)))

    def _is_current(self, head: RunHead) -> bool:
        """Whether the run is as it was just read: it was not loaded meanwhile."""
        return head.state in RESTING_STATES and head.run_id not in self._in_memory

    async def add(self, run: Run, key: str | None, body_sha256: str) -> Run:
        """Store a new run; or the run that this Idempotency-Key made (RUN-003).

        RUN-027: only a run that is stored uses up its key. RUN-029: without a key
        nothing is looked up.
        """
        # A request that finds it in the store, even before this one, finds this object.
        self._in_memory[run.run_id] = run
        self._admit(run)  # before it is stored: one submit is one transaction
        is_stored = False
        try:
            is_stored = await self._store.insert(run, key, body_sha256)
        finally:
            if not is_stored:
                self._in_memory.pop(run.run_id, None)
                self._active.discard(run.run_id)
                self._admit()
        if is_stored:
            self._cache(run)
            self._index_by_state(run, run.state)
            self._admit()
            return run
        assert key is not None
        use = await self.find_by_key(run.account, key)
        assert use is not None, "an insert is refused only for a used key"
        conflict = key_conflict(use, body_sha256)
        if conflict is not None:
            raise Refused.from_verdict(conflict)
        return await self.get(use.run_id)

    async def find_by_key(self, account: str, key: str) -> KeyUse | None:
        """What an Idempotency-Key of the account made, if it was used (RUN-026)."""
        found = await self._store.find_key(account, key)
        return None if found is None else KeyUse(*found)

    async def page(
        self,
        account: str,
        before: int | None,
        limit: int,
        view: Callable[[RunHead], Rendered],
    ) -> list[Rendered]:
        """Up to `limit` views of the account, newest first (RUN-009, AUTH-004)."""
        ids = [run_id for _, run_id in await self._store.page(account, before, limit)]
        heads = await self._store.heads([i for i in ids if i not in self._in_memory])
        found = []
        for run_id in ids:
            head = heads.get(run_id)
            if head is not None and self._is_current(head):
                found.append(view(head))
            else:
                found.append(
                    await self.render_when_stored(await self.get(run_id), view)
                )
        return found

    async def render_when_stored(
        self, run: Run, view: Callable[[Run], Rendered]
    ) -> Rendered:
        """What `view` makes of the run, once all of that is stored."""
        while True:
            rendered = view(run)
            if await self.is_stored(run):
                return rendered
            run = await self.get(run.run_id)

    async def is_stored(self, run: Run) -> bool:
        """Whether the run as it is now is on disk, as soon as that is known.

        Waits for the last write that was begun, and for none that begins meanwhile.
        """
        saving = self._saving.get(run.run_id)
        if saving is not None:
            await asyncio.wait([saving])
        return not run.lost

    async def commit(self, run: Run) -> None:
        """Store what changed, then wake the requests that wait for it (CRASH-001).

        A caller that is cancelled does not take the write with it.
        """
        if not await asyncio.shield(self.commit_later(run)):
            raise Refused("unavailable", "The run could not be stored.")

    def commit_later(self, run: Run) -> asyncio.Task[bool]:
        """Begin to store what changed (a lease that ended, an admission).

        The task never raises; its result is whether the run was stored.
        """
        # RUN-021: a clock that is set back does not set the run back.
        run.updated_at_wall = max(run.updated_at_wall, time.time())
        saving = asyncio.ensure_future(self._save(run))
        self._saving[run.run_id] = saving
        self.run_in_background(saving)
        return saving

    def change_event(self, run_id: str) -> asyncio.Event:
        """The next change of what get_run shows; take it before reading the run."""
        return self._change_events.setdefault(run_id, asyncio.Event())

    async def wait_for_change(self, change: asyncio.Event, timeout_s: float) -> bool:
        """Wait for a change; whether there was one in time."""
        try:
            if not self._ending:
                await asyncio.wait_for(change.wait(), timeout_s)
        except TimeoutError:
            return False
        if self._ending:
            raise Refused("unavailable", "The server is shutting down.")
        return True

    def notify(self, run: Run) -> None:
        """Something that get_run shows has changed."""
        if not run.lost:
            self._index_by_state(run, run.state)
        self._wake(run.run_id)
        self._admit()

    def active(self) -> list[str]:
        """Ids of the runs that hold capacity."""
        return list(self._active)

    def queue_position(self, run: RunHead) -> int | None:
        """RUN-008: 1 is next; None unless queued."""
        if run.state not in WAITING_STATES:
            return None
        return 1 + bisect_left(self._queue, run.number)

    def _index_by_state(self, run: Run, state: State | None) -> None:
        """Among the active, in the queue, or nowhere, as the state says."""
        if state in ACTIVE_STATES:
            self._active.add(run.run_id)
        else:
            self._active.discard(run.run_id)
        was_queued = self._queued.pop(run.run_id, None) is not None
        is_queued = state in WAITING_STATES
        if is_queued:
            self._queued[run.run_id] = run
        if was_queued != is_queued:
            self._update_queue(run.number, was_queued)
        if state is not None:
            self._on_change(run)

    def _update_queue(self, number: int, has_left: bool) -> None:
        """A run has left or entered the queue: those behind it have moved (RUN-008)."""
        if has_left:
            del self._queue[bisect_left(self._queue, number)]
        else:
            insort(self._queue, number)
        for run_id in list(
            self._change_events
        ):  # rarely as many as there are in the queue
            waiting = self._queued.get(run_id)
            if waiting is not None and waiting.number > number:
                self._wake(run_id)

    def _wake(self, run_id: str) -> None:
        event = self._change_events.pop(run_id, None)
        if event is not None:
            event.set()

    def _admit(self, new: Run | None = None) -> None:
        """Let runs in while there is capacity.

        new: one that is not stored yet; its place is taken, and storing it is left to
        the caller.
        """
        # The length of a queue that cannot move costs nothing.
        if self._closed or len(self._active) >= self._active_max:
            return
        queued = [r for r in self._queued.values() if r.state in WAITING_STATES]
        if new is not None and new.state in WAITING_STATES:
            queued.append(new)
        if not queued:
            return
        now = steady_clock.now_wall()
        admitted = effects.admit(queued, len(self._active), self._active_max, now)
        for run in admitted:
            if run is new:
                self._active.add(run.run_id)
            else:
                self._index_by_state(run, run.state)
                self.commit_later(run)
        self._schedule_admission(now)

    def _schedule_admission(self, now: float) -> None:
        """Admit again when the next hold in the queue ends."""
        holds = [r.queue_until_wall for r in self._queued.values()]
        later = [until for until in holds if until > now]
        if self._admission_timer is not None:
            self._admission_timer.cancel()
            self._admission_timer = None
        if later:
            loop = asyncio.get_running_loop()
            wait_s = max(0.001, min(later) - now)
            self._admission_timer = loop.call_later(wait_s, self._admit)

    def run_in_background(self, work: Awaitable[object]) -> None:
        """Start work that no request waits for; it ends before the server does."""
        task = asyncio.ensure_future(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _save(self, run: Run) -> bool:
        try:
            await self._store.save(run)
        except Exception as error:  # whatever it was: memory is ahead of the disk now
            if isinstance(error, StoreFailed):
                self._failures.report("a run could not be stored", str(error))
            else:
                log.exception("run %s could not be stored", run.run_id)
            self._evict(run)
            return False
        else:
            return True
        finally:
            if self._saving.get(run.run_id) is asyncio.current_task():
                del self._saving[run.run_id]
            self.notify(run)

    async def _load(self, run_id: str) -> Run | None:
        """The run from the store, read once for all concurrent requests."""
        loading = self._loading.get(run_id)
        if loading is None:
            loading = asyncio.ensure_future(self._load_once(run_id))
            self._loading[run_id] = loading
        return await asyncio.shield(loading)

    async def _load_once(self, run_id: str) -> Run | None:
        try:
            return self._adopt(await self._store.load(run_id))
        finally:
            del self._loading[run_id]

    def _adopt(self, loaded: Run | None) -> Run | None:
        """A run just loaded was not in memory, so no session of it is live."""
        if loaded is not None:
            effects.lose_sessions(loaded)
            loaded.queue_until_wall = queue_until(
                loaded.submission, loaded.queue_until_wall, steady_clock.now_wall()
            )
            self._in_memory[loaded.run_id] = loaded
            self._index_by_state(loaded, loaded.state)
            self._admit()
        return loaded

    def _cache(self, run: Run) -> None:
        self._in_memory[run.run_id] = run
        self._recent[run.run_id] = run
        self._recent.move_to_end(run.run_id)
        if len(self._recent) > CACHED_RUNS_MAX:
            self._recent.popitem(last=False)

    def _evict(self, run: Run) -> None:
        """Drop the run from memory: from now on it is what the store has."""
        if run.lost:
            return
        run.lost = True
        self._in_memory.pop(run.run_id, None)
        self._recent.pop(run.run_id, None)
        self._index_by_state(run, None)
        # Until it is known what the store has, the run may be active and keeps a place.
        self._active.add(run.run_id)
        self._on_run_lost(run)
        self._reload_later(run.run_id)

    def _reload_later(self, run_id: str) -> None:
        """Load it again: a queued run is admitted without a request for it."""
        # A request may have loaded it meanwhile, and its next write have failed, too.
        if not self._closed and run_id not in self._reload_timers:
            loop = asyncio.get_running_loop()
            timer = loop.call_later(RELOAD_S, self._reload, run_id)
            self._reload_timers[run_id] = timer

    def _reload(self, run_id: str) -> None:
        del self._reload_timers[run_id]
        self.run_in_background(self._retry_load(run_id))

    async def _retry_load(self, run_id: str) -> None:
        try:
            await self.get(run_id)
        except StoreFailed as error:
            self._failures.report("a run could not be loaded", str(error))
            self._reload_later(run_id)


def _no_run(run_id: str) -> Refused:
    return Refused("not_found", f"There is no run {run_id}.")
