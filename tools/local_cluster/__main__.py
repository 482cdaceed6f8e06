"""`python -m tools.local_cluster`: a cluster of this machine, behind one address.

Starts several reference servers over one database and a load balancer without affinity,
which leaves out a node that is not ready: kill one and the others go on. With options,
which `make cluster` gives, a PostgreSQL and a Ray cluster of its own are started, too.
The address and the port of the balancer, the tokens and the database are the settings
of a server (PROCTOR_HOST, PROCTOR_PORT, PROCTOR_TOKENS, PROCTOR_DATABASE), so that the
kit can start it: `make conformance` with ARGS="--start-cmd 'python -m
tools.local_cluster'". It shows how nodes are put together; a real cluster has its
balancer and its supervisor.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import os
import signal
import sys
from pathlib import Path
from typing import Any

from tools.local_cluster.cluster_parts import Parts, Plan, start_cluster
from tools.local_cluster.part_processes import NotStarted
from tools.local_cluster.ray_machines import MACHINES

FOLDER = Path("var/cluster")


def _read_plan() -> Plan:
    parser = argparse.ArgumentParser(
        prog="python -m tools.local_cluster",
        description=__doc__.partition("\n")[0],
        epilog="PROCTOR_DATABASE and PROCTOR_SIMULATORS, where they are set, are used "
        "instead. All settings of the server are passed on to the nodes.",
    )
    add = parser.add_argument
    add("--nodes", type=int, default=2, metavar="N", help="how many servers (2)")
    add(
        "--database",
        choices=["sqlite", "postgresql"],
        default="sqlite",
        help="a file, or a PostgreSQL of its own (sqlite)",
    )
    add(
        "--simulators",
        choices=["local", "ray"],
        default="local",
        help=f"processes, or a Ray cluster of its own with {MACHINES} machines (local)",
    )
    add(
        "--folder",
        type=Path,
        default=FOLDER,
        help=f"of PostgreSQL's data, keys and recordings ({FOLDER})",
    )
    given = parser.parse_args()
    if given.nodes < 1:
        parser.error("--nodes: at least 1")
    return Plan(
        host=os.environ.get("PROCTOR_HOST", "127.0.0.1"),
        port=int(os.environ.get("PROCTOR_PORT", "8460")),
        nodes=given.nodes,
        database=given.database,
        simulators=given.simulators,
        folder=given.folder,
    )


async def _run(plan: Plan) -> None:
    """Until a signal. Raises NotStarted, also if it cannot go on."""
    stopped = asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) is not signal.SIG_IGN:  # as under nohup
            loop.add_signal_handler(number, stopped.set)
    # Only this task ends what was started, and nothing cancels it.
    async with contextlib.AsyncExitStack() as ends:
        starting = asyncio.ensure_future(start_cluster(ends, plan))
        stopping = asyncio.ensure_future(stopped.wait())
        first = asyncio.FIRST_COMPLETED
        await asyncio.wait({starting, stopping}, return_when=first)
        if not starting.done():
            starting.cancel()
            await asyncio.wait({starting})
            return
        parts = starting.result()
        # In one write, also into a file or a pipe: a reader gets all lines or none.
        print("\n".join(parts.lines), flush=True)
        failing = asyncio.ensure_future(_wait_for_end(parts))
        await asyncio.wait({failing, stopping}, return_when=first)
        failing.cancel()
        stopping.cancel()
        if not stopped.is_set():
            raise NotStarted(failing.result())


async def _wait_for_end(parts: Parts) -> str:
    """Returns, with what has ended, when no node is of use any more."""
    all_nodes = asyncio.gather(*(node.wait() for node in parts.nodes))
    waits: dict[asyncio.Future[Any], str] = {all_nodes: "all nodes have ended"}
    for name, process in parts.vital.items():
        waits[asyncio.ensure_future(process.wait())] = f"{name} has ended"
    ended, _ = await asyncio.wait(waits, return_when=asyncio.FIRST_COMPLETED)
    return waits[ended.pop()]


def main() -> int:
    """Returns the exit code; a failure is 2 and one line on stderr."""
    try:
        asyncio.run(_run(_read_plan()))
    except (NotStarted, OSError) as problem:
        print(f"local_cluster: {problem}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
