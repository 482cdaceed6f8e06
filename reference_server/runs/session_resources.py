"""What sessions hold besides their state: a simulator, a task, a look at their lease.

It lends simulators to sessions and takes them back, and knows when a lease could be
over. It decides nothing, plays nothing and answers nobody: that is `stage.py`.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Awaitable, Callable, Iterable
from dataclasses import dataclass
from typing import Any

from reference_server.rules.lifecycle import lease_over
from reference_server.rules.run import Run, Session
from reference_server.runs.benchmarks import world_of
from reference_sim.process.pool import SimulatorHandle, SimulatorPool


@dataclass(slots=True, eq=False)
class Scene:
    """One session's; keeps its run in memory.

    handle: its simulator, while it plays an episode. task: the work in execution, or
    the last one. fault: what broke in the turn in execution, schema Fault.
    """

    run: Run
    session: Session
    handle: SimulatorHandle | None = None
    task: asyncio.Task[dict[str, Any]] | None = None
    timer: asyncio.TimerHandle | None = None
    fault: dict[str, Any] | None = None


class Scenes:
    """The scene of every session that has not ended; without one nothing is held.

    begin: does work that nobody waits for.
    over: is called with the run of a session whose lease is over.
    """

    def __init__(
        self,
        pool: SimulatorPool,
        begin: Callable[[Awaitable[None]], object],
        over: Callable[[Run], object],
    ) -> None:
        self._pool = pool
        self._begin = begin
        self._over = over
        self._scenes: dict[Session, Scene] = {}

    def __len__(self) -> int:
        return len(self._scenes)

    def of(self, session: Session) -> Scene | None:
        return self._scenes.get(session)

    def open(self, run: Run, session: Session, before: Session | None) -> Scene:
        """The scene of a new session; the simulator of the one before goes over."""
        scene = Scene(run, session)
        left = None if before is None else self._leave(before)
        if left is not None:
            scene.handle = left.handle
        self._scenes[session] = scene
        self._watch(scene)
        return scene

    def let_go(self, sessions: Iterable[Session]) -> None:
        """Free what ended sessions hold; a simulator in execution is killed."""
        for session in sessions:
            scene = self._leave(session)
            if scene is not None:
                self.free(scene, kill=session.busy is not None)

    def forget(self, run: Run | None = None) -> None:
        """End the sessions of a run, or all, without counting anything."""
        sessions = [
            session
            for session, scene in self._scenes.items()
            if run is None or scene.run is run
        ]
        for session in sessions:
            self._scenes[session].run.remember_end(session, "unknown")
        self.let_go(sessions)

    async def lend(self, scene: Scene) -> float:
        """Give the scene a simulator for its run, unless it has one.

        Returns the seconds that this took. Its session may have ended meanwhile; then
        it has none. Raises NoCapacity, SimulatorFault and TaskUnplayable.
        """
        if scene.handle is not None:
            return 0.0
        started = time.perf_counter()
        scene.handle = await self._pool.acquire(world_of(scene.run))
        if scene.session.ended_by is not None:
            self.free(scene, kill=False)
        return time.perf_counter() - started

    def free(self, scene: Scene, *, kill: bool) -> None:
        """Take back the simulator, if there is one: to serve others, or to be ended."""
        handle, scene.handle = scene.handle, None
        if handle is None:
            return
        if kill:
            handle.discard()
        else:
            self._begin(handle.release())

    def _leave(self, session: Session) -> Scene | None:
        scene = self._scenes.pop(session, None)
        if scene is not None and scene.timer is not None:
            scene.timer.cancel()
        return scene

    def _watch(self, scene: Scene) -> None:
        """Look at the lease when it could be over; one timer per session."""
        now = time.monotonic()
        if lease_over(scene.session, now):
            self._over(scene.run)
            return
        wait_s = scene.session.expires_at - now
        if wait_s <= 0:  # busy beyond its lease, or at its very end
            wait_s = 0.05
        loop = asyncio.get_running_loop()
        scene.timer = loop.call_later(wait_s + 0.001, self._watch, scene)
