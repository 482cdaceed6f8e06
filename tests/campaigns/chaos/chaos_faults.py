"""The faults: each happens, is there while the players go on, and is repaired.

A fault is a generator. What precedes its `yield` makes it; it yields the time from
which on a cluster has to go on, and repairs what is broken when it is resumed.
A long campaign ends when what is promised in `PROMISED` has been broken so often.
"""

from __future__ import annotations

import signal
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from random import Random

from reference_server.storage.connection.postgresql import NODE_STATEMENT_TIMEOUT_S
from tests.campaigns.chaos.clusters.chaos_cluster import ChaosCluster, ChaosNode
from tests.campaigns.chaos.clusters.host_cluster import HostCluster
from tests.campaigns.chaos.clusters.linked_cluster import LinkedCluster
from tests.support.network.hosts import Host
from tests.support.network.links import Link
from tests.support.processes import descendants, signal_all
from tests.support.server.postgresql_server import LIBFAKETIME

# Files of a full disk; days of a clock.
FULL_AT, DAY_S = 4096, 86_400.0
NODES_KILLED, SIMULATORS_KILLED = "nodes killed", "simulators killed"
DATABASES_KILLED = "PostgreSQL killed"
PAUSES, PARTITIONS = "pauses beyond the lease", "partitions"
PROMOTIONS = "standbys promoted"
RAY, LINKS, HOSTS = "ray", "links", "hosts"
PROMISED = {
    NODES_KILLED: 1000,
    SIMULATORS_KILLED: 1000,
    DATABASES_KILLED: 100,
    PAUSES: 100,
    PARTITIONS: 50,
    PROMOTIONS: 20,
}
SLOW_MS, SLOW_KBIT_S = 40, 512


@dataclass(frozen=True)
class Broken:
    """since: the time from which on a cluster has to go on. count: of its promise."""

    since: float
    count: int = 1


Happens = Callable[[ChaosCluster, Random], Iterator[Broken]]


@dataclass(frozen=True)
class Fault:
    """does: for the table. weight: how often it is chosen beside the others.

    promise: what it counts for, of PROMISED. needs: a kind of cluster that alone has
    what it breaks; empty where each kind has it.
    """

    name: str
    does: str
    happens: Happens
    weight: int = 1
    promise: str = ""
    needs: str = ""


def _wait_until(moment: float) -> None:
    time.sleep(max(0.0, moment - time.monotonic()))


def _beyond_lease(cluster: ChaosCluster, chance: Random) -> float:
    """Seconds; rarely less than the lease, for what is just in time, too."""
    return cluster.lease_s * chance.choice((0.5, 0.9, 1.0, 1.1, 1.5, 2.5))


def _number(cluster: ChaosCluster, chance: Random) -> int:
    return chance.randrange(len(cluster.nodes))


# --- processes ---


def _kill_nodes(count: int, with_: signal.Signals) -> Happens:
    def happens(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
        nodes = chance.sample(cluster.nodes, count)
        for node in nodes:
            node.process.send_signal(with_)
        since = time.monotonic()
        for node in nodes:
            node.end(with_)
        yield Broken(since, count)
        for node in nodes:
            node.start()

    return happens


def _restart_nodes(count: int) -> Happens:
    """At once: each takes its own place."""

    def happens(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
        nodes = chance.sample(cluster.nodes, count)
        since = time.monotonic()
        for node in nodes:
            node.process.send_signal(signal.SIGKILL)
        for node in nodes:
            node.end(signal.SIGKILL)
        with ThreadPoolExecutor() as executor:
            list(executor.map(ChaosNode.start, nodes))
        yield Broken(since, count)

    return happens


def _pause_node(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    node, pause_s = chance.choice(cluster.nodes), _beyond_lease(cluster, chance)
    since = time.monotonic()
    node.process.send_signal(signal.SIGSTOP)
    try:
        yield Broken(since, int(pause_s > cluster.lease_s))
        _wait_until(since + pause_s)
    finally:
        node.process.send_signal(signal.SIGCONT)


def _kill_simulators(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    since, killed = time.monotonic(), 0
    for _ in range(3):
        found = cluster.simulators(chance.choice(cluster.nodes))
        if found:
            killed += signal_all([chance.choice(found)], signal.SIGKILL)
    yield Broken(since, killed)


# --- machines of Ray ---


def _kill_machine(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    """With all that it simulates. Another one joins."""
    assert cluster.ray is not None
    machine = chance.choice(cluster.ray.machines())
    since = time.monotonic()
    signal_all(machine, signal.SIGKILL)
    yield Broken(since)
    cluster.ray.replace_lost()


def _pause_machine(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    """With all that it simulates, for 1 to 15 s."""
    assert cluster.ray is not None
    machine = chance.choice(cluster.ray.machines())
    pause_s = chance.choice((1.0, 4.0, 8.0, 15.0))
    since = time.monotonic()
    signal_all(machine, signal.SIGSTOP)
    try:
        yield Broken(since)
        _wait_until(since + pause_s)
    finally:
        signal_all(machine, signal.SIGCONT)
        cluster.ray.replace_lost()


# --- the database ---


def _restart_database(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    cluster.postgresql.kill()
    time.sleep(chance.choice((0.0, 0.3, 1.5)) * cluster.lease_s)
    cluster.postgresql.start()
    yield Broken(time.monotonic())


def _pause_database(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    pause_s = _beyond_lease(cluster, chance)
    cluster.signal_database(signal.SIGSTOP)
    try:
        time.sleep(pause_s)
    finally:
        cluster.signal_database(signal.SIGCONT)
    yield Broken(time.monotonic(), int(pause_s > cluster.lease_s))


def _kill_backend(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    """PostgreSQL ends all its other processes then, and recovers."""
    found = sorted(descendants(cluster.postgresql.process.pid))
    since = time.monotonic()
    signal_all([chance.choice(found)], signal.SIGKILL)
    yield Broken(since)


def _fill_disk(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    """Nothing of it grows: it ends itself at the next write of its log."""
    lasts_s = _beyond_lease(cluster, chance)
    cluster.limit_database_files(FULL_AT)
    time.sleep(lasts_s)
    cluster.limit_database_files(None)
    yield Broken(time.monotonic())


# --- clocks ---


def _jump_s(chance: Random) -> float:
    """Seconds, forth or back."""
    return chance.choice((-1, 1)) * chance.choice((2.0, 60.0, 3600.0, 400 * DAY_S))


def _shift_clocks(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    """Each node by another time: the clock of the database is the one that counts."""
    since = time.monotonic()
    for number in range(len(cluster.nodes)):
        cluster.shift_clock(number, _jump_s(chance))
    yield Broken(since)
    for number in range(len(cluster.nodes)):
        cluster.shift_clock(number, 0)


def _shift_database_clock(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    since = time.monotonic()
    cluster.postgresql.shift_clock(_jump_s(chance))
    yield Broken(since)
    cluster.postgresql.shift_clock(0)


# --- ways ---


def _disturb(
    links_of: Callable[[LinkedCluster, int], list[Link]],
    change: Callable[[Link], None],
    *,
    is_over_first: bool = False,
) -> Happens:
    """is_over_first: the cluster has to go on when the fault is over."""

    def happens(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
        assert isinstance(cluster, LinkedCluster)
        links = links_of(cluster, _number(cluster, chance))
        lasts_s = _beyond_lease(cluster, chance)
        since = time.monotonic()
        cluster.links.call(*(lambda link=link: change(link) for link in links))
        try:
            if not is_over_first:
                yield Broken(since)
            _wait_until(since + lasts_s)
        finally:
            cluster.links.call(*(link.heal for link in links))
        if is_over_first:
            yield Broken(time.monotonic())

    return happens


def _lose_answers(link: Link) -> None:
    link.loss = 0.2


def _delay(link: Link) -> None:
    link.delay_s = 0.03


# --- hosts ---


def _lose(ways_of: Callable[[HostCluster, Random], list[tuple[Host, Host]]]) -> Happens:
    """Packets of these ways vanish, often for longer than TCP waits to repeat one."""

    def happens(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
        assert isinstance(cluster, HostCluster)
        lasts_s = chance.choice((_beyond_lease(cluster, chance), 6 * cluster.lease_s))
        since = time.monotonic()
        for sender, receiver in ways_of(cluster, chance):
            cluster.hosts.lose_way(sender, receiver)
        try:
            yield Broken(since)
            _wait_until(since + lasts_s)
        finally:
            cluster.hosts.heal()

    return happens


def _both(one: Host, *others: Host) -> list[tuple[Host, Host]]:
    """The ways between one host and others, there and back."""
    return [pair for other in others for pair in ((one, other), (other, one))]


def _node_and_all(cluster: HostCluster, chance: Random) -> list[tuple[Host, Host]]:
    host = chance.choice(cluster.places)
    others = {*cluster.places, *cluster.replicated.hosts, cluster.hosts.here} - {host}
    return _both(host, *sorted(others, key=lambda other: other.address))


def _one_way(cluster: HostCluster, chance: Random) -> list[tuple[Host, Host]]:
    """The way from one node to another one, or to the database."""
    sender, *others = chance.sample(cluster.places, len(cluster.places))
    return [(sender, chance.choice([*others, cluster.replicated.hosts[0]]))]


def _slow_host(hosts_of: Callable[[HostCluster], Sequence[Host]]) -> Happens:
    def happens(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
        assert isinstance(cluster, HostCluster)
        since = time.monotonic()
        host = chance.choice(hosts_of(cluster))
        cluster.hosts.slow(host, SLOW_MS, SLOW_KBIT_S)
        try:
            yield Broken(since)
        finally:
            cluster.hosts.heal()

    return happens


def _fill_node_disk(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    """Where nodes share a folder, that of all. Nothing goes on where it is full."""
    assert isinstance(cluster, HostCluster)
    disk = chance.choice(cluster.disks)
    disk.fill()
    try:
        time.sleep(_beyond_lease(cluster, chance))
    finally:
        disk.clear()
    yield Broken(time.monotonic())


def _promote(*, is_lost: bool, is_behind: bool = False) -> Happens:
    """is_lost: the primary still runs and is reached by none; else it is killed.

    is_behind: the standby was not reached before, for longer than commits wait for it.
    """

    def happens(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
        assert isinstance(cluster, HostCluster)
        primary, standby = cluster.replicated.hosts
        if is_behind:
            cluster.hosts.partition(primary, standby)
            time.sleep(NODE_STATEMENT_TIMEOUT_S + cluster.lease_s)
        if is_lost:
            cluster.hosts.partition(primary)
        else:
            cluster.postgresql.kill()
        time.sleep(chance.choice((0.0, 0.5, 2.0)) * cluster.lease_s)
        cluster.replicated.promote()
        yield Broken(time.monotonic())
        cluster.replicated.standby.kill()  # else both could be written to
        cluster.hosts.heal()
        cluster.replicated.replace_standby()

    return happens


def _lose_standby(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    """No commit ends meanwhile."""
    assert isinstance(cluster, HostCluster)
    cluster.hosts.partition(*cluster.replicated.hosts)
    try:
        time.sleep(_beyond_lease(cluster, chance))
    finally:
        cluster.hosts.heal()
    yield Broken(time.monotonic())


FAULTS = {
    fault.name: fault
    for fault in (
        Fault("node killed", "SIGKILL, started when all go on",
              _kill_nodes(1, signal.SIGKILL), 4, NODES_KILLED),
        Fault("two nodes killed", "SIGKILL of two of three",
              _kill_nodes(2, signal.SIGKILL), 1, NODES_KILLED),
        Fault("node restarted", "SIGKILL, started again at once",
              _restart_nodes(1), 2, NODES_KILLED),
        Fault("all nodes restarted", "SIGKILL of three, started again at once",
              _restart_nodes(3), 2, NODES_KILLED),
        Fault("node ended", "SIGTERM", _kill_nodes(1, signal.SIGTERM)),
        Fault("node paused", "SIGSTOP for 0.5 to 2.5 leases", _pause_node, 4, PAUSES),
        Fault("simulators killed", "SIGKILL of three", _kill_simulators, 2,
              SIMULATORS_KILLED),
        Fault("Ray machine killed", "SIGKILL with its simulators; another one joins",
              _kill_machine, 4, needs=RAY),
        Fault("Ray machine paused", "SIGSTOP with its simulators, 1 to 15 s",
              _pause_machine, 2, needs=RAY),
        Fault("database restarted", "killed; away for up to 1.5 leases",
              _restart_database, 2, DATABASES_KILLED),
        Fault("database paused", "SIGSTOP for 0.5 to 2.5 leases", _pause_database, 2,
              PAUSES),
        Fault("database process killed", "SIGKILL; PostgreSQL recovers",
              _kill_backend, 2, DATABASES_KILLED),
        Fault("database disk full", "writes fail for up to 2.5 leases", _fill_disk, 2),
        Fault("node clocks jump", "each by 2 s to 400 days, forth or back",
              _shift_clocks, 2),
        Fault("database clock jumps", "by 2 s to 400 days, forth or back",
              _shift_database_clock, 2),
        Fault("balancer – node cut", "connections closed",
              _disturb(lambda c, n: [c.fronts[n]], Link.cut), needs=LINKS),
        Fault("balancer – node lost", "no byte passes",
              _disturb(lambda c, n: [c.fronts[n]], Link.hold), needs=LINKS),
        Fault("node – nodes cut", "others do not reach it",
              _disturb(lambda c, n: [c.peers[n]], Link.cut), 2, needs=LINKS),
        Fault("node – nodes lost", "no byte from others passes",
              _disturb(lambda c, n: [c.peers[n]], Link.hold), 2, PARTITIONS,
              LINKS),
        Fault("node – database cut", "connections closed",
              _disturb(lambda c, n: [c.databases[n]], Link.cut), 2, needs=LINKS),
        Fault("node – database lost", "no byte passes",
              _disturb(lambda c, n: [c.databases[n]], Link.hold), 3, PARTITIONS,
              LINKS),
        Fault("node partitioned", "no byte to or from it passes",
              _disturb(lambda c, n: c.ways(n), Link.hold), 2, PARTITIONS, needs=LINKS),
        Fault("answers lost", "a fifth, to players and to nodes",
              _disturb(lambda c, _: [*c.fronts, *c.peers], _lose_answers,
                       is_over_first=True), 2, needs=LINKS),
        Fault("slow network", "30 ms each way, everywhere",
              _disturb(lambda c, _: [*c.fronts, *c.peers, *c.databases], _delay),
              needs=LINKS),
        Fault("host of a node lost", "no packet to or from it arrives",
              _lose(_node_and_all), 3, PARTITIONS, HOSTS),
        Fault("hosts node – database lost", "no packet between them arrives",
              _lose(lambda c, r: _both(r.choice(c.places), *c.replicated.hosts)), 3,
              PARTITIONS, HOSTS),
        Fault("hosts node – node lost", "no packet between them arrives",
              _lose(lambda c, r: _both(*r.sample(c.places, 2))), 3, PARTITIONS, HOSTS),
        Fault("hosts balancer – node lost", "no packet between them arrives",
              _lose(lambda c, r: _both(c.hosts.here, r.choice(c.places))), 1,
              PARTITIONS, HOSTS),
        Fault("one way lost", "from a node to another one or the database",
              _lose(_one_way), 3, PARTITIONS, HOSTS),
        Fault("host of a node slow", f"{SLOW_MS} ms or {SLOW_KBIT_S} kbit/s",
              _slow_host(lambda c: c.places), 2, needs=HOSTS),
        Fault("host of the database slow", f"{SLOW_MS} ms or {SLOW_KBIT_S} kbit/s",
              _slow_host(lambda c: c.replicated.hosts[:1]), 1, needs=HOSTS),
        Fault("node disk full", "no recording can be written", _fill_node_disk, 3,
              needs=HOSTS),
        Fault("database killed for good", "the standby is promoted",
              _promote(is_lost=False), 3, PROMOTIONS, HOSTS),
        Fault("database lost for good", "the standby is promoted",
              _promote(is_lost=True), 3, PROMOTIONS, HOSTS),
        Fault("standby lost and promoted", "commits did not end before",
              _promote(is_lost=True, is_behind=True), 2, PROMOTIONS, HOSTS),
        Fault("standby lost", "no commit ends meanwhile", _lose_standby, 2,
              needs=HOSTS),
    )
    # Without that library its clock is the one of all other programs.
    if fault.happens is not _shift_database_clock or LIBFAKETIME
}  # fmt: skip


def faults_of(cluster: set[str]) -> list[str]:
    """Names of those that clusters of these kinds have."""
    return [name for name, fault in FAULTS.items() if {fault.needs} <= {"", *cluster}]
