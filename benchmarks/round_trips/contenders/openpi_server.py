"""openpi's way, as its policy server does it: observation up, action down.

The server is not on the package index; this one does what it does: `websockets` without
compression, a first message of metadata, then each message unpacked and answered by
openpi-client's own packer.
"""

from __future__ import annotations

import asyncio
import contextlib
import sys

import numpy as np
from openpi_client import msgpack_numpy
from websockets.asyncio.server import ServerConnection, serve
from websockets.exceptions import ConnectionClosed

from benchmarks.round_trips.observations import action


async def answer(connection: ServerConnection) -> None:
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


async def main() -> None:
    async with serve(answer, "127.0.0.1", 0, compression=None, max_size=None) as server:
        port = next(iter(server.sockets)).getsockname()[1]
        print(f"ready 127.0.0.1:{port}", flush=True)
        await server.serve_forever()


if __name__ == "__main__":
    sys.exit(asyncio.run(main()))
