"""What the current generation of EBench's client needs, request by request."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

from reference_server.profiles.ebench.owed_results import OwedResults
from tests.support.profiles.ebench_client import (
    PICKLED,
    EbenchClient,
    action,
    count,
    decode_arrays,
    dump_pickle,
    episodes_of,
    load_pickle,
    open_client,
)
from tests.support.server.runs import make_run
from tests.support.servers import ReferenceServer

pytestmark = pytest.mark.slow("starts servers with other settings")


def send_chunk(client: EbenchClient, steps: Any) -> Any:
    """`step_chunk` as the current client sends it: the run is named in two places."""
    answer = client.http.post(
        f"{client.endpoint}/step_chunk",
        content=dump_pickle(steps),
        headers=PICKLED | {"run_id": client.task_id},
        params={"run_id": client.task_id},
    )
    assert answer.status_code == 200, answer.text
    return decode_arrays(load_pickle(answer.content))


# --- prefixes ---


@pytest.fixture(scope="module")
def chosen(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    """A server with every setting of the profile at another value."""
    directory = tmp_path_factory.mktemp("chosen")
    settings = {
        "PROCTOR_PROFILES": "ebench",
        "PROCTOR_EBENCH_PREFIXES": "/eval,/a/b",
        "PROCTOR_EBENCH_MAX_CHUNK": "3",
        "PROCTOR_EBENCH_MAX_ATTEMPTS": "2",
        "PROCTOR_EBENCH_EQUAL_STEPS": "answer_chunks",
    }
    with ReferenceServer(directory, **settings) as server:
        yield server


@pytest.mark.parametrize("prefix", ["", "/eval", "/a/b"])
def test_the_endpoint_is_under_the_prefix_that_was_used(
    chosen: ReferenceServer, prefix: str
) -> None:
    with chosen.client() as http:
        control = f"{prefix}/api/v1/benchmark/onlineEvaluation"
        made = http.post(f"{control}/createTask", json={"benchmark_set": "calibration"})
        task_id = made.json()["data"]["task_id"]
        ready = http.post(f"{control}/ready", json={"task_id": task_id}).json()["data"]
        assert urlsplit(ready["endpoint"]).path.startswith(f"{prefix}/eval-server/")
        query = {"run_id": task_id}
        assert http.get(f"{ready['endpoint']}/docs", params=query).status_code == 200
        root = ready["endpoint"].partition("/api/predict/")[0]
        assert http.post(f"{root}/stop", params=query).json()["code"] == 0


def test_another_prefix_is_not_found(chosen: ReferenceServer) -> None:
    with chosen.client() as http:
        path = "/other/api/v1/benchmark/onlineEvaluation/ready"
        assert http.post(path, json={"task_id": "x"}).status_code == 404


# --- attempts ---


def test_a_limit_of_attempts_is_the_operator_s(chosen: ReferenceServer) -> None:
    """EBE-030: two attempts here, though the benchmark has three."""
    with chosen.client() as http:
        client = open_client(http, "score")
        assert client.status()["max_attempts"] == 2
        for _ in range(2):
            client.reset()
            client.step({"0": action(score=0.5)})
            client.workers("kill")
        [episode] = episodes_of(client)
        assert episode["result"]["outcome"] == "abandoned"
        assert client.status()["repeated_attempts"] == 1


# --- long lists of steps ---


def test_the_limit_of_a_list_may_be_shorter_than_a_turn(
    chosen: ReferenceServer,
) -> None:
    with chosen.client() as http:
        client = open_client(http, "count")
        assert client.status()["max_chunk"] == 3
        assert client.step([{"0": action()}] * 3)
        body = dump_pickle([{"0": action()}] * 4)
        assert client.send("step", body).status_code == 422


# --- lost results ---


def test_results_of_before_a_restart_are_given_again(tmp_path: Path) -> None:
    """EBE-031: one with each executed step that ends no episode, and no step twice."""
    server = ReferenceServer(tmp_path, PROCTOR_PROFILES="ebench")
    try:
        with server.client() as http:
            client = open_client(http, "score", "score", "count")
            ids = []
            for score in (0.5, 1):
                seen, _ = client.step({"0": action(score=score, end=1)})
                ids.append(seen["0"]["episode_result"]["episode_id"])
        server.end(signal.SIGKILL)
        server.start()
        with server.client() as http:
            client = EbenchClient(http, client.task_id)
            client.find()
            assert client.reset()["0"]["episode_result"] is None
            again = []
            for number in range(3):
                body = action(vector=[float(number)] * 8)
                seen, _ = client.step({"0": body})
                assert (seen["0"]["metric"], count(seen)) == (None, number + 1)
                again.append(seen["0"]["episode_result"])
            assert [result and result["episode_id"] for result in again] == [*ids, None]
            assert [result["score"] for result in again[:2]] == [0.5, 1.0]
            seen, done = client.step({"0": action(end=1)})
            assert done
            assert seen["0"]["episode_result"]["task_name"] == "count"
    finally:
        server.end(signal.SIGKILL)


def test_a_result_is_owed_once_in_the_order_of_the_manifest() -> None:
    """EBE-031: however often its answer was lost."""
    owed = OwedResults()
    run = make_run(2)
    owed.notice(run)
    assert owed.take(run) is None
    owed.add(run, [1, 0, 1])
    assert [owed.take(run), owed.take(run), owed.take(run)] == [*run.episodes, None]


# --- equal steps ---


def test_varied_lists_are_repetitions_where_the_operator_says_so(
    chosen: ReferenceServer,
) -> None:
    """EBE-029: equal actions and single ones are steps; another step comes between."""
    with chosen.client() as http:
        client = open_client(http, "count", options={"max_steps": 100})
        assert client.status()["equal_steps"] == "answer_chunks"
        varied = [{"0": action(vector=[float(n)] * 8)} for n in range(3)]
        for _ in range(3):
            assert count(client.step(varied)[0]) == 3
        assert [count(client.step({"0": action()})[0]) for _ in range(2)] == [4, 5]
        assert count(client.step(varied)[0]) == 8
        same = [{"0": action()}] * 2
        assert [count(client.step(same)[0]) for _ in range(2)] == [10, 12]
        client.step(varied)
        client.reset()
        assert count(client.step(varied)[0]) == 18


def test_every_equal_step_is_a_repetition_where_the_operator_says_so(
    tmp_path: Path,
) -> None:
    """EBE-029: also a list of several turns; a policy that repeats itself stands."""
    settings = {"PROCTOR_PROFILES": "ebench", "PROCTOR_EBENCH_EQUAL_STEPS": "answer"}
    with ReferenceServer(tmp_path, **settings) as server, server.client() as http:
        client = open_client(http, "count", options={"max_steps": 1000})
        for _ in range(3):
            assert count(client.step({"0": action()})[0]) == 1
        for _ in range(2):
            answer = send_chunk(client, [{"0": action()}] * 100)
            assert (count(answer["obs"]), answer["executed_steps"]) == (101, 100)
        assert count(client.step({"0": action()})[0]) == 102
