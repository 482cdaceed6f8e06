"""A thousand workers of three nodes.

Three nodes over one PostgreSQL (in tests' settings: nothing is forced to disk) behind
the balancer of `make cluster`, and workers that all play at once steps that sleep: how
long it took until all were attached, what a turn took beside its sleep, and how many
turns the slowest and the fastest worker had, for no worker may starve.
"""

import asyncio
import itertools
import json
import statistics
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import httpcore

from benchmarks import measuring
from tests.support.server.cluster_nodes import Cluster
from tests.support.server.databases import UsedDatabase
from tests.support.server.http_runs import predict_body, worker_path
from tests.support.server.postgresql_server import PostgresqlServer
from tests.support.servers import TOKENS
from tools.local_cluster.balancer import HOST, Balancer

TITLE = "Many workers"
NODES = 3
WORKERS_OF_RUN = 50
WORKERS, WORKERS_TRIED = 1000, 30
SLEEP_S, SLEEP_S_TRIED = 5.0, 0.5  # of a step, at most 5
PLAYED_S, PLAYED_S_TRIED = 60.0, 3.0
# A request with such an answer has to be sent again.
AGAIN = (429, 503)
HEADERS: Mapping[bytes | str, bytes | str] = {
    "Authorization": f"Bearer {TOKENS['alice']}",
    "Content-Type": "application/json",
}


@dataclass
class Worker:
    """One connection to the balancer. Seconds of each turn beside its sleep."""

    run_id: str
    name: str
    port: int
    added_s: list[float] = field(default_factory=list)
    repeated: int = 0
    reconnected: int = 0

    def __post_init__(self) -> None:
        self._connect()

    def _connect(self) -> None:
        # One connection each: a pool of httpcore looks at all of them for each request.
        self._origin = httpcore.Origin(b"http", HOST.encode(), self.port)
        self._connection = httpcore.AsyncHTTPConnection(self._origin)

    async def attach(self) -> None:
        path = worker_path(self.run_id, self.name)
        self._turn = await self._ask("PUT", path, {"attach_key": self.name})

    async def play(self, sleep_s: float, until: float) -> None:
        """Turns, one after another; the last one begins before `until`."""
        path = f"{worker_path(self.run_id, self.name)}/predict"
        while time.monotonic() < until:
            began_at = time.monotonic()
            body = predict_body(self._turn, delay_s=sleep_s)
            self._turn = await self._ask("POST", path, body)
            self.added_s.append(time.monotonic() - began_at - sleep_s)

    async def close(self) -> None:
        await self._connection.aclose()

    async def _ask(self, method: str, path: str, body: dict[str, Any]) -> Any:
        """Sent again, after a short time, while there is no room."""
        while True:
            try:
                answer = await self._connection.request(
                    method,
                    f"{self._origin}{path}",
                    headers=HEADERS,
                    content=json.dumps(body).encode(),
                )
            except (httpcore.NetworkError, httpcore.ProtocolError):
                self.reconnected += 1
                await self.close()
                self._connect()
                continue
            if answer.status == 200:
                return json.loads(answer.content)
            if answer.status not in AGAIN:
                said = answer.content[:300]
                raise RuntimeError(f"{method} {path}: {answer.status} {said!r}")
            self.repeated += 1
            await asyncio.sleep(1.0)


@contextmanager
def open_cluster(workers: int) -> Iterator[tuple[Cluster, UsedDatabase]]:
    """Three nodes with room for so many workers, and their database."""
    with ExitStack() as stack:
        directory = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        server = stack.enter_context(PostgresqlServer())
        database = server.create()
        cluster = stack.enter_context(
            Cluster.of(
                directory,
                database,
                NODES,
                PROCTOR_NODE_LEASE_S="5",
                # All of one node, in case that it owns most of the runs.
                PROCTOR_MAX_SIMULATORS=str(workers),
                PROCTOR_MAX_WORKERS=str(WORKERS_OF_RUN),
                PROCTOR_MAX_CONNECTIONS="4000",
                PROCTOR_MAX_CONNECTIONS_PER_ADDRESS="3000",
                PROCTOR_LOG_LEVEL="warning",
            )
        )
        yield cluster, UsedDatabase(database, server=server)


def submit(cluster: Cluster, workers: int) -> list[str]:
    """Runs for so many workers, in turn at each node; each run has a node."""
    sizes = [WORKERS_OF_RUN] * (workers // WORKERS_OF_RUN)
    if rest := workers % WORKERS_OF_RUN:
        sizes.append(rest)
    runs = []
    for size, client in zip(sizes, itertools.cycle(cluster.clients), strict=False):
        options = {"tasks": ["delay"] * size, "max_steps": 10_000}
        body = {
            "benchmark_id": "calibration",
            "policy": {"name": "many workers"},
            "options": options,
            "max_workers": size,
        }
        answer = client.post("/v1/runs", json=body).raise_for_status()
        runs += [answer.json()["run_id"]] * size
    return runs


async def play(
    cluster: Cluster,
    runs: list[str],
    sleep_s: float,
    lasts_s: float,
    note: Callable[[], None] = lambda: None,
) -> tuple[float, list[Worker]]:
    """Seconds until all are attached, and the workers after they have played.

    note: is called when all are attached, and when they have played.
    """
    ports = [int(node.url.rpartition(":")[2]) for node in cluster.nodes]
    balancer = Balancer([(HOST, port) for port in ports])
    async with await balancer.listen(HOST, 0) as server:
        port = server.sockets[0].getsockname()[1]
        workers = [Worker(run, f"w{number}", port) for number, run in enumerate(runs)]
        began_at = time.monotonic()
        await asyncio.gather(*(worker.attach() for worker in workers))
        attached_s = time.monotonic() - began_at
        note()
        until = time.monotonic() + lasts_s
        await asyncio.gather(*(worker.play(sleep_s, until) for worker in workers))
        note()
        for worker in workers:
            await worker.close()
        await balancer.close()
    return attached_s, workers


def measure(*, trying: bool) -> str:
    """A table; trying: few workers, and short."""
    count = WORKERS_TRIED if trying else WORKERS
    sleep_s = SLEEP_S_TRIED if trying else SLEEP_S
    played_s = PLAYED_S_TRIED if trying else PLAYED_S
    where = measuring.machine()
    with open_cluster(count) as (cluster, _):
        runs = submit(cluster, count)
        attached_s, workers = asyncio.run(play(cluster, runs, sleep_s, played_s))
    turns = [len(worker.added_s) for worker in workers]
    added_ms = [1e3 * added_s for worker in workers for added_s in worker.added_s]
    rows = [
        ["workers, runs, nodes", f"{count}, {len(set(runs))}, {NODES}"],
        ["seconds until all were attached", f"{attached_s:.1f}"],
        ["seconds of a step", f"{sleep_s:g}"],
        ["turns", str(len(added_ms))],
        ["a turn beside its step, p50, ms", f"{statistics.median(added_ms):.0f}"],
        ["– p99", f"{measuring.percentile(added_ms, 99):.0f}"],
        ["– at most", f"{max(added_ms):.0f}"],
        ["turns of a worker", f"{min(turns)} to {max(turns)}"],
        ["repeated for want of room", str(sum(w.repeated for w in workers))],
        ["connections opened again", str(sum(w.reconnected for w in workers))],
    ]
    return f"{measuring.table(['', ''], rows)}\n\n{where}"
