"""What outlives a server in a schedule, and how a server ends.

The chances are drawn from one generator, so that a seed repeats them all.
"""

from __future__ import annotations

import asyncio
import random
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from tests.simulation.chances import CALM, Chances


@dataclass(slots=True)
class Executed:
    """What one action did: in which playing of an episode, and the score it left."""

    playing: int
    score: float
    ended: bool


@dataclass(slots=True)
class World:
    """chance: every draw. executed: by the number that each action carries."""

    chance: random.Random
    chances: Chances
    executed: dict[int, list[Executed]] = field(default_factory=dict)
    steps_of_playing: dict[int, int] = field(default_factory=dict)
    kill: Callable[[], None] = lambda: None

    def happens(self, probability: float) -> bool:
        return self.chance.random() < probability

    def calm_down(self) -> None:
        """From now on nothing goes wrong."""
        self.chances = CALM

    async def delay(self, most_s: float) -> None:
        await asyncio.sleep(self.chance.random() * most_s)


class Life:
    """One server process: what it began after its end has no effect outside."""

    def __init__(self) -> None:
        self.tasks: set[asyncio.Task[Any]] = set()
        self.ended: asyncio.Event = asyncio.Event()

    @property
    def is_over(self) -> bool:
        return self.ended.is_set()

    def end(self) -> None:
        self.ended.set()

    async def check(self) -> None:
        """Stops for ever what belongs to a server that was killed."""
        if self.is_over:
            await asyncio.get_running_loop().create_future()
