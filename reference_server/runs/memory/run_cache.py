"""The runs in memory: one object per run for as long as it is referenced (MODEL-002).

So every decision sees the same state. A run that is used is kept a while longer; one
that is not in memory is read once for all requests that want it at the same moment. In
a cluster memory has the runs of its node alone: one of a node that has ended is claimed
when it is read.
"""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from weakref import WeakValueDictionary

from reference_server.process.background_work import shielded
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import WAITING_STATES
from reference_server.rules.runs.run import Run, RunHead
from reference_server.rules.submission import queue_until
from reference_server.runs import steady_clock
from reference_server.runs.memory.ended_sessions import EndedSessions
from reference_server.runs.memory.recent_runs import RecentRuns
from reference_server.runs.memory.remote_runs import Ownership
from reference_server.runs.memory.run_events import RunEvents
from reference_server.storage.runs.run_store import Store, StoreFailed


class RunCache:
    """Runs by id. ownership: None for a server that has the database for itself."""

    def __init__(
        self,
        store: Store,
        events: RunEvents,
        ended_sessions: EndedSessions,
        ownership: Ownership | None = None,
    ) -> None:
        self._store, self._events, self._ownership = store, events, ownership
        self._ended_sessions = ended_sessions
        self._in_memory: WeakValueDictionary[str, Run] = WeakValueDictionary()
        self._recent = RecentRuns()
        self._loading: dict[str, asyncio.Task[Run | None]] = {}
        self._leaving: dict[str, asyncio.Task[None]] = {}

    def __contains__(self, run_id: str) -> bool:
        """Whether the run is in memory."""
        return run_id in self._in_memory

    def __iter__(self) -> Iterator[Run]:
        """All runs in memory, as they are at this moment."""
        return iter(list(self._in_memory.values()))

    def find(self, run_id: str) -> Run | None:
        """The run, if it is in memory."""
        return self._in_memory.get(run_id)

    def find_settled(self, run_id: str) -> Run | None:
        """The run, if it is in memory and neither lost nor being deleted."""
        run = self._in_memory.get(run_id)
        return None if run is None or run.lost or run_id in self._leaving else run

    def is_loading(self, run_id: str) -> bool:
        return run_id in self._loading

    def is_elsewhere(self, head: RunHead) -> bool:
        """Whether another node acts for the run, or will."""
        owners = self._ownership
        return owners is not None and owners.node_id != head.owner

    async def get(self, run_id: str) -> Run | None:
        """The run, read if it is not in memory; None if there is none."""
        if (leaving := self._leaving.get(run_id)) is not None:
            await asyncio.wait([leaving])
        run = self._in_memory.get(run_id) or await self.load(run_id)
        if run is not None and run.lost:  # a write that its loading began has failed
            if self._in_memory.get(run_id) is run:
                del self._in_memory[run_id]
            run = await self.load(run_id)
            if run is not None and run.lost:
                raise StoreFailed("the run could not be stored")
        return run

    async def load(self, run_id: str) -> Run | None:
        """The run in memory, or from the store, read once for concurrent requests."""
        if (run := self._in_memory.get(run_id)) is not None:
            return run
        loading = self._loading.get(run_id)
        if loading is None:
            loading = asyncio.ensure_future(self._load_once(run_id))
            self._loading[run_id] = loading
        return await shielded(loading)

    async def _load_once(self, run_id: str) -> Run | None:
        try:
            loaded = await self._store.load(run_id)
            if loaded is not None and self.is_elsewhere(loaded):
                loaded = await self._claim(run_id)
            if loaded is not None and self._ownership is not None:
                await self._ownership.confirm()
            if loaded is not None:
                await self._events.prepare(loaded)
                self._adopt(loaded)
            return loaded
        finally:
            del self._loading[run_id]

    async def _claim(self, run_id: str) -> Run | None:
        """The run of another node that has ended. Raises OwnedElsewhere."""
        assert self._ownership is not None, "without it no run is elsewhere"
        if await self._ownership.claim(run_id):
            loaded = await self._store.load(run_id)
            if loaded is None or not self.is_elsewhere(loaded):
                return loaded
        raise OwnedElsewhere(run_id)

    def _adopt(self, loaded: Run) -> None:
        """A run just loaded was not in memory: it has the sessions that go on alone."""
        stored = loaded.state
        loaded.ended.update(self._ended_sessions.of(loaded.run_id))
        effects.lose_sessions(loaded)
        loaded.queue_until_wall = queue_until(
            loaded.submission, loaded.queue_until_wall, steady_clock.now_wall()
        )
        self._in_memory[loaded.run_id] = loaded
        self._events.loaded(loaded, stored)

    def add(self, run: Run) -> None:
        """Each request for the run gets this object of it from now on."""
        self._in_memory[run.run_id] = run

    def keep(self, run: Run) -> None:
        """Keep a run that is used; one that waits is not, however many there are."""
        if self._recent.is_last(run):
            return  # as at each turn: it is in memory, too
        self.add(run)
        if run.state not in WAITING_STATES:
            self._recent.keep(run)

    def remove(self, run: Run) -> None:
        """The next request for the run reads it again."""
        self._in_memory.pop(run.run_id, None)
        self._recent.drop(run.run_id)

    def hold_until(self, run_id: str, leaving: asyncio.Task[None]) -> None:
        """A request for the run waits for the end of its deletion meanwhile."""
        self._leaving[run_id] = leaving
        leaving.add_done_callback(lambda _: self._leaving.pop(run_id))
