"""Simulators in the place of the pool's processes: each step has an effect once.

The first number of an action's `vector` names the action; the world notes what it did.
The episode is that of the task `score`: it has the score of its last action, and ends
when the action says so or after the last step.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from reference_sim.process.observation_encoding import EncodedObservation
from reference_sim.process.pool import (
    Begin,
    ChunkReply,
    EpisodeStart,
    NoCapacity,
    SimulatorFault,
    Timing,
)
from tests.simulation.world import Executed, Life, World

STEP_S = 0.05
_NO_TIME = Timing(0.0, 0.0, 0.0)


class MemorySimulator:
    """Stands for a SimulatorHandle."""

    def __init__(self, pool: MemoryPool, world: World, life: Life) -> None:
        self._pool, self._world, self._life = pool, world, life
        self._is_lent = True
        self._playing, self._steps, self._steps_max = 0, 0, 0

    async def begin(self, begin: Begin) -> EpisodeStart:
        await self._work()
        self._playing = len(self._world.steps_of_playing) + 1
        self._world.steps_of_playing[self._playing] = 0
        self._steps, self._steps_max = 0, begin.max_steps
        return EpisodeStart("", self._observation(), _NO_TIME)

    async def play(
        self,
        actions: Sequence[Mapping[str, Sequence[float]]],
        *,
        observe_all: bool,
        **_: Any,
    ) -> ChunkReply:
        await self._work()
        rewards: list[float] = []
        ended, score = False, 0.0
        for action in actions:
            self._steps += 1
            self._world.steps_of_playing[self._playing] = self._steps
            rewards.append(action["vector"][0])
            score = action["score"][0]
            ended = action["end"][0] >= 0.5 or self._steps >= self._steps_max
            executed = self._world.executed.setdefault(int(action["vector"][0]), [])
            executed.append(Executed(self._playing, score, ended))
            if ended:
                break
        await self._work()
        seen = self._observation()
        return ChunkReply(
            executed=len(rewards),
            rewards=rewards,
            ended=ended,
            terminated=ended and self._steps < self._steps_max,
            truncated=ended and self._steps >= self._steps_max,
            success=score >= 0.5,
            score=score,
            steps=self._steps,
            observation=None if ended else seen,
            observations=[seen] * len(rewards) if observe_all else None,
            timing=_NO_TIME,
        )

    async def observe(self) -> EncodedObservation:
        await self._work()
        return self._observation()

    async def _work(self) -> None:
        world = self._world
        await world.delay(STEP_S)
        await self._life.check()
        if not self._is_lent:
            raise SimulatorFault("the simulator was discarded")
        if world.happens(world.chances.simulator_breaks):
            self.discard()
            raise SimulatorFault("the simulator broke")

    def _observation(self) -> EncodedObservation:
        state = {"count": [float(self._steps)]}
        return {"state": state, "images": {}, "tensors": {}}

    async def release(self) -> None:
        self.discard()

    def discard(self) -> None:
        if self._is_lent:
            self._is_lent = False
            self._pool.busy -= 1


class MemoryPool:
    """Stands for a SimulatorPool. busy: simulators lent, or about to be."""

    def __init__(self, world: World, life: Life, size_max: int) -> None:
        self._world, self._life, self._size_max = world, life, size_max
        self.busy = 0

    def is_full_for(self, _config: object) -> bool:
        return self.busy >= self._size_max

    def makes_room(self, _lent: object, _config: object) -> bool:
        return True

    async def acquire(self, config: object) -> MemorySimulator:
        world = self._world
        if self.is_full_for(config) or world.happens(world.chances.no_capacity):
            raise NoCapacity("all simulators are in use")
        self.busy += 1
        simulator = MemorySimulator(self, world, self._life)
        await world.delay(STEP_S)
        await self._life.check()
        return simulator
