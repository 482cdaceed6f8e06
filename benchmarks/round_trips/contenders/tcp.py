"""The physical limit: the bytes of an observation for the bytes of an action.

One connection, no protocol: both sides know every size beforehand.
"""

import socket
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.round_trips.contender_process import ObservationParts, Turn
from benchmarks.round_trips.observations import (
    SCENARIOS,
    STATE_SIZES,
    ScenarioPlayer,
    action,
)


def serve(scenario: str) -> None:
    world = ScenarioPlayer(scenario)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        print(f"ready 127.0.0.1:{listener.getsockname()[1]}", flush=True)
        while True:
            _serve_connection(listener.accept()[0], world)


def _serve_connection(connection: socket.socket, world: ScenarioPlayer) -> None:
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    if hasattr(socket, "TCP_CONGESTION"):  # as the server has it on loopback
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_CONGESTION, b"reno")
    size = np.array(action(0)).nbytes
    while request := connection.recv(size, socket.MSG_WAITALL):
        state, images = world.turn(np.frombuffer(request))
        arrays: list[NDArray[Any]] = [*state.values(), *images.values()]
        parts = [array.data.cast("B") for array in arrays]
        left = sum(part.nbytes for part in parts)
        while left := left - connection.sendmsg(parts):
            parts = _unsent(parts, sum(part.nbytes for part in parts) - left)


def _unsent(parts: list[memoryview], sent: int) -> list[memoryview]:
    while sent >= parts[0].nbytes:
        sent -= parts.pop(0).nbytes
    return [parts[0][sent:], *parts[1:]]


def connect(address: str, scenario: str) -> Turn:
    host, _, port = address.partition(":")
    connection = socket.create_connection((host, int(port)))
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    shown = SCENARIOS[scenario]
    shape = (shown.height, shown.width, 3)
    state_bytes, image_bytes = 8 * sum(STATE_SIZES.values()), prod(shape)
    buffer = bytearray(state_bytes + image_bytes * len(shown.cameras))
    whole = memoryview(buffer)

    def turn(action: list[float]) -> ObservationParts:
        connection.sendall(np.array(action).data)
        filled = 0
        while filled < len(buffer):
            filled += connection.recv_into(whole[filled:])
        state, at = {}, 0
        for name, size in STATE_SIZES.items():
            state[name] = np.frombuffer(buffer, np.float64, size, at)
            at += 8 * size
        images = {}
        for name in shown.cameras:
            images[name] = np.frombuffer(buffer, np.uint8, image_bytes, at)
            images[name] = images[name].reshape(shape)
            at += image_bytes
        return state, images

    return turn
