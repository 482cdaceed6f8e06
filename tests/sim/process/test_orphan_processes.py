"""No simulator process outlives the server, however the server ends."""

import os
import signal
import subprocess
import sys

import pytest

from tests.support.processes import is_alive, wait_until_ended

pytestmark = pytest.mark.slow("starts interpreters")

SERVER = """
import asyncio, os, signal, sys
from reference_sim import benchmark_registry
from reference_sim.process.pool import Begin, SimulatorPool

async def main():
    pool = SimulatorPool(fork=sys.argv[1] == "True")
    world = benchmark_registry.resolve("calibration").world
    names = ("score", "success", "end", "fault")
    action = {name: [0.0] for name in names} | {"delay_s": [5.0]}
    action |= {"vector": [0.0] * 8, "clipped": [0.0] * 2}
    busy, deaf, waiting = [await pool.acquire(world) for _ in range(3)]
    await busy.begin(Begin("delay", 1, max_steps=99, success_rule="any_step"))
    playing = asyncio.create_task(busy.play([action] * 64, observe_all=False))
    await waiting.begin(Begin("count", 1, max_steps=9, success_rule="any_step"))
    if sys.argv[1] == "True":
        os.kill(deaf.pid, signal.SIGSTOP)
        print(pool._starter.fork_server_pid, end=" ")
    print(busy.pid, waiting.pid, deaf.pid, flush=True)
    await playing

asyncio.run(main())
"""


@pytest.mark.parametrize("fork", [True, False], ids=["fork", "exec"])
def test_no_process_outlives_a_server_that_was_killed(fork: bool) -> None:
    """One is busy, one waits, and one is stopped: it cannot even see its parent end."""
    with subprocess.Popen(
        [sys.executable, "-c", SERVER, str(fork)], stdout=subprocess.PIPE, text=True
    ) as server:
        assert server.stdout is not None
        pids = [int(pid) for pid in server.stdout.readline().split()]
        assert len(pids) == 3 + fork
        assert all(is_alive(pid) for pid in pids)
        server.kill()
    wait_until_ended(set(pids))


@pytest.mark.skipif(sys.platform != "linux", reason="forks on Linux only")
def test_no_process_outlives_a_fork_server_and_a_server_killed_together() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", SERVER, "True"], stdout=subprocess.PIPE, text=True
    ) as server:
        assert server.stdout is not None
        pids = [int(pid) for pid in server.stdout.readline().split()]
        server.send_signal(signal.SIGSTOP)
        os.kill(pids[0], signal.SIGKILL)
        server.kill()
    wait_until_ended(set(pids))
