"""The two processes of every contender: a server, and a client that plays on command.

`python -m … serve NAME SCENARIO` serves until it is ended. `… play NAME ADDRESS
SCENARIO [MEDIA CODEC]` reads commands from stdin and answers in lines of JSON:

    ready     it has connected and received its first observation
    play N    N turns, each from the action as floats to the observation as arrays:
              {"ns": [one for each], "cpu_ns": of all}
    check N   the same, every pixel compared

After each turn both clocks are stopped and the observation is checked. A contender is a
module of contenders/ with `serve` and `connect`, which returns a function from an
action to state and images.
"""

import gc
import importlib
import json
import socket
import sys
from collections.abc import Callable, Mapping
from time import perf_counter_ns, process_time_ns
from typing import Any, Protocol

from benchmarks.round_trips.observations import ObservationChecker, Vector, action

ObservationParts = tuple[Mapping[str, Vector], Mapping[str, Any]]
Turn = Callable[[list[float]], ObservationParts]


class Player(Protocol):
    """A client that plays on command."""

    def play(self, turns: int, *, whole: bool = False) -> tuple[list[int], int]:
        """Nanoseconds of each turn, and of CPU of all together."""


class TurnClient:
    """A client that plays turns and checks them.

    unpack: makes an array of an image that the turn leaves as a file, off the clock.
    is_exact: false where images are compressed and come out a little different.
    """

    def __init__(
        self,
        turn: Turn,
        scenario: str,
        *,
        unpack: Callable[[Any], Any] | None = None,
        is_exact: bool = True,
    ) -> None:
        self._turn = turn
        self._checker = ObservationChecker(scenario)
        self._unpack = unpack
        self._is_exact = is_exact
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
                images = {name: self._unpack(file) for name, file in images.items()}
            self._checker.check(sent, state, images, whole=whole, exact=self._is_exact)
        return took, computed


def answer_commands(player: Player) -> None:
    """Play what stdin says, until it ends."""
    player.play(1, whole=True)
    gc.collect()
    gc.freeze()
    print("ready", flush=True)
    for line in sys.stdin:
        word, count = line.split()
        took, computed = player.play(int(count), whole=word == "check")
        print(json.dumps({"ns": took, "cpu_ns": computed}), flush=True)


def listen() -> socket.socket:
    """A socket for a server that is given one; its address is printed."""
    # The protocol is named, or asyncio leaves out TCP_NODELAY and 40 ms are lost.
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.bind(("127.0.0.1", 0))
    print(f"ready 127.0.0.1:{listener.getsockname()[1]}", flush=True)
    return listener


def main() -> None:
    """Serve or play."""
    role, name, *arguments = sys.argv[1:]
    module: Any = importlib.import_module(f"benchmarks.round_trips.contenders.{name}")
    if role == "serve":
        module.serve(*arguments)
        return
    scenario, codec = arguments[1], arguments[-1]
    answer_commands(
        TurnClient(
            module.connect(*arguments),
            scenario,
            unpack=module.decompressed if codec == "jpeg-files" else None,
            is_exact=not codec.startswith("jpeg"),
        )
    )


if __name__ == "__main__":
    main()
