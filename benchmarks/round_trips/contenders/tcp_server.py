"""The physical limit: the bytes of an observation for the bytes of an action.

One connection, no protocol: both sides know every size beforehand.
"""

from __future__ import annotations

import socket
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.round_trips.observations import ScenarioPlayer, action


def main() -> None:
    world = ScenarioPlayer(sys.argv[1])
    with socket.create_server(("127.0.0.1", 0)) as listener:
        print(f"ready 127.0.0.1:{listener.getsockname()[1]}", flush=True)
        while True:
            serve(listener.accept()[0], world)


def serve(connection: socket.socket, world: ScenarioPlayer) -> None:
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    size = np.array(action(0)).nbytes
    while request := connection.recv(size, socket.MSG_WAITALL):
        state, images = world.turn(np.frombuffer(request))
        arrays: list[NDArray[Any]] = [*state.values(), *images.values()]
        parts = [array.data.cast("B") for array in arrays]
        left = sum(part.nbytes for part in parts)
        while left := left - connection.sendmsg(parts):
            parts = _behind(parts, sum(part.nbytes for part in parts) - left)


def _behind(parts: list[memoryview], sent: int) -> list[memoryview]:
    """What is left when some bytes are gone."""
    while sent >= parts[0].nbytes:
        sent -= parts.pop(0).nbytes
    return [parts[0][sent:], *parts[1:]]


if __name__ == "__main__":
    main()
