"""The runs in memory and their way to and from the store.

One Run object per run for as long as it is referenced, so that every decision sees the
same state (MODEL-002). It stores what the rules changed, wakes requests that wait for a
change, and admits queued runs when there is capacity. It decides no rule, and knows no
HTTP and no SQL.

Memory may be ahead of the disk while a write is in progress. That is never shown: a
view is taken from memory and returned once it is stored (`render_when_stored`;
CRASH-001, EVT-009). A failed write drops the run from memory, because the database
holds the valid state, and its sessions end as in a restart.

In a cluster it has the runs of its node alone; of others it shows what is stored.
"""

from __future__ import annotations

import asyncio
import contextvars
import logging
import math
import time
from collections import Counter, deque
from collections.abc import Awaitable, Callable, Mapping, Sequence
from functools import partial
from typing import TypeVar
from weakref import WeakKeyDictionary, WeakValueDictionary

from reference_server.rules import effects
from reference_server.rules.capacity import Quota, WaitingRun
from reference_server.rules.lifecycle import (
    ACTIVE_STATES,
    ENDED_STATES,
    RESTART_REASON,
    RESTING_STATES,
    STATES_AFTER_RESTART,
    WAITING_STATES,
)
from reference_server.rules.manifest import Submission
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Episode, Run, RunHead, State
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.rules.submission import (
    KeyUse,
    key_conflict,
    may_see_run,
    queue_s,
    queue_until,
)
from reference_server.runs import steady_clock
from reference_server.runs.account_usage import AccountUsage
from reference_server.runs.admission import Admission
from reference_server.runs.memory.ended_sessions import EndedSessions
from reference_server.runs.memory.places import Places
from reference_server.runs.memory.recent_runs import RecentRuns
from reference_server.runs.memory.run_changes import RunChange, RunChanges
from reference_server.runs.memory.runs_elsewhere import (
    OtherQueues,
    Ownership,
    RunsElsewhere,
    has_newer_owner,
)
from reference_server.runs.run_log import RunLog, new_results
from reference_server.storage.node_store import OwnedRun, StoredQueue
from reference_server.storage.store import (
    OwnershipLost,
    RunIsKept,
    Store,
    StoreFailed,
)
from reference_server.system.counters import COUNTERS, timed
from reference_server.system.repeated_failures import RepeatedFailures
from reference_server.system.spans import span

log = logging.getLogger("proctor.runs")

# How long after a failed write its run is loaded again without a request for it.
RELOAD_S = 1.0
# Read at once of the runs that may be played after a restart.
HEADS_PER_READ = 200
# Shown of a page of runs before others are served.
VIEWS_AT_ONCE = 20

Rendered = TypeVar("Rendered")


class RunRegistry:
    """All runs of this server, by id.

    active_max: places of runs that are played or about to be. unused_s: when others
    wait, how long a run without a worker keeps its place. quota: of each account.
    on_run_lost: ends the sessions of a run whose write failed. on_change: is called
    with a run whose state may have changed. ownership, other_queues: None for a server
    that has the database for itself.
    """

    def __init__(
        self,
        store: Store,
        active_max: int,
        on_run_lost: Callable[[Run], None],
        on_change: Callable[[Run], None],
        *,
        unused_s: float = 120.0,
        quota: Quota | None = None,
        ownership: Ownership | None = None,
        other_queues: OtherQueues | None = None,
    ) -> None:
        self._store, self._ownership = store, ownership
        self._other_queues = other_queues
        self._on_run_lost, self._on_change = on_run_lost, on_change
        self.usage = AccountUsage(quota or Quota())
        self._admission = Admission(
            Places(active_max, unused_s),
            self._let_in,
            self._note_moved,
            None if other_queues is None else other_queues.look,
        )
        self._in_memory: WeakValueDictionary[str, Run] = WeakValueDictionary()
        self.ended_sessions = EndedSessions()
        self._recent = RecentRuns()
        self._elsewhere = RunsElsewhere()
        self._admitted: deque[str] = deque()  # ids of what is to be loaded for that
        self._not_opened: WeakKeyDictionary[Run, Refused] = WeakKeyDictionary()
        self._loading: dict[str, asyncio.Task[Run | None]] = {}
        self._saving: dict[str, asyncio.Task[bool]] = {}  # the last one of each run
        self._deleting: dict[str, asyncio.Task[None]] = {}
        self._changes = RunChanges()
        self._reload_timers: dict[str, asyncio.TimerHandle] = {}
        self._tasks: set[asyncio.Future[object]] = set()
        self._ending = self._closed = False
        self._failures = RepeatedFailures(log)
        self._life = RunLog()

    async def open(self) -> None:
        """Apply what a restart does, then admit what waits for capacity.

        What was played has a place, for its workers come back; what was only ready gets
        one when a worker attaches. No run is loaded for that. In a cluster this happens
        to each run when a node claims it, and `get` admits it.
        """
        if self._ownership is not None:
            return
        places, now = self._admission.places, time.monotonic()
        for run in await self._store.waiting_runs(*STATES_AFTER_RESTART):
            places.play(run.run_id, run.account)
            places.rest(run.run_id, now)
        await self._store.replace_states(STATES_AFTER_RESTART, RESTART_REASON)
        self.usage.load_stored(*await self._store.sizes_of_accounts())
        for run in await self._store.waiting_runs(*ACTIVE_STATES):
            self.usage.note_open(run.account, run.run_id, is_open=True)
        for run in await self._store.waiting_runs(*WAITING_STATES):
            self.usage.note_open(run.account, run.run_id, is_open=True)
            if run.queue_until_wall <= steady_clock.now_wall():
                self._admission.note_queued(run, is_queued=True)
            else:  # seldom, and for seconds: `_adopt` checks it by what was asked for
                await self.get(run.run_id)
        self._admission.admit()

    def begin_ending(self) -> None:
        """The server will shut down: end every wait for a change, begin nothing new."""
        self._ending = True
        self._changes.wake_all()

    @property
    def is_ending(self) -> bool:
        return self._ending

    def refuse_if_ending(self) -> None:
        """Of what is new: what has begun is finished."""
        if self._ending:
            raise Refused("unavailable", "The server is shutting down.")

    async def close(self) -> None:
        """Wait until every write that was begun has ended; no other begins."""
        self._closed = True
        self._admission.close()
        for timer in self._reload_timers.values():
            timer.cancel()
        while self._tasks:  # one may begin another
            await asyncio.wait(self._tasks)

    async def get(self, run_id: str, account: str | None = None) -> Run:
        """The run, if the account may see it (AUTH-003, RUN-010)."""
        if (deleting := self._deleting.get(run_id)) is not None:
            await asyncio.wait([deleting])
        run = self._in_memory.get(run_id) or await self._load(run_id)
        if run is not None and run.lost:  # a write that its loading began has failed
            if self._in_memory.get(run_id) is run:
                del self._in_memory[run_id]
            run = self._in_memory.get(run_id) or await self._load(run_id)
            if run is not None and run.lost:
                raise StoreFailed("the run could not be stored")
        if run is None or not may_see_run(account, run.account):
            raise _no_run(run_id)
        self._cache(run)
        return run

    async def read_view(
        self,
        run_id: str,
        account: str | None,
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
        await self._know_queue(run_id)
        if run_id not in self._in_memory:
            found = await self._store.read_window(run_id, start, end, scored)
            if found is not None and self._is_current(found[0]):
                if not may_see_run(account, found[0].account):
                    raise _no_run(run_id)
                return view(*found)
        run = await self.get(run_id, account)
        window = partial(Run.window, start=start, end=end, scored=scored)
        return await self.render_when_stored(run, lambda run: view(run, window(run)))

    def has(self, run_id: str) -> bool:
        """Whether the run is in memory, and no other node may take it."""
        return run_id in self._in_memory and run_id not in self._admission.queue

    def is_elsewhere(self, head: RunHead) -> bool:
        """Whether another node acts for the run, or will."""
        owners = self._ownership
        return owners is not None and owners.node_id != head.owner

    def _is_current(self, head: RunHead) -> bool:
        """Whether the run is as it was just read: it was not loaded meanwhile."""
        if self.is_elsewhere(head):
            return True  # all that this node can know
        # What is known to be in the queue leaves it only in memory.
        queue = self._admission.queue
        is_stable = head.state in RESTING_STATES or head.run_id in queue
        return is_stable and head.run_id not in self._in_memory

    async def add(self, run: Run, key: str | None, body_sha256: str) -> Run:
        """Store a new run; or the run that this Idempotency-Key made (RUN-003).

        RUN-027: only a run that is stored uses up its key. RUN-029: without a key
        nothing is looked up.
        """
        self.refuse_if_ending()
        check = None
        if self._ownership is None:
            await self._check_quota(run.account, key)
        else:  # others count, too: in the transaction that stores it
            run.owner, run.fence = self._ownership.node_id, 1
            check = partial(self.usage.check_stored, key is not None)
        # At once: what is submitted at the same time counts it.
        self.usage.note_open(run.account, run.run_id, is_open=True)
        self.usage.note_stored(run, key)
        # A request that finds it in the store, even before this one, finds this object.
        self._in_memory[run.run_id] = run
        self._admission.admit(run)  # before it is stored: one submit is one transaction
        if await self.run_to_end(self._store_new(run, key, body_sha256, check)):
            return run
        assert key is not None
        use = await self.find_by_key(run.account, key)
        assert use is not None, "an insert is refused only for a used key"
        conflict = key_conflict(use, body_sha256)
        if conflict is not None:
            raise Refused.from_verdict(conflict)
        try:
            return await self.get(use.run_id)
        except OwnedElsewhere:
            return await self._read_foreign(use.run_id)
        except Refused as refused:
            raise Refused(
                "not_found",
                "The run of this Idempotency-Key was deleted; use a new key.",
                requirement="DEL-005",
            ) from refused

    async def _store_new(
        self,
        run: Run,
        key: str | None,
        body_sha256: str,
        check: Callable[[Quota], None] | None,
    ) -> bool:
        """Whether a run that memory counts was stored; if not, it counts no more."""
        is_stored = False
        try:
            with timed(COUNTERS.database_writes), span("store run"):
                is_stored = await self._store.insert(run, key, body_sha256, check)
        finally:
            if not is_stored:
                self._in_memory.pop(run.run_id, None)
                self.usage.note_open(run.account, run.run_id, is_open=False)
                self.usage.note_stored(run, key, is_stored=False)
                self._admission.give_back(run.run_id)
        if is_stored:
            self._life.log_submitted(run)
            if self._elsewhere.is_complete(run):  # another node had room for it
                return True
            if run.lost:  # `drop_all` meanwhile: the node that claims it plays it
                text = "The node lost its lease. Repeat with the same Idempotency-Key."
                raise Refused("unavailable", text)
            self._cache(run)
            self._index_by_state(run, run.state)
            self._admission.admit()
            self._announce_queue()
        return is_stored

    async def _read_foreign(self, run_id: str) -> Run:
        """A run of another node as it is stored, to be shown."""
        run = await self._store.load(run_id)
        if run is None:
            raise _no_run(run_id)
        return run

    async def find_by_key(self, account: str, key: str) -> KeyUse | None:
        """What an Idempotency-Key of the account made, if it was used (RUN-026)."""
        found = await self._store.find_key(account, key)
        return None if found is None else KeyUse(*found)

    async def page(
        self,
        account: str | None,
        before: int | None,
        limit: int,
        view: Callable[[RunHead], Rendered],
    ) -> list[Rendered]:
        """Up to `limit` views of the account, newest first (RUN-009, AUTH-004).

        Without an account those of all (AUTH-008).
        """
        if self._admission.queue and self._other_queues is not None:
            await self._other_queues.refresh()
        ids = [run_id for _, run_id in await self._store.page(account, before, limit)]
        heads = await self._store.heads([i for i in ids if i not in self._in_memory])
        found = []
        for place, run_id in enumerate(ids):
            if place % VIEWS_AT_ONCE == 0:
                await asyncio.sleep(0)  # a page may have a thousand
            head = heads.get(run_id)
            if head is not None and self._is_current(head):
                found.append(view(head))
                continue
            try:
                run = await self.get(run_id)
                found.append(await self.render_when_stored(run, view))
            except Refused:  # deleted meanwhile: a page is not short of it
                return await self.page(account, before, limit, view)
        return found

    async def render_when_stored(
        self, run: Run, view: Callable[[Run], Rendered]
    ) -> Rendered:
        """What `view` makes of the run, once all of that is stored."""
        while True:
            await self._know_queue(run.run_id)
            rendered, played_number = view(run), run.played_number
            # DEL-006: the first write of what was played gives its number.
            if await self.is_stored(run) and run.played_number == played_number:
                return rendered
            run = await self.get(run.run_id)

    async def is_stored(self, run: Run) -> bool:
        """Whether the run as it is now is on disk, as soon as that is known.

        Waits for the last write that was begun, and for none that begins meanwhile.
        What another node has taken since then was stored before.
        """
        saving = self._saving.get(run.run_id)
        if saving is not None:
            await asyncio.wait([saving])
        return not run.lost or self._elsewhere.is_complete(run)

    async def commit(self, run: Run) -> None:
        """Store what changed, then wake the requests that wait for it (CRASH-001).

        A caller that is cancelled does not take the write with it.
        """
        await self._wait_until_stored(run, self.commit_later(run))

    async def commit_opened(self, run: Run) -> None:
        """Store a run that counts as open again, or refuse that.

        LIM-007: in a cluster, by what the account has open on every node, in the
        transaction that stores the run.
        """
        if self._ownership is None:
            await self.commit(run)
            return
        saving = self.commit_later(run, self.usage.check_opened)
        await self._wait_until_stored(run, saving)

    async def _wait_until_stored(self, run: Run, saving: asyncio.Task[bool]) -> None:
        if await asyncio.shield(saving):
            return
        if (refused := self._not_opened.pop(run, None)) is not None:
            raise refused
        if self._elsewhere.is_lost(run):
            raise OwnedElsewhere(run.run_id)
        raise Refused("unavailable", "The run could not be stored.")

    def commit_later(
        self, run: Run, check: Callable[[Quota], None] | None = None
    ) -> asyncio.Task[bool]:
        """Begin to store what changed (a lease that ended, an admission).

        The task never raises; its result is whether the run was stored. check: as for
        Store.save.
        """
        run.updated_at_wall = _changed_at(run.updated_at_wall, time.time())
        saving = asyncio.ensure_future(self._save(run, check))
        self._saving[run.run_id] = saving
        self.run_in_background(saving)
        return saving

    async def delete(self, run: Run, *, by_host: bool = False) -> None:
        """Delete a run that nothing can play any more; DEL-004: then it is no more.

        Who requests it meanwhile waits for the end. Raises StoreFailed and RunIsKept;
        the run then is as it was before.
        """
        deleting = asyncio.ensure_future(self._delete(run, by_host))
        self._deleting[run.run_id] = deleting
        self.run_in_background(deleting)
        self.notify(run)
        await asyncio.shield(deleting)

    async def _delete(self, run: Run, by_host: bool) -> None:
        try:
            await self.is_stored(run)  # a write that was begun would come after it
            await self._store.delete(run, time.time(), by_host=by_host)
        except OwnershipLost:
            COUNTERS.fenced_writes += 1
            self._drop(run)
            raise
        except (StoreFailed, RunIsKept):
            self._evict(run)
            raise
        else:
            self._life.log_deleted(run)
            self.usage.note_deleted(run)
            self._forget(run)
            self.ended_sessions.forget(run.run_id)
        finally:
            del self._deleting[run.run_id]
            self._changes.wake(run.run_id)
            self._admission.admit()
            self._announce_queue()

    async def ended_since(
        self, before_wall: float, after: int
    ) -> list[tuple[int, str]]:
        """(number, id) of the next runs behind a number that ended before that time."""
        states = sorted(ENDED_STATES)
        return await self._store.in_states_since(
            states, before_wall, after, HEADS_PER_READ
        )

    def change_event(self, run_id: str) -> RunChange:
        """The next change of what get_run shows; take it before reading the run."""
        return self._changes.next_of(run_id)

    async def wait_for_change(self, change: RunChange, timeout_s: float) -> bool:
        """Wait for a change; whether there was one in time."""
        try:
            if not self._ending:
                await asyncio.wait_for(change.wait(), timeout_s)
        except TimeoutError:
            return False
        self.refuse_if_ending()
        if change.is_elsewhere:
            raise OwnedElsewhere(change.run_id)
        return True

    def notify(self, run: Run) -> None:
        """Something that get_run shows has changed."""
        if not run.lost:
            self._life.log_playing(run)
            self._index_by_state(run, run.state)
        self._changes.wake(run.run_id)
        self._admission.admit()

    async def check_open_elsewhere(self, account: str) -> None:
        """LIM-007: refuse before anything has changed, where that is known by then.

        What opens at the same moment is seen by the transaction (`commit_opened`).
        """
        if self._ownership is not None:
            self.usage.check_opened(await self._store.usage_of(account))

    def open_again(self, run: Run) -> None:
        """LIM-007: a resume makes a run count at once, or is refused."""
        self.refuse_if_ending()
        self.usage.check_open(run.account)
        self.usage.note_open(run.account, run.run_id, is_open=True)

    async def _check_quota(self, account: str, key: str | None) -> None:
        """A key that is used makes no run (RUN-003)."""
        try:
            self.usage.check_new(account, has_key=key is not None)
        except Refused:
            if key is None or await self.find_by_key(account, key) is None:
                raise

    def take_place(self, run: Run) -> None:
        """A worker attaches: the run has a place, or is refused and waits for one.

        What waits gets the next place that is its own in turn, so that a repeat finds
        it. LIM-004: others give back what they do not use.
        """
        places = self._admission.places
        if run.run_id in places:
            return
        places.wait(WaitingRun(run.run_id, run.number, run.account, 0.0))
        self._admission.admit(knows_all=True)  # the answer waits for no look elsewhere
        if run.run_id not in places:
            raise Refused("no_capacity", "As many runs are played as may be at once.")

    async def push_runs(self) -> list[str]:
        """Ids of the push runs that may be played; none is loaded for that."""
        found: list[str] = []
        if self._ownership is not None:  # each is found when a node claims it
            return found
        ids = await self._store.in_states(*ACTIVE_STATES)
        for start in range(0, len(ids), HEADS_PER_READ):
            heads = await self._store.heads(ids[start : start + HEADS_PER_READ])
            found += [run_id for run_id, head in heads.items() if head.is_push]
        return found

    # --- the queues of other nodes ---

    def queued_ids(self) -> list[str]:
        """Of the runs of this server that wait."""
        return self._admission.queue.ids()

    def held_no_more(self) -> list[str]:
        """Ids of runs that their submitters held in the queue, and that wait now."""
        return self._admission.held_no_more()

    def queue_until(self, submission: Submission) -> float:
        """Until when a run that is submitted or resumed now is held in the queue.

        0 in a cluster if it is not held: any node may take it then, whatever its clock.
        """
        held_s = queue_s(submission)
        if self._other_queues is not None and held_s <= 0:
            return 0.0
        return steady_clock.now_wall() + held_s

    def places_of_accounts(self) -> dict[str, int]:
        """How many places each account has here."""
        return self._admission.places.counts()

    def note_queue(self, seen: StoredQueue) -> None:
        """What waits at all nodes by now, and what became of others of `queued_ids`."""
        assert self._ownership is not None, "without it there is no other node"
        me, queue, elsewhere = self._ownership.node_id, self._admission.queue, []
        for one in (*seen.queued, *seen.left):
            if one.owner != me:
                self._forget_taken(one)
        for one in seen.queued:
            if one.owner != me:
                elsewhere.append(one.run.number)
            elif one.run.run_id not in queue and not self._knows(one.run.run_id):
                self.load_in_background(one.run.run_id)
        changed = queue.note_elsewhere(elsewhere)
        if changed is not None:
            self._wake_behind(changed)

    def note_waiting_elsewhere(
        self, waiting: Sequence[WaitingRun], places: Mapping[str, int]
    ) -> None:
        """What other nodes let this one take, and the places of accounts there.

        By that, and by what waits here, the next runs get the places that are free.
        """
        waiting = [run for run in waiting if not self._knows(run.run_id)]
        self._elsewhere.offer(run.run_id for run in waiting)
        self._admission.places.note_elsewhere(waiting, places)
        self._admission.admit(knows_all=True)

    def _knows(self, run_id: str) -> bool:
        """Whether the run is here, or on its way."""
        known = (self._in_memory, self._loading, self._admitted, self._reload_timers)
        return any(run_id in some for some in known)

    def _forget_taken(self, taken: OwnedRun) -> None:
        """A run of another node, which may have been one of this."""
        run_id = taken.run.run_id
        run = self._in_memory.get(run_id)
        if run is not None:
            if has_newer_owner(run, taken):
                self._drop(run, is_complete=run_id not in self._saving)
        elif run_id in self._admission.queue:
            self._changes.wake(run_id, is_elsewhere=True)
            self.usage.note_open(taken.run.account, run_id, is_open=False)
            self._admission.places.leave(run_id)
            self._admission.note_queued(taken.run, is_queued=False)

    async def _know_queue(self, run_id: str) -> None:
        """RUN-008: what waits before a run may wait at another node."""
        if self._other_queues is None or run_id not in self._admission.queue:
            return
        if self._admission.places.is_due(run_id, steady_clock.now_wall()):
            await self._other_queues.refresh()

    def _announce_queue(self) -> None:
        """Once what has changed in the queue is stored."""
        if self._other_queues is not None and self._elsewhere.begin_to_announce():
            self._other_queues.announce()

    def queue_position(self, run: RunHead) -> int | None:
        """RUN-008: 1 is next; None unless queued."""
        if run.state not in WAITING_STATES:
            return None
        return self._admission.queue.position(run.number)

    def count_open(self) -> dict[str, int]:
        """How many runs have not ended, by state."""
        played = Counter(run.state for run in list(self._in_memory.values()))
        counts: dict[str, int] = {"queued": len(self._admission.queue)}
        # What has a live session is in memory.
        counts |= {"running": played["running"], "stopping": played["stopping"]}
        counts["ready"] = max(0, self.usage.count_open() - sum(counts.values()))
        return counts

    def oldest_queued_s(self) -> float:
        """How long the first of the queue has waited; 0 without one."""
        queued_at_wall = self._admission.queue.oldest_queued_at_wall()
        return 0.0 if queued_at_wall is None else max(0.0, time.time() - queued_at_wall)

    def _index_by_state(self, run: Run, state: State | None) -> None:
        """What the state means for places and accounts, and for listeners."""
        self._admission.index(run, state)
        if state is not None:
            is_open = state in WAITING_STATES or state in ACTIVE_STATES
            self.usage.note_open(run.account, run.run_id, is_open=is_open)
            self._on_change(run)

    def _note_moved(self, number: int) -> None:
        """A run came into the queue here, or left it."""
        self._elsewhere.note_queue_change()
        self._wake_behind(number)

    def _wake_behind(self, number: int) -> None:
        """Runs that wait behind that number have another place in the queue."""
        # Rarely as many wait for a change as there are in the queue.
        for run_id in self._changes.run_ids():
            if self._admission.queue.is_behind(run_id, number):
                self._changes.wake(run_id)

    def _let_in(self, run_id: str, new: Run | None) -> None:
        """A run got a place; one that is not in memory is loaded for that."""
        if new is not None:
            effects.admit(new, steady_clock.now_wall())
        elif (run := self._in_memory.get(run_id)) is not None:
            if not self._apply_admission(run):
                self._index_by_state(run, run.state)
        else:
            self._elsewhere.want(run_id)
            self._admitted.append(run_id)
            if len(self._admitted) == 1:
                self.run_in_background(self._load_admitted())

    def _apply_admission(self, run: Run) -> bool:
        """Whether the run was queued; else it was ready, and a worker attaches."""
        if not effects.admit(run, steady_clock.now_wall()):
            return False
        self._index_by_state(run, run.state)
        self.commit_later(run)
        return True

    async def _load_admitted(self) -> None:
        """One after another: each is stored and out of memory before the next."""
        while self._admitted and not self._closed:
            run_id = self._admitted[0]
            try:
                is_from_elsewhere = self._elsewhere.begin_to_take(run_id)
                if is_from_elsewhere and not await self._take(run_id):
                    continue
                run = self._in_memory.get(run_id) or await self._load(run_id)
                if run is not None and is_from_elsewhere:
                    self._life.log_taken(run)
                if run is not None:
                    await self.is_stored(run)
            except OwnedElsewhere:  # another node that has room came first
                self._admission.give_back(run_id)
            except StoreFailed as error:
                self._failures.report("a run could not be loaded", str(error))
                self._reload_later(run_id)
            except Exception:  # its row is damaged: those behind it are admitted
                log.exception("run %s cannot be read", run_id)
                self._admission.give_back(run_id)
            finally:
                self._admitted.popleft()

    async def _take(self, run_id: str) -> bool:
        """Whether a run of another node that got a place here is this one's now."""
        assert self._other_queues is not None, "without them nothing waits there"
        is_taken = False
        try:
            is_taken = await self._other_queues.take(run_id)
        finally:
            if not is_taken:
                self._admission.give_back(run_id)
        if is_taken:
            self._elsewhere.note_queue_change()
        self._announce_queue()
        return is_taken

    async def run_to_end(self, work: Awaitable[Rendered]) -> Rendered:
        """What `work` returns. A caller that is cancelled does not take it with it.

        For a write and what memory notes of it: both happen, or neither does.
        """
        task = asyncio.ensure_future(work)
        self.run_in_background(task)
        # What it raises is for its caller; one that is gone needs no traceback.
        task.add_done_callback(lambda done: done.cancelled() or done.exception())
        return await asyncio.shield(task)

    def run_in_background(self, work: Awaitable[object]) -> None:
        """Start work that no request waits for; it ends before the server does."""
        task = asyncio.ensure_future(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _save(
        self, run: Run, check: Callable[[Quota], None] | None = None
    ) -> bool:
        scored, checks = new_results(run), () if check is None else (check,)
        try:
            with timed(COUNTERS.database_writes), span("store run"):
                await self._store.save(run, *checks)
        except Refused as refused:  # by the check
            self._not_opened[run] = refused
            self.usage.note_open(run.account, run.run_id, is_open=False)
            self._evict(run)
            return False
        except OwnershipLost as error:
            COUNTERS.fenced_writes += 1
            self._failures.report("a run was stored by another node", str(error))
            self._drop(run)
            return False
        except Exception as error:  # whatever it was: memory is ahead of the disk now
            if isinstance(error, StoreFailed):
                self._failures.report("a run could not be stored", str(error))
            else:
                log.exception("run %s could not be stored", run.run_id)
            self._evict(run)
            return False
        else:
            self._life.log_stored(run, scored)
            return True
        finally:
            if self._saving.get(run.run_id) is asyncio.current_task():
                del self._saving[run.run_id]
            self.notify(run)
            self._announce_queue()

    async def _load(self, run_id: str) -> Run | None:
        """The run from the store, read once for all concurrent requests."""
        loading = self._loading.get(run_id)
        if loading is None:
            loading = asyncio.ensure_future(self._load_once(run_id))
            self._loading[run_id] = loading
        return await asyncio.shield(loading)

    async def _load_once(self, run_id: str) -> Run | None:
        try:
            loaded = await self._store.load(run_id)
            if loaded is not None and self.is_elsewhere(loaded):
                loaded = await self._claim(run_id)
            return self._adopt(loaded)
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

    def _adopt(self, loaded: Run | None) -> Run | None:
        """A run just loaded was not in memory, so no session of it is live."""
        if loaded is not None:
            self._life.note_loaded(loaded)
            loaded.ended.update(self.ended_sessions.of(loaded.run_id))
            effects.lose_sessions(loaded)
            loaded.queue_until_wall = queue_until(
                loaded.submission, loaded.queue_until_wall, steady_clock.now_wall()
            )
            self._in_memory[loaded.run_id] = loaded
            self._elsewhere.note_here(loaded.run_id)
            has_place = loaded.run_id in self._admission.places
            if not (has_place and self._apply_admission(loaded)):
                self._index_by_state(loaded, loaded.state)
            self._admission.admit()
        return loaded

    def _cache(self, run: Run) -> None:
        """Keep a run that is used; one that waits is not, however many there are."""
        self._in_memory[run.run_id] = run
        if run.state not in WAITING_STATES:
            self._recent.keep(run)

    def _evict(self, run: Run) -> None:
        """Drop the run from memory: from now on it is what the store has."""
        if run.lost:
            return
        places = self._admission.places
        had_place = run.run_id in places
        self._forget(run)
        # Until it is known what the store has, the run may be active and keeps a place.
        if had_place:
            places.play(run.run_id, run.account)
        self._on_run_lost(run)
        self._reload_later(run.run_id)

    def drop_all(self) -> None:
        """This node lost its runs: others may have claimed them."""
        for run in list(self._in_memory.values()):
            self._drop(run)
        self._admission.forget_all()
        self.usage.forget_open()
        self._elsewhere.forget_offers()
        self._changes.wake_all(is_elsewhere=True)

    def _drop(self, run: Run, *, is_complete: bool = False) -> None:
        """Another node acts for the run: this one forgets it, and ends its sessions."""
        if not run.lost:
            self._elsewhere.note_lost(run, is_complete=is_complete)
            self._changes.wake(run.run_id, is_elsewhere=True)
            self.usage.note_open(run.account, run.run_id, is_open=False)
            self._forget(run)
            self._on_run_lost(run)

    def _forget(self, run: Run) -> None:
        """Drop it from memory; a view of it that was not shown yet is taken again."""
        run.lost = True
        self._in_memory.pop(run.run_id, None)
        self._recent.drop(run.run_id)
        self._index_by_state(run, None)

    def _reload_later(self, run_id: str) -> None:
        """Load it again: a queued run is admitted without a request for it."""
        # A request may have loaded it meanwhile, and its next write have failed, too.
        if not self._closed and run_id not in self._reload_timers:
            loop = asyncio.get_running_loop()
            # Nothing that a timer does belongs to the request that set it.
            timer = loop.call_later(
                RELOAD_S, self._reload, run_id, context=contextvars.Context()
            )
            self._reload_timers[run_id] = timer

    def _reload(self, run_id: str) -> None:
        del self._reload_timers[run_id]
        self.load_in_background(run_id)

    def load_in_background(self, run_id: str) -> None:
        """Load a run without a request for it, as soon as the store has it."""
        if not self._closed:
            self.run_in_background(self._retry_load(run_id))

    async def _retry_load(self, run_id: str) -> None:
        try:
            await self.get(run_id)
        except Refused:
            log.debug("run %s was deleted", run_id)
        except StoreFailed as error:
            self._failures.report("a run could not be loaded", str(error))
            self._reload_later(run_id)


def _changed_at(before_wall: float, now_wall: float) -> float:
    """When a run changed that had changed before: later, whatever the clock says.

    RUN-021: a clock that is set back does not set the run back. What was stored since
    its submission is known by that, too: another node takes a run from the queue only
    while its times are equal (`node_store.py`).
    """
    return max(math.nextafter(before_wall, math.inf), now_wall)


def _no_run(run_id: str) -> Refused:
    return Refused("not_found", f"There is no run {run_id}.")
