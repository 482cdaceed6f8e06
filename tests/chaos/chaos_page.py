"""Shows rounds: a line for the console, a table for build/chaos.md."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime

from tests.attack.verdicts import percentile
from tests.chaos.chaos_campaign import NODES
from tests.chaos.chaos_faults import FAULTS, PROMISED
from tests.chaos.chaos_rounds import Counts, Round, broken_so_far
from tools.built_pages import write_page
from tools.measurements.git_commit import read_commit

GOING_P99_S = 10.0
# What of a finding says nothing about results.
TRACEBACK = re.compile(r"node \d+: Traceback")


@dataclass(frozen=True)
class Conditions:
    """Under which rounds were played.

    load: of the machine before half of them. clusters: so many were broken at once.
    """

    seeds: Sequence[int]
    players: int
    lease_s: float
    load: float
    clusters: int = 1


def round_line(played: Round) -> str:
    """One line, and one more for each finding."""
    waits = played.waits_s
    line = (
        f"{played.number:4} {played.fault.name:<24} on after "
        f"{percentile(waits, 0.5):5.2f} s, all {max(waits, default=0):5.2f} s  "
        f"{'BROKEN' if played.findings else 'kept'}"
    )
    return "\n".join([line, *(f"    {found[:4000]}" for found in played.findings)])


def summary(rounds: Sequence[Round], conditions: Conditions) -> Iterator[str]:
    """What was found, and the times of all rounds."""
    counts = sum((one.counts for one in rounds), Counts())
    waits = [wait for one in rounds for wait in one.waits_s]
    findings = sum(len(one.findings) for one in rounds)
    seeds = ", ".join(map(str, conditions.seeds))
    yield (
        f"{len(rounds):,} rounds, seeds {seeds}: {findings} findings in "
        f"{counts.runs:,} runs, {counts.operations:,} turns, starts and "
        f"changes of push runs, {counts.compared:,} turns with two answers, "
        f"{counts.writes:,} writes, {counts.records:,} records, and "
        f"{counts.claims:,} claims of runs by another node"
    )
    yield (
        f"Time until a player goes on: p50 {percentile(waits, 0.5):.1f} s, "
        f"p99 {percentile(waits, 0.99):.1f} s, at most {max(waits, default=0):.1f} s"
    )


def write(rounds: Sequence[Round], conditions: Conditions) -> None:
    commit, _ = read_commit()
    date = datetime.now(UTC).date().isoformat()
    head = (
        f"# A cluster that is broken\n\n{NODES} [nodes](../docs/host/cluster.md) over "
        "one PostgreSQL, behind a balancer without affinity, on this\nmachine alone. "
        "`make chaos` plays rounds: a fault while players play, its repair, then a\n"
        "verdict about all that was answered and all that was written:\n\n"
        "1. What was acknowledged exists once, as it was acknowledged.\n"
        "2. The steps of the simulator are the actions that were sent.\n"
        "3. The score is the mean of the results.\n"
        "4. Whenever the owner of a run changes, its fence grows.\n"
        "5. A turn that is sent twice, to two nodes at once, has one answer.\n"
        "6. A stop and a resume lose nothing that is scored.\n"
        "7. Events come once each, and all, to a reader who reconnects to any node.\n"
        "8. Each completed run has a record that verifies and has what was "
        "acknowledged; all are one chain.\n\n"
        "Time: the longest in which a player had no success, from the fault on; for a "
        "database or a network\nthat is away as a whole, from its return. A player "
        "waits a lease and a second for an answer.\nThe balancer is the one of "
        "`make cluster`: it asks each node at `/readyz`, gives new connections to\n"
        "those that are ready, and closes the connections of one that has said nothing "
        "for 3 s.\nThe clocks of nodes are changed inside their programs, that of the "
        "database by libfaketime (without it\nthere is no such round); a full disk is "
        "a limit of the size of its files, at which PostgreSQL ends.\n\n"
        f"Written by `make chaos` on commit {commit} of {date}: clusters at once "
        f"{conditions.clusters}, each with {conditions.players} players\nand one of "
        f"runs that nodes play; lease {conditions.lease_s:g} s; {os.cpu_count()} "
        "processors shared with other programs; load before\nhalf of the rounds "
        f"{conditions.load:.1f} or less.\n\n"
    )
    text = head + "\n\n".join(summary(rounds, conditions)) + "\n\n"
    text += "\n".join(_promises(rounds)) + "\n\n"
    text += "\n".join(_table(rounds)) + "\n"
    write_page("chaos.md", text)


def _promises(rounds: Sequence[Round]) -> Iterator[str]:
    """How often each was to be broken, and was: `--long` goes on until it was."""
    broken = broken_so_far(rounds)
    waits = [wait for one in rounds for wait in one.waits_s]
    findings = [found for one in rounds for found in one.findings]
    tracebacks = sum(TRACEBACK.match(found) is not None for found in findings)
    is_lost = len(findings) > tracebacks
    yield "| promised | measured | verdict |"
    yield "|---|--:|---|"
    for promise, count in PROMISED.items():
        verdict = _verdict(not is_lost, broken[promise] >= count)
        what = f"{count:,} {promise}: no result lost, doubled, rescored"
        yield f"| {what} | {broken[promise]:,} | {verdict} |"
    yield (
        f"| The log of no node has a traceback | {tracebacks} "
        f"| {_verdict(tracebacks == 0, True)} |"
    )
    p99_s = percentile(waits, 0.99)
    yield (
        f"| All go on with a p99 of at most {GOING_P99_S:g} s | {p99_s:.1f} s "
        f"| {_verdict(p99_s <= GOING_P99_S, True)} |"
    )


def _verdict(is_kept: bool, is_whole: bool) -> str:
    if not is_kept:
        return "**broken**"
    return "kept" if is_whole else "kept in part"


def _table(rounds: Sequence[Round]) -> Iterator[str]:
    yield "| fault | what happens | rounds | p50, s | p99, s | longest, s | findings |"
    yield "|---|---|--:|--:|--:|--:|--:|"
    for fault in FAULTS.values():
        of_fault = [one for one in rounds if one.fault is fault]
        if of_fault:
            waits = [wait for one in of_fault for wait in one.waits_s]
            times = (percentile(waits, 0.5), percentile(waits, 0.99), max(waits))
            shown = " | ".join(f"{value:.1f}" for value in times)
            found = sum(len(one.findings) for one in of_fault)
            yield (
                f"| {fault.name} | {fault.does} | {len(of_fault)} | {shown} | {found} |"
            )
