"""A pool of simulators on a Ray cluster, with the interface of the local one.

What the cluster has no room for stays requested: Ray's autoscaler sees it. A caller
waits for it for a while, then gets NoCapacity; what is then placed serves the next one.
What is idle is soon given back, because others may use the cluster, too.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
from collections import deque
from pathlib import Path

from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.process.pool import NoCapacity, SimulatorHandle, SimulatorPool
from reference_sim.process.ray.actor_process import (
    ActorProcess,
    CannotUseRay,
    LauncherClient,
)
from reference_sim.process.ray.launcher_messages import Connect, MachineCheck
from reference_sim.process.ray.machine_check import make_check, remove_marker
from reference_sim.process.simulator_process import (
    ResourceShortage,
    SimulatorFault,
    SimulatorProcess,
)

PLACE_S = 15.0  # for a machine that starts a simulator slowly
PLACE_IN_FULL_CLUSTER_S = 1.0
REQUEST_S = 120.0  # how long a request outlives the last caller that waited for it
IDLE_S = 10.0  # less than another server waits for room
START_TRIES, START_AGAIN_S = 4, 1.0
_log = logging.getLogger(__name__)


def parse_resources(text: str) -> dict[str, float]:
    """`CPU=0.5,GPU=1` as amounts by name. Raises ValueError."""
    amounts: dict[str, float] = {}
    for part in filter(None, map(str.strip, text.split(","))):
        name, _, written = map(str.strip, part.partition("="))
        amount = float(written)
        if not (name and 0 < amount < float("inf")):
            raise ValueError(f"{part!r} is not NAME=AMOUNT with an amount above 0")
        if amount > 1 and amount != int(amount):
            raise ValueError(f"{part}: above 1 Ray takes whole numbers only")
        amounts[name] = amount
    if not amounts:
        raise ValueError("a simulator needs at least one resource, such as CPU=1")
    return amounts


def _connect(
    address: str, resources: str, recordings: Path | None, *, checks_machines: bool
) -> Connect:
    machine = make_check(recordings)
    return Connect(address, parse_resources(resources), machine, checks_machines)


async def check_cluster(address: str, resources: str, recordings: Path | None) -> int:
    """How many machines could simulate; each was looked at. Raises CannotUseRay."""
    found = _connect(address, resources, recordings, checks_machines=True)
    launcher = LauncherClient(found)
    try:
        return await launcher.open()
    finally:
        await launcher.close()
        remove_marker(found.machine)


class RayPool(SimulatorPool):
    """Lends at most `size_max` simulators, as far as the cluster has room.

    address: `ray`, or `ray://HOST:PORT` of Ray's own server for clients. resources: of
    one simulator. recordings: the folder that they are written to, if they are.
    place_s: how long a caller waits while the cluster places none.
    """

    def __init__(
        self,
        address: str,
        resources: str,
        size_max: int = 64,
        spares: int = 0,
        turn_timeout_s: float = 60.0,
        *,
        recordings: Path | None = None,
        place_s: float = PLACE_S,
        idle_s: float = IDLE_S,
    ) -> None:
        super().__init__(size_max, spares, turn_timeout_s)
        self._plan = address, resources, recordings
        self._place_s, self._idle_s = place_s, idle_s
        self._launcher: LauncherClient | None = None
        self._machine: MachineCheck | None = None
        self._starting: dict[asyncio.Task[None], None] = {}  # oldest first
        self._idle_since: dict[SimulatorProcess, float] = {}
        self._waiting: deque[asyncio.Future[SimulatorProcess]] = deque()
        self._cluster_is_full = False
        self._waited_at = self._placed_at = 0.0
        self._tidying: asyncio.Task[None] | None = None
        self._joining: asyncio.Task[None] | None = None

    @property
    def is_full(self) -> bool:
        return super().is_full or (self._cluster_is_full and not self._idle)

    async def start(self) -> None:
        """Join the cluster. Raises SimulatorFault."""
        address, resources, recordings = self._plan
        connect = _connect(address, resources, recordings, checks_machines=False)
        self._machine = connect.machine
        await self.start_with(LauncherClient(connect))

    async def start_with(self, launcher: LauncherClient) -> None:
        """Join the cluster by this launcher. Raises SimulatorFault."""
        self._launcher = launcher
        await launcher.open()
        self._tidying = asyncio.create_task(self._tidy())
        await super().start()

    async def close(self) -> None:
        self._closed = True
        tasks = (self._tidying, self._joining, *self._starting)
        for task in [one for one in tasks if one is not None]:
            task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await task
        while self._waiting:
            closed = SimulatorFault("the pool of simulators is closed")
            self._waiting.popleft().set_exception(closed)
        await super().close()
        if self._launcher is not None:
            await self._launcher.close()
        if self._machine is not None:
            remove_marker(self._machine)

    async def check_start(self) -> None:
        """Raises SimulatorFault while there is no cluster, which is joined again."""
        if self._closed or self._launcher is None:
            raise SimulatorFault("the pool of simulators is closed")
        if not self._launcher.is_open:
            if self._joining is None or self._joining.done():
                self._joining = asyncio.create_task(self._join_again(self._launcher))
            raise CannotUseRay("the Ray cluster cannot be reached")

    async def _join_again(self, launcher: LauncherClient) -> None:
        with contextlib.suppress(CannotUseRay):
            await launcher.open()

    async def acquire(self, world: SimulatorConfig) -> SimulatorHandle:
        """Raises NoCapacity, or SimulatorFault if the simulator cannot be built."""
        if self.busy >= self.size_max:
            raise NoCapacity(f"all {self.size_max} simulators are in use")
        return await self._lend(world)

    def _new_process(self) -> SimulatorProcess:
        if self._launcher is None:
            raise SimulatorFault("the pool of simulators was not started")
        return ActorProcess(self._launcher, self._turn_timeout_s, self._forget)

    # Requests: callers wait in a row for whichever simulator is free or placed first

    async def _obtain_process(self) -> SimulatorProcess:
        """Raises ResourceShortage if the cluster has no room for too long."""
        loop = asyncio.get_running_loop()
        mine: asyncio.Future[SimulatorProcess] = loop.create_future()
        self._waiting.append(mine)
        self._request_missing()
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
        if self._cluster_is_full:
            wait_s = min(wait_s, PLACE_IN_FULL_CLUSTER_S)
        while not mine.done():
            # Many at once start slowly: as long as one after the other is placed, the
            # cluster has room.
            left_s = max(waited_from, self._placed_at) + wait_s - loop.time()
            if left_s <= 0:
                self._cluster_is_full = True
                text = "the Ray cluster has no room for another simulator now"
                raise ResourceShortage(text)
            await asyncio.wait([mine], timeout=left_s)
        return mine.result()

    def _withdraw(self, mine: asyncio.Future[SimulatorProcess]) -> None:
        """What this caller got in the last moment is for the next one."""
        if mine in self._waiting:
            self._waiting.remove(mine)
        elif mine.exception() is None:
            self._hand_out(mine.result())

    def _request_missing(self) -> None:
        """One request for each caller that waits, and each spare that is missing."""
        spares = sum(one.world is None for one in self._idle)
        wanted = len(self._waiting) + max(0, self._spares - spares)
        while len(self._starting) < wanted and not self._closed:
            task = asyncio.create_task(self._place())
            self._starting[task] = None
            task.add_done_callback(self._count_out)

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
        self._cluster_is_full = False
        self._placed_at = asyncio.get_running_loop().time()
        self._hand_out(process)

    async def _start_somewhere(self) -> SimulatorProcess:
        """Again when a machine fails meanwhile, or is not fit to simulate."""
        for _ in range(START_TRIES - 1):
            try:
                return await self._start_process()
            except CannotUseRay:
                raise
            except ResourceShortage as shortage:
                _log.warning("a simulator is started elsewhere: %s", shortage)
                await asyncio.sleep(START_AGAIN_S)
        return await self._start_process()

    def _hand_out(self, process: SimulatorProcess) -> None:
        while self._waiting:
            first = self._waiting.popleft()
            if not first.done():
                first.set_result(process)
                return
        self._idle.append(process)
        self._idle_since[process] = asyncio.get_running_loop().time()

    def _take_back(self, process: SimulatorProcess) -> None:
        super()._take_back(process)
        if process in self._idle:
            self._idle.remove(process)
            self._hand_out(process)

    def _forget(self, process: SimulatorProcess) -> None:
        super()._forget(process)
        self._idle_since.pop(process, None)
        # What it took of the cluster is free, unless its machine is gone.
        self._cluster_is_full = False

    def _fill_spares(self) -> None:
        self._request_missing()

    async def _tidy(self) -> None:
        """Give back what was not used for a while, and requests without a caller."""
        loop = asyncio.get_running_loop()
        while True:
            await asyncio.sleep(min(1.0, self._idle_s / 2))
            now = loop.time()
            for process in self._idle[: max(0, len(self._idle) - self._spares)]:
                if now - self._idle_since.get(process, now) > self._idle_s:
                    process.end("was idle")
            if not self._waiting and now - self._waited_at > REQUEST_S:
                for task in list(self._starting)[self._spares :]:
                    task.cancel()
