"""A cluster of hosts: each node has an address, a way and a disk of its own.

PostgreSQL is on two more hosts, a primary and its standby, and the policy server is on
another one. Players and the balancer are on the host of the campaign. Recordings are in
a folder that all nodes share; or on the disk of each node, and in a storage when they
are done.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from pathlib import Path

from conformance.policy.scripted_policy import ScriptedPolicy
from tests.campaigns.chaos.clusters.chaos_cluster import ChaosCluster
from tests.support.network.hosts import NETWORK, Disk, Host, Hosts, within
from tests.support.network.links import LinkThread
from tests.support.network.replicated_postgresql import ReplicatedPostgresql

PORT = "8460"
DISK_MB = 128  # for the recordings of some thousand runs
# The clocks since boot of two machines are not alike.
BOOTED_APART_S = 86_400


class HostCluster(ChaosCluster):
    """Opened by `open`, in a process that may make hosts.

    places: of the nodes. disks: where each records, one of its own or the same.
    """

    def __init__(
        self,
        directory: Path,
        hosts: Hosts,
        postgresql: ReplicatedPostgresql,
        links: LinkThread,
        lease_s: float,
    ) -> None:
        super().__init__(directory, lambda: postgresql.primary, links, lease_s)
        self.hosts, self.replicated = hosts, postgresql
        self.places: list[Host] = []
        self.disks: list[Disk] = []
        self._all_disks: list[Disk] = []
        self.database = postgresql.create()

    @classmethod
    @contextlib.contextmanager
    def open(
        cls,
        directory: Path,
        *,
        size: int,
        lease_s: float,
        seed: int,
        own_disks: bool = False,
    ) -> Iterator[HostCluster]:
        hosts = Hosts()
        with contextlib.ExitStack() as stack:
            databases = hosts.add("database0"), hosts.add("database1")
            postgresql = stack.enter_context(ReplicatedPostgresql(*databases))
            links = stack.enter_context(LinkThread(seed))
            cluster = cls(directory, hosts, postgresql, links, lease_s)
            stack.callback(cluster._remove_disks)
            stack.callback(cluster.end_nodes)
            stack.callback(hosts.heal)
            cluster.places = [hosts.add(f"node{number}") for number in range(size)]
            addresses = [(host.address, int(PORT)) for host in cluster.places]
            cluster.balance(addresses, stack)
            shared = directory / "records"
            cluster.disks = [cluster._disk(shared)] * size
            for number in range(size):
                cluster._add_node(number, shared, own_disks=own_disks)
            yield cluster

    def open_policy(self, make: Callable[[str], ScriptedPolicy]) -> ScriptedPolicy:
        host = self.hosts.add("policy")
        return within(host, lambda: make(host.address))

    def _add_node(self, number: int, shared: Path, *, own_disks: bool) -> None:
        host = self.places[number]
        settings = {
            "PROCTOR_HOST": host.address,
            "PROCTOR_PORT": PORT,
            "PROCTOR_PUBLIC_URL": self.url,
            "PROCTOR_ALLOW_PRIVATE_POLICIES": NETWORK,
            "PROCTOR_RECORDS_DIR": str(shared),
            "PROCTOR_DATABASE": self.replicated.url(host.name, self.database),
        }
        if own_disks:
            own = self.directory / host.name / "records"
            self.disks[number] = self._disk(own)
            settings |= {
                "PROCTOR_RECORDS_DIR": str(own),
                "PROCTOR_RECORDS_STORAGE": f"file://{shared}",
            }
        boot_s = str(number * BOOTED_APART_S)
        clocks = ("unshare", "--time", "--boottime", boot_s, "--monotonic", boot_s)
        self.start_node(settings, list(map(str, host.command(clocks))))

    def _disk(self, folder: Path) -> Disk:
        self._all_disks.append(Disk(folder, DISK_MB))
        return self._all_disks[-1]

    def _remove_disks(self) -> None:
        for disk in self._all_disks:
            disk.remove()
