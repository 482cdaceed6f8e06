"""The page of metrics: what it says of a played run, and where it is."""

from __future__ import annotations

import math
import re
import socket
import sys
from collections.abc import Callable, Iterable
from pathlib import Path

import httpx
import prometheus_client.openmetrics.parser as openmetrics_parser
import pytest
from prometheus_client import Metric

from reference_server.__main__ import main
from reference_server.telemetry.counters import BOUNDS_S, Durations, Outcomes, timed
from tests.support.metrics_page import METRICS, metrics_url, read_page
from tests.support.paths import ROOT
from tests.support.server.http_runs import attach, predict_body, submit, worker_path
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.waiting import wait_until

OPENMETRICS = {"Accept": "application/openmetrics-text; version=1.0.0"}

# The library's reader, which has no types.
READ_OPENMETRICS: Callable[[str], Iterable[Metric]] = (
    openmetrics_parser.text_string_to_metric_families
)


def play(client: httpx.Client) -> tuple[str, str]:
    """Play the first of two episodes of one run, and leave another one queued."""
    played = submit(client, "score", "score")
    turn = attach(client, played)
    path = worker_path(played)
    body = predict_body(turn, score=1)
    body["actions"] *= 3
    turn = client.post(f"{path}/predict", json=body).json()
    body = predict_body(turn, score=1, end=1)
    turn = client.post(f"{path}/predict", json=body).json()
    assert turn["episode_result"]["outcome"], turn
    bad = body | {"seq": 99}
    assert client.post(f"{path}/predict", json=bad).status_code == 409
    return played, submit(client, "score")


@pytest.mark.slow("starts a server")
def test_the_page_has_what_was_played(tmp_path: Path) -> None:
    with ReferenceServer(tmp_path, PROCTOR_MAX_ACTIVE_RUNS="1", **METRICS) as server:
        url = metrics_url(server)
        with server.client() as client:
            played, waiting = play(client)
            page = read_page(url)
            assert page["http_server_open_connections",] == 1
            request = "http_server_request_duration_seconds_count"
            assert page[request, "predict", "2xx"] == 2
            assert page[request, "predict", "4xx"] == 1
            assert page[request, "submit_run", "2xx"] == 2
            bucket = "http_server_request_duration_seconds_bucket"
            assert page[bucket, "+Inf", "predict", "2xx"] == 2
            assert page["proctor_steps_total",] == 4
            assert page["proctor_step_time_seconds_total",] > 0
            assert page["proctor_sessions",] == 1
            assert page["proctor_turns_in_progress",] == 0
            assert page["proctor_runs", "running"] == 1
            assert page["proctor_runs", "queued"] == 1
            assert page["proctor_runs", "ready"] == 0
            assert page["proctor_simulators", "lent"] == 1
            assert page["proctor_simulator_starts_total",] >= 1
            assert page["proctor_recordings_total",] == 1
            files = [*tmp_path.rglob("00000.mcap")]
            assert page["proctor_recording_bytes_total",] == files[0].stat().st_size
            assert page["proctor_database_write_duration_seconds_count", "ok"] >= 3
            assert page["proctor_draining",] == 0
            assert page["process_resident_memory_bytes",] > 0
            wait_until(
                lambda: read_page(url)["proctor_queue_oldest_seconds",] > 0.01,
                "the queued run grows older",
            )
            outcomes = [key for key in page if key[0] == "proctor_episodes_total"]
            assert [page[key] for key in outcomes] == [1]
            path = worker_path(played)
            session = {"session_id": attach(client, played)["session_id"]}
            client.delete(path, params=session)
            client.post(f"/v1/runs/{played}/stop", json={})
            page = read_page(url)
            assert page["proctor_sessions_ended_total", "detached"] == 1
            assert page["proctor_run_changes_total", "stopped"] == 1
            wait_until(
                lambda: read_page(url)["proctor_runs", "queued"] == 0,
                "the queued run has the place that became free",
            )
            text = httpx.get(url, trust_env=False, headers=OPENMETRICS).text
            assert len(list(READ_OPENMETRICS(text))) > 20
            page_for_hosts = (ROOT / "docs/host/run-for-others.md").read_text()
            names = re.findall(r"^# TYPE (proctor_\w+)", text, re.MULTILINE)
            assert names
            assert [name for name in names if name not in page_for_hosts] == []
            for secret in (*TOKENS, *TOKENS.values(), played, waiting, "calibration"):
                assert secret not in text
        assert httpx.get(f"{server.url}/metrics", trust_env=False).status_code == 404
        ready = httpx.get(url.replace("metrics", "readyz"), trust_env=False)
        assert ready.json() == {"status": "ready"}


def test_durations_are_in_the_bucket_of_their_bound() -> None:
    durations = Durations()
    for seconds in (0.0, BOUNDS_S[0], 0.0003, 11.0):
        durations.add(seconds)
    assert durations.counts[:2] == [2, 1]
    assert durations.counts[-1] == 1
    assert math.isclose(durations.total_s, 11.00055)
    assert list(BOUNDS_S) == sorted(set(BOUNDS_S))


def test_work_that_raises_has_failed() -> None:
    outcomes = Outcomes(Durations)
    with timed(outcomes):
        pass
    with pytest.raises(KeyError), timed(outcomes):
        raise KeyError
    assert {key: sum(one.counts) for key, one in outcomes.items()} == {
        "ok": 1,
        "failed": 1,
    }


@pytest.mark.parametrize("flag", ["--metrics-port", "--port"])
@pytest.mark.parametrize("level", ["", "1"])
def test_a_port_that_is_taken_ends_the_start_with_one_line(
    flag: str,
    level: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Expect the option, and under make how make passes it on."""
    monkeypatch.delenv("MAKELEVEL", raising=False)
    if level:
        monkeypatch.setenv("MAKELEVEL", level)
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = str(taken.getsockname()[1])
        flags = ["--port", "0", "--metrics", "on", flag, port]
        monkeypatch.setattr(sys, "argv", ["reference_server", *flags])
        assert main() == 2
    line = capsys.readouterr().err
    of_make = rf" \(make serve ARGS='{flag} …'\)" if level else ""
    assert re.fullmatch(rf"proctor: cannot listen on .* {flag}{of_make}\n", line), line
