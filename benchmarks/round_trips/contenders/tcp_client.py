"""The physical limit, from the client's side: see tcp_server."""

from __future__ import annotations

import socket
from math import prod

import numpy as np

from benchmarks.round_trips.contenders import turn_client
from benchmarks.round_trips.observations import SCENARIOS, STATE_SIZES


def connect(address: str, scenario: str) -> turn_client.Turn:
    host, _, port = address.partition(":")
    connection = socket.create_connection((host, int(port)))
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    shown = SCENARIOS[scenario]
    shape = (shown.height, shown.width, 3)
    state_bytes, image_bytes = 8 * sum(STATE_SIZES.values()), prod(shape)
    buffer = bytearray(state_bytes + image_bytes * len(shown.cameras))
    whole = memoryview(buffer)

    def turn(action: list[float]) -> turn_client.ObservationParts:
        connection.sendall(np.array(action).data)
        got = 0
        while got < len(buffer):
            got += connection.recv_into(whole[got:])
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


if __name__ == "__main__":
    turn_client.main(connect)
