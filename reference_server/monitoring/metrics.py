"""The metrics of a server as Prometheus reads them: the one user of its library.

Events are counted where they happen (`telemetry/counters.py`); the present state is
read when the page is asked for. Names follow the semantic conventions of OpenTelemetry
where these have one, with the unit last. Labels have few values, all of them from the
code: never an account, a run, a benchmark, a path or an address.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import accumulate

from prometheus_client import CollectorRegistry, ProcessCollector
from prometheus_client.core import (
    CounterMetricFamily,
    GaugeMetricFamily,
    HistogramMetricFamily,
    Metric,
)
from prometheus_client.exposition import choose_encoder
from prometheus_client.registry import Collector
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from reference_server.telemetry.counters import BOUNDS_S, Counters, Durations


@dataclass(frozen=True, slots=True)
class ServerState:
    """Numbers of a server at the moment.

    runs: numbers of those that have not ended, by state. oldest_queued_s: how long the
    first of the queue has waited; 0 without one. simulators: processes, by `lent` and
    `idle`. kept_bytes: on the disk, measured only if there is a bound.
    """

    version: str
    is_draining: bool
    connections: int
    event_streams: int
    sessions: int
    turns: int
    runs: Mapping[str, int]
    oldest_queued_s: float
    simulators: Mapping[str, int]
    simulators_max: int
    simulator_starts: int
    kept_bytes: int = 0
    kept_bytes_max: int = 0


ReadState = Callable[[], ServerState]


def metrics_route(counters: Counters, read_state: ReadState) -> Route:
    """`/metrics`: text of Prometheus, or OpenMetrics to a reader that accepts it."""
    page = _Page(counters)
    registry = CollectorRegistry()
    registry.register(page)
    ProcessCollector(registry=registry)

    async def show(request: Request) -> Response:
        page.state = read_state()
        encode, content_type = choose_encoder(request.headers.get("accept", ""))
        headers = {"Content-Type": content_type, "Cache-Control": "no-store"}
        return Response(encode(registry), headers=headers)

    return Route("/metrics", show)


class _Page(Collector):
    """The families of one answer."""

    def __init__(self, counters: Counters) -> None:
        self._counters = counters
        self.state: ServerState | None = None

    def describe(self) -> Iterable[Metric]:
        return ()

    def collect(self) -> Iterator[Metric]:
        assert self.state is not None, "it is read before the page is made"
        yield from _of_state(self.state)
        yield from _of_runs(self._counters)
        yield from _of_work(self._counters)


def _of_state(now: ServerState) -> Iterator[Metric]:
    build = GaugeMetricFamily("proctor_build_info", "Version.", labels=["version"])
    build.add_metric([now.version], 1)
    yield build
    for name, text, value in (
        ("proctor_draining", "1 while the server ends.", float(now.is_draining)),
        ("http_server_open_connections", "Open connections.", now.connections),
        ("proctor_event_streams", "Open streams of events.", now.event_streams),
        ("proctor_sessions", "Live sessions of workers.", now.sessions),
        ("proctor_turns_in_progress", "Turns in execution.", now.turns),
        (
            "proctor_queue_oldest_seconds",
            "How long the first run of the queue has waited.",
            now.oldest_queued_s,
        ),
        ("proctor_simulators_max", "Limit of lent simulators.", now.simulators_max),
    ):
        yield GaugeMetricFamily(name, text, value=value)
    if now.kept_bytes_max:
        text = "Bytes that the server keeps on its disk."
        yield GaugeMetricFamily("proctor_kept_bytes", text, value=now.kept_bytes)
        text = "Bytes that it may keep; then nothing new begins."
        most = now.kept_bytes_max
        yield GaugeMetricFamily("proctor_kept_bytes_max", text, value=most)
    runs = "Runs that have not ended, by state."
    yield _gauges("proctor_runs", runs, "state", now.runs)
    processes = "Simulator processes, by use."
    yield _gauges("proctor_simulators", processes, "use", now.simulators)
    starts = "Simulator processes started."
    yield _counter("proctor_simulator_starts", starts, now.simulator_starts)


def _of_runs(counted: Counters) -> Iterator[Metric]:
    yield _counters(
        "proctor_run_changes", "Runs that came to a state.", "state", counted.runs
    )
    yield _counters(
        "proctor_sessions_ended",
        "Sessions that ended, by cause; lease_ended: no request came in time.",
        "cause",
        counted.sessions_ended,
    )
    yield _counters(
        "proctor_episodes", "Episodes scored, by outcome.", "outcome", counted.episodes
    )
    steps = "Steps that simulators executed."
    yield _counter("proctor_steps", steps, counted.steps)
    seconds = "Time that simulators took for these steps."
    yield _counter("proctor_step_time_seconds", seconds, counted.simulate_s)
    faults = "Faults of simulators and of recordings in play."
    yield _counter("proctor_simulator_faults", faults, counted.simulator_faults)
    recordings = "Recordings of episodes completed."
    yield _counter("proctor_recordings", recordings, counted.recordings)
    size = "Size of these recordings."
    yield _counter("proctor_recording_bytes", size, counted.recording_bytes)
    fenced = "Writes of runs refused, as another node had claimed them."
    yield _counter("proctor_fenced_writes", fenced, counted.fenced_writes)
    failed = "Writes of recordings that failed."
    yield _counter("proctor_recording_failures", failed, counted.recordings_failed)


def _of_work(counted: Counters) -> Iterator[Metric]:
    requests = HistogramMetricFamily(
        "http_server_request_duration_seconds",
        "Requests answered, with the time to the end of the answer.",
        labels=["operation", "status"],
    )
    for (operation, hundreds), durations in sorted(counted.requests.items()):
        status = f"{hundreds}xx" if hundreds else "none"
        _add(requests, [operation, status], durations)
    yield requests
    refused = {str(key): count for key, count in counted.refused_requests.items()}
    text = "Requests refused before they were read, and closed with their connection."
    yield _counters("http_server_refused_requests", text, "status", refused)
    for name, text, outcomes in (
        (
            "proctor_policy_call_duration_seconds",
            "Calls of policy servers.",
            counted.policy_calls,
        ),
        (
            "proctor_database_write_duration_seconds",
            "Writes of runs, with the wait for those before.",
            counted.database_writes,
        ),
        (
            "proctor_passed_on_request_duration_seconds",
            "Requests passed on to other nodes; failed: without a whole answer.",
            counted.passed_on,
        ),
    ):
        family = HistogramMetricFamily(name, text, labels=["outcome"])
        for outcome in ("ok", "failed"):
            _add(family, [outcome], outcomes.get(outcome) or Durations())
        yield family


def _add(
    family: HistogramMetricFamily, labels: list[str], durations: Durations
) -> None:
    bounds = [*map(str, BOUNDS_S), "+Inf"]
    buckets = list(zip(bounds, accumulate(durations.counts), strict=True))
    family.add_metric(labels, buckets, durations.total_s)


def _counter(name: str, text: str, value: float) -> Metric:
    return CounterMetricFamily(name, text, value=value)


def _counters(name: str, text: str, label: str, values: Mapping[str, int]) -> Metric:
    family = CounterMetricFamily(name, text, labels=[label])
    for key, value in sorted(values.items()):
        family.add_metric([key], value)
    return family


def _gauges(name: str, text: str, label: str, values: Mapping[str, int]) -> Metric:
    family = GaugeMetricFamily(name, text, labels=[label])
    for key, value in sorted(values.items()):
        family.add_metric([key], value)
    return family
