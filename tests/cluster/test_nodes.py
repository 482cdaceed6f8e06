"""Servers that share a database: any of them answers for any run of the others."""

import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from typing import Any

import httpx
import pytest

from tests.support.pages.page_reader import PageReader
from tests.support.push_runs import episodes
from tests.support.server.cluster_nodes import (
    LEASE_S,
    Cluster,
    attach,
    go_on,
    pause,
    predict,
)
from tests.support.server.databases import UsedDatabase
from tests.support.server.http_runs import submit
from tests.support.server.postgresql_server import PostgresqlServer
from tests.support.servers import TOKENS
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts two servers")


@pytest.fixture(scope="module")
def used(postgresql: PostgresqlServer) -> UsedDatabase:
    """The database of the shared cluster."""
    return UsedDatabase(postgresql.create(), server=postgresql)


@pytest.fixture(scope="module")
def shared_cluster(
    tmp_path_factory: pytest.TempPathFactory, used: UsedDatabase
) -> Iterator[Cluster]:
    folder = tmp_path_factory.mktemp("cluster")
    with Cluster.of(folder, used.setting, 3, PROCTOR_MAX_OPEN_RUNS="30") as cluster:
        yield cluster


@pytest.fixture
def cluster(shared_cluster: Cluster) -> Cluster:
    """All its nodes run."""
    shared_cluster.start_again()
    return shared_cluster


def fence_of(used: UsedDatabase, run_id: str) -> int:
    """How many nodes have owned the run, as it is stored."""
    found = used.execute(f"SELECT fence FROM runs WHERE run_id = '{run_id}'")  # noqa: S608
    return int(found[0][0])


def play_to_end(
    client: httpx.Client, run_id: str, turn: dict[str, Any], score: float
) -> dict[str, Any]:
    """The rest of the episode in play, with one action that ends it."""
    answer = predict(client, run_id, turn, score=score, end=1)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def test_a_session_of_a_paused_node_has_ended(cluster: Cluster) -> None:
    first, second, _ = cluster.clients
    run_id = submit(first, "score")
    turn = attach(first, run_id)
    pause(cluster.nodes[0])
    taken = attach(second, run_id)
    go_on(cluster.nodes[0])
    late = predict(first, run_id, turn, score=1, end=1)
    assert late.status_code in (404, 409, 410), late.text
    assert play_to_end(first, run_id, taken, 0.5)["done"]
    assert [one["result"]["score"] for one in episodes(first, run_id)] == [0.5]


def test_a_short_pause_costs_nothing(cluster: Cluster, used: UsedDatabase) -> None:
    first, second, _ = cluster.clients
    run_id = submit(first, "score")
    turn = attach(second, run_id)
    pause(cluster.nodes[0])
    time.sleep(LEASE_S / 4)  # what is tested is a pause
    go_on(cluster.nodes[0])
    assert play_to_end(second, run_id, turn, 0.5)["done"]
    assert fence_of(used, run_id) == 1


def test_a_node_that_ends_in_order_leaves_its_runs_at_once(cluster: Cluster) -> None:
    first, second, _ = cluster.clients
    run_id = submit(first, "score")
    attach(first, run_id)
    cluster.nodes[0].end()
    body = {"attach_key": "a"}
    answer = second.put(f"/v1/runs/{run_id}/workers/w", json=body)
    assert answer.status_code == 200, answer.text


def test_a_reader_is_signed_in_at_every_node(cluster: Cluster) -> None:
    first, second, _ = cluster.clients
    run_id = submit(second, "score")
    reader = PageReader(str(first.base_url), "alice")
    reader.client.base_url = second.base_url
    assert run_id in reader.text(f"/pages/runs/{run_id}")
    assert reader.sign_out().status_code == 303
    for client in (first, second):
        reader.client.base_url = client.base_url
        assert reader.get("/pages/runs").status_code == 303


def test_a_reader_whose_node_is_paused_signs_in_at_another(cluster: Cluster) -> None:
    first, second, _ = cluster.clients
    reader = PageReader(str(first.base_url), "alice")
    pause(cluster.nodes[0])
    try:
        reader.client.base_url = second.base_url
        shown = reader.get("/pages/runs")
        assert shown.status_code == 503
        assert "/pages/login?next=%2Fpages%2Fruns" in shown.text
        assert reader.sign_in(TOKENS["alice"]).status_code == 303
        assert "Runs" in reader.text("/pages/runs")
    finally:
        go_on(cluster.nodes[0])


@pytest.mark.parametrize("path", ["/node/views", "/node/queue"])
def test_the_paths_for_nodes_answer_no_client(cluster: Cluster, path: str) -> None:
    answer = cluster.clients[0].post(path, json={"has_changed": True})
    assert answer.json()["code"] == "not_found"


def test_a_run_that_a_node_has_left_is_claimed_when_it_is_needed(
    cluster: Cluster, used: UsedDatabase
) -> None:
    """A repeated submission names its run in no path."""
    body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    first, second, _ = cluster.clients

    def submit_once(client: httpx.Client) -> str:
        answer = client.post("/v1/runs", json=body, headers={"Idempotency-Key": "left"})
        return str(answer.json()["run_id"])

    run_id = submit_once(first)
    first.post(f"/v1/runs/{run_id}/stop", json={"mode": "abort"})
    cluster.nodes[0].end()
    assert submit_once(second) == run_id
    assert fence_of(used, run_id) == 2


def test_quotas_count_the_runs_of_all_nodes(cluster: Cluster) -> None:
    body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    with ExitStack() as stack:
        clients = [stack.enter_context(node.client("bob")) for node in cluster.nodes]

        def submit_until_decided(number: int) -> dict[str, Any]:
            """A node that is late with its lease refuses: the key makes one run."""
            key = {"Idempotency-Key": f"quota-{number}"}
            decided: dict[str, Any] = {}

            def is_decided() -> bool:
                client = clients[number % 3]
                decided.clear()
                decided.update(client.post("/v1/runs", json=body, headers=key).json())
                return decided.get("code") != "unavailable"

            wait_until(is_decided, "the submission is decided")
            return decided

        with ThreadPoolExecutor(8) as threads:
            answers = list(threads.map(submit_until_decided, range(36)))
        made = [one["run_id"] for one in answers if "run_id" in one]
        assert len(made) == len(set(made)) == 30
        refused = {one["code"] for one in answers if "run_id" not in one}
        assert refused == {"quota_exceeded"}
        clients[1].post(f"/v1/runs/{made[0]}/stop", json={"mode": "abort"})
        assert clients[0].post("/v1/runs", json=body).status_code == 201
        resumed = clients[2].post(f"/v1/runs/{made[0]}/resume")
        assert resumed.json()["code"] == "quota_exceeded"
