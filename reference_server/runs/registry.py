"""All runs of this server, for those who act on them: one face of four parts.

`memory/run_cache.py` has those in memory, `run_writer.py` stores them, `run_reader.py`
shows them, and `admission/` says which may be played. Changes are published to the
parts that follow runs (`memory/run_events.py`). This module does the work that needs
several of them at once: a new run, a resumed one, the start and the end of the server.

It decides no rule, and knows no HTTP and no SQL. In a cluster it has the runs of its
node alone; of others it shows what is stored.
"""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Coroutine
from functools import partial
from typing import Any

from reference_server.process.background_work import BackgroundWork
from reference_server.rules.capacity import Quota
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.rules.runs.lifecycle import (
    ACTIVE_STATES,
    ENDED_STATES,
    RESTART_REASON,
    STATES_AFTER_RESTART,
    WAITING_STATES,
)
from reference_server.rules.runs.run import Run
from reference_server.rules.submission import KeyUse, key_conflict
from reference_server.runs import steady_clock
from reference_server.runs.admission.account_usage import AccountUsage
from reference_server.runs.admission.disk_bound import DiskBound
from reference_server.runs.admission.places import Places
from reference_server.runs.admission.run_admission import RunAdmission
from reference_server.runs.memory.ended_sessions import EndedSessions
from reference_server.runs.memory.remote_runs import Ownership
from reference_server.runs.memory.run_cache import RunCache
from reference_server.runs.memory.run_changes import RunChange, RunChanges
from reference_server.runs.memory.run_events import RunEvents, RunFollower
from reference_server.runs.run_log import RunLog
from reference_server.runs.run_reader import RunReader
from reference_server.runs.run_writer import QuotaCheck, RunWriter
from reference_server.storage.runs.run_store import Store

# Read at once of the runs that may be played after a restart.
HEADS_PER_READ = 200


class RunRegistry:
    """All runs of this server, by id.

    active_max: places of runs that are played or about to be. unused_s: when others
    wait, how long a run without a worker keeps its place. quota: of each account.
    ownership: None for a server that has the database for itself. disk_bound: of all
    accounts together; None for no bound.
    """

    def __init__(
        self,
        store: Store,
        active_max: int,
        *,
        unused_s: float = 10.0,
        quota: Quota | None = None,
        ownership: Ownership | None = None,
        disk_bound: DiskBound | None = None,
    ) -> None:
        self._store, self._ownership = store, ownership
        self.usage = AccountUsage(quota or Quota(), disk_bound)
        self.ended_sessions, self.work = EndedSessions(), BackgroundWork()
        self._log, self._changes = RunLog(), RunChanges()
        self._events = RunEvents(
            self._log, self.usage, self._changes, self.ended_sessions
        )
        self.cache = RunCache(store, self._events, self.ended_sessions, ownership)
        self.writer = RunWriter(store, self.cache, self._events, self.work)
        self.admission = RunAdmission(
            Places(active_max, unused_s),
            self.cache,
            self.writer,
            work=self.work,
            usage=self.usage,
            changes=self._changes,
            run_log=self._log,
            ownership=ownership,
        )
        self._events.subscribe(self.admission)
        self.reader = RunReader(store, self.cache, self.writer, self.admission)
        self._ending = False

    def subscribe(self, follower: RunFollower) -> None:
        """Inform a part of the server of every change of a run from now on."""
        self._events.subscribe(follower)

    # --- the start and the end of the server ---

    async def open(self) -> None:
        """Apply what a restart does, then admit what waits for capacity.

        A run that was being played keeps a place, because its workers come back; a run
        that was only ready gets one when a worker attaches. No run is loaded for that.
        In a cluster a node does this for each run that it claims, when it is loaded.
        """
        if self._ownership is not None:
            return
        played = await self._store.waiting_runs(*STATES_AFTER_RESTART)
        self.admission.note_played(played)
        await self._store.replace_states(STATES_AFTER_RESTART, RESTART_REASON)
        self.usage.load_stored(*await self._store.sizes_of_accounts())
        for run in await self._store.waiting_runs(*ACTIVE_STATES):
            self.usage.note_open(run.account, run.run_id, is_open=True)
        for run in await self._store.waiting_runs(*WAITING_STATES):
            self.usage.note_open(run.account, run.run_id, is_open=True)
            if run.queue_until_wall <= steady_clock.now_wall():
                self.admission.note_queued(run)
            else:  # seldom, and for seconds: loading checks it by what was asked for
                await self.get(run.run_id)
        self.admission.admit()

    def begin_ending(self) -> None:
        """The server will shut down: end every wait for a change, begin nothing new."""
        self._ending = True
        self._changes.wake_all()

    @property
    def is_ending(self) -> bool:
        return self._ending

    def refuse_if_ending(self) -> None:
        """Refuse what would begin now; what has begun is finished."""
        if self._ending:
            raise Refused("unavailable", "The server is shutting down.")

    async def close(self) -> None:
        """Wait until every write that was begun has ended; no other begins."""
        self.work.is_closed = True
        self.admission.close()
        self.writer.close()
        await self.work.wait()

    def get(self, run_id: str, account: str | None = None) -> Coroutine[Any, Any, Run]:
        """The run in memory, if the account may see it (AUTH-003, RUN-010)."""
        # Each turn comes here: a coroutine around the reader's would only cost time.
        return self.reader.get(run_id, account)

    # --- a new run ---

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
        self.usage.note_submitted(run, key)
        # A request that finds it in the store, even before this one, finds this object.
        self.cache.add(run)
        self.admission.admit_new(run)
        stored = self._store_new(run, key, body_sha256, check)
        if await self.work.run_to_end(stored):
            return run
        assert key is not None
        return await self._find_repeated(run.account, key, body_sha256)

    async def _store_new(
        self, run: Run, key: str | None, body_sha256: str, check: QuotaCheck | None
    ) -> bool:
        """Whether a run that memory counts was stored; if not, it counts no more."""
        is_stored = False
        try:
            is_stored = await self.writer.insert(run, key, body_sha256, check)
        finally:
            if not is_stored:
                self.cache.remove(run)
                self.usage.note_not_stored(run, key)
                self.admission.give_back(run.run_id)
        if is_stored:
            self._log.log_submitted(run)
            if self.writer.is_complete(run):  # another node had room for it
                return True
            if run.lost:  # `drop_all` meanwhile: the node that claims it plays it
                text = "The node lost its lease. Repeat with the same Idempotency-Key."
                raise Refused("unavailable", text)
            self.cache.keep(run)
            self._events.stored(run, ())
        return is_stored

    async def _find_repeated(self, account: str, key: str, body_sha256: str) -> Run:
        """The run that a used key has made, if it was of the same body."""
        use = await self.find_by_key(account, key)
        assert use is not None, "an insert is refused only for a used key"
        conflict = key_conflict(use, body_sha256)
        if conflict is not None:
            raise Refused.from_verdict(conflict)
        try:
            return await self.get(use.run_id)
        except OwnedElsewhere:
            return await self.reader.read_stored(use.run_id)
        except Refused as refused:
            raise Refused(
                "not_found",
                "The run of this Idempotency-Key was deleted; use a new key.",
                requirement="DEL-005",
            ) from refused

    async def find_by_key(self, account: str, key: str) -> KeyUse | None:
        """The run that an Idempotency-Key of the account made, if any (RUN-026)."""
        use = await self._store.find_key(account, key)
        return None if use is None else KeyUse(*use)

    async def _check_quota(self, account: str, key: str | None) -> None:
        """A key that is used makes no run (RUN-003)."""
        try:
            self.usage.check_new(account, has_key=key is not None)
        except Refused:
            if key is None or await self.find_by_key(account, key) is None:
                raise

    # --- a resumed run ---

    async def check_open_elsewhere(self, account: str) -> None:
        """LIM-007: refuse before anything has changed, if the limit is already reached.

        A run that opens at the same moment is counted by the transaction that follows
        (`commit_opened`).
        """
        if self._ownership is not None:
            self.usage.check_opened(await self._store.usage_of(account))

    def open_again(self, run: Run) -> None:
        """LIM-007: a resume makes a run count at once, or is refused."""
        self.refuse_if_ending()
        self.usage.check_open(run.account)
        self.usage.note_open(run.account, run.run_id, is_open=True)

    async def commit_opened(self, run: Run) -> None:
        """Store a run that counts as open again, or refuse that.

        LIM-007: in a cluster, by what the account has open on every node, in the
        transaction that stores the run.
        """
        is_shared = self._ownership is not None
        await self.writer.commit(run, self.usage.check_opened if is_shared else None)

    # --- waiting for a change ---

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
        """Something that get_run shows has changed, in memory alone."""
        if run.lost:
            self._changes.wake(run.run_id)
        else:
            self._events.changed(run)

    # --- numbers and lists ---

    async def ended_since(
        self, before_wall: float, after: int
    ) -> list[tuple[int, str]]:
        """(number, id) of the next runs behind a number that ended before that time."""
        states = sorted(ENDED_STATES)
        return await self._store.in_states_since(
            states, before_wall, after, HEADS_PER_READ
        )

    async def newest_change(self) -> float | None:
        """When the last change of any run was stored; None without runs."""
        return await self._store.newest_change()

    async def push_runs(self) -> list[str]:
        """Ids of the push runs that may be played; none is loaded for that."""
        push_ids: list[str] = []
        if self._ownership is not None:  # each is found when a node claims it
            return push_ids
        ids = await self._store.in_states(*ACTIVE_STATES)
        for start in range(0, len(ids), HEADS_PER_READ):
            heads = await self._store.heads(ids[start : start + HEADS_PER_READ])
            push_ids += [run_id for run_id, head in heads.items() if head.is_push]
        return push_ids

    def count_open(self) -> dict[str, int]:
        """How many runs have not ended, by state."""
        played = Counter(run.state for run in self.cache)
        counts: dict[str, int] = {"queued": self.admission.count_queued()}
        # A run that has a live session is in memory.
        counts |= {"running": played["running"], "stopping": played["stopping"]}
        counts["ready"] = max(0, self.usage.count_open() - sum(counts.values()))
        return counts

    def has(self, run_id: str) -> bool:
        """Whether the run is in memory, and no other node may take it."""
        return run_id in self.cache and not self.admission.has_queued(run_id)
