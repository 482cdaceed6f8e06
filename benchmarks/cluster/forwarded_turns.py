"""The cost of forwarding a turn to another node.

Two nodes on this machine; one session of `calibration` is played with turns that
alternate between the owner of the run and the other node, so that both see the same
load.
"""

import statistics
import tempfile
import time
from pathlib import Path

from benchmarks import measuring
from tests.support.server.cluster_nodes import Cluster, attach, predict

TITLE = "Turns that are passed on"
TURNS, TURNS_TRIED, WARM_UP = 2000, 400, 200


def measure(*, trying: bool) -> str:
    """The median and the 95th percentile of each, and the ratio of the medians."""
    where = measuring.machine()
    with tempfile.TemporaryDirectory() as directory:
        taken = play_turns(Path(directory), TURNS_TRIED if trying else TURNS)
    owner_ms = statistics.median(taken["at the owner"])
    rows = [
        [
            name,
            f"{statistics.median(each):.2f}",
            f"{measuring.percentile(each, 95):.2f}",
            f"{statistics.median(each) / owner_ms:.2f}",
        ]
        for name, each in taken.items()
    ]
    return f"{measuring.table(['', 'p50, ms', 'p95, ms', 'ratio'], rows)}\n\n{where}"


def play_turns(directory: Path, turns: int) -> dict[str, list[float]]:
    """Milliseconds of each turn after the warm-up: at the owner, and passed on."""
    database = str(directory / "proctor.sqlite")
    taken: dict[str, list[float]] = {"at the owner": [], "passed on": []}
    with Cluster.of(directory, database, PROCTOR_NODE_LEASE_S="5") as cluster:
        body = {
            "benchmark_id": "calibration",
            "policy": {"name": "p"},
            "options": {"tasks": ["count"], "max_steps": turns + 1},
        }
        run_id = cluster.clients[0].post("/v1/runs", json=body).json()["run_id"]
        turn = attach(cluster.clients[0], run_id)
        for number in range(turns):
            began_at = time.perf_counter()
            answer = predict(cluster.clients[number % 2], run_id, turn)
            taken_ms = 1e3 * (time.perf_counter() - began_at)
            if number >= WARM_UP:
                list(taken.values())[number % 2].append(taken_ms)
            turn = answer.raise_for_status().json()
    return taken
