"""Simulators of a pool's own kind, forked by one fork server for each test process.

To start a fork server costs a third of a second of a processor, to fork a simulator a
few milliseconds. A test of the fork server itself takes a `SimulatorPool`.
"""

import atexit
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from reference_sim.process.pool import FORK_IS_SAFE, SimulatorPool
from reference_sim.process.simulator_process import ForkStarter, wait_or_kill


class _SharedForkServer(ForkStarter):
    async def close(self) -> None:
        """Leave it to the next pool: a pool that is closed kills what it started."""

    def end(self) -> None:
        self._disconnect_fork_server()
        for fork_server in self._fork_servers:
            wait_or_kill(fork_server)


_SHARED = _SharedForkServer()
atexit.register(_SHARED.end)


def shared_pool(
    size_max: int = 64, spares: int = 2, turn_timeout_s: float = 60.0
) -> SimulatorPool:
    """A pool that starts its processes as any other, but for their fork server."""
    pool = SimulatorPool(size_max, spares, turn_timeout_s)
    if FORK_IS_SAFE:
        pool._starter = _SHARED
    return pool


@asynccontextmanager
async def opened_pool(**settings: Any) -> AsyncIterator[SimulatorPool]:
    """Such a pool, which is started, and closed at the end; it has no spares."""
    pool = shared_pool(**{"spares": 0} | settings)
    await pool.start()
    try:
        yield pool
    finally:
        await pool.close()
