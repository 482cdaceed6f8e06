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

# --- tasks ---


def test_the_profile_is_off_unless_asked_for() -> None:
    nothing: Any = None
    without_profile, asked = (
        Handlers(Settings(profiles=chosen), nothing)
        for chosen in (Settings().profiles, "ebench")
    )
    assert profile_tables(without_profile) == {}
    assert set(profile_tables(asked)) == set(EbenchHandlers(asked).table())


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
