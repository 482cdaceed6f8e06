"""The runs in memory and their way to and from the store.

One Run object per run for as long as anyone holds it, so that every decision sees the
same state. Carries out what the protocol decides for the control plane, wakes whoever
waits for a change, and lets queued runs in when there is capacity.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import time
from collections import OrderedDict
from collections.abc import Awaitable, Callable
from weakref import WeakValueDictionary

from reference_server import progress
from reference_server.problems import Refused
from reference_server.run_state import Run, State
from reference_server.store import Store, StoreFailed

log = logging.getLogger("proctor.runs")

# Runs kept in memory although nobody uses them at the moment.
RUNS_KEPT = 256
ACTIVE = ("ready", "running", "stopping")


class RunBook:
    """All runs of this server, by id."""

    def __init__(self, store: Store, active_max: int) -> None:
        self._store = store
        self._active_max = active_max
        self._known: WeakValueDictionary[str, Run] = WeakValueDictionary()
        self._recent: OrderedDict[str, Run] = OrderedDict()
        self._queued: dict[str, Run] = {}
        self._active: set[str] = set()
        self._saving: dict[str, int] = {}
        self._news: dict[str, asyncio.Event] = {}
        self._admission: asyncio.TimerHandle | None = None
        self._tasks: set[asyncio.Task[None]] = set()
        self._ending = False
        # Set by the data plane: what to do with the sessions of a run that was lost.
        self.forget: Callable[[Run], None] = lambda _run: None

    async def open(self) -> None:
        self._active = set(await self._store.in_states(*ACTIVE))
        for run_id in await self._store.in_states("queued"):
            await self.get(run_id)

    def end(self) -> None:
        """The server will end: nobody needs to wait for a change any more."""
        self._ending = True
        for run_id in list(self._news):
            self._wake(run_id)

    async def close(self) -> None:
        """Wait until everything that was begun is stored."""
        if self._admission is not None:
            self._admission.cancel()
        if self._tasks:
            await asyncio.wait(set(self._tasks))

    async def get(self, run_id: str, account: str | None = None) -> Run:
        """The run, if the account may see it (AUTH-003, RUN-010)."""
        run = self._known.get(run_id)
        if run is None:
            loaded = await self._store.load(run_id)
            # Somebody may have loaded it meanwhile: theirs is the one.
            run = self._known.get(run_id) or self._adopt(loaded)
        if run is None or account not in (None, run.account):
            raise Refused("not_found", f"There is no run {run_id}.")
        self._keep(run)
        return run

    async def add(self, run: Run, key: str | None, body_sha256: str) -> Run:
        """Store a new run; or the run that this Idempotency-Key made (RUN-003)."""
        if await self._store.insert(run, key, body_sha256):
            self._keep(run)
            self._place(run, run.state)
            self._admit()
            return run
        assert key is not None
        found = await self._store.find_key(run.account, key)
        assert found is not None, "an insert is refused only for a used key"
        if found[0] != body_sha256:
            raise Refused(
                "idempotency_conflict",
                f"The key made run {found[1]} from another body.",
                requirement="RUN-004",
            )
        return await self.get(found[1])

    async def page(self, account: str, before: int | None, limit: int) -> list[Run]:
        """Up to `limit` runs of the account, newest first."""
        rows = await self._store.page(account, before, limit)
        return [await self.settled(await self.get(run_id)) for _, run_id in rows]

    async def commit(self, run: Run) -> None:
        """Store what changed; then tell those who wait for it.

        A failed write drops the run from memory: the store has the truth, and the
        sessions end as in a restart.
        """
        run.updated_at_wall = time.time()
        self._saving[run.run_id] = self._saving.get(run.run_id, 0) + 1
        try:
            await self._store.save(run)
        except StoreFailed as error:
            log.exception("run %s could not be stored", run.run_id)
            self._drop(run)
            raise Refused("unavailable", "The run could not be stored.") from error
        finally:
            self._saving[run.run_id] -= 1
            if not self._saving[run.run_id]:
                del self._saving[run.run_id]
            self.notify(run)

    def commit_later(self, run: Run) -> None:
        """Commit what no request waits for (a lease that ended, an admission)."""
        self.begin(self._commit_quietly(run))

    async def settled(self, run: Run) -> Run:
        """The run when all of it is stored: nobody is told what may yet be lost."""
        while run.run_id in self._saving:
            await self._event(run).wait()
        return await self.get(run.run_id)

    async def changed(self, run: Run, timeout_s: float) -> bool:
        """Wait for the next change; whether there was one in time."""
        try:
            await asyncio.wait_for(self._event(run).wait(), timeout_s)
        except TimeoutError:
            return False
        if self._ending:
            raise Refused("unavailable", "The server is ending.")
        return True

    def notify(self, run: Run) -> None:
        """Something that get_run shows has changed."""
        if not run.lost:
            self._place(run, run.state)
        self._wake(run.run_id)
        self._admit()

    def queue_position(self, run: Run) -> int | None:
        """RUN-008: 1 is next; None unless queued."""
        if run.state != "queued":
            return None
        return 1 + sum(
            1 for other in self._queued.values() if other.number < run.number
        )

    def _place(self, run: Run, state: State | None) -> None:
        """Among the active, in the queue, or nowhere, as the state says."""
        if state in ACTIVE:
            self._active.add(run.run_id)
        else:
            self._active.discard(run.run_id)
        was_queued = self._queued.pop(run.run_id, None) is not None
        if state == "queued":
            self._queued[run.run_id] = run
        if was_queued != (state == "queued"):
            for run_id in self._queued:  # their positions have changed
                self._wake(run_id)

    def _wake(self, run_id: str) -> None:
        event = self._news.pop(run_id, None)
        if event is not None:
            event.set()

    def _event(self, run: Run) -> asyncio.Event:
        return self._news.setdefault(run.run_id, asyncio.Event())

    def _admit(self) -> None:
        queued = [r for r in self._queued.values() if r.state == "queued"]
        if not queued:
            return
        now = time.time()
        admitted = progress.admit(queued, len(self._active), self._active_max, now)
        for run in admitted:
            self._place(run, run.state)
            self.commit_later(run)
        self._admit_again(now)

    def _admit_again(self, now: float) -> None:
        """Look again when the next hold in the queue ends."""
        holds = [r.queue_until_wall for r in self._queued.values()]
        later = [until for until in holds if until > now]
        if self._admission is not None:
            self._admission.cancel()
            self._admission = None
        if later:
            loop = asyncio.get_running_loop()
            wait_s = max(0.001, min(later) - now)
            self._admission = loop.call_later(wait_s, self._admit)

    async def _commit_quietly(self, run: Run) -> None:
        # Logged and dropped by commit; there is nobody to answer.
        with contextlib.suppress(Refused):
            await self.commit(run)

    def begin(self, work: Awaitable[None]) -> None:
        """Do work that no request waits for, before the server ends."""
        task = asyncio.ensure_future(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    def _adopt(self, loaded: Run | None) -> Run | None:
        """A run just loaded: nobody held it, so no session of it lives."""
        if loaded is not None:
            progress.move(loaded, "last_lease_ends", "Its sessions were lost.")
            self._known[loaded.run_id] = loaded
            self._place(loaded, loaded.state)
            self._admit()
        return loaded

    def _keep(self, run: Run) -> None:
        self._known[run.run_id] = run
        self._recent[run.run_id] = run
        self._recent.move_to_end(run.run_id)
        if len(self._recent) > RUNS_KEPT:
            self._recent.popitem(last=False)

    def _drop(self, run: Run) -> None:
        """From now on the run is what the store has, and loaded when it is wanted."""
        if run.lost:
            return
        run.lost = True
        self._known.pop(run.run_id, None)
        self._recent.pop(run.run_id, None)
        self._place(run, None)
        self.forget(run)
