"""Shows rounds: a line for the console, their promises, and their part of the page."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from tests.campaigns import campaign_page as page
from tests.campaigns.chaos.chaos_faults import FAULTS, PROMISED
from tests.campaigns.chaos.chaos_rounds import Counts, Round, broken_so_far
from tests.campaigns.promises import Promise, Verdict, judge, percentile

GOING_P99_S = 10.0
# A finding that says nothing about results.
TRACEBACK = re.compile(r"node \d+: Traceback")
NOTE = """\
Nodes over one PostgreSQL, behind a balancer without affinity. A round is a fault while
players play, its repair, then a verdict about all that was answered and written:

1. What was acknowledged exists once, as it was acknowledged.
2. The steps of the simulator are the actions that were sent.
3. The score is the mean of the results.
4. Whenever the owner of a run changes, its fence grows.
5. A turn that is sent twice, to two nodes at once, has one answer.
6. A stop and a resume lose nothing that is scored.
7. Events come once each, and all, to a reader who reconnects to any node.
8. Each completed run has a record that verifies and has what was acknowledged; all are
   one chain.

Times are the longest in which a player had no success, from the fault on; for a
database or a network that is away as a whole, from its return.
"""


def round_line(played: Round) -> str:
    """One line, and one more for each finding."""
    waits = played.waits_s
    line = (
        f"{played.number:4} {played.fault.name:<24} on after "
        f"{percentile(waits, 0.5):5.2f} s, all {max(waits, default=0):5.2f} s  "
        f"{'BROKEN' if played.findings else 'kept'}"
    )
    return "\n".join([line, *(f"    {found[:4000]}" for found in played.findings)])


def summary(rounds: Sequence[Round]) -> str:
    """What there was to find."""
    counts = sum((played.counts for played in rounds), Counts())
    return (
        f"{len(rounds):,} rounds: {counts.runs:,} runs, {counts.operations:,} turns, "
        f"starts and changes of push runs, {counts.compared:,} turns with two answers, "
        f"{counts.writes:,} writes, {counts.records:,} records, and "
        f"{counts.claims:,} claims of runs by another node"
    )


def _tracebacks(rounds: Sequence[Round]) -> int:
    findings = [found for played in rounds for found in played.findings]
    return sum(TRACEBACK.match(found) is not None for found in findings)


def _findings(rounds: Sequence[Round]) -> int:
    """Of all kinds but tracebacks."""
    return sum(len(played.findings) for played in rounds) - _tracebacks(rounds)


def _going_p99_s(rounds: Sequence[Round]) -> float:
    return percentile([wait for played in rounds for wait in played.waits_s], 0.99)


def _count_of(promise: str) -> Callable[[Sequence[Round]], int]:
    return lambda rounds: broken_so_far(rounds)[promise]


PROMISES: list[Promise[Sequence[Round]]] = [
    *(
        Promise(
            f"{count:,} {promise}: no result lost, doubled, rescored",
            "findings",
            _findings,
            promised=count,
            count=_count_of(promise),
        )
        for promise, count in PROMISED.items()
    ),
    Promise(
        "The log of no node has a traceback",
        "tracebacks",
        _tracebacks,
    ),
    Promise(
        f"All go on with a p99 of at most {GOING_P99_S:g} s",
        "s",
        _going_p99_s,
        lambda rounds: not _going_p99_s(rounds) <= GOING_P99_S,
    ),
]


def judge_all(rounds: Sequence[Round]) -> list[Verdict]:
    return judge(PROMISES, [rounds], lambda _: "")


def write(rounds: Sequence[Round], conditions: str) -> None:
    header = ("fault", "what happens", "rounds", "p50, s", "p99, s", "longest, s")
    rows = page.table((*header, "findings"), _rows(rounds))
    cases = [NOTE, f"{summary(rounds)}.\n", *rows]
    page.write("chaos", conditions, judge_all(rounds), cases)


def _rows(rounds: Sequence[Round]) -> Iterator[list[str]]:
    for fault in FAULTS.values():
        of_fault = [played for played in rounds if played.fault is fault]
        if of_fault:
            waits = [wait for played in of_fault for wait in played.waits_s]
            times = (percentile(waits, 0.5), percentile(waits, 0.99), max(waits))
            shown = [f"{value:.1f}" for value in times]
            findings = sum(len(played.findings) for played in of_fault)
            yield [
                fault.name, fault.does, str(len(of_fault)), *shown, str(findings),
            ]  # fmt: skip
