"""`python -m tools.local_cluster`: a cluster of this machine, behind one address.

Starts several reference servers over one database and a load balancer without affinity,
which leaves out a node that is not ready: kill one and the others go on. The address
and the port of the balancer, the tokens and the database are the settings of a server
(PROCTOR_HOST, PROCTOR_PORT, PROCTOR_TOKENS, PROCTOR_DATABASE), so that the kit can
start it: `make conformance` with ARGS="--start-cmd 'python -m tools.local_cluster'".
It shows how nodes are put together; a real cluster has its balancer and its supervisor.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import os
import signal
import sys

from tools.local_cluster.balancer import Balancer

HOST = os.environ.get("PROCTOR_HOST", "127.0.0.1")
PORT = int(os.environ.get("PROCTOR_PORT", "8460"))
# Nodes listen behind the balancer's port, so that a restart finds the same addresses.
START_NODE = (sys.executable, "-m", "reference_server")


async def start_node(port: int) -> tuple[asyncio.subprocess.Process, str]:
    """One server that accepts requests on a port, and its line about the token.

    The line is empty where tokens are given.
    """
    settings = {
        "PROCTOR_CLUSTER": "on",
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
    """Until all nodes have ended, or a signal."""
    ports = [PORT + 1 + number for number in range(size)]
    # One after another: the first one makes the database and the keys beside it.
    started = [await start_node(port) for port in ports]
    nodes = [node for node, _ in started]
    ended = [asyncio.ensure_future(node.wait()) for node in nodes]
    stopped = asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, stopped.set)
    balancer = Balancer(ports)
    async with await balancer.listen(HOST, PORT):
        lines = [
            f"A cluster of {size} nodes is listening at http://{HOST}:{PORT}",
            started[0][1],
            f"nodes: {', '.join(f'http://{HOST}:{port}' for port in ports)}",
        ]
        # In one write, also into a file or a pipe: a reader gets all lines or none.
        print("\n".join(filter(None, lines)), flush=True)

        stopping = asyncio.ensure_future(stopped.wait())
        all_ended = asyncio.ensure_future(asyncio.wait(ended))
        first = asyncio.FIRST_COMPLETED
        await asyncio.wait({all_ended, stopping}, return_when=first)
        stopping.cancel()
    for node in nodes:
        with contextlib.suppress(ProcessLookupError):
            node.terminate()
    await all_ended
    await balancer.close()  # only now: they complete their answers


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--nodes", type=int, default=2, metavar="N")
    asyncio.run(serve(parser.parse_args().nodes))


if __name__ == "__main__":
    main()
