"""How long workers wait for an answer when the node that has their run is killed.

Three nodes over one PostgreSQL. Each worker plays a run of its own, and sends a request
that was cut off to the next node, as a balancer without affinity would. A node is
killed while all play, and started again when all go on; the wait is the time from the
kill to the next answer of each worker whose run it had.
"""

import itertools
import signal
import tempfile
import threading
import time
from pathlib import Path
from typing import Any

import httpx

from benchmarks import measuring
from tests.support.server.cluster_nodes import Cluster
from tests.support.server.databases import UsedDatabase
from tests.support.server.http_runs import predict_body, submit, worker_path
from tests.support.server.postgresql_server import PostgresqlServer

TITLE = "Owners that are killed"
NODES, WORKERS, KILLS, KILLS_TRIED = 3, 6, 50, 6
EPISODES, STEPS, PAUSE_S, WAIT_S = 100, 400, 0.02, 60.0
_OWNED = "SELECT run_id FROM runs JOIN nodes ON owner = node_id WHERE url = '{}'"


class _Worker(threading.Thread):
    """answered_at: when its last turn was answered. lost: sessions that did not go on.

    wrong: turns that did not follow the one before.
    """

    def __init__(self, cluster: Cluster, number: int) -> None:
        super().__init__(daemon=True)
        self._cluster = cluster
        self._clients = itertools.cycle(
            [node.client() for node in cluster.nodes[number % NODES :] + cluster.nodes]
        )
        self._client = next(self._clients)
        options = {"max_steps": STEPS}
        self.run_id = submit(self._client, *["count"] * EPISODES, options=options)
        self.answered_at, self.lost, self.wrong = 0.0, 0, 0
        self.is_ending = threading.Event()

    def _send(self, method: str, path: str, body: dict[str, Any]) -> httpx.Response:
        while True:
            try:
                answer = self._client.request(method, path, json=body)
                if answer.status_code != 503:
                    return answer
            except httpx.HTTPError:
                pass
            self._client = next(self._clients)

    def _attach(self) -> dict[str, Any]:
        body = {"attach_key": str(time.monotonic_ns()), "takeover": True}
        answer = self._send("PUT", worker_path(self.run_id), body)
        return dict(answer.raise_for_status().json())

    def run(self) -> None:
        turn = self._attach()
        while not self.is_ending.wait(PAUSE_S):
            path = f"{worker_path(self.run_id)}/predict"
            answer = self._send("POST", path, predict_body(turn))
            if answer.status_code != 200:
                self.lost += 1
                turn = self._attach()
                continue
            self.answered_at = time.monotonic()
            step, turn = turn["episode"]["step"], answer.json()
            expected = 0 if "episode_result" in turn else step + 1
            self.wrong += turn["episode"]["step"] != expected


def measure(*, trying: bool) -> str:
    """The waits, and how many sessions were lost."""
    where = measuring.machine()
    kills = KILLS_TRIED if trying else KILLS
    with tempfile.TemporaryDirectory() as directory, PostgresqlServer() as postgresql:
        used = UsedDatabase(postgresql.create(), server=postgresql)
        waits_s, workers = _kill_owners(Path(directory), used, kills)
    row = [
        str(kills),
        str(len(waits_s)),
        *(f"{measuring.percentile(waits_s, percent):.2f}" for percent in (50, 99)),
        f"{max(waits_s):.2f}",
        str(sum(worker.lost for worker in workers)),
        str(sum(worker.wrong for worker in workers)),
    ]
    head = ["kills", "waits", "p50, s", "p99, s", "longest, s", "lost", "wrong turns"]
    return f"{measuring.table(head, [row])}\n\n{where}"


def _kill_owners(
    directory: Path, used: UsedDatabase, kills: int
) -> tuple[list[float], list[_Worker]]:
    waits_s: list[float] = []
    settings = {"PROCTOR_NODE_LEASE_S": "2", "PROCTOR_FAILOVER": "replay"}
    with Cluster.of(directory, used.url, NODES, **settings) as cluster:
        workers = [_Worker(cluster, number) for number in range(WORKERS)]
        for worker in workers:
            worker.start()
        _wait_for_answers(workers, time.monotonic())
        for number in range(kills):
            node = cluster.nodes[number % NODES]
            rows = used.execute(_OWNED.format(node.url))
            owned = {str(row[0]) for row in rows}
            killed_at = time.monotonic()
            node.end(signal.SIGKILL)
            of_node = [worker for worker in workers if worker.run_id in owned]
            waits_s += _wait_for_answers(of_node, killed_at)
            node.start()
            _wait_for_answers(workers, time.monotonic())
            measuring.say(f"{number + 1} of {kills}: {waits_s[-len(of_node) :]}")
        for worker in workers:
            worker.is_ending.set()
            worker.join(WAIT_S)
    return waits_s, workers


def _wait_for_answers(workers: list[_Worker], since: float) -> list[float]:
    """Seconds until each of them had its next answer."""
    deadline = since + WAIT_S
    waits: dict[str, float] = {}
    while len(waits) < len(workers):
        assert time.monotonic() < deadline, "workers did not go on"
        for worker in workers:
            if worker.answered_at > since:
                waits.setdefault(worker.run_id, worker.answered_at - since)
        time.sleep(0.005)
    return list(waits.values())
