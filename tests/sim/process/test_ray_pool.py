"""The pool on Ray without Ray: requests, room, what is given back, what is refused.

What needs a cluster is in tests/cluster/on_ray/ray_checks.py.
"""

import asyncio
import dataclasses
import os
import signal
import socket
import threading
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any, cast

import msgspec
import pytest

from reference_sim import benchmark_registry
from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.message_frames import frame
from reference_sim.process import simulator_main
from reference_sim.process.pool import (
    Begin,
    NoCapacity,
    SimulatorFault,
    SimulatorHandle,
)
from reference_sim.process.ray import placement_queue
from reference_sim.process.ray.actor_process import CannotUseRay, LauncherClient
from reference_sim.process.ray.launcher import actor_options, find_lacking
from reference_sim.process.ray.machine_check import make_check, mismatch
from reference_sim.process.ray.ray_pool import RayPool, check_cluster
from reference_sim.process.ray.simulator_actor import SimulatorActor
from tests.support.sim.actors_without_ray import LauncherWithoutRay
from tests.support.sim.calibration_action import calibration_action as action
from tests.support.sim.shared_processes import opened_pool as local_pool
from tests.support.waiting import wait_in_loop

DEADLINE_S = 60.0
WORLD = benchmark_registry.resolve("calibration").world
SMALL, ON_GPU, OF_MORE = (
    dataclasses.replace(WORLD, ray_resources=resources)
    for resources in ({"CPU": 0.5}, {"CPU": 1, "GPU": 0.25}, {"CPU": 2, "GPU": 1})
)


@asynccontextmanager
async def opened_pool(
    room: int, **settings: Any
) -> AsyncIterator[tuple[RayPool, LauncherWithoutRay]]:
    """A pool on a cluster that has room for some simulators."""
    launcher = LauncherWithoutRay(room)
    waits = {"place_s": DEADLINE_S, "idle_s": DEADLINE_S}
    pool = RayPool("ray", "CPU=1", **{**waits, **settings})
    await pool.start_with(cast("LauncherClient", launcher))
    try:
        yield pool, launcher
    finally:
        await pool.close()
    assert (pool.busy, pool.idle, launcher.actors) == (0, 0, {})
    assert launcher.requested == 0


async def begin(handle: SimulatorHandle, task: str, max_steps: int = 100) -> Any:
    how = Begin(task, 1000, max_steps=max_steps, success_rule="any_step")
    return await handle.begin(how)


async def waiting_caller(
    pool: RayPool, launcher: LauncherWithoutRay, world: SimulatorConfig = WORLD
) -> asyncio.Task[SimulatorHandle]:
    """A caller whose one request the cluster has no room for yet."""
    waiting = asyncio.create_task(pool.acquire(world))
    await wait_in_loop(lambda: launcher.requested == 1, DEADLINE_S)
    return waiting


async def test_pictures_and_chunks_are_those_of_a_local_process() -> None:
    seen: list[list[bytes]] = []
    async with opened_pool(room=1) as (pool, _), local_pool() as local:
        for lender in (pool, local):
            handle = await lender.acquire(WORLD)
            start = await begin(handle, "echo", max_steps=3)
            turns = [start.observation]
            for observe_all in (False, True):
                chunk = [action(vector=0.5)]
                played = await handle.play(chunk, observe_all=observe_all)
                assert played.observation is not None
                turns.append(played.observation)
            seen.append([msgspec.msgpack.encode(turn) for turn in turns])
    assert seen[0] == seen[1]
    assert b"pattern" in seen[0][0]


async def test_a_full_cluster_refuses_and_the_request_stays() -> None:
    async with opened_pool(room=1) as (pool, launcher):
        first = await pool.acquire(WORLD)
        pool._queues[0]._place_s = 0.5
        fullness = [pool.is_full_for(WORLD)]
        for _ in range(3):  # a caller that repeats asks for no more
            with pytest.raises(NoCapacity, match="no room"):
                await pool.acquire(WORLD)
            assert launcher.requested == 1
        fullness.append(pool.is_full_for(WORLD))
        launcher.add_room()
        await wait_in_loop(lambda: pool.idle == 1, DEADLINE_S)
        fullness.append(pool.is_full_for(WORLD))
        assert fullness == [False, True, False]
        second = await pool.acquire(WORLD)
        assert first.pid != second.pid
        assert pool.starts == 2


async def test_a_cluster_that_starts_slowly_is_not_full() -> None:
    """Until it says that it has no more room."""
    async with opened_pool(room=0, place_s=0.2) as (pool, launcher):
        launcher.is_slow = True
        waiting = [asyncio.create_task(pool.acquire(WORLD)) for _ in range(2)]
        await wait_in_loop(lambda: launcher.requested == 2, DEADLINE_S)
        assert not (await asyncio.wait(waiting, timeout=0.5))[0]
        assert not pool.is_full_for(WORLD)
        launcher.add_room()
        await asyncio.wait(waiting, return_when=asyncio.FIRST_COMPLETED)
        launcher.is_slow = False
        done, refused = sorted(waiting, key=lambda task: not task.done())
        assert (await done).pid
        with pytest.raises(NoCapacity, match="no room"):
            await refused


async def test_who_waits_gets_what_is_returned() -> None:
    async with opened_pool(room=1) as (pool, launcher):
        first = await pool.acquire(WORLD)
        waiting = await waiting_caller(pool, launcher)
        await first.release()
        assert (await waiting).pid == first.pid


@pytest.mark.parametrize("leaves_first", [True, False])
async def test_who_stops_waiting_leaves_nothing_lent(leaves_first: bool) -> None:
    """In the moment in which it is handed what another caller returned."""
    async with opened_pool(room=1) as (pool, launcher):
        first = await pool.acquire(WORLD)
        waiting = await waiting_caller(pool, launcher)
        if leaves_first:
            waiting.cancel()
        await first.release()
        waiting.cancel()
        with pytest.raises(asyncio.CancelledError):
            await waiting
        assert (pool.busy, pool.idle) == (0, 1)


async def test_what_has_ended_is_not_free() -> None:
    """Nor if it ends in the moment in which who was handed it stops waiting."""
    async with opened_pool(room=1) as (pool, launcher):
        first = await pool.acquire(WORLD)
        waiting = await waiting_caller(pool, launcher)
        await first.release()
        first._process.end("died")
        waiting.cancel()
        with pytest.raises(asyncio.CancelledError):
            await waiting
        assert first._process not in pool._idle
        assert (await pool.acquire(WORLD)).pid != first.pid


async def test_no_more_are_lent_than_the_setting_allows() -> None:
    async with opened_pool(room=9, size_max=1) as (pool, _launcher):
        await pool.acquire(WORLD)
        with pytest.raises(NoCapacity, match="all 1 simulators are in use"):
            await pool.acquire(WORLD)


async def test_idle_simulators_are_given_back_but_for_the_spares() -> None:
    async with opened_pool(room=4, spares=1, idle_s=0.2) as (pool, launcher):
        await wait_in_loop(lambda: pool.idle == 1, DEADLINE_S)
        lent = [await pool.acquire(WORLD) for _ in range(3)]
        await wait_in_loop(lambda: len(launcher.actors) == 4, DEADLINE_S)
        for handle in lent:
            await handle.release()
        await wait_in_loop(
            lambda: pool.idle == 1 and len(launcher.actors) == 1, DEADLINE_S
        )


async def test_a_request_without_a_caller_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(placement_queue, "REQUEST_S", 0.1)
    async with opened_pool(room=0, place_s=0.1, idle_s=0.2) as (pool, launcher):
        with pytest.raises(NoCapacity):
            await pool.acquire(WORLD)
        await wait_in_loop(lambda: launcher.requested == 0, DEADLINE_S)


async def test_a_killed_actor_is_a_fault_and_frees_its_place() -> None:
    async with opened_pool(room=1) as (pool, _launcher):
        handle = await pool.acquire(WORLD)
        await begin(handle, "delay")
        play = handle.play([action(delay_s=5)], observe_all=False)
        playing = asyncio.create_task(play)
        await asyncio.sleep(0)
        assert handle.pid is not None
        os.kill(handle.pid, signal.SIGKILL)
        with pytest.raises(SimulatorFault):
            await playing
        assert pool.busy == 0
        await begin(await pool.acquire(WORLD), "count")


async def test_an_actor_that_makes_no_step_is_killed() -> None:
    async with opened_pool(room=1) as (pool, launcher):
        handle = await pool.acquire(WORLD)
        await begin(handle, "delay")
        handle._process._timeout_s = 1.0  # not of its start, which may be slower
        with pytest.raises(SimulatorFault, match="made no step for 1 s"):
            await handle.play([action(delay_s=5)], observe_all=False)
        assert launcher.actors == {}


async def test_a_lost_cluster_is_no_fault() -> None:
    async with opened_pool(room=1) as (pool, launcher):
        launcher.is_joined = False
        with pytest.raises(NoCapacity, match="no cluster"):
            await pool.acquire(WORLD)
        launcher.is_joined = True
        with pytest.raises(SimulatorFault, match="cannot be reached"):
            await pool.check_start()
        await wait_in_loop(lambda: launcher.is_open, DEADLINE_S)
        await pool.check_start()
        await pool.acquire(WORLD)


async def test_a_cluster_that_does_not_answer_is_named() -> None:
    """Ray itself notices only after a minute that its head is lost."""
    async with opened_pool(room=0, place_s=0.1) as (pool, launcher):
        await pool.check_start()
        await wait_in_loop(lambda: not pool._is_asking, DEADLINE_S)
        launcher.is_silent = True
        for _ in range(2):  # the second one waits less
            with pytest.raises(NoCapacity, match="Ray cluster does not answer"):
                await pool.acquire(WORLD)
        await pool.check_start()
        await wait_in_loop(lambda: not pool._is_asking, DEADLINE_S)
        launcher.is_silent = False
        with pytest.raises(CannotUseRay, match="does not answer"):
            await pool.check_start()
        await wait_in_loop(lambda: not pool._is_asking, DEADLINE_S)
        await pool.check_start()
        with pytest.raises(NoCapacity, match="no room now"):
            await pool.acquire(WORLD)


@pytest.mark.parametrize(("bad", "starts"), [(3, True), (4, False)])
async def test_a_machine_that_fails_in_a_start_is_not_the_last_one(
    monkeypatch: pytest.MonkeyPatch, bad: int, starts: bool
) -> None:
    monkeypatch.setattr(placement_queue, "START_AGAIN_S", 0.01)
    async with opened_pool(room=1) as (pool, launcher):
        launcher.bad_starts = bad
        if starts:
            await pool.acquire(WORLD)
        else:
            with pytest.raises(NoCapacity, match="its machine is gone"):
                await pool.acquire(WORLD)


async def test_memory_of_another_machine_is_not_mapped() -> None:
    async with opened_pool(room=1) as (pool, _launcher):
        await pool.acquire(WORLD)
        (process,) = pool._processes
        message = frame(simulator_main.NewFrameMemory(1, 0, 4096))
        process.get_buffer(-1)[: len(message)] = message
        process.buffer_updated(len(message))
        assert not process.alive


# --- resources that a benchmark declares ---


async def test_a_simulator_is_placed_by_what_its_benchmark_declares() -> None:
    async with opened_pool(room=3) as (pool, launcher):
        same = dataclasses.replace(WORLD, ray_resources={"CPU": 1.0})
        for world in (WORLD, SMALL, same):
            await pool.acquire(world)
        assert launcher.started == [{"CPU": 1}, {"CPU": 0.5}, {"CPU": 1}]
        assert len(pool._queues) == 2


async def test_a_free_simulator_serves_only_what_declares_the_same() -> None:
    async with opened_pool(room=9) as (pool, launcher):
        first = await pool.acquire(SMALL)
        await first.release()
        other = await pool.acquire(WORLD)
        assert other.pid != first.pid
        assert (await pool.acquire(SMALL)).pid == first.pid
        assert launcher.started == [{"CPU": 0.5}, {"CPU": 1}]


async def test_what_is_returned_goes_to_who_waits_for_the_same() -> None:
    async with opened_pool(room=1) as (pool, launcher):
        first = await pool.acquire(SMALL)
        waiting = []
        for world in (WORLD, SMALL):
            waiting.append(asyncio.create_task(pool.acquire(world)))
            await wait_in_loop(lambda: launcher.requested == len(waiting), DEADLINE_S)
        await first.release()
        assert (await waiting[1]).pid == first.pid
        assert not waiting[0].done()
        launcher.add_room()
        await waiting[0]


async def test_what_no_machine_has_is_named_and_holds_up_no_other() -> None:
    async with opened_pool(room=9, size_max=2) as (pool, launcher):
        pool._queue_for(ON_GPU)._place_s = 0.5
        refused = [asyncio.create_task(pool.acquire(ON_GPU)) for _ in range(2)]
        await wait_in_loop(lambda: launcher.requested == 2, DEADLINE_S)
        fits = await pool.acquire(WORLD)  # though two simulators are all that may be
        for one in refused:
            with pytest.raises(NoCapacity, match=r"no machine of the .* has GPU=0.25 "):
                await one
        assert (await pool.acquire(WORLD)).pid != fits.pid
        assert launcher.requested == 2  # they stay, for a machine that joins
        fits.discard()
        assert not pool.is_full_for(ON_GPU)  # nothing given back would serve it
        pool._queue_for(ON_GPU)._place_s = DEADLINE_S
        with pytest.raises(NoCapacity):  # soon: what has ended made no room for it
            await pool.acquire(ON_GPU)
        launcher.add_resource("GPU")
        await wait_in_loop(lambda: pool.idle == 2, DEADLINE_S)
        await pool.acquire(ON_GPU)
        assert pool.is_full_for(ON_GPU)
        assert pool.starts == 4


async def test_no_more_are_lent_than_allowed_when_a_place_comes_late() -> None:
    """Others were lent what is allowed while this one waited for what it declares."""
    async with opened_pool(room=9, size_max=1) as (pool, launcher):
        late = await waiting_caller(pool, launcher, ON_GPU)
        first = await pool.acquire(WORLD)
        launcher.add_resource("GPU")
        with pytest.raises(NoCapacity, match="all 1 simulators are in use"):
            await late
        assert (pool.busy, pool.idle) == (1, 1)
        await first.release()
        await pool.acquire(ON_GPU)
        assert launcher.started == [{"CPU": 1}, {"CPU": 1, "GPU": 0.25}]


async def test_a_cluster_may_be_full_for_one_benchmark_alone() -> None:
    async with opened_pool(room=1) as (pool, launcher):
        lent = await pool.acquire(SMALL)
        pool._queue_for(WORLD)._place_s = 0.2
        with pytest.raises(NoCapacity, match=r"no room now .* with CPU=1"):
            await pool.acquire(WORLD)
        assert pool.is_full_for(WORLD)
        assert not pool.is_full_for(SMALL)
        await lent.release()
        # Longer than it is kept else: its room is needed, and no caller is there now.
        await wait_in_loop(lambda: pool.starts == 2 and pool.idle == 1, DEADLINE_S)
        assert launcher.started == [{"CPU": 0.5}, {"CPU": 1}]
        assert not pool.is_full_for(WORLD)


async def test_a_machine_that_joins_is_known_to_the_next_caller() -> None:
    """Though it has no room either: what others give back would serve it now."""
    async with opened_pool(room=0, place_s=0.1) as (pool, launcher):
        with pytest.raises(NoCapacity, match="no machine"):
            await pool.acquire(ON_GPU)
        launcher.add_resource("GPU")
        with pytest.raises(NoCapacity, match=r"no room now .* with CPU=1,GPU=0.25"):
            await pool.acquire(ON_GPU)
        assert pool.is_full_for(ON_GPU)


@pytest.mark.parametrize(
    ("lent", "size_max", "makes_room"),
    [
        (ON_GPU, 2, True),
        (OF_MORE, 2, True),  # enough, and on one machine
        (WORLD, 2, False),  # which has no GPU
        (WORLD, 1, True),  # but is all that may be lent
    ],
)
async def test_a_session_ends_for_another_only_if_what_it_took_is_enough(
    lent: SimulatorConfig, size_max: int, makes_room: bool
) -> None:
    async with opened_pool(room=1, size_max=size_max) as (pool, _launcher):
        await pool.acquire(WORLD)
        assert pool.makes_room(lent, ON_GPU) is makes_room


async def test_spares_take_what_the_setting_says() -> None:
    async with opened_pool(room=4, spares=1, idle_s=0.2) as (pool, launcher):
        await wait_in_loop(lambda: pool.idle == 1, DEADLINE_S)
        await (await pool.acquire(SMALL)).release()
        await wait_in_loop(lambda: pool.idle == 1, DEADLINE_S)
        assert launcher.started == [{"CPU": 1}, {"CPU": 0.5}]
        (spare,) = pool._idle
        assert spare.world is None


# --- what the launcher knows of machines ---

MACHINES: list[dict[str, Any]] = [
    {"Alive": True, "Resources": {"CPU": 4.0, "memory": 2.0**30}},
    {"Alive": True, "Resources": {"CPU": 1.0, "GPU": 1.0}},
    {"Alive": False, "Resources": {"CPU": 4.0, "GPU": 4.0, "arm": 1.0}},
]


@pytest.mark.parametrize(
    ("resources", "lacking"),
    [
        ({"CPU": 4}, {}),
        ({"CPU": 1, "GPU": 0.25}, {}),
        ({"CPU": 1, "arm": 1}, {"arm": 1}),
        ({"CPU": 5, "GPU": 2, "memory": 1}, {"CPU": 5, "GPU": 2}),
        ({"CPU": 4, "GPU": 1}, {"CPU": 4, "GPU": 1}),  # each, but none has both
    ],
)
def test_what_no_machine_has_is_found(
    resources: dict[str, float], lacking: dict[str, float]
) -> None:
    assert find_lacking(MACHINES, resources) == lacking


def test_resources_are_options_of_an_actor() -> None:
    options = actor_options({"GPU": 0.25, "memory": 2.0**30, "arm": 1})
    wanted = {"num_cpus": 0, "num_gpus": 0.25, "memory": 2**30, "max_restarts": 0}
    assert wanted.items() <= options.items()
    assert options["resources"] == {"arm": 1}


# --- one actor ---


def test_an_actor_serves_only_who_knows_the_secret() -> None:
    actor = SimulatorActor(make_check(), "127.0.0.1")
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
    check = make_check()
    assert mismatch(check) is None
    other = msgspec.structs.replace(check, software=check.software | {"numpy": "0.1"})
    assert "has numpy" in str(mismatch(other))
    assert "and the server has 0.1" in str(mismatch(other))


def test_without_ray_one_sentence_says_what_to_install() -> None:
    with pytest.raises(CannotUseRay, match=r"not installed here: pip install"):
        asyncio.run(check_cluster("ray", [{"CPU": 1}]))
