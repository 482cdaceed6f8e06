"""The capacity of a cluster: constants of a model, measured, and the model.

Three nodes over one PostgreSQL; CPU seconds are those of processes, so that another
load on the machine counts less. First one worker plays at the owner of its run and
through another node; then more and more workers play steps that sleep, through the
balancer of `make cluster`. From the constants follows what a thousand workers need.
"""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx

from benchmarks import measuring
from benchmarks.cluster import many_workers
from benchmarks.cluster.capacity_model import Constants, needs_table
from tests.support.server.cluster_nodes import Cluster
from tests.support.server.databases import UsedDatabase
from tests.support.server.http_runs import attach, predict_body, submit, worker_path

TITLE = "Capacity of a cluster"
OPERATIONS, OPERATIONS_TRIED = 1000, 100
EPISODES, EPISODES_TRIED = 200, 20
READERS = 10
IDLE_S, IDLE_S_TRIED = 10.0, 2.0
SIZES, SIZES_TRIED = (1, 2, 4, 8, 16, 32, 64, 128, 256), (1, 2, 4)
STEP_S, PLAYED_S = 2.0, 20.0
STEP_S_TRIED, PLAYED_S_TRIED = 0.5, 2.0
_COMMITS = "SELECT xact_commit FROM pg_stat_database WHERE datname = '{}'"
# PostgreSQL adds its counts up once a second.
COUNTED_AFTER_S = 1.2


@dataclass(frozen=True)
class Reading:
    """CPU seconds so far: of each node, of all simulators, and of PostgreSQL."""

    nodes_s: tuple[float, ...]
    simulators_s: float
    database_s: float
    commits: int

    def since(self, earlier: Reading) -> Reading:
        pairs = zip(self.nodes_s, earlier.nodes_s, strict=True)
        return Reading(
            tuple(later - before for later, before in pairs),
            self.simulators_s - earlier.simulators_s,
            self.database_s - earlier.database_s,
            self.commits - earlier.commits,
        )


class Meter:
    """Reads what the processes of a cluster have used."""

    def __init__(self, cluster: Cluster, used: UsedDatabase) -> None:
        self.cluster, self._used = cluster, used

    def read(self) -> Reading:
        pids = [node.process.pid for node in self.cluster.nodes]
        nodes_s = tuple(measuring.cpu_s(pid) for pid in pids)
        children_s = sum(map(measuring.tree_cpu_s, pids)) - sum(nodes_s)
        rows = self._used.execute(_COMMITS.format(self._used.name))
        assert self._used.server is not None
        database_s = measuring.tree_cpu_s(self._used.server.process.pid)
        return Reading(nodes_s, children_s, database_s, int(rows[0][0]))

    def used(self, work: Callable[[], object]) -> Reading:
        """By the work, and until the database has counted it."""
        before = self.read()
        work()
        time.sleep(COUNTED_AFTER_S)
        return self.read().since(before)


def measure(*, trying: bool) -> str:
    """The constants, what grows with workers, and what the model says."""
    where = measuring.machine()
    sizes = SIZES_TRIED if trying else SIZES
    with many_workers.open_cluster(max(sizes)) as (cluster, used):
        meter = Meter(cluster, used)
        constants = _measure_constants(meter, trying=trying)
        rows = [_measure_size(meter, size, trying=trying) for size in sizes]
    last = rows[-1]
    constants = constants.with_sessions(last.node_mb, last.simulator_mb, last.files)
    parts = [constants.table(), _size_table(rows), needs_table(constants), where]
    return "\n\n".join(parts)


# --- one worker ---


def _measure_constants(meter: Meter, *, trying: bool) -> Constants:
    operations = OPERATIONS_TRIED if trying else OPERATIONS
    idle_s = IDLE_S_TRIED if trying else IDLE_S
    idle = meter.used(lambda: time.sleep(idle_s))
    lasts_s = idle_s + COUNTED_AFTER_S
    owner, other, _ = meter.cluster.clients
    run_id = submit(owner, "count", options={"max_steps": 3 * operations + 10})
    turns = _Turns(run_id, attach(owner, run_id))
    turns.play(owner, 10)
    direct = meter.used(lambda: turns.play(owner, operations))
    passed = meter.used(lambda: turns.play(other, operations))
    beats = meter.used(lambda: turns.beat(owner, operations))
    episodes = EPISODES_TRIED if trying else EPISODES
    _play_episodes(owner, episodes // 2, readers=READERS)  # the first ones cost more
    scored = meter.used(lambda: _play_episodes(owner, episodes, readers=0))
    events = 0

    def follow() -> None:
        nonlocal events
        events = _play_episodes(owner, episodes, readers=READERS)

    followed = meter.used(follow)
    _stop(owner, run_id)
    turn_s = direct.nodes_s[0] / operations
    return Constants(
        idle_node=sum(idle.nodes_s) / len(idle.nodes_s) / lasts_s,
        idle_database=idle.database_s / lasts_s,
        turn_s=turn_s,
        passed_on_s=(sum(passed.nodes_s) - direct.nodes_s[0]) / operations,
        passing_node_s=passed.nodes_s[1] / operations,
        heartbeat_s=beats.nodes_s[0] / operations,
        episode_s=scored.nodes_s[0] / episodes - turn_s,
        episode_database_s=scored.database_s / episodes,
        episode_commits=scored.commits / episodes,
        event_s=max(0.0, followed.nodes_s[0] - scored.nodes_s[0]) / events,
        simulator_turn_s=direct.simulators_s / operations,
    )


def _stop(client: httpx.Client, run_id: str) -> None:
    """Its simulators are free for the next ones."""
    answer = client.post(f"/v1/runs/{run_id}/stop", json={"mode": "abort"})
    answer.raise_for_status()


class _Turns:
    """One session. Its run has steps enough."""

    def __init__(self, run_id: str, turn: dict[str, Any]) -> None:
        self._path, self._turn = worker_path(run_id), turn

    def play(self, client: httpx.Client, count: int) -> None:
        for _ in range(count):
            body = predict_body(self._turn)
            answer = client.post(f"{self._path}/predict", json=body)
            self._turn = answer.raise_for_status().json()

    def beat(self, client: httpx.Client, count: int) -> None:
        body = {"session_id": self._turn["session_id"]}
        for _ in range(count):
            client.post(f"{self._path}/heartbeat", json=body).raise_for_status()


def _play_episodes(client: httpx.Client, count: int, *, readers: int) -> int:
    """How many events the readers had of a run, whose episodes have one turn each."""
    run_id = submit(client, *["score"] * count)
    turn = attach(client, run_id)
    with ThreadPoolExecutor(max(1, readers)) as threads:
        following = [threads.submit(_follow, client, run_id) for _ in range(readers)]
        while not turn["done"]:
            body = predict_body(turn, score=0.5, end=1.0)
            answer = client.post(f"{worker_path(run_id)}/predict", json=body)
            turn = answer.raise_for_status().json()
        return sum(reader.result() for reader in following)


def _follow(client: httpx.Client, run_id: str) -> int:
    """The events of the run until it is over."""
    with client.stream("GET", f"/v1/runs/{run_id}/events") as answer:
        answer.raise_for_status()
        return sum(part.count(b"\nid: ") for part in answer.iter_raw())


# --- many workers ---


@dataclass(frozen=True)
class Size:
    """The use by so many workers. node_mb, files: of a session more."""

    workers: int
    turns: int
    attach_ms: float
    node_ms: float
    simulator_ms: float
    database_ms: float
    added_ms: Sequence[float]
    node_mb: float
    simulator_mb: float
    files: float


def _measure_size(meter: Meter, count: int, *, trying: bool) -> Size:
    step_s, lasts_s = (STEP_S_TRIED, PLAYED_S_TRIED) if trying else (STEP_S, PLAYED_S)
    pids = [node.process.pid for node in meter.cluster.nodes]
    mb, files = _memory_mb(pids), _open_files(pids)
    runs = many_workers.submit(meter.cluster, count)
    readings, seen = [meter.read()], list[float]()

    def note() -> None:
        """When all have attached, and when they have played."""
        readings.append(meter.read())
        grown_mb, opened = _memory_mb(pids) - mb, _open_files(pids) - files
        simulators = set(itertools.chain(*map(measuring.process_tree, pids)))
        shared_mb = _memory_mb(sorted(simulators - set(pids))) / count
        seen[:] = grown_mb / count, shared_mb, opened / count

    playing = many_workers.play(meter.cluster, runs, step_s, lasts_s, note)
    _, workers = asyncio.run(playing)
    before, attached, played = readings
    attaching, used = attached.since(before), played.since(attached)
    for run_id in dict.fromkeys(runs):
        _stop(meter.cluster.clients[0], run_id)
    turns = sum(len(worker.added_s) for worker in workers)
    node_mb, simulator_mb, opened = seen
    return Size(
        count,
        turns,
        1e3 * sum(attaching.nodes_s) / count,
        1e3 * sum(used.nodes_s) / turns,
        1e3 * used.simulators_s / turns,
        1e3 * used.database_s / turns,
        [1e3 * added_s for worker in workers for added_s in worker.added_s],
        node_mb,
        simulator_mb,
        opened,
    )


def _memory_mb(pids: Sequence[int]) -> float:
    """The memory of processes; what several of them share counts once."""
    return sum(map(_proportional_kb, pids)) / 1024


def _proportional_kb(pid: int) -> int:
    with contextlib.suppress(OSError):
        for line in Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines():
            if line.startswith("Pss:"):
                return int(line.split()[1])
    return 0


def _open_files(pids: Sequence[int]) -> int:
    return sum(len(list(Path(f"/proc/{pid}/fd").iterdir())) for pid in pids)


def _size_table(sizes: Sequence[Size]) -> str:
    head = [
        "workers", "turns", "CPU of nodes, ms an attach", "ms a turn",
        "of simulators", "of PostgreSQL",
        "beside the step, p50, ms", "p99", "node, MB a session", "simulator, MB",
        "files a session",
    ]  # fmt: skip

    def row(size: Size) -> Iterator[str]:
        yield from (str(size.workers), str(size.turns))
        values = (
            size.attach_ms, size.node_ms, size.simulator_ms, size.database_ms,
            measuring.percentile(size.added_ms, 50),
            measuring.percentile(size.added_ms, 99),
            size.node_mb, size.simulator_mb, size.files,
        )  # fmt: skip
        yield from map(measuring.digits, values)

    return measuring.table(head, [list(row(size)) for size in sizes])
