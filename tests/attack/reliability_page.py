"""Shows results: lines for the console, tables for build/attack.md."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime

from tests.attack.server_usage import MB
from tests.attack.verdicts import PROMISES, Latency, Promise, Result
from tools.built_pages import write_page
from tools.measurements.git_commit import read_commit

COLUMNS = (
    "attack", "what is sent", "bound", "sent", "`GET /v1`, ms", "turn, ms", "start, s",
    "memory, MB", "descriptors", "threads", "verdict",
)  # fmt: skip


def console_line(result: Result) -> str:
    """One line, and one more for each finding."""
    verdict = "broken: " + ", ".join(result.broken) if result.broken else "kept"
    during, calm = result.during, result.calm
    line = (
        f"{result.attack.name:<20} {result.took_s:5.1f} s  sent {result.report.sent:<7}"
        f" /v1 {_ms(calm.service_s)} → {_ms(during.service_s)} ms"
        f"  turn {_ms(calm.turn_s)} → {_ms(during.turn_s)} ms"
        f"  start {during.start_s:.1f} s"
        f"  memory {_mb(result.before.rss)} → {_mb(result.peak.rss)}"
        f" → {_mb(result.after.rss)} MB  {verdict}"
    )
    answers = (result.report.answers, result.watched.answers)
    shown = " to others ".join(str(dict(sorted(one.items()))) for one in answers)
    lines = [line, f"    answers {shown}"]
    if result.report.figures:
        lines.append(f"    {result.report.figures}")
    found = [*result.report.violations, *result.watched.violations]
    lines += [f"    {one[:1000]}" for one in found[:5]]
    return "\n".join(lines)


def promise_lines(results: Sequence[Result]) -> Iterator[str]:
    """A verdict for each promise, over all attacks."""
    for name, promise in PROMISES.items():
        verdict, worst = _judge_promise(name, promise, results)
        yield f"{verdict:<12} {promise.text}: {worst}"


def _judge_promise(
    name: str, promise: Promise, results: Sequence[Result]
) -> tuple[str, str]:
    covered = [result for result in results if promise.covers(result)]
    if not covered:
        return "not measured", "–"
    broken = [result.attack.name for result in covered if name in result.broken]
    worst = max(covered, key=lambda r: _order(promise.measure(r)))
    text = f"{_number(promise.measure(worst))} {promise.unit}"
    if (promise.measure(worst) or broken) and not promise.promised:
        text += f" ({worst.attack.name})"
    sent = sum(result.report.sent for result in covered)
    if promise.promised:
        text += f" in {sent:,} of {promise.promised:,}"
    if name == "turns":
        text += f", calm {_ms(worst.calm.turn_s)} ms"
    if broken:
        return "broken", f"{text}; by {', '.join(broken)}"
    return "kept in part" if sent < promise.promised else "kept", text


def _order(value: float) -> float:
    return math.inf if math.isnan(value) else value


def _number(value: float) -> str:
    if math.isnan(value):
        return "never"
    return f"{value:.1f}" if value % 1 and value < 100 else f"{value:.0f}"


def _ms(seconds: float) -> str:
    return "–" if math.isnan(seconds) else f"{seconds * 1000:.0f}"


def _mb(size: int) -> str:
    return f"{size / MB:.0f}"


def write(results: Sequence[Result], *, form: str, seed: int, load: float) -> None:
    """Write the page.

    form: what was run. load: average of running processes when it began.
    """
    commit, _ = read_commit()
    date = datetime.now(UTC).date().isoformat()
    head = (
        "# A server under attack\n\n"
        "What the reference server keeps while it is attacked. `make attack` runs the\n"
        "attacks on this machine alone and judges the server; `LONG=1` is the long\n"
        "form, `ONLY=` chooses attacks, `SEED=` repeats random choices.\n\n"
        f"Written by `make attack`: {form} on commit {commit}\n"
        f"of {date}, seed {seed}, {os.cpu_count()} processors; load before "
        f"it {load:.1f}.\n\n"
    )
    rows = [
        f"| {promise.text} | {worst} | {verdict} |"
        for name, promise in PROMISES.items()
        for verdict, worst in [_judge_promise(name, promise, results)]
    ]
    promises = [
        "## Promises\n",
        "| promise | worst of all attacks | verdict |",
        "|---|---|---|",
        *rows,
    ]
    attacks = [
        "\n## Attacks\n",
        "Latency is that of another account, calm → during the attack: p99 of",
        "`GET /v1` and of turns, and the longest start of a run. Memory, descriptors",
        "and threads are the server's, before → highest → after.\n",
        "| " + " | ".join(COLUMNS) + " |",
        "|---|---|---|--:|--:|--:|--:|--:|--:|--:|---|",
        *map(_row, results),
    ]
    write_page("attack.md", head + "\n".join([*promises, *attacks]) + "\n")


def _row(result: Result) -> str:
    attack, before, peak, after = (
        result.attack, result.before, result.peak, result.after,
    )  # fmt: skip
    cells = [
        attack.name,
        attack.sends,
        attack.bound,
        f"{result.report.sent}",
        *_latencies(result),
        f"{_mb(before.rss)} → {_mb(peak.rss)} → {_mb(after.rss)}",
        f"{before.files} → {peak.files} → {after.files}",
        f"{before.threads} → {peak.threads} → {after.threads}",
        f"broken: {', '.join(result.broken)}" if result.broken else "kept",
    ]
    return "| " + " | ".join(cells) + " |"


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
