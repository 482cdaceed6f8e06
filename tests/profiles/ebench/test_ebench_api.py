"""EBench's API on our server: what the kit's checks of the profile leave open.

Most runs are on `calibration` and submitted by `submit_run`, because that has options:
`action` holds the vectors of its action space one after another, sorted by name.
"""

from __future__ import annotations

from typing import Any
from urllib.parse import urlsplit

import httpx
import pytest

from reference_server.http.handlers import Handlers
from reference_server.profiles.ebench.task_handlers import EbenchHandlers
from reference_server.profiles.operation_tables import profile_tables
from reference_server.settings import Settings
from tests.support.profiles.ebench_client import (
    EbenchClient,
    Json,
    action,
    count,
    dump_pickle,
    open_client,
    run_of,
)
from tests.support.server.http_runs import submit
from tests.support.servers import TIMEOUT_S, ReferenceServer

# --- tasks ---


def test_the_profile_is_off_unless_asked_for() -> None:
    nothing: Any = None
    without_profile, asked = (
        Handlers(Settings(profiles=chosen), nothing)
        for chosen in (Settings().profiles, "ebench")
    )
    assert profile_tables(without_profile) == {}
    assert set(profile_tables(asked)) == set(EbenchHandlers(asked).table())


def test_a_task_is_a_run(http: httpx.Client) -> None:
    client = EbenchClient(http)
    ready = client.submit(
        model_name="internVLA",
        model_type="VLA",
        benchmark_set="calibration",
        submitter_name="test",
        submitter_homepage="http://example.com",
        is_public=0,
    )
    assert (ready["msg"], ready["data"]["ready"]) == ("success", True)
    assert ready["trace_id"]
    assert "/api/predict/" in client.endpoint
    assert "ebench" in http.get("/v1").json()["profiles"]
    run = run_of(client)
    assert (run["state"], run["benchmark_id"]) == ("ready", "calibration")
    assert run["policy"] == {
        "name": "internVLA (VLA)",
        "submitter": "test",
        "homepage": "http://example.com",
    }


@pytest.mark.parametrize(
    ("wanted", "benchmark_id"),
    [
        ({}, "mobile_bimanual"),
        ({"benchmark_set": "ebench_generalist"}, "mobile_bimanual"),
        ({"benchmark_set": "ebench_mobile_manip"}, "mobile_bimanual_mobile_manip"),
        ({"benchmark_set": "mobile_bimanual_ee"}, "mobile_bimanual_ee"),
    ],
)
def test_a_benchmark_set_is_a_benchmark(
    http: httpx.Client, wanted: Json, benchmark_id: str
) -> None:
    client = EbenchClient(http)
    client.submit(**wanted)
    assert run_of(client)["benchmark_id"] == benchmark_id
    client.stop()


@pytest.mark.parametrize(
    ("name", "body", "code"),
    [
        ("createTask", {"benchmark_set": "no_such_set"}, 422),
        ("createTask", {"benchmark_set": "No such set"}, 422),
        ("createTask", {"benchmark_set": 7}, 422),
        ("createTask", {"model_name": "x" * 300}, 422),
        ("createTask", {"task_id": "run_unknown"}, 404),
        ("ready", {"task_id": "run_unknown"}, 404),
        ("ready", {}, 422),
    ],
)
def test_a_refusal_of_the_control_plane_is_an_envelope(
    http: httpx.Client, name: str, body: Json, code: int
) -> None:
    answer = EbenchClient(http).control(name, **body)
    assert (answer["code"], answer["data"]) == (code, None)
    assert len(answer["msg"]) > 20


def test_foreign_accounts_are_refused_in_an_envelope(
    server: ReferenceServer, http: httpx.Client
) -> None:
    task_id = submit(http, "score")
    with server.client("bob") as bob, server.client("reader") as reader:
        for client_of_account, code in ((bob, 404), (reader, 403)):
            foreign_client = EbenchClient(client_of_account, task_id)
            assert foreign_client.control("createTask", task_id=task_id)["code"] == code
            url = f"/eval-server/{task_id}/stop"
            assert foreign_client.stop(url)["code"] == code
        assert EbenchClient(bob, task_id).find()["code"] == 404
        assert EbenchClient(reader, task_id).find()["data"]["ready"]
    with httpx.Client(
        base_url=server.url, trust_env=False, timeout=TIMEOUT_S
    ) as anonymous:
        assert EbenchClient(anonymous, task_id).find()["code"] == 401


# --- steps ---


@pytest.mark.parametrize(
    ("verb", "body", "status"),
    [
        ("step", dump_pickle({}), 422),
        ("step", dump_pickle([]), 422),
        ("step", dump_pickle("0"), 422),
        ("step", dump_pickle([1]), 422),
        ("step", dump_pickle({"no id": action()}), 422),
        ("step", dump_pickle({"0": action(), 0: action()}), 422),
        ("step", dump_pickle({str(i): action() for i in range(17)}), 422),
        ("step", dump_pickle([{"0": action()}] * 1025), 422),
        ("step", dump_pickle({"0": {1: None, "action": [float("nan")] * 15}}), 422),
        ("step", b"not a pickle", 400),
        ("step", b"cos\nsystem\n(Vtrue\ntR.", 400),
        ("step", b"", 400),
        ("reset", dump_pickle({}), 422),
        ("reset", dump_pickle({"worker_ids": "0"}), 422),
        ("reset", dump_pickle({"worker_ids": ["0", "0"]}), 422),
        ("reset", dump_pickle({"worker_ids": [None]}), 422),
        ("reset", dump_pickle(["0"]), 422),
    ],
)
def test_a_bad_request_is_a_problem(
    http: httpx.Client, verb: str, body: bytes, status: int
) -> None:
    client = open_client(http, "count")
    before = run_of(client)
    answer = client.send(verb, body)
    assert (answer.status_code, answer.json()["status"]) == (status, status)
    assert run_of(client)["progress"] == before["progress"]
    assert count(client.step({"0": action()})[0]) == 1


def test_requests_outside_the_profile_are_refused(http: httpx.Client) -> None:
    client = open_client(http, "count")
    body = dump_pickle({"0": action()})
    wrong = client.send("step", body, **{"Content-Type": "application/json"})
    assert wrong.status_code == 415
    assert client.send("step", body, run_id="run_other").status_code == 404
    path = urlsplit(client.endpoint).path
    elsewhere = path.replace("/predict/calibration", "/predict/tabletop")
    assert http.get(f"{elsewhere}/docs").status_code == 404
    assert http.post(f"{client.endpoint}/kill", json={"data": {}}).status_code == 422
    assert http.get(f"{client.endpoint}/step").status_code == 405
    assert count(client.step({"0": action()})[0]) == 1
