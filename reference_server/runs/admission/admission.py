"""When runs are let in: a place is free, a hold in the queue ends, or time is up.

It holds places and the queue, and looks at them again whenever that may change
something. Who is next is decided in `rules/capacity.py`; what being let in does to a
run is its caller's.
"""

from __future__ import annotations

import asyncio
import contextvars
import time
from collections.abc import Callable

from reference_server.rules.capacity import WaitingRun
from reference_server.rules.runs.lifecycle import (
    PLAYABLE_STATES,
    STATES_AFTER_RESTART,
    WAITING_STATES,
)
from reference_server.rules.runs.run import Run, State
from reference_server.runs import steady_clock
from reference_server.runs.admission.places import Places
from reference_server.runs.admission.run_queue import RunQueue


class Admission:
    """The places and the queue of one server.

    let_in: is called with the id of each run that got a place, and with the run itself
    if it is not stored yet. on_moved: is called with a number in the queue, when those
    behind it have moved.
    """

    def __init__(
        self,
        places: Places,
        let_in: Callable[[str, Run | None], None],
        on_moved: Callable[[int], None],
    ) -> None:
        self.places, self.queue = places, RunQueue()
        self._let_in, self._on_moved = let_in, on_moved
        self._look: Callable[[], None] | None = None
        self._timer: asyncio.Handle | None = None  # None as soon as it has fired
        self._timer_at = 0.0  # by the clock of the loop
        self._closed = False

    def look_elsewhere(self, look: Callable[[], None]) -> None:
        """Take into account from now on that runs wait at other nodes, too.

        look: asks for a look at these, which ends in `admit`.
        """
        self._look = look

    def close(self) -> None:
        """Let no more runs in."""
        self._closed = True
        if self._timer is not None:
            self._timer.cancel()

    def forget_all(self) -> None:
        """Other servers have the runs now."""
        for run_id in self.places.run_ids():
            self.places.leave(run_id)
        self.queue.clear()

    def index(self, run: Run, state: State | None) -> None:
        """With a place, in the queue, or nowhere, as the state says; None: unknown."""
        if state in STATES_AFTER_RESTART:
            self.places.stop_waiting(run.run_id)
            self.places.play(run.run_id, run.account)
        elif state in PLAYABLE_STATES:
            self.places.rest(run.run_id, time.monotonic())
        else:
            self.places.leave(run.run_id)
        self.note_queued(WaitingRun.of(run), is_queued=state in WAITING_STATES)

    def note_queued(self, run: WaitingRun, *, is_queued: bool) -> None:
        """In the queue or not; those behind it have moved (RUN-008)."""
        if is_queued:
            self.places.wait(run)
        if is_queued == (run.run_id in self.queue):
            return
        if is_queued:
            self.queue.put(run)
        else:
            self.queue.remove(run.run_id)
        self._on_moved(run.number)

    def give_back(self, run_id: str) -> None:
        """The run does not use its place: the next one may."""
        self.places.leave(run_id)
        self.admit()

    def held_no_more(self) -> list[str]:
        """Ids of runs that their submitters held in the queue, and that wait now."""
        now_wall = steady_clock.now_wall()
        return [
            run.run_id
            for run in self.places.waiting_here()
            if 0 < run.queue_until_wall <= now_wall and run.run_id in self.queue
        ]

    def admit(self, new: Run | None = None, *, knows_all: bool = False) -> None:
        """Let runs in while there is capacity.

        new: one that is not stored yet; its place is taken, and storing it is left to
        the caller. knows_all: what waits at other nodes was just noted, or need not be.
        """
        if self._closed:
            return
        now, now_wall = time.monotonic(), steady_clock.now_wall()
        is_new = new is not None and new.state in WAITING_STATES
        unstored = WaitingRun.of(new) if new is not None and is_new else None
        if not self.places.can_change(now, unstored):
            pass
        elif self._look is not None and not (is_new or knows_all):
            self._look()
        else:
            for waiting in self.places.share(now, now_wall, unstored):
                self._let_in(waiting.run_id, new if waiting is unstored else None)
            self._admit_in(self.places.next_due(now_wall))
        self._admit_in(self.places.next_look(now))
        self._admit_in(self.places.next_overdue(now))

    def _admit_in(self, wait_s: float | None) -> None:
        """Admit again then: when a hold in the queue ends, or a place is unused."""
        if wait_s is None:
            return
        loop = asyncio.get_running_loop()
        at = loop.time() + max(0.001, wait_s)
        if self._timer is not None:
            # One whose time has passed fires in a moment: it must not be put off.
            if self._timer_at <= at:
                return
            self._timer.cancel()
        self._timer_at = at
        # Nothing that a timer does belongs to the request that set it.
        self._timer = loop.call_at(
            at, self._admit_in_time, context=contextvars.Context()
        )

    def _admit_in_time(self) -> None:
        # A timer may fire before its `when`, by the resolution of the loop's clock: so
        # a timer that has fired must not be taken for one that will.
        self._timer = None
        self.admit()
