"""What both generations of EBench's client were seen to send, sent again.

spec/vectors/ebench/requests.json holds the requests in their order. A server answers
each as its client needs it: the older one reads numbers, the current one labels.
"""

from __future__ import annotations

import base64
import json
from typing import Any

import httpx
import pytest

from tests.support.paths import ROOT
from tests.support.profiles.ebench_client import load_pickle
from tests.support.server.http_runs import submit

VECTORS = json.loads((ROOT / "spec/vectors/ebench/requests.json").read_text())
GENERATIONS = ("older", "current")
METRICS: dict[str, list[Any]] = {
    "older": [{"score": 0.5}, {"score": 0.5, "count": 0.0}],
    "current": [
        {"(1/1)score": {"score": 0.5, "sr": 0.0}},
        {
            "(1/1)score": {"score": 0.5, "sr": 0.0},
            "(1/1)count": {"score": 0.0, "sr": 0.0},
        },
    ],
}


def send(http: httpx.Client, vector: dict[str, Any], run_id: str) -> httpx.Response:
    def fill(value: Any) -> Any:
        text = json.dumps(value).replace("{run_id}", run_id)
        return json.loads(text.replace("{benchmark_id}", "calibration"))

    content = json.dumps(fill(vector["json"])).encode() if "json" in vector else None
    if "pickle" in vector:
        content = base64.b64decode(vector["pickle"])
    return http.request(
        vector["method"],
        fill(vector["path"]),
        params=fill(vector["query"]) or None,
        headers=fill(vector["headers"]),
        content=content,
    )


@pytest.mark.parametrize("generation", GENERATIONS)
def test_recorded_requests_are_answered(http: httpx.Client, generation: str) -> None:
    """EBE-024, EBE-025: every one with 200, and metrics in the client's own form."""
    run_id = submit(http, "score", "count")
    metrics = []
    for vector in VECTORS["vectors"]:
        if vector["generation"] != generation:
            continue
        answer = send(http, vector, run_id)
        assert answer.status_code == 200, (vector["id"], answer.text)
        if vector["path"].endswith("createTask"):
            run_id = answer.json()["data"]["task_id"]
        if "pickle" in vector:
            seen = load_pickle(answer.content)
            metrics.append(seen.get("obs", seen)["0"]["metric"])
        elif answer.headers["Content-Type"] == "application/json":
            assert answer.json().get("code", 0) == 0, (vector["id"], answer.text)
    assert [metric for metric in metrics if metric] == METRICS[generation]


def test_both_generations_use_every_operation_that_they_have() -> None:
    verbs = {
        generation: {
            vector["path"].rpartition("/")[2]
            for vector in VECTORS["vectors"]
            if vector["generation"] == generation
        }
        for generation in GENERATIONS
    }
    assert verbs["current"] - verbs["older"] == {"step_chunk"}
    assert {"docs", "reset", "step", "kill", "status", "stop"} <= verbs["older"]
