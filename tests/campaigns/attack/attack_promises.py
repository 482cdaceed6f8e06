"""What was measured of one attack, and what is promised while a server is attacked."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from tests.campaigns.attack.attack import Attack
from tests.campaigns.attack.server_usage import MB, Usage
from tests.campaigns.players.run_history import Report, Sample
from tests.campaigns.promises import Promise, percentile

SERVICE_P99_S = 0.25
TURN_CALM_FACTOR, TURN_EXTRA_S = 2.0, 0.1
START_S = 10.0
RSS_GROWTH = 200 * MB
RSS_BACK_GROWTH = 50 * MB
FILES_BACK_GROWTH = 32
READY_P99_S = 5.0


@dataclass(frozen=True)
class Latency:
    """p99 of the service and of turns, and the longest start of a run; seconds."""

    service_s: float = math.nan
    turn_s: float = math.nan
    start_s: float = math.nan

    @classmethod
    def of(cls, samples: Iterable[Sample]) -> Latency:
        by_kind: dict[str, list[float]] = {"service": [], "turn": [], "start": []}
        for sample in samples:
            by_kind[sample.kind].append(sample.took_s)
        return cls(
            percentile(by_kind["service"], 0.99),
            percentile(by_kind["turn"], 0.99),
            max(by_kind["start"], default=math.nan),
        )


@dataclass
class Result:
    """One attack as it was measured. back_s: until memory was back; NaN: it was not.

    report: of the attacker. watched: of the watchers.
    """

    attack: Attack
    report: Report
    watched: Report
    calm: Latency
    during: Latency
    before: Usage
    peak: Usage
    after: Usage
    back_s: float
    took_s: float
    tracebacks: int = 0

    @property
    def broken(self) -> list[str]:
        """Names of the promises that are broken."""
        return [
            name
            for name, promise in PROMISES.items()
            if promise.covers(self) and promise.breaks(self)
        ]

    @property
    def growth(self) -> int:
        return self.peak.rss - self.before.rss


def _is_timed(result: Result) -> bool:
    return result.attack.is_timed


def _has_one_process(result: Result) -> bool:
    return result.attack.is_timed or not result.attack.is_beside


def _turn_bound_s(result: Result) -> float:
    return TURN_CALM_FACTOR * result.calm.turn_s + TURN_EXTRA_S


def _charged(result: Result) -> int:
    return sum("is charged" in one for one in result.watched.violations)


def _not_charged(result: Result) -> int:
    return len(result.watched.violations) - _charged(result)


def _count_findings(result: Result) -> int:
    """Of all kinds but latency and memory."""
    reports = (result.report, result.watched)
    return sum(r.wrong_5xx + r.hangs + len(r.violations) for r in reports)


def _no_findings_in(text: str, attack: str, promised: int) -> Promise[Result]:
    return Promise(
        text,
        "findings",
        _count_findings,
        covers=lambda r: r.attack.name == attack,
        promised=promised,
        count=lambda r: r.report.sent,
    )


PROMISES: dict[str, Promise[Result]] = {
    "latency": Promise(
        "p99 of `GET /v1` of another account is under 250 ms during every attack",
        "ms",
        lambda r: r.during.service_s * 1000,
        lambda r: not r.during.service_s < SERVICE_P99_S,
        _is_timed,
    ),
    "turns": Promise(
        "p99 of its turns is under 2 × calm + 100 ms (the worst of calm is named)",
        "ms",
        lambda r: r.during.turn_s * 1000,
        lambda r: not r.during.turn_s < _turn_bound_s(r),
        _is_timed,
        detail=lambda r: f", calm {r.calm.turn_s * 1000:.0f} ms",
    ),
    "starts": Promise(
        "Runs of another account are admitted and get their first turn within 10 s",
        "s",
        lambda r: r.during.start_s,
        lambda r: not r.during.start_s < START_S,
        _is_timed,
    ),
    "memory": Promise(
        "Memory of the server grows by less than 200 MB",
        "MB",
        lambda r: r.growth / MB,
        lambda r: r.growth >= RSS_GROWTH,
        _has_one_process,
    ),
    "back": Promise(
        "Memory and descriptors are back within 30 s (50 MB, 32 descriptors)",
        "s",
        lambda r: r.back_s,
        lambda r: math.isnan(r.back_s),
        _has_one_process,
    ),
    "errors": Promise(
        "No answer is 5xx but `unavailable` and `no_capacity`",
        "answers",
        lambda r: r.report.wrong_5xx + r.watched.wrong_5xx,
    ),
    "charges": Promise(
        "No attempt or fault is charged to another account, but by a broken simulator",
        "episodes",
        _charged,
    ),
    "results": Promise(
        "What is acknowledged exists once, is not rescored, and adds up",
        "findings",
        _not_charged,
    ),
    "hangs": Promise(
        "Every request is answered or its connection closed",
        "hangs",
        lambda r: r.report.hangs + r.watched.hangs,
    ),
    "log": Promise(
        "The log of the server has no traceback, but of a full disk",
        "tracebacks",
        lambda r: r.tracebacks,
        covers=lambda r: r.attack.name != "full disk",
    ),
    "own": Promise(
        "No refused request changes anything",
        "findings",
        lambda r: len(r.report.violations),
    ),
    "fuzz": _no_findings_in(
        "10⁶ random requests over three APIs: no 500, no hang, no change where refused",
        "fuzz",
        10**6,
    ),
    "kills": _no_findings_in(
        "1,000 kills of the server, 8 workers: no result is lost, doubled, rescored",
        "server kills",
        1000,
    ),
    "records": _no_findings_in(
        "100 kills of the server in runs of 8 workers: each record verifies, replays, "
        "and has every turn and result that was acknowledged",
        "recorded kills",
        100,
    ),
    "simulators": _no_findings_in(
        "1,000 kills of simulators, 8 workers: no result is lost, doubled, rescored",
        "simulator kills",
        1000,
    ),
    "soak": Promise(
        "An hour of 16 workers: memory, descriptors, threads flat after ten minutes",
        "MB",
        lambda r: r.report.figures["growth_mb"],
        lambda r: _count_findings(r) > 0,
        lambda r: "growth_mb" in r.report.figures,
        3600,
        lambda r: r.report.sent,
    ),
    "ready": Promise(
        "After a kill the server is ready again with a p99 under 5 s",
        "s",
        lambda r: r.report.figures["ready_p99_s"],
        lambda r: not r.report.figures["ready_p99_s"] < READY_P99_S,
        lambda r: "ready_p99_s" in r.report.figures,
    ),
}
