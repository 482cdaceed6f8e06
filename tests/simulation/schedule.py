"""One schedule: a world from a seed, played to its end and judged."""

from __future__ import annotations

import asyncio
import contextlib
import gc
import itertools
import random
from dataclasses import dataclass
from typing import cast

from reference_server.files.seed_secret import SeedSecret
from reference_server.rules.refusal import Refused
from reference_server.runs.registry import RunRegistry
from reference_server.runs.service import RunService
from reference_server.runs.sessions.session_executor import SessionExecutor
from reference_server.storage.runs.run_store import Store, StoreFailed
from reference_sim.process.pool import SimulatorPool
from tests.simulation.chances import Chances
from tests.simulation.history import History
from tests.simulation.memory_simulators import MemoryPool
from tests.simulation.memory_store import Database, MemoryStore
from tests.simulation.network import Network
from tests.simulation.simulated_clients import Client
from tests.simulation.virtual_time import NothingLeft, VirtualLoop, virtual_modules
from tests.simulation.world import Life, World
from tests.support.server.server_parts import make_service

# A schedule in which runs make no progress for so long does not end by itself.
CALM_AFTER_S, END_AFTER_S = 120.0, 600.0
DOWN_S = 3.0
# Longer than every lease.
REST_S = 60.0
SIMULATORS, ACTIVE_RUNS = 3, 2


@dataclass(frozen=True, slots=True)
class Outcome:
    """wrong: what was not as it had to be. actions: executed; kills: of servers.

    digest: of all answers; equal when a seed is played again.
    """

    seed: int
    wrong: tuple[str, ...]
    actions: int
    kills: int
    digest: str


class SimulatedServer:
    """One server after another over the same database; each may be killed."""

    def __init__(self, world: World) -> None:
        self._world, self._database = world, Database()
        self._seed_secret = SeedSecret()
        self.service: RunService | None = None
        self.life, self.kills = Life(), 0
        self.pool: MemoryPool | None = None
        self._restart: asyncio.Task[None] | None = None
        world.kill = self.kill

    async def start(self) -> None:
        """Until it has opened its runs, however often the database fails meanwhile."""
        while self.service is None:
            self.life = Life()
            try:
                self.service = await self._open(self.life)
            except StoreFailed:
                self.life.end()
                await self._world.delay(DOWN_S)

    async def _open(self, life: Life) -> RunService:
        store = cast("Store", MemoryStore(self._world, life, self._database))
        pool = MemoryPool(self._world, life, SIMULATORS)

        registry = RunRegistry(store, ACTIVE_RUNS)
        lent = cast("SimulatorPool", pool)
        executor = SessionExecutor(registry, lent, self._seed_secret)
        service = make_service(registry, executor, self._seed_secret)
        await registry.open()
        self.pool = pool
        return service

    def kill(self) -> None:
        """Nothing that it began has an effect from now on; another one starts."""
        if self.service is None:
            return
        self.service = None
        self.kills += 1
        self.life.end()
        self._restart = asyncio.ensure_future(self._start_later())

    async def _start_later(self) -> None:
        await self._world.delay(DOWN_S)
        await self.start()


def play_schedule(seed: int) -> Outcome:
    """Play the schedule of a seed to its end. Nothing of it waits in real time."""
    gc.collect()
    gc.freeze()  # what is left is looked at no more: collecting again costs little
    gc.disable()  # what holds runs weakly must not depend on when garbage is found
    loop = VirtualLoop()
    try:
        with virtual_modules(loop, seed):
            return loop.run_until_complete(_play(loop, seed))
    finally:
        _end(loop)
        gc.enable()


async def _play(loop: VirtualLoop, seed: int) -> Outcome:
    chance = random.Random(seed)
    world = World(chance, Chances.draw(chance))
    server, history = SimulatedServer(world), History(world)
    network = Network(world, server)
    await server.start()
    numbers, keys = itertools.count(1), itertools.count(1)
    accounts = ["alice", "bob"][: chance.choice((1, 2))]
    clients = [
        Client(world, network, history, account, numbers, keys) for account in accounts
    ]
    stories = [
        asyncio.ensure_future(_follow_run(client, f"key-{index}"))
        for index, client in enumerate(chance.choices(clients, k=chance.choice((1, 3))))
    ]
    killer = asyncio.ensure_future(_kill_at_times(world, server))
    done, late = await asyncio.wait(stories, timeout=CALM_AFTER_S)
    world.calm_down()
    if late:
        more, late = await asyncio.wait(late, timeout=END_AFTER_S)
        done |= more
    await killer
    history.check_executed()
    if not late:
        await _check_rest(server, history)
    wrong = [*history.wrong, *network.unexpected, *loop.failures]
    wrong += [f"a run did not end: {story.get_stack()[-1]}" for story in late]
    wrong += [repr(e) for story in done if (e := story.exception()) is not None]
    return Outcome(
        seed, tuple(wrong), len(world.executed), server.kills, history.digest()
    )


async def _check_rest(server: SimulatedServer, history: History) -> None:
    """When every run has ended and every lease is over, nothing is held any more."""
    await asyncio.sleep(REST_S)
    assert server.pool is not None, "it was started"
    if server.pool.busy:
        history.wrong.append(f"{server.pool.busy} simulators are still lent")


async def _kill_at_times(world: World, server: SimulatedServer) -> None:
    for _ in range(world.chances.kills):
        await world.delay(20.0)
        server.kill()


async def _follow_run(client: Client, key: str) -> None:
    """Submit a run, play it with workers, meddle with it, and judge its score."""
    chance = client.world.chance
    run_id = await client.submit(key, chance.choice((1, 2, 4)))
    work = [client.work(run_id, f"w{n}") for n in range(chance.choice((1, 2, 3)))]
    work += [client.watch(run_id) for _ in range(chance.choice((0, 2)))]
    meddling = client.meddle(run_id, chance.choice((0, 2, 5)))
    workers = asyncio.gather(*work)
    await meddling
    while not await client.is_complete(run_id):
        try:
            await client.resume(run_id)
        except Refused as refused:
            if refused.code != "illegal_transition":
                raise
        await client.world.delay(10.0)
    await workers
    episodes = await client.episodes(run_id)
    client.history.check_results(run_id, episodes)
    client.history.check_score(run_id, await client.score(run_id), episodes)


def _end(loop: VirtualLoop) -> None:
    """Cancel what a killed server left, and close."""
    while left := asyncio.all_tasks(loop):  # one that is cancelled may begin another
        for task in left:
            task.cancel()
        with contextlib.suppress(NothingLeft):
            loop.run_until_complete(asyncio.wait(left))
    loop.close()
