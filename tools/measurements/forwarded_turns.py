"""`python -m tools.measurements.forwarded_turns`: what passing a turn on costs.

Two nodes on this machine; one session of `calibration` is played with turns that
alternate between the owner of the run and the other node, so that both see the same
load. Prints the median and the 95th percentile of each, and their ratio.
"""

from __future__ import annotations

import statistics
import tempfile
import time
from pathlib import Path

from tests.support.server.cluster_nodes import Cluster, attach, predict

TURNS, WARM_UP = 2000, 200


def measure(directory: Path) -> tuple[list[float], list[float]]:
    """Milliseconds of each turn: at the owner, and passed on."""
    database = str(directory / "proctor.sqlite")
    with Cluster.of(directory, database, PROCTOR_NODE_LEASE_S="5") as cluster:
        body = {
            "benchmark_id": "calibration",
            "policy": {"name": "p"},
            "options": {"tasks": ["count"], "max_steps": TURNS + 1},
        }
        run_id = cluster.clients[0].post("/v1/runs", json=body).json()["run_id"]
        turn = attach(cluster.clients[0], run_id)
        taken: tuple[list[float], list[float]] = ([], [])
        for number in range(TURNS):
            started = time.perf_counter()
            answer = predict(cluster.clients[number % 2], run_id, turn)
            taken[number % 2].append(1e3 * (time.perf_counter() - started))
            turn = answer.raise_for_status().json()
    return taken


def main() -> None:
    with tempfile.TemporaryDirectory() as directory:
        both = [one[WARM_UP // 2 :] for one in measure(Path(directory))]
    medians = [statistics.median(one) for one in both]
    for name, one in zip(("at the owner", "passed on"), both, strict=True):
        p95 = statistics.quantiles(one, n=20)[-1]
        print(f"{name:13} {statistics.median(one):6.2f} ms, p95 {p95:6.2f} ms")
    print(f"ratio         {medians[1] / medians[0]:6.2f}")


if __name__ == "__main__":
    main()
