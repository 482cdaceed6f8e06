"""Nodes over one PostgreSQL behind a balancer, with a link on each of their ways.

Players reach the balancer. It gives the nodes connections in turn, each over a link
(`fronts`); nodes reach one another (`peers`) and the database (`databases`) over links,
too. So each way of each node can be cut for itself.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tests.campaigns.campaign_server import CampaignServer
from tests.campaigns.chaos.links import HOST, Link, LinkThread
from tests.support.processes import descendants
from tests.support.server.postgresql_server import (
    LIBFAKETIME,
    PASSWORD,
    PostgresqlServer,
)
from tests.support.servers import NotStarted
from tests.support.sim.ray_machine_processes import PYTHON, RayMachines
from tools.local_cluster.balancer import Balancer

SOCKET = ".s.PGSQL.5432"
# A server whose wall clock is wrong by what its file `clock` says.
PROGRAM = "tests.campaigns.patched_server"
STARTS_MAX = 5


class ChaosNode(CampaignServer):
    """A node that is started again if it ends at once, as a service manager does it.

    Its database may not answer at that moment.
    """

    def start(self) -> None:
        for _ in range(STARTS_MAX - 1):
            try:
                super().start()
            except NotStarted:
                self.end(signal.SIGKILL)  # closes what it wrote to
            else:
                return
        super().start()


class ChaosCluster:
    """Opened by `open`. url: of the balancer. database: name of the nodes' one.

    directory: of all files, among them the recordings, which the nodes share. ray: has
    the simulators, or they are processes of the nodes.
    """

    def __init__(
        self,
        directory: Path,
        postgresql: PostgresqlServer,
        links: LinkThread,
        lease_s: float,
        ray: RayMachines | None,
    ) -> None:
        self.postgresql, self.links, self.lease_s = postgresql, links, lease_s
        self.ray = ray
        self.nodes: list[ChaosNode] = []
        self.fronts: list[Link] = []
        self.peers: list[Link] = []
        self.databases: list[Link] = []
        self.directory = directory
        self._ports: list[int] = []
        url = postgresql.create()
        self.database = url.partition("@/")[2].partition("?")[0]
        self._socket = Path(url.partition("host=")[2]) / SOCKET

    @classmethod
    @contextlib.contextmanager
    def open(
        cls, directory: Path, *, size: int, lease_s: float, seed: int, ray: bool = False
    ) -> Iterator[ChaosCluster]:
        with contextlib.ExitStack() as stack:
            postgresql = stack.enter_context(
                PostgresqlServer(has_clock=LIBFAKETIME is not None)
            )
            links = stack.enter_context(LinkThread(seed))
            machines = stack.enter_context(RayMachines.open()) if ray else None
            cluster = cls(directory, postgresql, links, lease_s, machines)
            stack.callback(cluster._end_nodes)
            fronts = [cluster._add_node(number) for number in range(size)]
            balancer = Balancer(fronts)
            server = links.run(balancer.listen(HOST, 0))
            stack.callback(lambda: links.run(balancer.close()))
            cluster.url = f"http://{HOST}:{server.sockets[0].getsockname()[1]}"
            yield cluster

    url = ""

    def _add_node(self, number: int) -> int:
        """The port of its front link."""
        user = f"node{number}"  # so that the database knows who writes
        self.execute(
            f"CREATE ROLE {user} SUPERUSER LOGIN PASSWORD '{PASSWORD}'", "SELECT 1"
        )
        folder = self.directory / user
        folder.mkdir()
        self._ports.append(0)  # a node finds one when it starts
        peer, peer_port = self.links.open_port(lambda: self._ports[number])
        front, front_port = self.links.open_port(lambda: self._ports[number])
        self.databases.append(self.links.open_path(folder / SOCKET, self._socket))
        self.peers.append(peer)
        self.fronts.append(front)
        settings = {
            "PROCTOR_CLUSTER": "on",
            "PROCTOR_FAILOVER": "replay",
            "PROCTOR_RECORDS_DIR": str(self.directory / "records"),
            "PROCTOR_SIGNING_KEY": str(self.directory / "signing-key"),
            "PROCTOR_PROFILES": "",
            "PROCTOR_NODE_LEASE_S": str(self.lease_s),
            "PROCTOR_NODE_URL": f"http://{HOST}:{peer_port}",
            "PROCTOR_SPARE_SIMULATORS": "1",
            "PROCTOR_TURN_TIMEOUT_S": "5",
            "PROCTOR_LOG_LEVEL": "info",
            "PROCTOR_ALLOW_PRIVATE_POLICIES": "127.0.0.0/8",
            "PROCTOR_DATABASE": f"postgresql://{user}:{PASSWORD}@/{self.database}"
            f"?host={folder}",
            "CAMPAIGN_DIRECTORY": str(folder),
            "PROCTOR_SEALING_KEY": str(self.directory / "key"),
            "PROCTOR_SEED_SECRET": str(self.directory / "seeds"),
        }
        python = sys.executable
        if self.ray is not None:
            settings |= self.ray.settings
            python = str(PYTHON)
        node = ChaosNode(folder, settings, program=PROGRAM, python=python)
        self.nodes.append(node)
        self._ports[number] = int(node.url.rpartition(":")[2])
        return front_port

    def _end_nodes(self) -> None:
        for node in self.nodes:
            node.end(signal.SIGKILL)

    def ways(self, number: int) -> list[Link]:
        """All links of a node."""
        return [self.fronts[number], self.peers[number], self.databases[number]]

    def execute(self, *statements: str) -> list[tuple[Any, ...]]:
        """In the database, past the links; the rows of the last one."""
        return self.postgresql.execute(self.database, *statements)

    def simulators(self, node: ChaosNode) -> list[int]:
        """Those that a node has started; on Ray, those of all nodes."""
        return node.simulators() if self.ray is None else self.ray.simulators()

    def signal_database(self, number: signal.Signals) -> None:
        """Send it to each process of PostgreSQL."""
        main = self.postgresql.process.pid
        for pid in (main, *descendants(main)):
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, number)

    def limit_database_files(self, size: int | None) -> None:
        """Let its writes beyond a size fail, as on a full disk; None: no longer.

        It ends itself then, and is started again when there is room.
        """
        self.postgresql.limit_files(size)
        if size is None:
            self.postgresql.kill()
            self.postgresql.start()

    def shift_clock(self, number: int, by_s: float) -> None:
        """Let the wall clock of a node be wrong by so much."""
        (self.directory / f"node{number}" / "clock").write_text(str(by_s))

    def logs(self) -> list[str]:
        """Of each node, from its first start on."""
        return [node.log() for node in self.nodes]
