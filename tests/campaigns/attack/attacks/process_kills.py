"""SIGKILL of the server, SIGKILL and SIGSTOP of simulators, while runs are played."""

from __future__ import annotations

import signal
import time

from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.attack.server_usage import MB, read_usage
from tests.campaigns.campaign_server import CampaignServer
from tests.campaigns.players.run_history import Report
from tests.campaigns.promises import percentile
from tests.support.processes import signal_all

FLAT_RSS, FLAT_NUMBER = 20 * MB, 32


def server_of(target: Target) -> CampaignServer:
    assert target.server is not None, "this attack needs the server's process"
    return target.server


def count_samples(target: Target) -> int:
    return sum(len(watcher.samples) for watcher in target.watchers)


def wait_for_samples(target: Target, count: int) -> bool:
    """Whether the watchers have that many more answers within 20 s."""
    wanted = count_samples(target) + count
    deadline = time.monotonic() + 20
    while count_samples(target) < wanted:
        if time.monotonic() > deadline:
            return False
        time.sleep(0.005)
    return True


def kill_server(target: Target) -> Report:
    """Kill at a random moment of play, start again with the same database."""
    report, server, random = Report(), server_of(target), target.random("kill")
    ready_s = []
    for _ in range(target.count(6)):
        if not wait_for_samples(target, 20):
            report.hangs += 1
        time.sleep(random.uniform(0.0, 0.2))
        server.end(signal.SIGKILL)
        began_at = time.monotonic()
        server.start()
        with target.client() as client:  # counts the kill
            report.add_answer(client.request("GET", "/v1"))
        ready_s.append(time.monotonic() - began_at)
    if not wait_for_samples(target, 20):
        report.hangs += 1
    report.figures["ready_p99_s"] = percentile(ready_s, 0.99)
    return report


def kill_simulators(target: Target) -> Report:
    """Kill one simulator after another, mostly in the middle of an episode."""
    return _signal_simulators(target, signal.SIGKILL, target.count(20))


def pause_simulators(target: Target) -> Report:
    """Stop one simulator after another; the server must replace it after its time."""
    return _signal_simulators(target, signal.SIGSTOP, target.count(4))


def _signal_simulators(target: Target, number: signal.Signals, count: int) -> Report:
    report, server, random = Report(), server_of(target), target.random(number)
    deadline = time.monotonic() + 20 + count
    while report.sent < count and time.monotonic() < deadline:
        simulators = server.simulators()
        if simulators:
            report.sent += signal_all([random.choice(simulators)], number)
        # So rarely that no episode faults as often as its run allows.
        if not wait_for_samples(target, 60):
            report.hangs += 1
    return report


def play_long(target: Target) -> Report:
    """Only watch: memory, descriptors and threads after a sixth of the time and later.

    Counts seconds. The long form takes an hour.
    """
    report, server = Report(), server_of(target)
    seconds = target.count(6)
    time.sleep(seconds / 6)
    early = read_usage(server.process.pid)
    time.sleep(seconds * 5 / 6)
    late = read_usage(server.process.pid)
    report.sent = seconds
    report.figures["growth_mb"] = (late.rss - early.rss) / MB
    if late.rss - early.rss > FLAT_RSS:
        report.violations.append(f"memory grew from {early} to {late}")
    if max(late.files - early.files, late.threads - early.threads) > FLAT_NUMBER:
        report.violations.append(f"descriptors or threads grew from {early} to {late}")
    return report


ATTACKS = (
    Attack(
        "server kills",
        "SIGKILL of the server",
        "6 kills, 8 players",
        kill_server,
        long_size=1000 / 6,
        is_alone=True,
        is_beside=True,
        is_timed=False,
        watchers=8,
    ),
    Attack(
        "long play",
        "runs of 16 players and nothing else",
        "6 s (an hour in the long form)",
        play_long,
        long_size=600,
        is_beside=True,
        is_timed=False,
        watchers=16,
    ),
    Attack(
        "simulator kills",
        "SIGKILL of simulators",
        "20 kills, 8 players",
        kill_simulators,
        long_size=50,
        is_beside=True,
        is_timed=False,
        is_fault_expected=True,
        watchers=8,
    ),
    Attack(
        "simulator pauses",
        "SIGSTOP of simulators",
        "4 pauses, 8 players, turns of at most 1 s",
        pause_simulators,
        settings={"PROCTOR_TURN_TIMEOUT_S": "1"},
        long_size=50,
        is_beside=True,
        is_timed=False,
        is_fault_expected=True,
        watchers=8,
    ),
)
