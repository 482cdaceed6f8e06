"""Simulators on a real Ray cluster of three machines, all on this one.

Run by tests/cluster/on_ray/test_ray.py in .venv-cluster, where Ray is installed. What
needs no cluster is in tests/sim/process/test_ray_pool.py.
"""

from __future__ import annotations

import asyncio
import dataclasses
import os
import signal
import sys
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager
from functools import partial
from pathlib import Path

import msgspec
import pytest

from reference_server.records.recordings import Recordings
from reference_server.rules.runs.lifecycle import Attach
from reference_sim import benchmark_registry
from reference_sim.process.pool import Begin, NoCapacity, SimulatorPool
from reference_sim.process.ray.ray_pool import RayPool, check_cluster
from tests.support.processes import process_commands
from tests.support.server.server_parts import (
    ServerParts,
    calibration_run,
    expect_refusal,
    open_server_parts,
    predict_command,
    start_task,
)
from tests.support.servers import ReferenceServer
from tests.support.sim.calibration_action import calibration_action as action
from tests.support.sim.ray_cluster import RayCluster
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts a Ray cluster")

DEADLINE_S = 60.0
WORLD = benchmark_registry.resolve("calibration").world
WITH_ARM = dataclasses.replace(WORLD, ray_resources={"CPU": 0.5, "arm": 1})


@pytest.fixture(scope="module")
def cluster() -> Iterator[RayCluster]:
    cluster = RayCluster(2)
    yield cluster
    cluster.close()


@pytest.fixture(autouse=True)
def _leaves_nothing(cluster: RayCluster) -> Iterator[None]:
    yield
    left = (cluster.living_actors, cluster.actor_processes, launchers)
    wait_until(
        lambda: not any(found() for found in left), "nothing is left", DEADLINE_S
    )


async def until(holds: Callable[[], bool]) -> None:
    """Asked in a thread, as Ray's answers take time."""
    await asyncio.to_thread(wait_until, holds, "it came true", DEADLINE_S)


def launchers() -> list[str]:
    """What is connected to Ray for a server of this environment."""
    command = f"{sys.executable} -P -m reference_sim.process.ray.launcher "
    return [line for line in process_commands() if line.startswith(command)]


@asynccontextmanager
async def opened_parts(
    tmp_path: Path, folder: Path | None = None
) -> AsyncIterator[ServerParts]:
    """A server whose simulators are on the cluster.

    folder: of recordings, if there are any.
    """
    pool = RayPool("ray", "CPU=1", place_s=DEADLINE_S)
    await pool.start()
    recordings = None if folder is None else Recordings(folder)
    if recordings is not None:
        recordings.open()
    database = tmp_path / "proctor.sqlite"
    async with open_server_parts(database, 10, recordings, pool) as parts:
        yield parts


async def episode(pool: SimulatorPool) -> list[bytes]:
    """All that one shows, turn for turn, but for the time that it took."""
    handle = await pool.acquire(WORLD)
    start = await handle.begin(Begin("echo", 7, max_steps=6, success_rule="any_step"))
    shown = [msgspec.msgpack.encode(start.observation)]
    for number in range(3):
        chunk = [action(vector=number / 10, clipped=0.5)] * 2
        played = await handle.play(chunk, observe_all=number == 1)
        nothing = played.timing.__class__(0, 0, 0)
        untimed = msgspec.structs.replace(played, timing=nothing)
        shown.append(msgspec.msgpack.encode(untimed))
    assert played.ended
    await handle.release()
    return shown


def test_an_episode_is_that_of_a_local_process(cluster: RayCluster) -> None:
    async def play() -> tuple[list[bytes], list[bytes]]:
        kinds = {"CPU": 1.0}, {"CPU": 1.0, "arm": 1.0}
        assert await check_cluster("ray", kinds) == [len(cluster.machines), 0]
        pools = RayPool("ray", "CPU=1"), SimulatorPool(spares=0)
        for pool in pools:
            await pool.start()
        try:
            return await episode(pools[0]), await episode(pools[1])
        finally:
            for pool in pools:
                await pool.close()

    there, here = asyncio.run(play())
    assert there == here
    assert b"pattern" in there[0]


class ServerOnRay(ReferenceServer):
    command = (sys.executable, "-m", "reference_server")


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL])
def test_a_server_leaves_nothing_behind(
    cluster: RayCluster, tmp_path: Path, number: signal.Signals
) -> None:
    settings = {"PROCTOR_SIMULATORS": "ray", "PROCTOR_RECORDINGS": "off"}
    with ServerOnRay(tmp_path, **settings) as server, server.client() as client:
        body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
        run_id = client.post("/v1/runs", json=body).json()["run_id"]
        where = f"/v1/runs/{run_id}/workers/w"
        client.put(where, json={"attach_key": "key"}).raise_for_status()
        assert len(launchers()) == len(cluster.actor_processes()) == 1
        server.end(number)
        assert server.log() == ""


async def test_a_full_cluster_refuses_and_is_asked_for_more(
    cluster: RayCluster, tmp_path: Path
) -> None:
    async with opened_parts(tmp_path) as parts:
        # No lease ends while others wait, however long Ray takes to place something.
        run = calibration_run(idle_timeout_s=10 * DEADLINE_S)
        run = await parts.registry.add(run, None, "")
        for worker in ("a", "b"):
            await parts.executor.attach(run, Attach(worker, "key"))
        run = await parts.registry.add(calibration_run(run_id="run_2"), None, "")
        assert isinstance(parts.pool, RayPool)
        parts.pool._queues[0]._place_s = 1.0
        with expect_refusal("no_capacity"):
            await parts.executor.attach(run, Attach("c", "key"))
        await until(lambda: cluster.requested() == 1)
        cluster.machines.append(cluster.add_machine())
        await until(lambda: parts.pool.idle == 1)
        await parts.executor.attach(run, Attach("c", "key"))


async def test_a_simulator_is_placed_where_what_its_benchmark_declares_is(
    cluster: RayCluster,
) -> None:
    pool = RayPool("ray", "CPU=1")
    await pool.start()
    try:
        pool._queue_for(WITH_ARM)._place_s = 1.0
        with pytest.raises(NoCapacity, match=r"no machine of the .* has arm=1 "):
            await pool.acquire(WITH_ARM)
        await (await pool.acquire(WORLD)).release()
        machine = cluster.add_machine({"arm": 1})
        cluster.machines.append(machine)
        await until(lambda: len(pool._idle_for(WITH_ARM)) == 1)
        lent = await pool.acquire(WITH_ARM)
        (where,) = [
            one["Address"]["NodeID"]
            for one in cluster.actors().values()
            if one["Pid"] == lent.pid
        ]
        assert where == machine.node_id
    finally:
        await pool.close()


async def test_recordings_are_written_by_the_server(tmp_path: Path) -> None:
    async with opened_parts(tmp_path, folder=tmp_path / "records") as parts:
        run = await parts.registry.add(calibration_run("score"), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        turn = await parts.executor.predict(run, predict_command(turn, end=1))
        assert run.episodes[0].recording is not None


async def test_what_is_lost_is_a_fault_that_costs_no_attempt(
    cluster: RayCluster, tmp_path: Path
) -> None:
    """First the actor's process is killed in a turn, then its machine is removed."""
    async with opened_parts(tmp_path) as parts:
        run = await parts.registry.add(calibration_run("delay"), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        for faults in (1, 2):
            command = predict_command(turn, delay_s=5)
            playing = start_task(parts.executor.predict(run, command))
            (process,) = parts.pool._lent
            await until(partial(getattr, process, "is_busy"))
            assert process.pid is not None
            if faults == 1:
                os.kill(process.pid, signal.SIGKILL)
            else:
                await asyncio.to_thread(cluster.remove_machine_of, process.pid)
            turn = await playing
            assert turn["fault"]["faults"] == faults
            assert turn["episode"]["step"] == 0
            assert run.episodes[0].attempt == 1
        turn = await parts.executor.predict(run, predict_command(turn))
        assert turn["episode"]["step"] == 1
