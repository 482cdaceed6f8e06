"""The throughput of simulators over the protocol: section `throughput`.

The same control steps are played in Python loops, one process each; by such processes
behind a TCP socket (direct_simulation.py); and through a complete reference server with
as many workers: alternately (A B C A B C …), on the same cores. Sessions, exactly-once
execution, scoring and the store are active.

A client is a thread with the data plane of `reference_client`: the cost of the client
is included, that of a policy is not.
"""

from __future__ import annotations

import contextlib
import os
import statistics
import tempfile
import threading
import time
import uuid
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from proctor_client import ApiException, AttachWorker, PolicyInfo, StopRun, SubmitRun

from benchmarks import performance_page
from benchmarks.filled_databases import running_server
from benchmarks.results import Json
from benchmarks.round_trips.contenders.ours_client import TOKEN
from benchmarks.throughput.direct_simulation import (
    ACTIONS,
    Case,
    measure_bare,
    measure_over_tcp,
)
from reference_client.protocol.connection import Connection

ROUNDS, SECONDS = 3, 2.0
SECONDS_TRIED = 0.5


CASES = (
    *(Case("tabletop_state", workers, 1) for workers in (1, 2, 4, 8, 16)),
    *(Case("tabletop_state", 16, chunk) for chunk in (8, 32)),
    *(Case("mobile_bimanual", workers, 1) for workers in (4, 16)),
)


def measure(trying: bool, say: Callable[[str], None]) -> Json:
    """The section. trying: once each, and short."""
    os.environ["OPENBLAS_NUM_THREADS"] = "1"  # processes are the parallelism
    seconds, rounds = (SECONDS_TRIED, 1) if trying else (SECONDS, ROUNDS)
    with (
        tempfile.TemporaryDirectory() as scratch,
        running_server(Path(scratch, "bench.sqlite")) as server,
    ):
        url = f"http://{server.netloc}"
        rows = [_row(case, url, seconds, rounds, say) for case in CASES]
    return {"seconds": seconds, "rounds": rounds, "rows": rows}


def _row(
    case: Case, url: str, seconds: float, rounds: int, say: Callable[[str], None]
) -> Json:
    bares, limits, ours = [], [], []
    for _ in range(rounds):
        bares.append(measure_bare(case, seconds))
        limits.append(measure_over_tcp(case, seconds))
        ours.append(measure_protocol(case, url, seconds))
    shares = [own / plain for own, plain in zip(ours, bares, strict=True)]
    limit = [raw / plain for raw, plain in zip(limits, bares, strict=True)]
    row = {
        **case._asdict(),
        "bare_steps_per_s": round(statistics.median(bares), 1),
        "tcp_steps_per_s": round(statistics.median(limits), 1),
        "protocol_steps_per_s": round(statistics.median(ours), 1),
        "tcp_share": round(statistics.median(limit), 3),
        "share": round(statistics.median(shares), 3),
        "share_worst": round(min(shares), 3),
    }
    say(f"{row}")
    return row


# Over the protocol


class ThroughputWorker:
    """One worker of a run; when there is nothing left to play, of a run of its own."""

    def __init__(self, case: Case, url: str, run_id: str, number: int) -> None:
        self._case = case
        self._connection = Connection(url, TOKEN, requests=1)
        self._plane = self._connection.data(url)
        self._attach(run_id, f"w{number}")

    def _attach(self, run_id: str, worker_id: str) -> None:
        self._run_id, self._worker_id = run_id, worker_id
        request = AttachWorker(attach_key=uuid.uuid4().hex)
        self._turn = self._plane.attach_worker(run_id, worker_id, request)

    def play(self, seconds: float, barrier: threading.Barrier) -> float:
        """Returns steps per second."""
        actions = [{"values": ACTIONS[self._case.benchmark]}] * self._case.chunk
        steps = 0
        barrier.wait()
        began = time.monotonic()
        while time.monotonic() < began + seconds:
            before = self._turn
            self._turn = self._plane.predict(
                self._run_id,
                self._worker_id,
                before.session_id,
                before.seq + 1,
                actions,
            )
            steps += self._turn.executed_steps
            if self._turn.done:
                benchmark_id = self._case.benchmark
                self._attach(submit_run(self._connection, benchmark_id, 1), "w")
        return steps / (time.monotonic() - began)

    def close(self) -> None:
        """Stop the run, which may be completed."""
        with contextlib.suppress(ApiException):
            self._connection.control.stop_run(self._run_id, StopRun())
        self._connection.close()


def submit_run(connection: Connection, benchmark_id: str, workers: int) -> str:
    """The id of a new run."""
    policy = PolicyInfo(name="benchmarks")
    request = SubmitRun(benchmark_id=benchmark_id, policy=policy, max_workers=workers)
    return connection.control.submit_run(request).run_id


def measure_protocol(case: Case, url: str, seconds: float) -> float:
    """Control steps per second of all workers together."""
    with Connection(url, TOKEN, requests=1) as connection:
        run_id = submit_run(connection, case.benchmark, case.workers)
        workers = [
            ThroughputWorker(case, url, run_id, number)
            for number in range(case.workers)
        ]
        barrier = threading.Barrier(case.workers)
        with ThreadPoolExecutor(case.workers) as threads:
            plays = [threads.submit(one.play, seconds, barrier) for one in workers]
            total = sum(play.result() for play in plays)
        for one in workers:
            one.close()
    return total


def tables(section: Json) -> str:
    rows = [
        [
            f"`{row['benchmark']}`",
            str(row["workers"]),
            str(row["chunk"]),
            f"{row['bare_steps_per_s']:.0f}",
            f"{row['protocol_steps_per_s']:.0f}",
            f"{row['tcp_share']:.2f}",
            f"{row['share']:.2f}",
            f"{row['share_worst']:.2f}",
        ]
        for row in section["rows"]
    ]
    head = [
        *("", "workers", "actions in a turn", "bare, steps/s"),
        *("over the protocol, steps/s", "share of raw TCP", "share", "worst share"),
    ]
    return "\n\n".join(
        [performance_page.table(head, rows), _cost(section), _where(section)]
    )


def _cost(section: Json) -> str:
    """What a turn of one step costs beside the step."""
    row = next(
        row
        for row in reversed(section["rows"])
        if row["chunk"] == 1 and row["benchmark"] == "tabletop_state"
    )
    cores = section["measured_on"]["cores"]
    step_ms = 1000 * cores / row["bare_steps_per_s"]
    turn_ms = 1000 * cores / row["protocol_steps_per_s"] - step_ms
    return (
        f"With {row['workers']} workers a turn costs {turn_ms:.2f} ms of the {cores} "
        "cores together, client included, where a step of this small world costs "
        f"{step_ms:.2f} ms. Policies that answer with chunks pay that once a chunk."
    )


def _where(section: Json) -> str:
    on = section["measured_on"]
    loads = " ".join(map(str, on["load_before"]))
    return (
        f"Medians of {section['rounds']} rounds of {section['seconds']:g} s, measured "
        f"on {on['date']}: {on['cores']} cores, load before {loads}."
    )
