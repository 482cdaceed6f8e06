"""The client process of every contender: plays turns on command.

Commands are lines on stdin, results are lines of JSON on stdout:

    ready     it has connected and received its first observation
    play N    N turns, each from the action as floats to the observation as arrays:
              {"ns": [one for each], "cpu_ns": of all}
    check N   the same, every pixel compared

After each turn both clocks are stopped and the observation is checked. The clients
differ only in `connect`, which returns a function from an action to state and images.
"""

from __future__ import annotations

import gc
import json
import sys
from collections.abc import Callable, Mapping
from time import perf_counter_ns, process_time_ns
from typing import Any

from benchmarks.round_trips.observations import ObservationChecker, Vector, action

ObservationParts = tuple[Mapping[str, Vector], Mapping[str, Any]]
Turn = Callable[[list[float]], ObservationParts]


class TurnClient:
    """unpack: makes an array of an image that the turn leaves as a file, off the clock.
    exact: false where images are compressed and come out a little different.
    """

    def __init__(
        self,
        turn: Turn,
        scenario: str,
        *,
        unpack: Callable[[Any], Any] | None = None,
        exact: bool = True,
    ) -> None:
        self._turn = turn
        self._checker = ObservationChecker(scenario)
        self._unpack = unpack
        self._exact = exact
        self._number = 0

    def play(self, turns: int, *, whole: bool = False) -> tuple[list[int], int]:
        """Nanoseconds of each, and of CPU of all together."""
        took, computed = [], 0
        for _ in range(turns):
            self._number += 1
            sent = action(self._number)
            computed -= process_time_ns()
            started = perf_counter_ns()
            state, images = self._turn(sent)
            took.append(perf_counter_ns() - started)
            computed += process_time_ns()
            if self._unpack is not None:
                images = {name: self._unpack(one) for name, one in images.items()}
            self._checker.check(sent, state, images, whole=whole, exact=self._exact)
        return took, computed


def main(connect: Callable[[str, str], Turn]) -> None:
    """`python -m … ADDRESS SCENARIO`: until stdin ends."""
    address, scenario = sys.argv[1:3]
    serve(TurnClient(connect(address, scenario), scenario))


def serve(player: TurnClient) -> None:
    player.play(1, whole=True)
    gc.collect()
    gc.freeze()
    _say("ready")
    for line in sys.stdin:
        word, count = line.split()
        took, computed = player.play(int(count), whole=word == "check")
        _say(json.dumps({"ns": took, "cpu_ns": computed}))


def _say(line: str) -> None:
    sys.stdout.write(line + "\n")
    sys.stdout.flush()
