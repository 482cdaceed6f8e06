"""The faults: each happens, is there while the players go on, and is repaired.

A fault is a generator. What precedes its `yield` makes it; it yields the time from
which on a cluster has to go on, and repairs what is broken when it is resumed.
A long campaign ends when what is promised in `PROMISED` has been broken so often.
"""

from __future__ import annotations

import contextlib
import os
import signal
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from random import Random

from tests.campaigns.chaos.chaos_cluster import ChaosCluster, ChaosNode
from tests.campaigns.chaos.links import Link
from tests.support.processes import descendants
from tests.support.server.postgresql_server import LIBFAKETIME

# Files of a full disk; days of a clock.
FULL_AT, DAY_S = 4096, 86_400.0
NODES_KILLED, SIMULATORS_KILLED = "nodes killed", "simulators killed"
DATABASES_KILLED = "PostgreSQL killed"
PAUSES, PARTITIONS = "pauses beyond the lease", "partitions"
PROMISED = {
    NODES_KILLED: 1000,
    SIMULATORS_KILLED: 1000,
    DATABASES_KILLED: 100,
    PAUSES: 100,
    PARTITIONS: 50,
}


@dataclass(frozen=True)
class Broken:
    """since: the time from which on a cluster has to go on. count: of its promise."""

    since: float
    count: int = 1


Happens = Callable[[ChaosCluster, Random], Iterator[Broken]]


@dataclass(frozen=True)
class Fault:
    """does: for the table. weight: how often it is chosen beside the others.

    promise: what it counts for, of PROMISED. needs_ray: the simulators are on Ray.
    """

    name: str
    does: str
    happens: Happens
    weight: int = 1
    promise: str = ""
    needs_ray: bool = False


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
            with contextlib.suppress(ProcessLookupError):
                os.kill(chance.choice(found), signal.SIGKILL)
                killed += 1
    yield Broken(since, killed)


# --- machines of Ray ---


def _signal_all(pids: set[int], number: signal.Signals) -> None:
    for pid in pids:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, number)


def _kill_machine(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    """With all that it simulates. Another one joins."""
    assert cluster.ray is not None
    machine = chance.choice(cluster.ray.machines())
    since = time.monotonic()
    _signal_all(machine, signal.SIGKILL)
    yield Broken(since)
    cluster.ray.replace_lost()


def _pause_machine(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
    """With all that it simulates, for 1 to 15 s."""
    assert cluster.ray is not None
    machine = chance.choice(cluster.ray.machines())
    pause_s = chance.choice((1.0, 4.0, 8.0, 15.0))
    since = time.monotonic()
    _signal_all(machine, signal.SIGSTOP)
    try:
        yield Broken(since)
        _wait_until(since + pause_s)
    finally:
        _signal_all(machine, signal.SIGCONT)
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
    with contextlib.suppress(ProcessLookupError):
        os.kill(chance.choice(found), signal.SIGKILL)
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
    """Of each node by another time: what counts is the clock of the database."""
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
    links_of: Callable[[ChaosCluster, int], list[Link]],
    change: Callable[[Link], None],
    *,
    is_over_first: bool = False,
) -> Happens:
    """is_over_first: the cluster has to go on when the fault is over."""

    def happens(cluster: ChaosCluster, chance: Random) -> Iterator[Broken]:
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
              _kill_machine, 4, needs_ray=True),
        Fault("Ray machine paused", "SIGSTOP with its simulators, 1 to 15 s",
              _pause_machine, 2, needs_ray=True),
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
              _disturb(lambda c, n: [c.fronts[n]], Link.cut)),
        Fault("balancer – node lost", "no byte passes",
              _disturb(lambda c, n: [c.fronts[n]], Link.hold)),
        Fault("node – nodes cut", "others do not reach it",
              _disturb(lambda c, n: [c.peers[n]], Link.cut), 2),
        Fault("node – nodes lost", "no byte from others passes",
              _disturb(lambda c, n: [c.peers[n]], Link.hold), 2, PARTITIONS),
        Fault("node – database cut", "connections closed",
              _disturb(lambda c, n: [c.databases[n]], Link.cut), 2),
        Fault("node – database lost", "no byte passes",
              _disturb(lambda c, n: [c.databases[n]], Link.hold), 3, PARTITIONS),
        Fault("node partitioned", "no byte to or from it passes",
              _disturb(lambda c, n: c.ways(n), Link.hold), 2, PARTITIONS),
        Fault("answers lost", "a fifth, to players and to nodes",
              _disturb(lambda c, _: [*c.fronts, *c.peers], _lose_answers,
                       is_over_first=True), 2),
        Fault("slow network", "30 ms each way, everywhere",
              _disturb(lambda c, _: [*c.fronts, *c.peers, *c.databases], _delay)),
    )
    # Without that library its clock is the one of all other programs.
    if fault.happens is not _shift_database_clock or LIBFAKETIME
}  # fmt: skip
