"""Traces: what a collector receives of one server, and what it must not.

Of several nodes: tests/cluster/test_traces_of_nodes.py.
"""

from __future__ import annotations

import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from conformance.policy.scripted_policy import ScriptedPolicy
from reference_record.command_line.installation import install_command
from reference_server.__main__ import main
from reference_server.monitoring.request_spans import TraceParent, read_traceparent
from reference_server.monitoring.traces import Traces, endpoint_of
from reference_server.telemetry import spans
from tests.support.push_runs import ALLOW_LOOPBACK, play_push_run
from tests.support.server.http_runs import attach, predict_body, submit, worker_path
from tests.support.server.otlp_collector import Collector, ReceivedSpan, collecting
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.waiting import wait_until

SERVER, CLIENT = 2, 3  # kinds of spans
PREDICT = "POST /v1/runs/{run_id}/workers/{worker_id}/predict"
TRACE_ID, SPAN_ID = "4bf92f3577b34da6a3ce929d0e0e4736", "00f067aa0ba902b7"
SAMPLED = {"traceparent": f"00-{TRACE_ID}-{SPAN_ID}-01"}
NOT_SAMPLED = {"traceparent": f"00-{TRACE_ID}-{SPAN_ID}-00"}
FAILING = "the collector takes no traces"


@pytest.fixture
def collector() -> Iterator[Collector]:
    with collecting() as one:
        yield one


def play(client: httpx.Client) -> str:
    """One turn of a run, whose id it returns."""
    run_id = submit(client, "score")
    body = predict_body(attach(client, run_id), score=0.5)
    answer = client.post(f"{worker_path(run_id)}/predict", json=body)
    assert answer.status_code == 200, answer.text
    return run_id


def play_with(server: ReferenceServer, headers: dict[str, str]) -> None:
    with server.client() as client:
        client.headers.update(headers)
        play(client)


def one_named(found: list[ReceivedSpan], name: str) -> ReceivedSpan:
    (one,) = [span for span in found if span.name == name]
    return one


@pytest.mark.slow("starts a server")
def test_a_turn_shows_where_its_time_went(tmp_path: Path, collector: Collector) -> None:
    named = {"OTEL_SERVICE_NAME": "robots", "OTEL_RESOURCE_ATTRIBUTES": "a=b"}
    with (
        ReferenceServer(tmp_path, **collector.settings(**named)) as server,
        server.client() as client,
    ):
        client.headers["X-Request-Id"] = "asked-for"
        run_id = play(client)
        turn = collector.wait_for(PREDICT)[0]
        collector.wait_for("store run", 2)
        assert turn.kind == SERVER
        assert turn.parent == ""
        assert turn.instance == server.url
        assert turn.values == {
            "http.request.method": "POST",
            "http.route": "/v1/runs/{run_id}/workers/{worker_id}/predict",
            "http.response.status_code": 200,
            "proctor.operation": "predict",
            "proctor.request_id": "asked-for",
            "proctor.run_id": run_id,
        }
        playing = one_named(collector.parts_of(turn), "simulator plays")
        assert playing.values["proctor.steps"] == 1
        assert isinstance(playing.values["proctor.simulate_s"], float)
        assert playing.values["proctor.worker_id"] == "w"
        submitted = one_named(collector.spans(), "POST /v1/runs")
        stored = one_named(collector.parts_of(submitted), "store run")
        assert {one.name for one in collector.parts_of(stored)} == {
            "database transaction"
        }
        attached = one_named(
            collector.spans(), "PUT /v1/runs/{run_id}/workers/{worker_id}"
        )
        parts = {one.name for one in collector.parts_of(attached)}
        assert {"wait for simulator", "simulator begins"} <= parts
        assert set(collector.paths) == {"/v1/traces"}
        assert b"robots" in b"".join(collector.bodies)


@pytest.mark.slow("starts a server")
def test_no_secret_is_in_a_span(tmp_path: Path, collector: Collector) -> None:
    secrets = {"Idempotency-Key": "key-of-a-run", "tracestate": "vendor=secret-state"}
    with (
        ReferenceServer(tmp_path, **collector.settings()) as server,
        server.client() as client,
    ):
        body = {"benchmark_id": "calibration", "policy": {"name": "name-in-a-body"}}
        answer = client.post("/v1/runs", json=body, headers=secrets)
        turn = attach(client, answer.json()["run_id"], "key-that-attaches")
        path = worker_path(answer.json()["run_id"])
        client.delete(path, params={"session_id": turn["session_id"]})
        client.get("/v1/runs", params={"token": "token-in-a-query"})
        client.get("/v1/path-that-is-unknown")
        client.get(f"/v1/runs/{'x' * 65}")
        client.request("PROPFIND", "/v1/runs")
        collector.wait_for("_OTHER /v1/runs")
        received = b"".join(collector.bodies)
    hidden = [*secrets.values(), *TOKENS.values(), turn["session_id"], "x" * 65]
    hidden += ["name-in-a-body", "key-that-attaches", "token-in-a-query", "is-unknown"]
    hidden += ["PROPFIND", "secret-state"]
    assert [one for one in hidden if one.encode() in received] == []
    assert collector.spans("GET")[0].values["http.response.status_code"] == 404


@pytest.mark.slow("starts a server")
def test_a_client_starts_no_recording_and_joins_no_trace(
    tmp_path: Path, collector: Collector
) -> None:
    with ReferenceServer(tmp_path, **collector.settings()) as server:
        play_with(server, SAMPLED)
        linked = collector.wait_for(PREDICT)[0]
        assert linked.trace_id != TRACE_ID
        assert linked.parent == ""
        assert linked.links == (TRACE_ID,)
        play_with(server, NOT_SAMPLED)
        collector.wait_for(PREDICT, 2)
    settings = collector.settings(PROCTOR_TRACES_RATIO="0")
    collector.bodies.clear()
    (tmp_path / "other").mkdir()
    with ReferenceServer(tmp_path / "other", **settings) as server:
        play_with(server, SAMPLED)
        server.end()  # sends all that is recorded
    assert collector.spans() == []


@pytest.mark.slow("starts a server")
def test_behind_a_balancer_its_decision_holds(
    tmp_path: Path, collector: Collector
) -> None:
    settings = collector.settings(PROCTOR_TRACES_PARENT="all", PROCTOR_TRACES_RATIO="0")
    with ReferenceServer(tmp_path, **settings) as server:
        play_with(server, NOT_SAMPLED)
        play_with(server, SAMPLED)
        server.end()
    (turn,) = collector.spans(PREDICT)
    assert (turn.trace_id, turn.parent, turn.links) == (TRACE_ID, SPAN_ID, ())
    assert {one.trace_id for one in collector.spans()} == {TRACE_ID}


@pytest.mark.slow("starts a server")
def test_the_policy_server_is_part_of_a_push_turn(
    tmp_path: Path, collector: Collector
) -> None:
    settings = collector.settings() | ALLOW_LOOPBACK
    with ScriptedPolicy() as policy, ReferenceServer(tmp_path, **settings) as server:
        run = play_push_run(server, policy.url)
        assert run["state"] == "completed", run
        turns = collector.wait_for("push turn")
        assert {one.parent for one in turns} == {""}
        assert turns[0].values["proctor.run_id"] == run["run_id"]
        called = one_named(
            [
                one
                for one in collector.parts_of(turns[0])
                if one.values.get("proctor.path") == "/v1/policy/predict"
            ],
            "policy server",
        )
        assert called.kind == CLIENT
        sent = f"00-{called.trace_id}-{called.span_id}-01"
        assert sent in [dict(one.headers).get("traceparent") for one in policy.calls]
        names = {one.name for one in collector.parts_of(turns[0])}
        assert "simulator plays" in names


# --- the collector ---


@pytest.mark.slow("starts a server")
def test_a_collector_that_refuses_costs_one_line(
    tmp_path: Path, collector: Collector
) -> None:
    collector.status = 400
    with (
        ReferenceServer(tmp_path, **collector.settings()) as server,
        server.client() as client,
    ):
        while len(collector.paths) < 5:
            play(client)
        assert server.log().count(FAILING) == 1
        assert "code: 400" in server.log()
        collector.status = 200
        play(client)
        collector.wait_for(PREDICT)
        wait_until(lambda: "takes traces again" in server.log(), "it is logged")
        assert server.log().count("\n") == 2, server.log()


@pytest.mark.slow("starts a server")
def test_a_collector_that_is_away_is_named_once(tmp_path: Path) -> None:
    """Each batch is tried again for its time; turns do not wait for that."""
    with socket.socket() as closed:
        closed.bind(("127.0.0.1", 0))  # and it does not listen
        settings = Collector().settings(
            PROCTOR_TRACES=f"http://user:secret@127.0.0.1:{closed.getsockname()[1]}",
            OTEL_EXPORTER_OTLP_TIMEOUT="1.5",
        )
        with ReferenceServer(tmp_path, **settings) as server, server.client() as client:
            play(client)
            wait_until(lambda: FAILING in server.log(), "it is logged")
            play(client)
            server.end()
            assert server.log().count(FAILING) == 1
            assert "Connection refused" in server.log()
            assert "secret" not in server.log()


@pytest.mark.slow("starts a server")
def test_a_collector_that_hangs_neither_delays_a_turn_nor_fills_memory(
    tmp_path: Path, collector: Collector
) -> None:
    collector.go_on.clear()
    settings = collector.settings(
        OTEL_BSP_MAX_QUEUE_SIZE="8", OTEL_BSP_MAX_EXPORT_BATCH_SIZE="4"
    )
    with ReferenceServer(tmp_path, **settings) as server, server.client() as client:
        play(client)
        wait_until(lambda: collector.paths, "the collector is asked")
        for _ in range(50):  # none waits for the collector, which waits for us
            assert client.get("/v1").status_code == 200
        play(client)
        collector.go_on.set()
        last = play(client)
        wait_until(
            lambda: any(
                one.values.get("proctor.run_id") == last for one in collector.spans()
            ),
            "the last is received",
        )
        assert len(collector.spans("GET /v1")) < 20
        assert server.log() == ""


@pytest.mark.slow("starts a server")
def test_a_server_that_ends_sends_what_waits(
    tmp_path: Path, collector: Collector
) -> None:
    settings = collector.settings(OTEL_BSP_SCHEDULE_DELAY="3600000")
    with ReferenceServer(tmp_path, **settings) as server, server.client() as client:
        play(client)
        assert collector.paths == []
        server.end()
    assert len(collector.spans(PREDICT)) == 1


@pytest.mark.slow("starts a server")
def test_a_server_ends_without_a_collector_that_hangs(
    tmp_path: Path, collector: Collector
) -> None:
    collector.go_on.clear()
    with (
        ReferenceServer(tmp_path, **collector.settings()) as server,
        server.client() as client,
    ):
        play(client)
        wait_until(lambda: collector.paths, "the collector is asked")
        server.end()
        assert "the last traces could not be sent within 2 s" in server.log()


# --- what a client says ---


@pytest.mark.parametrize(
    "values",
    [
        [],
        [b""],
        [b"\xff" * 55],
        [SAMPLED["traceparent"].encode()] * 2,
        [SAMPLED["traceparent"].encode() + b"-x"],
        [SAMPLED["traceparent"].upper().encode()],
        [b"ff" + SAMPLED["traceparent"].encode()[2:]],
        [b"00-" + b"0" * 32 + b"-" + SPAN_ID.encode() + b"-01"],
        [b"00-" + TRACE_ID.encode() + b"-" + b"0" * 16 + b"-01"],
        [b"00-" + b"9" * 100_000 + b"-01"],
        ["00-٤".encode() * 20],
    ],
)
def test_a_traceparent_of_any_other_form_is_none(values: list[bytes]) -> None:
    scope = {"headers": [(b"traceparent", value) for value in values]}
    assert read_traceparent(scope) is None


@pytest.mark.parametrize(("flags", "is_recorded"), [("01", True), ("fe", False)])
def test_a_traceparent_is_read(flags: str, is_recorded: bool) -> None:
    value = f"00-{TRACE_ID}-{SPAN_ID}-{flags}".encode()
    read = read_traceparent({"headers": [(b"other", b"x"), (b"traceparent", value)]})
    assert read == TraceParent(int(TRACE_ID, 16), int(SPAN_ID, 16), is_recorded)


@pytest.mark.slow("starts a server")
def test_no_traceparent_breaks_a_request(tmp_path: Path, collector: Collector) -> None:
    good = SAMPLED["traceparent"].encode()
    settings = collector.settings(PROCTOR_TRACES_PARENT="all")
    with ReferenceServer(tmp_path, **settings) as server, server.client() as client:
        for value in (b"", b"\xff\xfe", b"0" * 7000, good + b",", b"00-" + b"9" * 60):
            headers = [(b"traceparent", value), (b"tracestate", b"=" * 600)]
            assert client.get("/v1", headers=headers).status_code == 200
        assert client.get("/v1", headers=[(b"traceparent", good)] * 2).is_success
        found = collector.wait_for("GET /v1", 6)
    assert {(one.parent, one.links) for one in found} == {("", ())}
    assert TRACE_ID not in {one.trace_id for one in found}


# --- set up ---


@pytest.mark.slow("imports the server in a new interpreter")
def test_a_server_without_traces_imports_none() -> None:
    program = (
        "import sys, reference_server.__main__\n"
        "print([name for name in sys.modules if name.startswith('opentelemetry')])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], check=True, capture_output=True, text=True
    )
    assert done.stdout == "[]\n"


def test_without_a_recorder_all_blocks_are_one() -> None:
    with spans.span("a") as first, spans.root_span("b") as second:
        first.set("name", "value")
    assert first is second is spans.NOT_RECORDED
    assert not first.is_recorded
    assert spans.traceparent() is None


def test_what_is_not_recorded_is_not_recorded_elsewhere() -> None:
    """The owner of a run draws no second time: it would have parts of traces."""
    traces = Traces("http://127.0.0.1:1", 0, version="1", instance="a")
    with traces.request(None, is_trusted=False) as request:
        assert not request.is_recorded
        sent = traces.traceparent(only_recorded=False)
        assert traces.traceparent(only_recorded=True) is None
        assert traces.part("x", is_call=True) is spans.NOT_RECORDED
    assert sent is not None
    read = read_traceparent({"headers": [(b"traceparent", sent.encode())]})
    assert read is not None
    assert not read.is_recorded
    eager = Traces("http://127.0.0.1:1", 1, version="1", instance="b")
    with eager.request(read, is_trusted=True) as passed_on:
        assert not passed_on.is_recorded


@pytest.mark.parametrize(
    ("url", "endpoint"),
    [
        ("http://h:4318", "http://h:4318/v1/traces"),
        ("http://h:4318/", "http://h:4318/v1/traces"),
        ("https://h/otlp", "https://h/otlp/v1/traces"),
        ("https://h/otlp/v1/traces", "https://h/otlp/v1/traces"),
    ],
)
def test_the_path_of_traces_is_added(url: str, endpoint: str) -> None:
    assert endpoint_of(url) == endpoint


def start(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], url: str
) -> str:
    """A server that does not start says so, and makes no file before."""
    flags = ["--port", "0", "--traces", url]
    monkeypatch.setattr(sys, "argv", ["reference_server", *flags])
    assert main() == 2
    return capsys.readouterr().err


def test_the_extra_that_is_missing_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    ours = "reference_server.monitoring.traces"
    monkeypatch.delitem(sys.modules, ours)
    monkeypatch.setitem(sys.modules, "opentelemetry.exporter", None)
    library = "opentelemetry.exporter.otlp.proto.http.trace_exporter"
    monkeypatch.setitem(sys.modules, library, None)
    line = start(monkeypatch, capsys, "http://127.0.0.1:1")
    assert line == (
        "proctor: --traces needs the packages of OpenTelemetry: "
        f"{install_command('server,traces')}\n"
    )


def test_a_variable_that_cannot_be_used_is_refused(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("OTEL_BSP_MAX_QUEUE_SIZE", "-1")
    line = start(monkeypatch, capsys, "http://127.0.0.1:1")
    assert line.startswith("proctor: cannot use --traces: max_queue_size must be")


@pytest.mark.parametrize("url", ["h:4318", "ftp://u:secret@h", "http://h?key=secret"])
def test_what_is_no_url_of_a_collector_is_refused(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], url: str
) -> None:
    line = start(monkeypatch, capsys, url)
    assert line.startswith("proctor: cannot use --traces: it must be the URL")
    assert "secret" not in line
