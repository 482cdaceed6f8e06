"""One queue of several servers: what waits at one goes to another one with room."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, TypeAlias

import httpx
import pytest

from tests.support.push_runs import wait_for_state
from tests.support.server.cluster_nodes import Cluster, attach, go_on, pause, predict
from tests.support.server.databases import UsedDatabase
from tests.support.server.http_runs import submit
from tests.support.server.postgresql_server import PostgresqlServer
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts two servers")

SharedCluster: TypeAlias = tuple[Cluster, UsedDatabase]


OPEN_RUNS_MAX = 25


@pytest.fixture(
    scope="module",
    params=["sqlite", pytest.param("postgresql", marks=pytest.mark.slow("PostgreSQL"))],
)
def shared_cluster(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[SharedCluster]:
    """Two nodes; each plays one run at once."""
    folder = tmp_path_factory.mktemp("cluster")
    used = UsedDatabase.of_file(folder / "proctor.sqlite")
    if request.param == "postgresql":
        server: PostgresqlServer = request.getfixturevalue("postgresql")
        used = UsedDatabase(server.create(), server=server)
    with Cluster.of(
        folder,
        used.setting,
        PROCTOR_MAX_ACTIVE_RUNS="1",
        PROCTOR_MAX_OPEN_RUNS=str(OPEN_RUNS_MAX),
    ) as cluster:
        yield cluster, used


@pytest.fixture
def cluster(shared_cluster: SharedCluster) -> Cluster:
    """No run is open."""
    cluster, used = shared_cluster
    query = (
        "SELECT account, run_id FROM runs WHERE state IN ('queued', 'ready', 'running')"
    )
    with cluster.nodes[0].client("bob") as bob:
        clients = {"alice": cluster.clients[0], "bob": bob}
        for account, run_id in used.execute(query):
            stop(clients[str(account)], str(run_id))
    return cluster


@pytest.fixture
def used(shared_cluster: SharedCluster) -> UsedDatabase:
    return shared_cluster[1]


def view(client: httpx.Client, run_id: str) -> dict[str, Any]:
    answer = client.get(f"/v1/runs/{run_id}")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def test_a_node_with_room_takes_what_waits_at_another(cluster: Cluster) -> None:
    first, second = cluster.clients
    submit(first, "score")
    run_id = submit(first, "score")
    wait_for_state(first, run_id, "ready")
    assert view(second, run_id)["state"] == "ready"
    turn = attach(first, run_id)
    assert predict(second, run_id, turn, score=0.5, end=1).json()["done"]
    assert "took run" in cluster.nodes[1].log()


def stop(client: httpx.Client, run_id: str) -> None:
    answer = client.post(f"/v1/runs/{run_id}/stop", json={"mode": "abort"})
    assert answer.status_code == 200, answer.text


def wait_for_change(
    threads: ThreadPoolExecutor, client: httpx.Client, run_id: str
) -> Future[httpx.Response]:
    """A long poll of the run, from what this client sees now."""
    etag = client.get(f"/v1/runs/{run_id}").headers["ETag"]
    headers = {"If-None-Match": etag, "Prefer": "wait=20"}
    return threads.submit(client.get, f"/v1/runs/{run_id}", headers=headers)


def fill(cluster: Cluster, used: UsedDatabase) -> list[str]:
    """Give every node the one run that it plays; the ids are in the order of nodes.

    A node may still offer its place to a run of an earlier test as it gets the new one,
    which the other node takes then.
    """
    run_ids = [submit(client, "score") for client in cluster.clients]
    for client, run_id in zip(cluster.clients, run_ids, strict=True):
        wait_for_state(client, run_id, "ready")
    query = "SELECT run_id, url FROM runs JOIN nodes ON owner = node_id"
    urls = {str(run_id): str(url) for run_id, url in used.execute(query)}
    order = [node.url for node in cluster.nodes]
    return sorted(run_ids, key=lambda run_id: order.index(urls[run_id]))


def test_who_waits_for_a_run_follows_it_to_the_node_that_takes_it(
    cluster: Cluster, used: UsedDatabase
) -> None:
    """A long poll at each node, over the one that had the run and the one that has."""
    playing = fill(cluster, used)
    first, second = cluster.clients
    run_id = submit(first, "score")
    with ThreadPoolExecutor(2) as threads:
        waiting = [wait_for_change(threads, one, run_id) for one in (first, second)]
        stop(second, playing[1])
        answers = [one.result() for one in waiting]
    assert [one.status_code for one in answers] == [200, 200]
    assert {one.json()["state"] for one in answers} == {"ready"}
    assert "proctor-run-moved" not in answers[0].headers
    assert f"took run {run_id}" in cluster.nodes[1].log()
    for client in (first, second):
        stop(client, run_id)


def test_no_run_too_many_is_let_in_when_both_nodes_have_room_at_once(
    cluster: Cluster, used: UsedDatabase
) -> None:
    """What is ready is stopped at either node, until nothing waits any more.

    Expect each run to have been ready once, and never more of them than places.
    """
    run_ids = {submit(cluster.clients[n % 2], "score") for n in range(20)}
    active: list[int] = []
    over: set[str] = set()

    def stop_what_is_ready(client: httpx.Client) -> None:
        while len(over) < len(run_ids):
            query = "SELECT run_id FROM runs WHERE state = 'ready'"
            ready = [str(row[0]) for row in used.execute(query)]
            active.append(len(ready))
            for run_id in ready:
                answer = client.post(f"/v1/runs/{run_id}/stop", json={"mode": "abort"})
                assert answer.status_code == 200, answer.text
                over.add(run_id)

    with ThreadPoolExecutor(2) as threads:
        list(threads.map(stop_what_is_ready, cluster.clients))
    assert over == run_ids
    assert max(active) == 2
    found = used.execute("SELECT run_id, state, fence FROM runs")
    owned = {run_id: fence for run_id, state, fence in found if state == "stopped"}
    assert max(owned[run_id] for run_id in run_ids) <= 2  # taken once at most


def test_an_event_stream_follows_a_run_to_the_node_that_takes_it(
    cluster: Cluster, used: UsedDatabase
) -> None:
    """One stream at the node that had the run, one that it is passed on from.

    Expect the same events in both, each once, without a reader that reconnects.
    """
    playing = fill(cluster, used)
    first, second = cluster.clients
    run_id = submit(first, "score", "score")
    with ThreadPoolExecutor(2) as threads:
        began = [threading.Event() for _ in range(2)]
        reading = [
            threads.submit(read_events, client, run_id, event)
            for client, event in zip((first, second), began, strict=True)
        ]
        assert all(event.wait(TIMEOUT_S) for event in began)
        stop(second, playing[1])
        wait_for_state(first, run_id, "ready")
        turn = attach(first, run_id)
        for _ in range(2):
            turn = predict(second, run_id, turn, score=0.5, end=1).json()
        seen = [one.result(30) for one in reading]
    assert turn["done"]
    assert f"took run {run_id}" in cluster.nodes[1].log()
    for events in seen:
        ids = [one["id"] for one in events]
        assert len(set(ids)) == len(ids)
        assert [one["event"] for one in events].count("episode") == 2
        states = [one["data"].get("state") for one in events if one["event"] == "run"]
        assert (states[0], states[-1]) == ("queued", "completed")
    assert seen[0][-1]["id"] == seen[1][-1]["id"]


def read_events(
    client: httpx.Client, run_id: str, began: threading.Event
) -> list[dict[str, Any]]:
    """All events of one stream, until it ends; began: is set after the first one."""
    events: list[dict[str, Any]] = [{}]
    with client.stream("GET", f"/v1/runs/{run_id}/events") as stream:
        for line in stream.iter_lines():
            name, _, value = line.partition(": ")
            if not line and "id" in events[-1]:
                events.append({})
                began.set()
            elif name in ("event", "id", "data"):
                events[-1][name] = json.loads(value) if name == "data" else value
    return events[:-1]


def test_a_run_that_waits_at_a_paused_node_is_let_in_by_another(
    cluster: Cluster, used: UsedDatabase
) -> None:
    """When the node goes on, it has lost the run for good."""
    playing = fill(cluster, used)
    first, second = cluster.clients
    run_id = submit(first, "score")
    pause(cluster.nodes[0])
    try:
        stop(second, playing[1])
        wait_for_change_to_ready(second, run_id)
        turn = attach(second, run_id)
        assert predict(second, run_id, turn, score=1, end=1).json()["done"]
    finally:
        go_on(cluster.nodes[0])
    wait_for_state(first, run_id, "completed")


def wait_for_change_to_ready(client: httpx.Client, run_id: str) -> None:
    def state() -> str | None:
        found = client.get(f"/v1/runs/{run_id}").json()
        return str(found["state"]) if "state" in found else None

    wait_until(lambda: state() == "ready", "the run is ready")
