"""A pool of simulators on a Ray cluster, with the interface of the local one.

A simulator is placed by the resources that its benchmark declares, and serves only
benchmarks that declare the same; placement_queue.py has those who wait. Idle
simulators are soon given back, because others may use the cluster, too.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Sequence

from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.process.pool import NoCapacity, SimulatorHandle, SimulatorPool
from reference_sim.process.ray.actor_process import (
    ActorProcess,
    CannotUseRay,
    LauncherClient,
)
from reference_sim.process.ray.launcher_messages import Connect
from reference_sim.process.ray.machine_check import make_check
from reference_sim.process.ray.placement_queue import SILENT, PlacementQueue
from reference_sim.process.simulator_process import (
    ResourceShortage,
    SimulatorFault,
    SimulatorProcess,
)
from reference_sim.ray_resources import parse_resources

PLACE_S = 15.0  # for a machine that starts a simulator slowly
IDLE_S = 10.0  # less than another server waits for room
IDLE_WHILE_NEEDED_S = 1.0  # while simulators with other resources need room


async def check_cluster(
    address: str, simulators: Sequence[dict[str, float]]
) -> list[int]:
    """How many machines could hold a simulator, for each of these resources.

    Every machine that could hold any was looked at. Raises CannotUseRay.
    """
    connect = Connect(address, make_check(), list(simulators))
    launcher = LauncherClient(connect)
    try:
        return await launcher.open()
    finally:
        await launcher.close()


class RayPool(SimulatorPool):
    """Lends at most `size_max` simulators, as far as the cluster has room.

    address: `ray`, or `ray://HOST:PORT` of Ray's own server for clients. resources: of
    one simulator of a benchmark that declares none; spares have these. place_s: how
    long a caller waits while the cluster places none.
    """

    records_here = True

    def __init__(
        self,
        address: str,
        resources: str,
        size_max: int = 64,
        spares: int = 0,
        turn_timeout_s: float = 60.0,
        *,
        place_s: float = PLACE_S,
        idle_s: float = IDLE_S,
    ) -> None:
        super().__init__(size_max, spares, turn_timeout_s)
        self._address = address
        self._place_s, self._idle_s = place_s, idle_s
        self._launcher: LauncherClient | None = None
        self._queues: list[PlacementQueue] = []  # the first one is the default
        self._placed_by: dict[SimulatorProcess, PlacementQueue] = {}
        self._idle_since: dict[SimulatorProcess, float] = {}
        self._tidying: asyncio.Task[None] | None = None
        self._joining: asyncio.Task[None] | None = None
        self._asking: asyncio.Task[None] | None = None
        self._is_silent = False
        self._add_queue(parse_resources(resources))

    async def start(self) -> None:
        """Join the cluster. Raises SimulatorFault."""
        connect = Connect(self._address, make_check())
        await self.start_with(LauncherClient(connect))

    async def start_with(self, launcher: LauncherClient) -> None:
        """Join the cluster by this launcher. Raises SimulatorFault."""
        self._launcher = launcher
        await launcher.open()
        self._tidying = asyncio.create_task(self._tidy())
        await super().start()

    async def close(self) -> None:
        self._closed = True
        for task in (self._tidying, self._joining, self._asking):
            if task is not None:
                task.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await task
        for queue in self._queues:
            await queue.close()
        await super().close()
        if self._launcher is not None:
            await self._launcher.close()

    async def check_start(self) -> None:
        """Raises SimulatorFault while there is no cluster, which is joined again.

        One whose head is lost is not seen to be for a minute. So it is asked for its
        room each time, and what it has answered before counts.
        """
        launcher = self._joined_launcher()
        if not launcher.is_open:
            self._is_silent = False
            if self._joining is None or self._joining.done():
                self._joining = asyncio.create_task(self._join_again(launcher))
            raise CannotUseRay("the Ray cluster cannot be reached")
        if not self._is_asking:
            self._asking = asyncio.create_task(self._ask(launcher))
        if self._is_silent:
            raise CannotUseRay(SILENT)

    @property
    def _is_asking(self) -> bool:
        return self._asking is not None and not self._asking.done()

    async def _ask(self, launcher: LauncherClient) -> None:
        room = await launcher.find_room({})
        self._is_silent = not room.is_known and launcher.is_open

    async def _join_again(self, launcher: LauncherClient) -> None:
        with contextlib.suppress(CannotUseRay):
            await launcher.open()

    def _joined_launcher(self) -> LauncherClient:
        if self._closed or self._launcher is None:
            raise SimulatorFault("the pool of simulators is closed")
        return self._launcher

    # Lending

    def is_full_for(self, world: SimulatorConfig) -> bool:
        queue = self._queue_for(world)
        if queue.lacking:
            return False  # whatever others give back
        return self._is_at_limit(queue) or (queue.is_full and not self._idle_for(world))

    def makes_room(self, lent: SimulatorConfig, world: SimulatorConfig) -> bool:
        queue, freed = self._queue_for(world), self._queue_for(lent).resources
        enough = all(freed.get(name, 0) >= n for name, n in queue.resources.items())
        return enough or self._is_at_limit(queue)

    async def acquire(self, world: SimulatorConfig) -> SimulatorHandle:
        """Raises NoCapacity, or SimulatorFault if the simulator cannot be built."""
        if self._is_at_limit(self._queue_for(world)):
            raise NoCapacity(self._limit_text)
        return await self._lend(world)

    def _is_at_limit(self, queue: PlacementQueue) -> bool:
        """Whether no more simulators may be lent to callers of this queue."""
        # `busy` counts callers that wait. Those of other queues may never get their
        # resources, so they must not block this queue.
        waiting_in_others = sum(q.waiting for q in self._queues if q is not queue)
        return self.busy - waiting_in_others >= self.size_max

    @property
    def _limit_text(self) -> str:
        return f"all {self.size_max} simulators are in use"

    async def _obtain_process(self, world: SimulatorConfig) -> SimulatorProcess:
        """Raises ResourceShortage if the cluster has no room for too long."""
        queue = self._queue_for(world)
        process = await queue.wait()
        lent = self.busy - sum(q.waiting for q in self._queues)
        if lent > self.size_max:
            # Simulators with other resources were lent meanwhile.
            queue.hand_out(process)
            raise ResourceShortage(self._limit_text)
        return process

    def _idle_for(self, world: SimulatorConfig) -> Sequence[SimulatorProcess]:
        return self._idle_of(self._queue_for(world))

    def _make_room(self, unfit: Sequence[SimulatorProcess]) -> None:
        if unfit:  # it holds what another one is placed with
            unfit[0].end("made room for another environment")

    def _idle_of(self, queue: PlacementQueue) -> list[SimulatorProcess]:
        return [process for process in self._idle if self._placed_by[process] is queue]

    def _take_back(self, process: SimulatorProcess) -> None:
        super()._take_back(process)
        if process in self._idle:
            self._idle.remove(process)
            self._placed_by[process].hand_out(process)

    def _forget(self, process: SimulatorProcess) -> None:
        super()._forget(process)
        self._idle_since.pop(process, None)
        self._placed_by.pop(process, None)
        for queue in self._queues:
            queue.note_room()

    # Placing, by resources

    def _queue_for(self, world: SimulatorConfig) -> PlacementQueue:
        resources = dict(world.ray_resources)
        for queue in self._queues:
            if not resources or queue.resources == resources:
                return queue
        return self._add_queue(resources)

    def _add_queue(self, resources: dict[str, float]) -> PlacementQueue:
        queue = PlacementQueue(
            resources,
            self._place_s,
            missing_spares=lambda: self._missing_spares(queue),
            start=self._start_for,
            find_room=lambda names: self._joined_launcher().find_room(names),
            keep=self._keep,
        )
        self._queues.append(queue)
        return queue

    async def _start_for(self, queue: PlacementQueue) -> SimulatorProcess:
        process = ActorProcess(
            self._joined_launcher(),
            queue.resources,
            self._turn_timeout_s,
            self._forget,
        )
        self._placed_by[process] = queue
        return await self._start_process(process)

    def _keep(self, process: SimulatorProcess) -> None:
        if process.alive:
            self._idle.append(process)
            self._idle_since[process] = asyncio.get_running_loop().time()

    def _missing_spares(self, queue: PlacementQueue) -> int:
        if queue is not self._queues[0]:
            return 0
        spares = sum(process.world is None for process in self._idle_of(queue))
        return max(0, self._spares - spares)

    def _fill_spares(self) -> None:
        self._queues[0].request_missing()

    async def _tidy(self) -> None:
        """Give back simulators not used for a while, and requests without a caller."""
        loop = asyncio.get_running_loop()
        while True:
            await asyncio.sleep(min(1.0, self._idle_s / 2))
            now = loop.time()
            for queue in self._queues:
                self._end_idle(queue, now)
                queue.drop_requests(now)

    def _end_idle(self, queue: PlacementQueue, now: float) -> None:
        idle, idle_s = self._idle_of(queue), self._idle_s
        if queue is self._queues[0]:
            idle = idle[: max(0, len(idle) - self._spares)]
        if any(q.needs_room for q in self._queues if q is not queue):
            idle_s = min(idle_s, IDLE_WHILE_NEEDED_S)
        for process in idle:
            if now - self._idle_since.get(process, now) > idle_s:
                process.end("was idle")
