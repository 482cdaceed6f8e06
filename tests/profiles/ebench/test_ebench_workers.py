"""EBench's workers: sixteen at once, killed, idle, stopped, resumed, disconnected."""

from __future__ import annotations

import socket
from concurrent.futures import ThreadPoolExecutor
from urllib.parse import urlsplit

import httpx
import pytest

from tests.support.profiles.ebench_client import (
    PICKLED,
    EbenchClient,
    action,
    count,
    dump_pickle,
    episodes_of,
    open_client,
)
from tests.support.raw_answers import read_answer
from tests.support.server.http_runs import submit
from tests.support.servers import TIMEOUT_S, TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("restarts servers")

# --- workers ---


def test_sixteen_workers_share_a_run(
    server: ReferenceServer, http: httpx.Client
) -> None:
    """Each in a thread of its own, as separate clients would be."""
    tasks = ["score", "count"] * 20
    scores = [round(0.01 * i, 2) for i in range(40)]
    task_id = submit(http, *tasks)

    def play(worker: str) -> int:
        with server.client() as own:
            client = EbenchClient(own, task_id, worker_ids=(worker,))
            client.find()
            seen, done, ended = client.reset(), False, 0
            while not done:
                if seen[worker]["obs"] is None:
                    break
                index = int(seen[worker]["obs"]["episode_id"].rpartition("e")[2])
                end = action(score=scores[index], success=index % 3 == 0, end=1)
                seen, done = client.step([{worker: action()}, {worker: end}])
                ended += seen[worker]["episode_result"] is not None
            client.workers("kill")
            return ended

    with ThreadPoolExecutor(16) as pool:
        ended = list(pool.map(play, map(str, range(16))))
    assert sum(ended) == 40
    expected = [
        scores[i] if task == "score" else float(i % 3 == 0)
        for i, task in enumerate(tasks)
    ]
    score = http.get(f"/v1/runs/{task_id}/score").json()
    assert (score["complete"], score["state"]) == (True, "completed")
    assert score["score"] == pytest.approx(sum(expected) / 40, abs=1e-12)


def test_a_loop_that_follows_its_first_worker_is_started_again(
    http: httpx.Client,
) -> None:
    """`gmp eval` ends when the first of its workers sees nothing, and kills them all.

    Each start completes at least the episode of that worker, so a few are enough.
    """
    workers = ("0", "1", "2")
    task_id = submit(http, *["score"] * 5)
    starts = 0
    while http.get(f"/v1/runs/{task_id}").json()["state"] != "completed":
        starts += 1
        client = EbenchClient(http, task_id, worker_ids=workers)
        client.find()
        seen, done = client.reset(), False
        while not done and seen["0"]["obs"] is not None:
            # The first worker is the fastest one.
            ends = {worker: action(end=worker == "0") for worker in workers}
            seen, done = client.step(ends)
        client.workers("kill")
    assert starts == 3  # the worker 0 plays three episodes, then one, then the last
    played = episodes_of(EbenchClient(http, task_id))
    assert [episode["result"]["outcome"] for episode in played] == ["failure"] * 5


def test_workers_beyond_the_limit_are_refused(http: httpx.Client) -> None:
    client = open_client(http, *["count"] * 3, workers=("0", "1"), max_workers=2)
    client.worker_ids = ("2",)
    answer = client.send("reset", dump_pickle({"worker_ids": ["2"]}))
    assert (answer.status_code, answer.json()["code"]) == (429, "worker_limit")


def test_a_simulator_that_breaks_costs_no_attempt(http: httpx.Client) -> None:
    client = open_client(http, "fault")
    client.step([{"0": action()}] * 2)
    seen, done = client.step({"0": action(fault=1)})
    assert (seen["0"]["obs"]["reset"], count(seen), done) == (True, 0, False)
    assert (seen["0"]["metric"], seen["0"]["episode_result"]) == (None, None)
    assert [e["attempt"] for e in episodes_of(client)] == [1]
    assert client.step({"0": action(end=1)})[1]


def test_a_failed_run_is_reported(http: httpx.Client) -> None:
    client = open_client(http, "fault", options={"max_faults": 1})
    broken = client.send("step", dump_pickle({"0": action(fault=1)}))
    assert (broken.status_code, broken.json()["code"]) == (409, "session_ended")
    answer = client.find()
    assert (answer["code"], "failed" in answer["msg"]) == (409, True)
    client.submit(task_id=client.task_id)
    assert client.reset()["0"]["obs"]["reset"]


def test_both_apis_work_on_the_same_run(http: httpx.Client) -> None:
    """A worker by each, and the session of one is seen by the other."""
    client = open_client(http, "count", "count")
    path = f"/v1/runs/{client.task_id}/workers"
    turn = http.put(f"{path}/native", json={"attach_key": "key"}).json()
    assert turn["episode"]["index"] == 1
    assert client.status()["active_workers"] == ["0", "native"]
    busy = http.put(f"{path}/0", json={"attach_key": "key"})
    assert busy.json()["code"] == "worker_busy"
    taken = http.put(f"{path}/0", json={"attach_key": "key", "takeover": True}).json()
    assert taken["observation"]["state"]["count"] == [0.0]
    # EBench's wire has no sessions: it goes on with the worker's, whosever it is.
    assert count(client.step({"0": action()})[0]) == 1


# --- lost answers ---


def address_of(server: ReferenceServer) -> tuple[str, int]:
    host, port = urlsplit(server.url).netloc.split(":")
    return host, int(port)


def request_of(
    server: ReferenceServer, client: EbenchClient, verb: str, body: bytes
) -> bytes:
    """A request as it goes over the wire."""
    headers = {
        **PICKLED,
        "Host": urlsplit(server.url).netloc,
        "Authorization": f"Bearer {TOKENS['alice']}",
        "Content-Length": str(len(body)),
    }
    lines = [f"POST {urlsplit(client.endpoint).path}/{verb} HTTP/1.1"]
    lines += [f"{name}: {value}" for name, value in headers.items()]
    return "\r\n".join([*lines, "", ""]).encode() + body


def test_closing_after_the_whole_answer_confirms_it(
    server: ReferenceServer, http: httpx.Client
) -> None:
    """As `requests.post` does: a connection for each step, closed at once."""
    client = open_client(http, "count", options={"max_steps": 200})
    body = dump_pickle({"0": action()})
    request = request_of(server, client, "step", body)
    host, port = address_of(server)
    for _ in range(100):
        with socket.create_connection((host, port), TIMEOUT_S) as connection:
            connection.sendall(request)
            read_answer(connection)
    assert count(client.reset()) == 100
