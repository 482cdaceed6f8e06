"""One queue of several servers: what waits at one goes to another one with room."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import httpx
import pytest

from tests.support.server.cluster_nodes import Cluster, attach, pause, predict
from tests.support.server.databases import UsedDatabase
from tests.support.server.http_runs import submit
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts two servers")


@pytest.fixture
def cluster(tmp_path: Path, database: UsedDatabase) -> Iterator[Cluster]:
    """Two nodes; each plays one run at once."""
    with Cluster.of(
        tmp_path, database.url, PROCTOR_MAX_ACTIVE_RUNS="1", PROCTOR_LOG_LEVEL="info"
    ) as cluster:
        yield cluster


def view(client: httpx.Client, run_id: str) -> dict[str, Any]:
    answer = client.get(f"/v1/runs/{run_id}")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def wait_for_state(client: httpx.Client, run_id: str, state: str) -> None:
    wait_until(lambda: view(client, run_id)["state"] == state, f"the run is {state}")


def test_a_node_with_room_takes_what_waits_at_another(cluster: Cluster) -> None:
    first, second = cluster.clients
    submit(first, "score")
    run_id = submit(first, "score")
    wait_for_state(first, run_id, "ready")
    assert view(second, run_id)["state"] == "ready"
    turn = attach(first, run_id)
    assert predict(second, run_id, turn, score=0.5, end=1).json()["done"]
    assert "took run" in cluster.nodes[1].log()
