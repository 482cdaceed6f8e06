"""Simulator processes: lent, reused, broken, killed."""

import asyncio
import errno
import os
import signal
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from reference_sim import benchmark_registry
from reference_sim.process import simulator_process
from reference_sim.process.pool import (
    Begin,
    NoCapacity,
    SimulatorFault,
    SimulatorHandle,
    SimulatorPool,
    TaskUnplayable,
)
from reference_sim.process.simulator_main import NewFrameMemory
from reference_sim.process.simulator_process import ForkStarter
from tests.support.sim.calibration_action import calibration_action as action
from tests.support.sim.shared_processes import shared_pool
from tests.support.waiting import wait_in_loop

DEADLINE_S = 30.0
WORLD = benchmark_registry.resolve("calibration").world
OTHER_WORLD = benchmark_registry.resolve(
    "calibration", images={"codec": "png", "width": 64, "height": 48}
).world
fork_and_exec = pytest.mark.parametrize(
    "fork",
    [
        pytest.param(True, id="fork"),
        pytest.param(False, id="exec", marks=pytest.mark.slow("starts interpreters")),
    ],
)


@asynccontextmanager
async def opened_pool(
    *, fork: bool | None = None, **settings: Any
) -> AsyncIterator[SimulatorPool]:
    """A pool; expects that none of its processes is left. fork: whether by a fork
    server of its own; without it, the tests' shared one."""
    if fork is None:
        pool = shared_pool(**settings)
    else:
        pool = SimulatorPool(fork=fork, **settings)
    await pool.start()
    try:
        yield pool
    finally:
        pids = [process.pid for process in pool._processes]
        await pool.close()
    assert (pool.busy, pool.idle) == (0, 0)
    await wait_in_loop(lambda: not any(pid and exists(pid) for pid in pids), DEADLINE_S)


async def begin(handle: SimulatorHandle, task: str, max_steps: int = 100) -> Any:
    how = Begin(task, 1000, max_steps=max_steps, success_rule="any_step")
    return await handle.begin(how)


def exists(pid: int | None) -> bool:
    """True for a zombie, too: none may be left while the pool lives."""
    assert pid is not None
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def read_environment(pid: int | None) -> str:
    return Path(f"/proc/{pid}/environ").read_text()


@pytest.mark.skipif(sys.platform != "linux", reason="needs /proc")
@fork_and_exec
async def test_settings_of_the_server_are_not_passed_on(
    monkeypatch: pytest.MonkeyPatch, fork: bool
) -> None:
    """Code of a host's own benchmark runs in these processes."""
    monkeypatch.setenv("PROCTOR_TOKENS", "alice:run:sesame")
    monkeypatch.setenv("proctor_database", "postgresql://user:sesame@host/name")
    monkeypatch.setenv("PGPASSWORD", "sesame")
    monkeypatch.setenv("OTHER_VARIABLE", "kept")
    async with opened_pool(fork=fork, spares=0) as pool:
        handle = await pool.acquire(WORLD)
        environment = read_environment(handle.pid)
        assert "sesame" not in environment
        assert "OTHER_VARIABLE=kept" in environment


@fork_and_exec
async def test_plays_an_episode(fork: bool) -> None:
    async with opened_pool(fork=fork) as pool:
        handle = await pool.acquire(WORLD)
        beginning = await begin(handle, "score", 3)
        assert beginning.instruction == "Calibration task score."
        assert beginning.observation["state"]["count"] == [0.0]
        chunk = [action(score=0.25), action(score=0.5)]
        first = await handle.play(chunk, observe_all=False)
        assert (first.executed, first.rewards, first.steps) == (2, [0.25, 0.5], 2)
        assert not first.ended
        assert first.observation is not None
        assert first.observation["state"]["count"] == [2.0]
        assert first.observations is None
        last = await handle.play([action(score=0.75)] * 2, observe_all=False)
        assert (last.executed, last.steps, last.score) == (1, 3, 0.75)
        assert (last.ended, last.terminated, last.truncated) == (True, False, True)
        assert last.observation is None


async def test_the_current_observation_can_be_read_again() -> None:
    async with opened_pool() as pool:
        handle = await pool.acquire(OTHER_WORLD)
        await begin(handle, "echo")
        played = await handle.play([action()], observe_all=False)
        assert await handle.observe() == played.observation
        assert (await handle.observe())["images"]["pattern"]["width"] == 64


async def test_a_released_process_is_lent_again_for_the_same_world() -> None:
    async with opened_pool() as pool:
        first = await pool.acquire(WORLD)
        other = await pool.acquire(OTHER_WORLD)
        await first.release()
        await other.release()
        assert pool.busy == 0
        for world, previous in ((OTHER_WORLD, other), (WORLD, first)):
            handle = await pool.acquire(world)
            assert handle.pid == previous.pid
        assert first.pid != other.pid


async def test_a_process_can_be_rebuilt_for_another_world() -> None:
    async with opened_pool(spares=0) as pool:
        first = await pool.acquire(WORLD)
        await first.release()
        second = await pool.acquire(OTHER_WORLD)
        assert second.pid == first.pid
        beginning = await begin(second, "echo", 1)
        assert beginning.observation["images"]["pattern"]["codec"] == "png"


async def test_a_released_handle_cannot_be_used() -> None:
    async with opened_pool(spares=0) as pool:
        handle = await pool.acquire(WORLD)
        await handle.release()
        await handle.release()
        handle.discard()
        assert (pool.busy, pool.idle) == (0, 1)
        with pytest.raises(SimulatorFault):
            await begin(handle, "count")


async def test_the_pool_lends_at_most_size_max() -> None:
    async with opened_pool(size_max=3) as pool:
        handles = await asyncio.gather(
            *(pool.acquire(WORLD) for _ in range(5)), return_exceptions=True
        )
        lent = [one for one in handles if isinstance(one, SimulatorHandle)]
        assert len(lent) == pool.busy == 3
        assert sum(isinstance(one, NoCapacity) for one in handles) == 2
        await lent[0].release()
        await pool.acquire(WORLD)


def fail(*_: object) -> None:
    raise OSError(errno.EMFILE, "Too many open files")


@pytest.mark.parametrize("module", ["socket.socketpair", "socket.send_fds"])
async def test_a_shortage_of_files_is_no_fault(
    module: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    async with opened_pool(spares=0) as pool:
        with monkeypatch.context() as patch:
            patch.setattr(module, fail)
            for _ in range(3):
                with pytest.raises(NoCapacity, match="Too many open files"):
                    await pool.acquire(WORLD)
        await begin(await pool.acquire(WORLD), "count")


async def test_memory_that_cannot_be_mapped_for_want_of_files_is_no_fault(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async with opened_pool(spares=0) as pool:
        monkeypatch.setattr(simulator_process, "map_memory", fail)
        handle = await pool.acquire(WORLD)
        await begin(handle, "count")
        pending = asyncio.create_task(handle.observe())
        await asyncio.sleep(0)
        handle._process._map_frame_memory(NewFrameMemory(1, 3, 64))
        with pytest.raises(NoCapacity, match="Too many open files"):
            await pending
        assert pool.busy == 0


async def test_spare_processes_are_started_and_replaced() -> None:
    async with opened_pool(spares=2) as pool:
        assert pool.idle == 0
        await wait_in_loop(lambda: pool.idle == 2, DEADLINE_S)
        await pool.acquire(WORLD)
        await wait_in_loop(lambda: pool.idle == 2, DEADLINE_S)


@fork_and_exec
async def test_a_crash_is_a_fault_and_frees_the_slot(fork: bool) -> None:
    async with opened_pool(size_max=1, fork=fork) as pool:
        handle = await pool.acquire(WORLD)
        await begin(handle, "fault")
        with pytest.raises(SimulatorFault, match="died"):
            await handle.play([action(), action(fault=1)], observe_all=False)
        assert pool.busy == 0
        await wait_in_loop(lambda: not exists(handle.pid), DEADLINE_S)
        with pytest.raises(SimulatorFault):
            await handle.observe()
        await handle.release()
        again = await pool.acquire(WORLD)
        await begin(again, "fault")


async def test_an_unplayable_task_differs_from_a_fault() -> None:
    async with opened_pool() as pool:
        handle = await pool.acquire(WORLD)
        with pytest.raises(TaskUnplayable):
            await begin(handle, "juggle")
        await begin(handle, "fault")
        with pytest.raises(TaskUnplayable, match="fault 2"):
            await handle.play([action(fault=2)], observe_all=False)
        await begin(handle, "count")


async def test_an_exception_in_the_simulator_is_a_fault() -> None:
    async with opened_pool() as pool:
        handle = await pool.acquire(WORLD)
        await begin(handle, "count")
        with pytest.raises(SimulatorFault, match="KeyError"):
            await handle.play([{"unheard_of": [1.0]}], observe_all=False)
        assert pool.busy == 0


async def test_a_world_that_cannot_be_built_is_a_fault() -> None:
    async with opened_pool() as pool:
        nowhere = benchmark_registry.SimulatorConfig("nowhere", {"codec": "raw"})
        with pytest.raises(SimulatorFault, match="nowhere"):
            await pool.acquire(nowhere)
        assert pool.busy == 0


@fork_and_exec
async def test_a_hung_process_is_killed_after_the_timeout(fork: bool) -> None:
    async with opened_pool(fork=fork) as pool:
        handle = await pool.acquire(WORLD)
        await begin(handle, "count")
        assert handle.pid is not None
        os.kill(handle.pid, signal.SIGSTOP)  # as deaf as a process can be
        handle._process._timeout_s = 1.0  # not of its start, which may be slower
        with pytest.raises(SimulatorFault, match="no step for"):
            await handle.play([action()], observe_all=False)
        await wait_in_loop(lambda: not exists(handle.pid), DEADLINE_S)


@pytest.mark.slow("simulates for five seconds")
async def test_a_slow_chunk_that_makes_steps_does_not_time_out() -> None:
    async with opened_pool(turn_timeout_s=5.0) as pool:
        handle = await pool.acquire(WORLD)
        await begin(handle, "delay")
        played = await handle.play([action(delay_s=0.6)] * 9, observe_all=False)
        assert played.executed == 9


@fork_and_exec
async def test_discarding_ends_a_running_play(fork: bool) -> None:
    async with opened_pool(fork=fork) as pool:
        handle = await pool.acquire(WORLD)
        await begin(handle, "delay")
        play = handle.play([action(delay_s=5)] * 9, observe_all=False)
        playing = asyncio.create_task(play)
        await asyncio.sleep(0)
        handle.discard()
        assert pool.busy == 0
        with pytest.raises(SimulatorFault, match="discarded"):
            await playing
        await wait_in_loop(lambda: not exists(handle.pid), DEADLINE_S)


async def test_a_cancelled_play_ends_its_process() -> None:
    async with opened_pool() as pool:
        handle = await pool.acquire(WORLD)
        await begin(handle, "delay")
        play = handle.play([action(delay_s=5)], observe_all=False)
        with pytest.raises(asyncio.TimeoutError):
            await asyncio.wait_for(play, 0.05)
        await wait_in_loop(lambda: not exists(handle.pid), DEADLINE_S)
        assert pool.busy == 0


async def test_a_long_turn_delays_no_other_simulator() -> None:
    async with opened_pool() as pool:
        slow, quick = await pool.acquire(WORLD), await pool.acquire(WORLD)
        await begin(slow, "delay")
        await begin(quick, "count", max_steps=1000)
        assert slow.pid is not None
        os.kill(slow.pid, signal.SIGSTOP)  # as long as the other one plays
        playing = asyncio.create_task(slow.play([action()], observe_all=False))
        for _ in range(20):
            await quick.play([action()], observe_all=False)
        assert not playing.done()
        os.kill(slow.pid, signal.SIGCONT)
        await playing


@pytest.mark.skipif(sys.platform != "linux", reason="forks on Linux only")
async def test_a_dead_fork_server_is_replaced() -> None:
    async with opened_pool(fork=True) as pool:
        handle = await pool.acquire(WORLD)
        await begin(handle, "count")
        assert isinstance(pool._starter, ForkStarter)
        assert pool._starter.fork_server_pid is not None
        os.kill(pool._starter.fork_server_pid, signal.SIGKILL)
        await wait_in_loop(lambda: not exists(handle.pid), DEADLINE_S)
        with pytest.raises(SimulatorFault):
            await handle.observe()
        await begin(await pool.acquire(WORLD), "count")


async def test_a_closed_pool_lends_nothing() -> None:
    pool = SimulatorPool()
    await pool.start()
    await pool.close()
    with pytest.raises(SimulatorFault):
        await pool.acquire(WORLD)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGHUP, signal.SIGUSR1])
async def test_simulators_ignore_signals_of_their_group(number: int) -> None:
    async with opened_pool() as pool:
        handle = await pool.acquire(WORLD)
        assert handle.pid is not None
        os.kill(handle.pid, number)
        await begin(handle, "count")
