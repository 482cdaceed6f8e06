"""Shows results of attacks: lines for the console, and their part of the page."""

from __future__ import annotations

import math
from collections.abc import Sequence

from tests.campaigns import campaign_page as page
from tests.campaigns.attack.attack_promises import PROMISES, Latency, Result
from tests.campaigns.attack.server_usage import MB
from tests.campaigns.promises import Verdict, judge

COLUMNS = (
    "attack", "what is sent", "bound", "sent", "`GET /v1`, ms", "turn, ms", "start, s",
    "memory, MB", "descriptors", "threads", "verdict",
)  # fmt: skip
NOTE = """\
Latency is that of another account, calm → during the attack: p99 of `GET /v1` and of
turns, and the longest start of a run. Memory, descriptors and threads are the server's,
before → highest → after.
"""


def console_line(result: Result) -> str:
    """One line, and one more for each finding."""
    during, calm = result.during, result.calm
    line = (
        f"{result.attack.name:<20} {result.took_s:5.1f} s  sent {result.report.sent:<7}"
        f" /v1 {_ms(calm.service_s)} → {_ms(during.service_s)} ms"
        f"  turn {_ms(calm.turn_s)} → {_ms(during.turn_s)} ms"
        f"  start {during.start_s:.1f} s"
        f"  memory {_mb(result.before.rss)} → {_mb(result.peak.rss)}"
        f" → {_mb(result.after.rss)} MB  {_verdict(result)}"
    )
    answers = (result.report.answers, result.watched.answers)
    shown = " to others ".join(str(dict(sorted(counts.items()))) for counts in answers)
    lines = [line, f"    answers {shown}"]
    if result.report.figures:
        lines.append(f"    {result.report.figures}")
    violations = [*result.report.violations, *result.watched.violations]
    lines += [f"    {violation[:1000]}" for violation in violations[:5]]
    return "\n".join(lines)


def judge_all(results: Sequence[Result]) -> list[Verdict]:
    return judge(PROMISES.values(), results, lambda result: result.attack.name)


def write(results: Sequence[Result], conditions: str) -> None:
    rows = page.table(COLUMNS, map(_row, results))
    page.write("attack", conditions, judge_all(results), [NOTE, *rows])


def _verdict(result: Result) -> str:
    return f"broken: {', '.join(result.broken)}" if result.broken else "kept"


def _ms(seconds: float) -> str:
    return "–" if math.isnan(seconds) else f"{seconds * 1000:.0f}"


def _mb(size: int) -> str:
    return f"{size / MB:.0f}"


def _row(result: Result) -> list[str]:
    usages = (result.before, result.peak, result.after)
    return [
        result.attack.name,
        result.attack.sends,
        result.attack.bound,
        f"{result.report.sent}",
        *_latencies(result),
        " → ".join(_mb(usage.rss) for usage in usages),
        " → ".join(str(usage.files) for usage in usages),
        " → ".join(str(usage.threads) for usage in usages),
        _verdict(result),
    ]


def _latencies(result: Result) -> list[str]:
    if not result.attack.is_timed:
        return ["–"] * 3
    calm, during = result.calm, result.during
    return [
        f"{_ms(calm.service_s)} → {_ms(during.service_s)}",
        f"{_ms(calm.turn_s)} → {_ms(during.turn_s)}",
        _start(during),
    ]


def _start(latency: Latency) -> str:
    return "never" if math.isnan(latency.start_s) else f"{latency.start_s:.1f}"
