"""Callers that wait for a simulator with some resources, and the requests for them.

Each set of resources that benchmarks declare has a queue of its own, so that one which
cannot be met delays no other. A request that the cluster has no room for stays open,
because Ray's autoscaler reads it. A caller waits for a while, then is refused; the
simulator that is placed afterwards serves the next caller. The pool knows which
simulators are free.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
from collections import deque
from collections.abc import Awaitable, Callable

from reference_sim.process.ray.actor_process import CannotUseRay
from reference_sim.process.ray.launcher_messages import Room
from reference_sim.process.simulator_process import (
    ResourceShortage,
    SimulatorFault,
    SimulatorProcess,
)
from reference_sim.ray_resources import format_resources

PLACE_IN_FULL_CLUSTER_S = 1.0
# How long a caller waits while the cluster has room and starts slowly. It is less than
# the 30 s that clients wait for an answer.
START_S_MAX = 25.0
REQUEST_S = 120.0  # how long a request outlives the last caller that waited for it
SILENT = "the Ray cluster does not answer: its head is lost, or busy"
START_TRIES, START_AGAIN_S = 4, 1.0
_log = logging.getLogger(__name__)


class PlacementQueue:
    """Callers in a row: each gets whichever simulator is free or placed first.

    resources: of one simulator, by Ray's names. place_s: how long a caller waits while
    the cluster places none. missing_spares: how many to request without a caller.
    start: one attempt to start one on the cluster. find_room: what the cluster has for
    these resources. keep: is called with a simulator that no caller waits for.

    is_full: the cluster had no room for the last caller. lacking: why it never will
    have, as its machines are; empty if it may have, or if that is not known. is_known:
    whether the cluster said so.
    """

    def __init__(
        self,
        resources: dict[str, float],
        place_s: float,
        *,
        missing_spares: Callable[[], int],
        start: Callable[[PlacementQueue], Awaitable[SimulatorProcess]],
        find_room: Callable[[dict[str, float]], Awaitable[Room]],
        keep: Callable[[SimulatorProcess], None],
    ) -> None:
        self.resources = resources
        self.is_full = False
        self.lacking: dict[str, float] = {}
        self.is_known = True
        self._place_s, self._missing_spares = place_s, missing_spares
        self._start, self._find_room, self._keep = start, find_room, keep
        self._waiting: deque[asyncio.Future[SimulatorProcess]] = deque()
        self._starting: dict[asyncio.Task[None], None] = {}  # oldest first
        self._waited_at = self._placed_at = 0.0
        self._closed = False

    @property
    def waiting(self) -> int:
        return len(self._waiting)

    @property
    def needs_room(self) -> bool:
        """Whether a request stays that other simulators may have to make room for."""
        return self.is_full and not self.lacking and bool(self._starting)

    async def close(self) -> None:
        """Callers that wait raise SimulatorFault; every request has then ended."""
        self._closed = True
        for task in list(self._starting):
            task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await task
        while self._waiting:
            closed = SimulatorFault("the pool of simulators is closed")
            self._waiting.popleft().set_exception(closed)

    async def wait(self) -> SimulatorProcess:
        """Raises ResourceShortage if the cluster has no room for too long."""
        loop = asyncio.get_running_loop()
        mine: asyncio.Future[SimulatorProcess] = loop.create_future()
        self._waiting.append(mine)
        self.request_missing()
        try:
            return await self._wait_for(mine)
        except BaseException:
            self._withdraw(mine)
            raise
        finally:
            self._waited_at = loop.time()

    async def _wait_for(
        self, mine: asyncio.Future[SimulatorProcess]
    ) -> SimulatorProcess:
        loop = asyncio.get_running_loop()
        wait_s, waited_from = self._place_s, loop.time()
        start_until = waited_from + START_S_MAX
        if self.is_full:
            wait_s = min(wait_s, PLACE_IN_FULL_CLUSTER_S)
        while not mine.done():
            # Many at once start slowly: as long as one after the other is placed, the
            # cluster has room.
            left_s = max(waited_from, self._placed_at) + wait_s - loop.time()
            if left_s > 0:
                await asyncio.wait([mine], timeout=left_s)
                continue
            starts_slowly = await self._note_full()
            if mine.done():
                break
            if not starts_slowly or loop.time() > start_until:
                raise ResourceShortage(self._why_full())
            waited_from, wait_s = loop.time(), PLACE_IN_FULL_CLUSTER_S
        return mine.result()

    async def _note_full(self) -> bool:
        """Whether there is room all the same: then the requested simulator is starting.

        Its resources are in use from then on, though it is ready only seconds later. So
        a cluster that has more resources free is slow, and not full.
        """
        if self.is_full and self.is_known and not self.lacking:
            return False  # some machine has what it takes, as was found before
        placed_at = self._placed_at
        room = await self._find_room(self.resources)
        if self._placed_at == placed_at:  # none was placed meanwhile
            self.is_full, self.lacking = not room.is_free, room.lacking
            self.is_known = room.is_known
        return not self.is_full

    def _why_full(self) -> str:
        if self.lacking:
            lacking = format_resources(self.lacking)
            return f"no machine of the Ray cluster has {lacking} for a simulator"
        if not self.is_known:
            return SILENT
        needed = format_resources(self.resources)
        return f"the Ray cluster has no room now for another simulator with {needed}"

    def _withdraw(self, mine: asyncio.Future[SimulatorProcess]) -> None:
        """Give a simulator that this caller got in the last moment to the next one."""
        if mine in self._waiting:
            self._waiting.remove(mine)
        elif mine.exception() is None:
            self.hand_out(mine.result())

    def hand_out(self, process: SimulatorProcess) -> None:
        """Give it to the caller that has waited longest; without one, to `keep`."""
        while self._waiting:
            first = self._waiting.popleft()
            if not first.done():
                first.set_result(process)
                return
        self._keep(process)

    def note_room(self) -> None:
        """A simulator has ended: what it took is free, unless its machine is gone."""
        self.is_full = bool(self.lacking)

    # Requests

    def request_missing(self) -> None:
        """Make a request for each caller that waits and each spare that is missing."""
        wanted = len(self._waiting) + self._missing_spares()
        while len(self._starting) < wanted and not self._closed:
            task = asyncio.create_task(self._place())
            self._starting[task] = None
            task.add_done_callback(self._count_out)

    def drop_requests(self, now: float) -> None:
        """End the requests that no caller has waited for since long."""
        if self._waiting or now - self._waited_at <= REQUEST_S:
            return
        for task in list(self._starting)[self._missing_spares() :]:
            task.cancel()

    def _count_out(self, task: asyncio.Task[None] | None) -> None:
        if task is not None:
            self._starting.pop(task, None)

    async def _place(self) -> None:
        """Start one simulator, for the caller that has waited longest."""
        try:
            process = await self._start_somewhere()
        except SimulatorFault as fault:
            # Before the caller runs, which may ask for another one at once.
            self._count_out(asyncio.current_task())
            _log.warning("no simulator on the Ray cluster: %s", fault)
            if self._waiting:
                self._waiting.popleft().set_exception(fault)
            return
        self._count_out(asyncio.current_task())
        self.is_full, self.lacking = False, {}
        self._placed_at = asyncio.get_running_loop().time()
        self.hand_out(process)

    async def _start_somewhere(self) -> SimulatorProcess:
        """Start a simulator; try again if a machine fails or is not fit to simulate."""
        for _ in range(START_TRIES - 1):
            try:
                return await self._start(self)
            except CannotUseRay:
                raise
            except ResourceShortage as shortage:
                _log.warning("a simulator is started elsewhere: %s", shortage)
                await asyncio.sleep(START_AGAIN_S)
        return await self._start(self)
