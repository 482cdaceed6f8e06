"""Counters of the events in this process: requests, steps, writes, calls.

To count is an addition in memory, less than a microsecond of a turn; the page of
metrics reads the numbers (`monitoring/metrics.py`). Like the log, the counters belong
to the process. No name of an account, a run or a policy is kept.
"""

from __future__ import annotations

import time
from bisect import bisect_left
from collections import Counter, defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

# Upper bounds of the buckets of durations: those that the semantic conventions of
# OpenTelemetry advise for HTTP, and four below them, where a turn is.
BOUNDS_S = (
    *(0.00025, 0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.075),
    *(0.1, 0.25, 0.5, 0.75, 1.0, 2.5, 5.0, 7.5, 10.0),
)


class Durations:
    """How many things took how long. counts: for each bound, and the longer ones."""

    __slots__ = ("counts", "total_s")

    def __init__(self) -> None:
        self.counts = [0] * (len(BOUNDS_S) + 1)
        self.total_s = 0.0

    def add(self, seconds: float) -> None:
        self.counts[bisect_left(BOUNDS_S, seconds)] += 1
        self.total_s += seconds


# Durations by outcome, `ok` or `failed`.
Outcomes = defaultdict[str, Durations]


def _outcomes() -> Outcomes:
    return defaultdict(Durations)


@contextmanager
def timed(outcomes: Outcomes) -> Iterator[None]:
    """Count what the block does: as failed, if it raises."""
    started, outcome = time.perf_counter(), "failed"
    try:
        yield
        outcome = "ok"
    finally:
        outcomes[outcome].add(time.perf_counter() - started)


@dataclass(slots=True)
class Counters:
    """All of them.

    requests: by operation and hundreds of the status, 0 without an answer.
    refused_requests: by status, of those that were not read to their end. runs: by the
    state that they came to. sessions_ended: by what ended them. episodes: scored, by
    outcome. simulate_s: of the steps. fenced_writes: of runs that another node had
    claimed. passed_on: requests, to the nodes that have their runs.
    """

    requests: defaultdict[tuple[str, int], Durations] = field(
        default_factory=lambda: defaultdict(Durations)
    )
    refused_requests: Counter[int] = field(default_factory=Counter)
    runs: Counter[str] = field(default_factory=Counter)
    sessions_ended: Counter[str] = field(default_factory=Counter)
    episodes: Counter[str] = field(default_factory=Counter)
    steps: int = 0
    simulate_s: float = 0.0
    simulator_faults: int = 0
    policy_calls: Outcomes = field(default_factory=_outcomes)
    database_writes: Outcomes = field(default_factory=_outcomes)
    fenced_writes: int = 0
    passed_on: Outcomes = field(default_factory=_outcomes)
    recordings: int = 0
    recording_bytes: int = 0
    recordings_failed: int = 0


COUNTERS = Counters()
