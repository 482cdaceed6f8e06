"""Which waiting trial a cell takes next: blocks, randomised by a committed seed.

A block has each waiting run once, in an order that the seed and the number of the block
give; so no policy is always the first one after a change of light, gripper or operator.
Pure.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence

# A run, and how many trials of it have been taken.
Waiting = tuple[str, int]


def next_run(waiting: Sequence[Waiting], order_seed: int) -> int:
    """The place in `waiting` of the run to take (PHY-020)."""

    def place(number: int) -> tuple[int, str, int]:
        run_id, taken = waiting[number]
        name = f"{order_seed}/{taken}/{run_id}"
        return taken, hashlib.sha256(name.encode()).hexdigest(), number

    return min(range(len(waiting)), key=place)
