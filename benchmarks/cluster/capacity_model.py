"""A model of a cluster's capacity: what each resource carries, from measured constants.

A node is one process that computes on one core; its simulators compute beside it. The
balancer gives requests to the nodes in turn, so most turns reach another node than the
owner of their run, which passes them on.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Iterator
from dataclasses import dataclass

from benchmarks import measuring

# The part of a resource above which what waits for it grows fast.
USABLE = 0.7
# Each machine that has a node has so much.
MEMORY_MB, FILES = 64 * 1024, 65_536
HEARTBEAT_EVERY_S = 10.0
DATABASE = "a core of PostgreSQL"


@dataclass(frozen=True)
class Constants:
    """CPU seconds of one of each; idle: of a second. passed_on_s: of both nodes."""

    idle_node: float
    idle_database: float
    turn_s: float
    passed_on_s: float
    passing_node_s: float
    heartbeat_s: float
    episode_s: float
    episode_database_s: float
    episode_commits: float
    event_s: float
    simulator_turn_s: float
    session_mb: float = 0.0
    simulator_mb: float = 0.0
    session_files: float = 0.0

    def with_sessions(
        self, session_mb: float, simulator_mb: float, files: float
    ) -> Constants:
        """With what many sessions at once need, each of them."""
        return dataclasses.replace(
            self,
            session_mb=max(0.0, session_mb),
            simulator_mb=simulator_mb,
            session_files=files,
        )

    def table(self) -> str:
        """CPU time, and memory."""
        cpu = {
            "a turn at the owner": self.turn_s,
            "a turn that is passed on, beside that": self.passed_on_s,
            "– of which at the node that passes it on": self.passing_node_s,
            "a heartbeat": self.heartbeat_s,
            "an episode, beside its turns": self.episode_s,
            "an episode, at PostgreSQL": self.episode_database_s,
            "an event to one reader": self.event_s,
            "a turn of a light simulator": self.simulator_turn_s,
            "a second of a node that does nothing": self.idle_node,
            "a second of PostgreSQL then": self.idle_database,
        }
        rows = [[f"{name}, ms of CPU", f"{1e3 * s:.2f}"] for name, s in cpu.items()]
        rows += [
            ["an episode, transactions", f"{self.episode_commits:.1f}"],
            ["a session, MB at the node", f"{self.session_mb:.2f}"],
            ["a light simulator, MB", f"{self.simulator_mb:.1f}"],
            ["a session, open files", f"{self.session_files:.1f}"],
        ]
        return measuring.table(["", ""], rows)


@dataclass(frozen=True)
class Load:
    """turn_s: from one turn of a worker to the next. readers: of a run's events."""

    name: str
    turn_s: float
    turns_of_episode: int
    readers: int = 1
    workers: int = 1000
    nodes: int = 3


LOADS = (
    Load("one action a turn, 10 turns/s", 0.1, 300),
    Load("one action a turn, 1 turn/s", 1.0, 300),
    Load("a chunk a turn, every 2 s", 2.0, 50),
    Load("a heavy policy, every 10 s", 10.0, 50),
)


def parts_used(constants: Constants, load: Load) -> dict[str, float]:
    """The part of each resource that the load needs; above 1: it has not got it."""
    turns = load.workers / load.turn_s  # a second, and so on
    episodes = turns / load.turns_of_episode
    beats = load.workers / HEARTBEAT_EVERY_S
    events = episodes * load.readers
    elsewhere = (load.nodes - 1) / load.nodes
    node = (
        turns * (constants.turn_s + elsewhere * constants.passed_on_s)
        + beats * (constants.heartbeat_s + elsewhere * constants.passed_on_s)
        + episodes * constants.episode_s
        + events * constants.event_s
    ) / load.nodes + constants.idle_node
    database = episodes * constants.episode_database_s
    sessions = load.workers / load.nodes
    memory = sessions * (constants.session_mb + constants.simulator_mb)
    return {
        "a node's core": node / USABLE,
        DATABASE: (database + constants.idle_database) / USABLE,
        "cores of simulators, one a node": turns
        * constants.simulator_turn_s
        / load.nodes
        / USABLE,
        f"memory, {MEMORY_MB // 1024} GB a node": memory / MEMORY_MB / USABLE,
        f"files, {FILES:,} a node": sessions * constants.session_files / FILES / USABLE,
    }


def needs_table(constants: Constants) -> str:
    """For each load what saturates first, and how many workers that carries."""
    head = ["1,000 workers, 3 nodes", *parts_used(constants, LOADS[0])]
    head += ["first", "workers at 3 nodes", "nodes for 1,000"]
    return measuring.table(head, [list(_row(constants, load)) for load in LOADS])


def _row(constants: Constants, load: Load) -> Iterator[str]:
    used = parts_used(constants, load)
    first = max(used, key=lambda name: used[name])
    yield load.name
    yield from (f"{100 * part:.0f} %" for part in used.values())
    yield first
    yield f"{round(load.workers / used[first], -1):,.0f}"
    yield str(nodes_needed(constants, load))


def nodes_needed(constants: Constants, load: Load) -> int:
    """The fewest nodes that carry the load; passing on grows with them."""
    for nodes in itertools.count(1):
        used = parts_used(constants, dataclasses.replace(load, nodes=nodes))
        if max(part for name, part in used.items() if name != DATABASE) <= 1:
            return nodes
    raise AssertionError
