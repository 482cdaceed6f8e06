"""The pool on Ray without Ray: requests, room, what is given back, what is refused.

What needs a cluster is in tests/cluster/on_ray/ray_checks.py.
"""

from __future__ import annotations

import asyncio
import os
import signal
import socket
import threading
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any, cast

import msgspec
import pytest

from reference_sim import benchmark_registry
from reference_sim.process import simulator_main
from reference_sim.process.pool import (
    NoCapacity,
    SimulatorFault,
    SimulatorHandle,
    SimulatorPool,
)
from reference_sim.process.ray import ray_pool
from reference_sim.process.ray.actor_process import CannotUseRay, LauncherClient
from reference_sim.process.ray.machine_check import (
    make_check,
    mismatch,
    remove_marker,
)
from reference_sim.process.ray.ray_pool import RayPool, check_cluster, parse_resources
from reference_sim.process.ray.simulator_actor import SimulatorActor
from tests.support.sim.actors_without_ray import LauncherWithoutRay
from tests.support.sim.calibration_action import calibration_action as action
from tests.support.waiting import wait_in_loop

DEADLINE_S = 60.0
WORLD = benchmark_registry.resolve("calibration").world
Scenario = Callable[[RayPool, LauncherWithoutRay], Coroutine[Any, Any, None]]


def with_pool(scenario: Scenario, room: int, **settings: Any) -> None:
    """A story with a pool on a cluster that has room for some simulators."""

    async def run() -> None:
        launcher = LauncherWithoutRay(room)
        pool = RayPool("ray", "CPU=1", **{"place_s": DEADLINE_S, **settings})
        await pool.start_with(cast("LauncherClient", launcher))
        try:
            await asyncio.wait_for(scenario(pool, launcher), DEADLINE_S)
        finally:
            await pool.close()
        assert (pool.busy, pool.idle, launcher.actors) == (0, 0, {})
        assert launcher.requested == 0

    asyncio.run(run())


async def begin(handle: SimulatorHandle, task: str) -> None:
    await handle.begin(task, 1000, max_steps=100, success_rule="any_step")


def test_pictures_and_chunks_are_those_of_a_local_process() -> None:
    async def scenario(pool: RayPool, _launcher: LauncherWithoutRay) -> None:
        local = SimulatorPool(spares=0)
        try:
            for lender in (pool, local):
                handle = await lender.acquire(WORLD)
                start = await handle.begin(
                    "echo", 7, max_steps=3, success_rule="any_step"
                )
                turns = [start.observation]
                for observe_all in (False, True):
                    chunk = [action(vector=0.5)]
                    played = await handle.play(chunk, observe_all=observe_all)
                    assert played.observation is not None
                    turns.append(played.observation)
                seen.append([msgspec.msgpack.encode(turn) for turn in turns])
        finally:
            await local.close()

    seen: list[list[bytes]] = []
    with_pool(scenario, room=1)
    assert seen[0] == seen[1]
    assert b"pattern" in seen[0][0]


def test_a_full_cluster_refuses_and_the_request_stays() -> None:
    async def scenario(pool: RayPool, launcher: LauncherWithoutRay) -> None:
        first = await pool.acquire(WORLD)
        pool._place_s = 0.5
        fullness = [pool.is_full]
        for _ in range(3):  # a caller that repeats asks for no more
            with pytest.raises(NoCapacity, match="no room"):
                await pool.acquire(WORLD)
            assert launcher.requested == 1
        fullness.append(pool.is_full)
        launcher.add_room()
        await wait_in_loop(lambda: pool.idle == 1, DEADLINE_S)
        fullness.append(pool.is_full)
        assert fullness == [False, True, False]
        second = await pool.acquire(WORLD)
        assert first.pid != second.pid
        assert pool.starts == 2

    with_pool(scenario, room=1)


def test_a_cluster_that_places_one_after_the_other_is_not_full() -> None:
    async def scenario(pool: RayPool, launcher: LauncherWithoutRay) -> None:
        waiting = asyncio.create_task(pool.acquire(WORLD))
        await wait_in_loop(lambda: launcher.requested == 1, DEADLINE_S)
        pool._placed_at = asyncio.get_running_loop().time() + DEADLINE_S
        assert not (await asyncio.wait([waiting], timeout=0.5))[0]
        launcher.add_room()
        await waiting

    with_pool(scenario, room=0, place_s=0.2)


def test_who_waits_gets_what_is_returned() -> None:
    async def scenario(pool: RayPool, launcher: LauncherWithoutRay) -> None:
        first = await pool.acquire(WORLD)
        waiting = asyncio.create_task(pool.acquire(WORLD))
        await wait_in_loop(lambda: launcher.requested == 1, DEADLINE_S)
        await first.release()
        assert (await waiting).pid == first.pid

    with_pool(scenario, room=1)


@pytest.mark.parametrize("leaves_first", [True, False])
def test_who_stops_waiting_leaves_nothing_lent(leaves_first: bool) -> None:
    """In the moment in which it is handed what another caller returned."""

    async def scenario(pool: RayPool, launcher: LauncherWithoutRay) -> None:
        first = await pool.acquire(WORLD)
        waiting = asyncio.create_task(pool.acquire(WORLD))
        await wait_in_loop(lambda: launcher.requested == 1, DEADLINE_S)
        if leaves_first:
            waiting.cancel()
        await first.release()
        waiting.cancel()
        with pytest.raises(asyncio.CancelledError):
            await waiting
        assert (pool.busy, pool.idle) == (0, 1)

    with_pool(scenario, room=1)


def test_no_more_are_lent_than_the_setting_allows() -> None:
    async def scenario(pool: RayPool, _launcher: LauncherWithoutRay) -> None:
        await pool.acquire(WORLD)
        with pytest.raises(NoCapacity, match="all 1 simulators are in use"):
            await pool.acquire(WORLD)

    with_pool(scenario, room=9, size_max=1)


def test_idle_simulators_are_given_back_but_for_the_spares() -> None:
    async def scenario(pool: RayPool, launcher: LauncherWithoutRay) -> None:
        await wait_in_loop(lambda: pool.idle == 1, DEADLINE_S)
        lent = [await pool.acquire(WORLD) for _ in range(3)]
        await wait_in_loop(lambda: len(launcher.actors) == 4, DEADLINE_S)
        for handle in lent:
            await handle.release()
        await wait_in_loop(
            lambda: pool.idle == 1 and len(launcher.actors) == 1, DEADLINE_S
        )

    with_pool(scenario, room=4, spares=1, idle_s=0.2)


def test_a_request_without_a_caller_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ray_pool, "REQUEST_S", 0.1)

    async def scenario(pool: RayPool, launcher: LauncherWithoutRay) -> None:
        with pytest.raises(NoCapacity):
            await pool.acquire(WORLD)
        await wait_in_loop(lambda: launcher.requested == 0, DEADLINE_S)

    with_pool(scenario, room=0, place_s=0.1, idle_s=0.2)


def test_a_killed_actor_is_a_fault_and_frees_its_place() -> None:
    async def scenario(pool: RayPool, _launcher: LauncherWithoutRay) -> None:
        handle = await pool.acquire(WORLD)
        await begin(handle, "delay")
        playing = asyncio.create_task(
            handle.play([action(delay_s=5)], observe_all=False)
        )
        await asyncio.sleep(0)
        assert handle.pid is not None
        os.kill(handle.pid, signal.SIGKILL)
        with pytest.raises(SimulatorFault):
            await playing
        assert pool.busy == 0
        await begin(await pool.acquire(WORLD), "count")

    with_pool(scenario, room=1)


def test_an_actor_that_makes_no_step_is_killed() -> None:
    async def scenario(pool: RayPool, launcher: LauncherWithoutRay) -> None:
        handle = await pool.acquire(WORLD)
        await begin(handle, "delay")
        handle._process._timeout_s = 1.0  # not of its start, which may be slower
        with pytest.raises(SimulatorFault, match="made no step for 1 s"):
            await handle.play([action(delay_s=5)], observe_all=False)
        assert launcher.actors == {}

    with_pool(scenario, room=1)


def test_a_discarded_actor_is_killed() -> None:
    async def scenario(pool: RayPool, launcher: LauncherWithoutRay) -> None:
        handle = await pool.acquire(WORLD)
        handle.discard()
        assert (launcher.actors, pool.busy, pool.idle) == ({}, 0, 0)

    with_pool(scenario, room=1)


def test_a_lost_cluster_is_no_fault() -> None:
    async def scenario(pool: RayPool, launcher: LauncherWithoutRay) -> None:
        launcher.is_joined = False
        with pytest.raises(NoCapacity, match="no cluster"):
            await pool.acquire(WORLD)
        launcher.is_joined = True
        with pytest.raises(SimulatorFault, match="cannot be reached"):
            await pool.check_start()
        await wait_in_loop(lambda: launcher.is_open, DEADLINE_S)
        await pool.check_start()
        await pool.acquire(WORLD)

    with_pool(scenario, room=1)


@pytest.mark.parametrize(("bad", "starts"), [(3, True), (4, False)])
def test_a_machine_that_fails_in_a_start_is_not_the_last_one(
    monkeypatch: pytest.MonkeyPatch, bad: int, starts: bool
) -> None:
    monkeypatch.setattr(ray_pool, "START_AGAIN_S", 0.01)

    async def scenario(pool: RayPool, launcher: LauncherWithoutRay) -> None:
        launcher.bad_starts = bad
        if starts:
            await pool.acquire(WORLD)
        else:
            with pytest.raises(NoCapacity, match="its machine is gone"):
                await pool.acquire(WORLD)

    with_pool(scenario, room=1)


def test_memory_of_another_machine_is_not_mapped() -> None:
    async def scenario(pool: RayPool, _launcher: LauncherWithoutRay) -> None:
        await pool.acquire(WORLD)
        (process,) = pool._processes
        message = simulator_main.frame(simulator_main.NewFrameMemory(0, 4096))
        process.get_buffer(-1)[: len(message)] = message
        process.buffer_updated(len(message))
        assert not process.alive

    with_pool(scenario, room=1)


# --- one actor ---


def test_an_actor_serves_only_who_knows_the_secret() -> None:
    actor = SimulatorActor(make_check(None), "127.0.0.1")
    host, port, why = actor.open()
    assert why == ""
    accepted: list[socket.socket | None] = []
    thread = threading.Thread(target=lambda: accepted.append(actor._accept(b"s" * 32)))
    thread.start()
    for first_bytes in (b"x" * 32, b"s" * 31):
        with socket.create_connection((host, port), DEADLINE_S) as other:
            other.sendall(first_bytes)
            other.shutdown(socket.SHUT_WR)
            assert other.recv(1) == b""
    with socket.create_connection((host, port), DEADLINE_S) as server:
        server.sendall(b"s" * 32)
        thread.join(DEADLINE_S)
        (connection,) = accepted
        assert connection is not None
        assert connection.getpeername() == server.getsockname()
        connection.close()


# --- machines ---


def test_a_machine_with_other_software_is_refused() -> None:
    check = make_check(None)
    assert mismatch(check) is None
    other = msgspec.structs.replace(check, software=check.software | {"numpy": "0.1"})
    assert "has numpy" in str(mismatch(other))
    assert "and the server has 0.1" in str(mismatch(other))


def test_a_machine_without_the_folder_of_recordings_is_refused(tmp_path: Path) -> None:
    check, other = (make_check(tmp_path / "records") for _ in range(2))
    assert mismatch(check) is mismatch(other) is None
    for unlike in ({"folder": str(tmp_path)}, {"marker": "of another folder"}):
        why = mismatch(msgspec.structs.replace(check, **unlike))
        assert "does not share" in str(why)
    for one in (check, other):
        remove_marker(one)
    assert list((tmp_path / "records").iterdir()) == []


def test_without_ray_one_sentence_says_what_to_install() -> None:
    with pytest.raises(CannotUseRay, match=r"not installed here: pip install"):
        asyncio.run(check_cluster("ray", "CPU=1", None))


def test_resources_are_rays() -> None:
    assert parse_resources("CPU=0.5, GPU=1,arm=1") == {"CPU": 0.5, "GPU": 1, "arm": 1}
