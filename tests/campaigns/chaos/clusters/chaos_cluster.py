"""Nodes over one PostgreSQL behind a balancer, which players reach.

Between them lies either a link for each way on this machine, or a network of hosts
(`linked_cluster.py`, `host_cluster.py`). This is what both have in common.
"""

from __future__ import annotations

import contextlib
import signal
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from conformance.policy.scripted_policy import ScriptedPolicy
from tests.campaigns.campaign_server import CampaignServer
from tests.support.network.links import HOST, LinkThread
from tests.support.processes import descendants, signal_all
from tests.support.server.cluster_nodes import node_settings
from tests.support.server.postgresql_server import PASSWORD, PostgresqlServer
from tests.support.servers import NotStarted
from tests.support.sim.ray_machine_processes import PYTHON, RayMachines
from tools.local_cluster.balancer import Balancer

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
    """url: of the balancer. database: name of the nodes' one. directory: of all files.

    ray: has the simulators, or they are processes of the nodes. find_database: the
    server that can be written to now.
    """

    url = ""

    def __init__(
        self,
        directory: Path,
        find_database: Callable[[], PostgresqlServer],
        links: LinkThread,
        lease_s: float,
        ray: RayMachines | None = None,
    ) -> None:
        self._find_database, self.links = find_database, links
        self.lease_s, self.ray = lease_s, ray
        self.nodes: list[ChaosNode] = []
        self.directory = directory
        self.database = ""

    @property
    def postgresql(self) -> PostgresqlServer:
        return self._find_database()

    def start_node(self, settings: dict[str, str], prefix: Sequence[str] = ()) -> None:
        """One more node. settings: beside those that all have."""
        user = f"node{len(self.nodes)}"  # so that the database knows who writes
        self.execute(
            f"CREATE ROLE {user} SUPERUSER LOGIN PASSWORD '{PASSWORD}'", "SELECT 1"
        )
        folder = self.directory / user
        folder.mkdir(exist_ok=True)
        common = node_settings(self.directory, self.lease_s) | {
            "PROCTOR_FAILOVER": "replay",
            "PROCTOR_PROFILES": "",
            "PROCTOR_TURN_TIMEOUT_S": "5",
            "CAMPAIGN_DIRECTORY": str(folder),
        }
        python = sys.executable
        if self.ray is not None:
            common |= self.ray.settings
            python = str(PYTHON)
        node = ChaosNode(folder, common | settings, prefix, PROGRAM, python)
        self.nodes.append(node)

    def open_policy(self, make: Callable[[str], ScriptedPolicy]) -> ScriptedPolicy:
        """Make a policy server at an address that the nodes can reach."""
        return make(HOST)

    def end_nodes(self) -> None:
        for node in self.nodes:
            node.end(signal.SIGKILL)

    def balance(
        self, nodes: Sequence[tuple[str, int]], ends: contextlib.ExitStack
    ) -> None:
        """Listen for players, and give the nodes their connections in turn."""
        balancer = Balancer(nodes)
        server = self.links.run(balancer.listen(HOST, 0))
        ends.callback(lambda: self.links.run(balancer.close()))
        self.url = f"http://{HOST}:{server.sockets[0].getsockname()[1]}"

    def execute(self, *statements: str) -> list[tuple[Any, ...]]:
        """In the database, past the network; the rows of the last one."""
        return self.postgresql.execute(self.database, *statements)

    def simulators(self, node: ChaosNode) -> list[int]:
        """Those that a node has started; on Ray, those of all nodes."""
        return node.simulators() if self.ray is None else self.ray.simulators()

    def signal_database(self, number: signal.Signals) -> None:
        """Send it to each process of PostgreSQL."""
        main = self.postgresql.process.pid
        signal_all((main, *descendants(main)), number)

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
        """The log of each node, from its first start on."""
        return [node.log() for node in self.nodes]
