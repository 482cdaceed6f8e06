"""What the metrics of two nodes say while runs are played, passed on and pushed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from conformance.policy.scripted_policy import ScriptedPolicy
from tests.support.metrics_page import METRICS, Page, metrics_url, read_page
from tests.support.push_runs import ALLOW_LOOPBACK, submit_push_run, wait_for_state
from tests.support.server.cluster_nodes import Cluster, attach, predict
from tests.support.waiting import wait_until

PASSED_ON = "proctor_passed_on_request_duration_seconds_count"


@pytest.mark.slow("starts two servers")
def test_each_number_moves_where_it_happens(tmp_path: Path) -> None:
    settings = {"PROCTOR_MAX_ACTIVE_RUNS": "1"} | METRICS | ALLOW_LOOPBACK
    with (
        ScriptedPolicy() as policy,
        Cluster.of(tmp_path, str(tmp_path / "db"), 2, **settings) as cluster,
    ):
        urls = [metrics_url(node) for node in cluster.nodes]
        owner, other = cluster.clients

        def wait_for(number: int, holds: Callable[[Page], bool], what: str) -> None:
            wait_until(lambda: holds(read_page(urls[number])), what)

        body = {
            "benchmark_id": "calibration",
            "policy": {"name": "p"},
            "idle_timeout_s": 3,
            "options": {"tasks": ["score", "score"]},
        }
        run_id = owner.post("/v1/runs", json=body).json()["run_id"]
        turn = attach(other, run_id)
        assert predict(other, run_id, turn, score=0.5).status_code == 200
        pages = [read_page(url) for url in urls]
        assert [page["proctor_steps_total",] for page in pages] == [1, 0]
        assert pages[0]["proctor_step_time_seconds_total",] > 0
        assert [page[PASSED_ON, "ok"] for page in pages] == [0, 2]
        request = "http_server_request_duration_seconds_count"
        assert pages[0][request, "predict", "2xx"] == 1
        assert pages[1][request, "passed_on", "2xx"] == 2
        # It waits behind the run that is played, whose lease ends: no node has room.
        full = other.post("/v1/runs", json=body).json()["run_id"]
        wait_for_state(other, full, "ready")
        pushed = submit_push_run(owner, policy.url)
        queued = "proctor_queue_oldest_seconds"
        wait_for(0, lambda page: page[queued,] > 0, "the queue grows older")
        ended = ("proctor_sessions_ended_total", "lease_ended")
        wait_for(0, lambda page: page.get(ended, 0) == 1, "the lease is over")
        wait_for(0, lambda page: page["proctor_sessions",] == 0, "no session is left")
        other.post(f"/v1/runs/{run_id}/stop", json={})
        assert wait_for_state(owner, pushed)["state"] == "completed"
        calls = "proctor_policy_call_duration_seconds_count"
        page = read_page(urls[0])
        assert page[calls, "ok"] == len(policy.calls)
        assert page[queued,] == 0
        cluster.kill(0)
        answer = other.get(f"/v1/runs/{run_id}/score")
        assert answer.status_code in (200, 503)  # that node is not known to be away
        page = read_page(urls[1])
        # Either it was tried in vain, or it was known to be away meanwhile.
        assert page[PASSED_ON, "failed"] in (
            {1} if answer.status_code == 503 else {0, 1}
        )
        assert page["proctor_fenced_writes_total",] == 0  # none came too late
