"""Runs are let in: what a place means for a run, here and at the other nodes.

`Admission` says when a run has a place. A run in memory is changed then and stored; one
that is not is loaded for that, one after another, however long the queue is; one that
waits at another node is taken from there first. In a cluster this is also how the
shared queue and this node's runs hear of each other.

Who is next is decided in `rules/capacity.py`.
"""

from __future__ import annotations

import logging
import time
from collections import deque
from collections.abc import Mapping, Sequence

from reference_server.process.background_work import BackgroundWork
from reference_server.rules.capacity import WaitingRun
from reference_server.rules.manifest import Submission
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import OwnedElsewhere
from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import WAITING_STATES
from reference_server.rules.runs.run import Episode, Run, RunHead, State
from reference_server.rules.submission import queue_s
from reference_server.runs import steady_clock
from reference_server.runs.admission.account_usage import AccountUsage
from reference_server.runs.admission.admission import Admission
from reference_server.runs.admission.places import Places
from reference_server.runs.memory.remote_runs import (
    OfferedRuns,
    OtherQueues,
    Ownership,
    has_newer_owner,
)
from reference_server.runs.memory.run_cache import RunCache
from reference_server.runs.memory.run_changes import RunChanges
from reference_server.runs.memory.run_events import Departure, RunFollower
from reference_server.runs.run_log import RunLog
from reference_server.runs.run_writer import RunWriter
from reference_server.storage.node_store import OwnedRun, StoredQueue
from reference_server.storage.runs.run_store import StoreFailed

log = logging.getLogger("proctor.runs")


class RunAdmission(RunFollower):
    """Lets the runs of one server in, as they change and as time passes.

    ownership: None for a server that has the database for itself.
    """

    def __init__(
        self,
        places: Places,
        cache: RunCache,
        writer: RunWriter,
        *,
        work: BackgroundWork,
        usage: AccountUsage,
        changes: RunChanges,
        run_log: RunLog,
        ownership: Ownership | None,
    ) -> None:
        self._admission = Admission(places, self._let_in, self._note_moved)
        self._cache, self._writer, self._work = cache, writer, work
        self._usage, self._changes, self._log = usage, changes, run_log
        self._ownership = ownership
        self._other_queues: OtherQueues | None = None
        self._offered = OfferedRuns()
        self._admitted: deque[str] = deque()  # ids of what is to be loaded for that

    def close(self) -> None:
        """Let no more runs in."""
        self._admission.close()

    @property
    def places(self) -> Places:
        return self._admission.places

    # --- runs as they change ---

    def loaded(self, run: Run, stored: State) -> None:
        self._offered.note_here(run.run_id)
        if run.run_id in self.places:
            self._apply(run)
        self._follow(run)

    def changed(self, run: Run) -> None:
        self._follow(run)

    def stored(self, run: Run, scored: Sequence[Episode]) -> None:
        super().stored(run, scored)
        self._announce()

    def left(self, run: Run, why: Departure) -> None:
        had_place = run.run_id in self.places
        self._admission.index(run, None)
        # The run keeps its place until it is loaded: it may be active in the database.
        if had_place and why in ("unstored", "refused"):
            self.places.play(run.run_id, run.account)
        self._admission.admit()
        if why != "moved":  # the node that has the run now announces it
            self._announce()

    def _follow(self, run: Run) -> None:
        self._admission.index(run, run.state)
        self._admission.admit()

    # --- a run that is submitted, or that a worker wants to play ---

    def admit_new(self, run: Run) -> None:
        """Admit a new run before it is stored, so that a submit is one transaction."""
        self._admission.admit(run)

    def give_back(self, run_id: str) -> None:
        """The run does not use its place: the next one may."""
        self._admission.give_back(run_id)

    def take_place(self, run: Run) -> None:
        """A worker attaches: the run has a place, or is refused and waits for one.

        A waiting run gets the next place when its turn comes, so that a repeated attach
        finds it. LIM-004: other runs give back the places that they do not use.
        """
        if run.run_id in self.places:
            return
        self.places.wait(WaitingRun(run.run_id, run.number, run.account, 0.0))
        self._admission.admit(knows_all=True)  # the answer waits for no look elsewhere
        if run.run_id not in self.places:
            raise Refused("no_capacity", "As many runs are played as may be at once.")

    def note_played(self, runs: Sequence[WaitingRun]) -> None:
        """They were played when the server ended: they have places, not in use yet."""
        now = time.monotonic()
        for run in runs:
            self.places.play(run.run_id, run.account)
            self.places.rest(run.run_id, now)

    def note_queued(self, run: WaitingRun) -> None:
        """It waits in the database, and need not be in memory for that."""
        self._admission.note_queued(run, is_queued=True)

    def admit(self) -> None:
        """Let runs in while there is capacity."""
        self._admission.admit()

    # --- the queue ---

    def has_queued(self, run_id: str) -> bool:
        """Whether the run waits in the queue of this server."""
        return run_id in self._admission.queue

    def queue_position(self, run: RunHead) -> int | None:
        """RUN-008: 1 is next; None unless queued."""
        if run.state not in WAITING_STATES:
            return None
        return self._admission.queue.position(run.number)

    def queue_until(self, submission: Submission) -> float:
        """The time until which a run submitted or resumed now is held in the queue.

        0 in a cluster if it is not held: any node may take it then, whatever its clock.
        """
        held_s = queue_s(submission)
        if self._other_queues is not None and held_s <= 0:
            return 0.0
        return steady_clock.now_wall() + held_s

    def count_queued(self) -> int:
        return len(self._admission.queue)

    def oldest_queued_s(self) -> float:
        """How long the first of the queue has waited; 0 without one."""
        queued_at_wall = self._admission.queue.oldest_queued_at_wall()
        return 0.0 if queued_at_wall is None else max(0.0, time.time() - queued_at_wall)

    def _note_moved(self, number: int) -> None:
        """A run came into the queue here, or left it."""
        self._offered.note_queue_change()
        self._wake_behind(number)

    def _wake_behind(self, number: int) -> None:
        """Runs that wait behind that number have another place in the queue."""
        # Rarely as many wait for a change as there are in the queue.
        for run_id in self._changes.run_ids():
            if self._admission.queue.is_behind(run_id, number):
                self._changes.wake(run_id)

    # --- a run that got a place ---

    def _let_in(self, run_id: str, new: Run | None) -> None:
        """A run got a place; one that is not in memory is loaded for that."""
        if new is not None:
            effects.admit(new, steady_clock.now_wall())
        elif (run := self._cache.find(run_id)) is not None:
            self._apply(run)
            self._admission.index(run, run.state)
        else:
            self._offered.want(run_id)
            self._admitted.append(run_id)
            if len(self._admitted) == 1:
                self._work.start(self._load_admitted())

    def _apply(self, run: Run) -> None:
        """The run was queued; or it was ready, and a worker attaches."""
        if effects.admit(run, steady_clock.now_wall()):
            self._writer.commit_later(run)

    async def _load_admitted(self) -> None:
        """One after another: each is stored and out of memory before the next."""
        while self._admitted and not self._work.is_closed:
            run_id = self._admitted[0]
            try:
                is_from_elsewhere = self._offered.begin_to_take(run_id)
                if is_from_elsewhere and not await self._take(run_id):
                    continue
                run = await self._cache.load(run_id)
                if run is not None and is_from_elsewhere:
                    self._log.log_taken(run)
                if run is not None:
                    await self._writer.is_stored(run)
            except OwnedElsewhere:  # another node that has room came first
                self.give_back(run_id)
            except StoreFailed as error:
                self._writer.report_unread(run_id, error)
            except Exception:  # its row is damaged: those behind it are admitted
                log.exception("run %s cannot be read", run_id)
                self.give_back(run_id)
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
                self.give_back(run_id)
        if is_taken:
            self._offered.note_queue_change()
        self._announce()
        return is_taken

    # --- the queues of other nodes ---

    def share_queue(self, other_queues: OtherQueues) -> None:
        """Let the runs of this server wait in a queue of several nodes from now on."""
        self._other_queues = other_queues
        self._admission.look_elsewhere(other_queues.look)

    def queued_ids(self) -> list[str]:
        """Ids of the runs of this server that wait."""
        return self._admission.queue.ids()

    def held_no_more(self) -> list[str]:
        """Ids of runs that their submitters held in the queue, and that wait now."""
        return self._admission.held_no_more()

    def places_of_accounts(self) -> dict[str, int]:
        """How many places each account has here."""
        return self.places.counts()

    async def refresh_before(self, run_id: str) -> None:
        """RUN-008: what waits before a run may wait at another node."""
        if self._other_queues is None or not self.has_queued(run_id):
            return
        if self.places.is_due(run_id, steady_clock.now_wall()):
            await self._other_queues.refresh()

    async def refresh(self) -> None:
        """Know what waits at other nodes, if anything waits here."""
        if self._other_queues is not None and self._admission.queue:
            await self._other_queues.refresh()

    def note_queue(self, stored: StoredQueue) -> None:
        """Take in the queue of all nodes, and the runs of `queued_ids` that left it."""
        assert self._ownership is not None, "without it there is no other node"
        me, queue, elsewhere = self._ownership.node_id, self._admission.queue, []
        for owned in (*stored.queued, *stored.left):
            if owned.owner != me:
                self._forget_taken(owned)
        for owned in stored.queued:
            if owned.owner != me:
                elsewhere.append(owned.run.number)
            elif owned.run.run_id not in queue and not self._knows(owned.run.run_id):
                self._writer.load_in_background(owned.run.run_id)
        changed = queue.note_elsewhere(elsewhere)
        if changed is not None:
            self._wake_behind(changed)

    def note_waiting_elsewhere(
        self, waiting: Sequence[WaitingRun], places: Mapping[str, int]
    ) -> None:
        """Take in the runs that other nodes offer, and the places of accounts there.

        The free places then go to the first of these runs and of those that wait here.
        """
        waiting = [run for run in waiting if not self._knows(run.run_id)]
        self._offered.offer(run.run_id for run in waiting)
        self.places.note_elsewhere(waiting, places)
        self._admission.admit(knows_all=True)

    def adopt(self, run_id: str) -> None:
        """This node has claimed an open run: it is loaded without a request for it."""
        self._writer.load_in_background(run_id)

    def drop_all(self) -> None:
        """This node lost its runs: others may have claimed them."""
        self._admission.forget_all()  # first: no place that is given back is used
        for run in self._cache:
            self._writer.drop_moved(run)
        self._usage.forget_open()
        self._offered.forget_offers()
        self._changes.wake_all(is_elsewhere=True)

    def _knows(self, run_id: str) -> bool:
        """Whether the run is here, or on its way."""
        cache = self._cache
        is_here = run_id in cache or cache.is_loading(run_id)
        return is_here or run_id in self._admitted or self._writer.is_reloading(run_id)

    def _forget_taken(self, taken: OwnedRun) -> None:
        """A run of another node, which may have been one of this."""
        run_id = taken.run.run_id
        run = self._cache.find(run_id)
        if run is not None:
            if has_newer_owner(run, taken):
                self._writer.drop_moved(run, is_complete=True)
        elif self.has_queued(run_id):
            self._changes.wake(run_id, is_elsewhere=True)
            self._usage.note_open(taken.run.account, run_id, is_open=False)
            self.places.leave(run_id)
            self._admission.note_queued(taken.run, is_queued=False)

    def _announce(self) -> None:
        """Once what has changed in the queue is stored."""
        if self._other_queues is not None and self._offered.begin_to_announce():
            self._other_queues.announce()
