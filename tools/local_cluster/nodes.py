"""The nodes of the cluster: reference servers of this environment, one a port.

They stay in the process group of what starts them, so that who kills that group, as
the kit does, kills them as well.
"""

import asyncio
import contextlib
import os
import sys
from collections.abc import Mapping, Sequence

from tools.local_cluster.part_processes import NotStarted, at_once, end_children

# A terminal sends its Ctrl-C to the group. A node ignores it until it serves, as it
# would end with a traceback; it is terminated all the same.
IGNORE_CTRL_C = ("sh", "-c", "trap '' INT; exec \"$@\"", "sh")
START_NODE = (*IGNORE_CTRL_C, sys.executable, "-m", "reference_server")


async def start_nodes(
    ends: contextlib.AsyncExitStack, ports: Sequence[int], settings: Mapping[str, str]
) -> list[asyncio.subprocess.Process]:
    """Servers that accept requests on these ports; `ends` ends them.

    Raises NotStarted; the server has said why on the standard error.
    """
    environment = os.environ | dict(settings) | {"PROCTOR_CLUSTER": "on"}
    nodes: dict[int, asyncio.subprocess.Process] = {}
    ends.push_async_callback(end_children, nodes.values())

    async def start(port: int) -> None:
        node = nodes[port] = await asyncio.create_subprocess_exec(
            *START_NODE,
            env=environment | {"PROCTOR_PORT": str(port)},
            stdout=asyncio.subprocess.PIPE,
        )
        assert node.stdout is not None
        if not await node.stdout.readline():
            raise NotStarted(f"the node at port {port} did not start, as it says above")

    # The first one makes the tables and the keys.
    await start(ports[0])
    await at_once(*map(start, ports[1:]))
    return [nodes[port] for port in ports]
