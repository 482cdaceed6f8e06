"""`python -m tools.local_cluster`: a cluster of this machine, behind one address.

Starts several reference servers over one database and a load balancer without affinity:
each connection goes to the next of them, and is passed on byte for byte. The address
and the port of the balancer, the tokens and the database are the settings of a server
(PROCTOR_HOST, PROCTOR_PORT, PROCTOR_TOKENS, PROCTOR_DATABASE), so that the kit can
start it: `make conformance` with ARGS="--start-cmd 'python -m tools.local_cluster'".
It shows how nodes are put together; a real cluster has its balancer and its supervisor.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import itertools
import os
import signal
import sys
from collections.abc import Sequence

BLOCK_BYTES = 2**16
HOST = os.environ.get("PROCTOR_HOST", "127.0.0.1")
PORT = int(os.environ.get("PROCTOR_PORT", "8460"))
# Nodes listen behind the balancer's port, so that a restart finds the same addresses.
START_NODE = (sys.executable, "-m", "reference_server")


async def copy(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    """Until the sender is done; its end is passed on, too."""
    try:
        while block := await reader.read(BLOCK_BYTES):
            writer.write(block)
            await writer.drain()
        if writer.can_write_eof():
            writer.write_eof()
    except OSError:
        writer.transport.abort()


async def balance(host: str, port: int, ports: Sequence[int]) -> asyncio.Server:
    """Pass the connections of a port on to others of this machine, in turn."""
    targets = itertools.cycle(ports)
    # asyncio alone drops who waits for one side when the other one has left.
    in_use: set[asyncio.StreamWriter] = set()

    async def connect(
        reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        for _ in ports:  # one that is down is left out
            with contextlib.suppress(OSError):
                there = await asyncio.open_connection(HOST, next(targets))
                break
        else:
            writer.transport.abort()
            return
        both = {writer, there[1]}
        in_use.update(both)
        await asyncio.gather(copy(reader, there[1]), copy(there[0], writer))
        in_use.difference_update(both)
        for one in both:
            one.close()

    return await asyncio.start_server(connect, host, port)


async def start_node(port: int) -> tuple[asyncio.subprocess.Process, str]:
    """One server that accepts requests on a port, and its line about the token.

    The line is empty where tokens are given.
    """
    settings = {
        "PROCTOR_CLUSTER": "on",
        "PROCTOR_RECORDINGS": "off",
        "PROCTOR_PORT": str(port),
    }
    node = await asyncio.create_subprocess_exec(
        *START_NODE, env=os.environ | settings, stdout=asyncio.subprocess.PIPE
    )
    assert node.stdout is not None
    if not await node.stdout.readline():
        raise SystemExit(f"the node at port {port} did not start")
    line = (await node.stdout.readline()).decode().strip()
    return node, line if line.startswith("token:") else ""


async def serve(size: int) -> None:
    """Until the first node ends, or a signal."""
    ports = [PORT + 1 + number for number in range(size)]
    # One after another: the first one makes the database and the keys beside it.
    started = [await start_node(port) for port in ports]
    nodes = [node for node, _ in started]
    ended = [asyncio.ensure_future(node.wait()) for node in nodes]
    stopped = asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, stopped.set)
    async with await balance(HOST, PORT, ports):
        lines = [
            f"A cluster of {size} nodes is listening at http://{HOST}:{PORT}",
            started[0][1],
            f"nodes: {', '.join(f'http://{HOST}:{port}' for port in ports)}",
        ]
        # At once, also into a file or a pipe.
        print(*filter(None, lines), sep="\n", flush=True)

        stopping = asyncio.ensure_future(stopped.wait())
        await asyncio.wait([*ended, stopping], return_when=asyncio.FIRST_COMPLETED)
        stopping.cancel()
    for node in nodes:
        with contextlib.suppress(ProcessLookupError):
            node.terminate()
    await asyncio.wait(ended)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--nodes", type=int, default=2, metavar="N")
    asyncio.run(serve(parser.parse_args().nodes))


if __name__ == "__main__":
    main()
