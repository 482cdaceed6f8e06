"""`python -m tools cluster`: a cluster of this machine, behind one address.

Starts several reference servers over one database and a load balancer without affinity,
which leaves out a node that is not ready: kill one and the others go on. With options,
which `make cluster` gives, a PostgreSQL and a Ray cluster of its own are started, too.
The address and the port of the balancer, the tokens and the database are the settings
of a server (PROCTOR_HOST, PROCTOR_PORT, PROCTOR_TOKENS, PROCTOR_DATABASE), so that the
kit can start it: `make conformance` with ARGS="--start-cmd 'python -m
tools cluster'". It shows how nodes are put together; a real cluster has its
balancer and its supervisor.
"""

import asyncio
import contextlib
import os
import sys
from pathlib import Path
from typing import Any

from reference_record.command_line.closed_output import ending_signals
from tools.local_cluster.cluster_parts import Parts, Plan, start_cluster
from tools.local_cluster.part_processes import NotStarted


async def _run(plan: Plan) -> None:
    """Until a signal. Raises NotStarted, also if it cannot go on."""
    stopped = asyncio.Event()
    loop = asyncio.get_running_loop()
    for number in ending_signals():
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


def main(*, nodes: int, database: str, simulators: str, folder: Path) -> int:
    """Returns the exit code; a failure is 2 and one line on stderr."""
    if nodes < 1:
        print("cluster: --nodes: at least 1", file=sys.stderr)
        return 2
    try:
        plan = Plan(
            host=os.environ.get("PROCTOR_HOST", "127.0.0.1"),
            port=int(os.environ.get("PROCTOR_PORT", "8460")),
            nodes=nodes,
            database=database,
            simulators=simulators,
            folder=folder,
        )
        asyncio.run(_run(plan))
    except (NotStarted, OSError) as problem:
        print(f"cluster: {problem}", file=sys.stderr)
        return 2
    return 0
