"""openpi's way, with the real client: observation up, action down.

The server is not on the package index; this one does what it does: `websockets` without
compression, a first message of metadata, then each message unpacked and answered by
openpi-client's own packer. The client sends what others receive, so what is judged is
that the answer belongs to what was sent.
"""

import asyncio
import contextlib

import numpy as np
from openpi_client import msgpack_numpy
from openpi_client.websocket_client_policy import WebsocketClientPolicy
from websockets.asyncio.server import ServerConnection
from websockets.asyncio.server import serve as serve_websocket
from websockets.exceptions import ConnectionClosed

from benchmarks.round_trips.contender_process import ObservationParts, Turn
from benchmarks.round_trips.observations import ScenarioPlayer, action


async def _answer(connection: ServerConnection) -> None:
    packer = msgpack_numpy.Packer()
    await connection.send(packer.pack({}))
    number = 0
    with contextlib.suppress(ConnectionClosed):
        async for message in connection:
            observation = msgpack_numpy.unpackb(message)
            number += 1
            actions = np.array(action(number))
            echo = observation["state"]["base"][0]
            await connection.send(packer.pack({"actions": actions, "step": echo}))


async def _serve() -> None:
    async with serve_websocket(
        _answer, "127.0.0.1", 0, compression=None, max_size=None
    ) as server:
        port = next(iter(server.sockets)).getsockname()[1]
        print(f"ready 127.0.0.1:{port}", flush=True)
        await server.serve_forever()


def serve(_scenario: str) -> None:
    asyncio.run(_serve())


def connect(address: str, scenario: str) -> Turn:
    host, _, port = address.partition(":")
    policy = WebsocketClientPolicy(host, int(port))
    world = ScenarioPlayer(scenario)

    def turn(action: list[float]) -> ObservationParts:
        state, images = world.turn(action)
        answer = policy.infer({"state": state, "images": images})
        assert answer["step"] == state["base"][0]
        assert answer["actions"].shape == (len(action),)
        return state, images

    return turn
