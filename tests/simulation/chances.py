"""What may go wrong in a schedule, and how often."""

from __future__ import annotations

import random
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Chances:
    """Probabilities of each event. kills: how often the server is killed at most."""

    request_lost: float = 0.0
    answer_lost: float = 0.0
    request_repeated: float = 0.0
    write_fails: float = 0.0
    write_in_doubt: float = 0.0
    killed_at_write: float = 0.0
    simulator_breaks: float = 0.0
    no_capacity: float = 0.0
    worker_pauses: float = 0.0
    kills: int = 0

    @classmethod
    def draw(cls, chance: random.Random) -> Chances:
        """Some schedules are quiet in some respects, so that others come through."""

        def at_most(most: float) -> float:
            return chance.choice((0.0, most / 4, most))

        return cls(
            request_lost=at_most(0.1),
            answer_lost=at_most(0.2),
            request_repeated=at_most(0.2),
            write_fails=at_most(0.05),
            write_in_doubt=at_most(0.1),
            killed_at_write=at_most(0.05),
            simulator_breaks=at_most(0.05),
            no_capacity=at_most(0.1),
            worker_pauses=at_most(0.05),
            kills=chance.choice((0, 1, 3)),
        )


CALM = Chances()
