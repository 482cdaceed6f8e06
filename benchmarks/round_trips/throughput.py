"""The throughput of simulators over the protocol.

The same control steps are played in Python loops, one process each; by such processes
behind a TCP socket (direct_simulation.py); and through a complete reference server with
as many workers: alternately (A B C A B C …), on the same cores. Sessions, exactly-once
execution, scoring and the store are active.

A client is a thread with the data plane of `reference_client`: the cost of the client
is included, that of a policy is not.
"""

import contextlib
import os
import statistics
import tempfile
import threading
import time
import uuid
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

from proctor_client import ApiException, AttachWorker, PolicyInfo, StopRun, SubmitRun

from benchmarks import measuring
from benchmarks.measured_server import TOKEN, running_server
from benchmarks.round_trips.direct_simulation import (
    ACTIONS,
    Case,
    measure_bare,
    measure_over_tcp,
)
from reference_client.protocol.connection import Connection
from reference_record.generated.answers import Action

TITLE = "Throughput"
ROUNDS, SECONDS = 3, 2.0
SECONDS_TRIED = 0.5
CASES = (
    *(Case("tabletop_state", workers, 1) for workers in (1, 2, 4, 8, 16)),
    *(Case("tabletop_state", 16, chunk) for chunk in (8, 32)),
    *(Case("mobile_bimanual", workers, 1) for workers in (4, 16)),
)


class Speeds(NamedTuple):
    """Control steps per second of all processes or workers together, in one round."""

    bare: float
    tcp: float
    protocol: float


def measure(*, trying: bool) -> str:
    """trying: once each, and short."""
    os.environ["OPENBLAS_NUM_THREADS"] = "1"  # processes are the parallelism
    seconds, rounds = (SECONDS_TRIED, 1) if trying else (SECONDS, ROUNDS)
    where = measuring.machine()
    rows = []
    with (
        tempfile.TemporaryDirectory() as scratch,
        running_server(Path(scratch, "bench.sqlite")) as server,
    ):
        for case in CASES:
            measured = [
                Speeds(
                    measure_bare(case, seconds),
                    measure_over_tcp(case, seconds),
                    measure_protocol(case, server.url, seconds),
                )
                for _ in range(rounds)
            ]
            rows.append(_row(case, measured))
            measuring.say(" ".join(rows[-1]))
    head = [
        *("", "workers", "actions in a turn", "bare, steps/s"),
        *("over the protocol, steps/s", "share of raw TCP", "share", "worst share"),
    ]
    counts = f"Medians of {rounds} rounds of {seconds:g} s."
    return f"{measuring.table(head, rows)}\n\n{counts} {where}"


def _row(case: Case, measured: list[Speeds]) -> list[str]:
    shares = [each.protocol / each.bare for each in measured]
    return [
        f"`{case.benchmark}`",
        str(case.workers),
        str(case.chunk),
        f"{statistics.median(each.bare for each in measured):.0f}",
        f"{statistics.median(each.protocol for each in measured):.0f}",
        f"{statistics.median(each.tcp / each.bare for each in measured):.2f}",
        f"{statistics.median(shares):.2f}",
        f"{min(shares):.2f}",
    ]


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
        actions: list[Action] = [
            {"values": ACTIONS[self._case.benchmark]}
        ] * self._case.chunk
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
        for worker in workers:
            worker.close()
    return total
