"""A cluster on this machine, with a link on each way of its nodes.

The balancer gives the nodes connections in turn, each over a link (`fronts`); nodes
reach one another (`peers`) and the database (`databases`) over links, too. So each way
of each node can be cut for itself.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

from tests.campaigns.chaos.clusters.chaos_cluster import ChaosCluster
from tests.support.network.links import HOST, Link, LinkThread
from tests.support.server.postgresql_server import (
    LIBFAKETIME,
    PASSWORD,
    PostgresqlServer,
)
from tests.support.sim.ray_machine_processes import RayMachines

SOCKET = ".s.PGSQL.5432"


class LinkedCluster(ChaosCluster):
    """Opened by `open`."""

    def __init__(
        self,
        directory: Path,
        postgresql: PostgresqlServer,
        links: LinkThread,
        lease_s: float,
        ray: RayMachines | None,
    ) -> None:
        super().__init__(directory, lambda: postgresql, links, lease_s, ray)
        self.fronts: list[Link] = []
        self.peers: list[Link] = []
        self.databases: list[Link] = []
        self._ports: list[int] = []
        url = postgresql.create()
        self.database = url.partition("@/")[2].partition("?")[0]
        self._socket = Path(url.partition("host=")[2]) / SOCKET

    @classmethod
    @contextlib.contextmanager
    def open(
        cls, directory: Path, *, size: int, lease_s: float, seed: int, ray: bool = False
    ) -> Iterator[LinkedCluster]:
        with contextlib.ExitStack() as stack:
            postgresql = stack.enter_context(
                PostgresqlServer(has_clock=LIBFAKETIME is not None)
            )
            links = stack.enter_context(LinkThread(seed))
            machines = stack.enter_context(RayMachines.open()) if ray else None
            cluster = cls(directory, postgresql, links, lease_s, machines)
            stack.callback(cluster.end_nodes)
            fronts = [(HOST, cluster._add_node(number)) for number in range(size)]
            cluster.balance(fronts, stack)
            yield cluster

    def _add_node(self, number: int) -> int:
        """The port of its front link."""
        user = f"node{number}"
        folder = self.directory / user
        folder.mkdir()
        self._ports.append(0)  # a node finds one when it starts
        peer, peer_port = self.links.open_port(lambda: self._ports[number])
        front, front_port = self.links.open_port(lambda: self._ports[number])
        self.databases.append(self.links.open_path(folder / SOCKET, self._socket))
        self.peers.append(peer)
        self.fronts.append(front)
        self.start_node(
            {
                "PROCTOR_NODE_URL": f"http://{HOST}:{peer_port}",
                "PROCTOR_ALLOW_PRIVATE_POLICIES": "127.0.0.0/8",
                "PROCTOR_DATABASE": f"postgresql://{user}:{PASSWORD}@/{self.database}"
                f"?host={folder}",
            }
        )
        self._ports[number] = int(self.nodes[number].url.rpartition(":")[2])
        return front_port

    def ways(self, number: int) -> list[Link]:
        """All links of a node."""
        return [self.fronts[number], self.peers[number], self.databases[number]]
