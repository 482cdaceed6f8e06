"""Runs attacks on servers, with watchers: before, during and after each of them.

A server serves all attacks that need the same settings, one after another. One that
broke a promise is replaced by a new one with an empty database, so that the next attack
is judged for itself.
"""

from __future__ import annotations

import contextlib
import math
import multiprocessing
import os
import signal
import tempfile
import time
import traceback
from collections.abc import Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import TypedDict

from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.attack.attack_promises import (
    FILES_BACK_GROWTH,
    RSS_BACK_GROWTH,
    Latency,
    Result,
)
from tests.campaigns.attack.server_usage import PeakUsage, Usage, read_usage
from tests.campaigns.campaign_server import ATTACKER, OTHERS, WATCHER, CampaignServer
from tests.campaigns.players.invariants import check_histories
from tests.campaigns.players.raw_client import NoAnswer, RawClient
from tests.campaigns.players.run_history import History, Report, Sample
from tests.campaigns.players.watcher import Player, ServiceWatcher, Watcher

BACK_S = 30.0
WAIT_S = 12.0  # more than any bound on latency
START_S = 60.0  # for the watchers to begin
CALM_S = 2.0
AT_A_TIME = 3  # attacks during which no time is measured
NICENESS = 10
PATCHED = "tests.campaigns.patched_server"


def measure_all(
    attacks: Iterable[Attack], *, seed: int, is_long: bool = False, part: float = 1.0
) -> Iterator[Result]:
    """Results as they are there. part: of the size of the short form.

    Attacks during which times are measured come first, one at a time and those that
    can share a server together; then the others, some at a time.
    """
    options: _Options = {"seed": seed, "is_long": is_long, "part": part}
    timed: dict[object, list[Attack]] = {}
    others = []
    for attack in attacks:
        if attack.is_timed or attack.is_alone:
            timed.setdefault(_server_key(attack), []).append(attack)
        else:
            others.append(attack)
    for group in timed.values():
        yield from _measure_group(group, options)
    with ThreadPoolExecutor(AT_A_TIME) as pool:
        running = [pool.submit(_measure_one, one, options) for one in others]
        for done in as_completed(running):
            yield from done.result()


def _server_key(attack: Attack) -> object:
    """Attacks with the same key can share a server."""
    alone = attack.name if attack.is_beside else None
    settings = tuple(sorted(attack.settings.items()))
    return settings, attack.prefix, attack.watchers, alone


def _measure_group(attacks: list[Attack], options: _Options) -> Iterator[Result]:
    """One after another on one server; one that broke a promise is started anew."""
    opened: _Measured | None = None
    try:
        for attack in attacks:
            opened = opened or _Measured(attack, options)
            result = opened.measure(attack)
            yield result
            if result.broken:
                opened.close()
                opened = None
            elif attack is not attacks[-1]:
                opened.watch_again(attack)
    finally:
        if opened is not None:
            opened.close()


def _measure_one(attack: Attack, options: _Options) -> list[Result]:
    return list(_measure_group([attack], options))


class _Options(TypedDict):
    seed: int
    is_long: bool
    part: float


class _Measured:
    """A server with its watchers, and how they were in calm."""

    def __init__(self, attack: Attack, options: _Options) -> None:
        self._stack = contextlib.ExitStack()
        self._options = options
        self._tracebacks = 0
        directory = self._stack.enter_context(
            tempfile.TemporaryDirectory(prefix="attack-", ignore_cleanup_errors=True)
        )
        settings = dict(attack.settings) | {"CAMPAIGN_DIRECTORY": directory}
        program = PATCHED if attack.is_beside else "reference_server"
        self.server = CampaignServer(Path(directory), settings, attack.prefix, program)
        self._stack.callback(self.server.end, signal.SIGKILL)
        self.watchers = self._start_watchers(attack.watchers)
        time.sleep(CALM_S * min(1.0, options["part"]))
        self.calm = Latency.of(self._samples_since(0.0))

    def _start_watchers(self, players: int) -> list[Watcher]:
        url, seed = self.server.url, self._options["seed"]
        watchers: list[Watcher] = [ServiceWatcher(url, seed, "service")]
        watchers += [Player(url, seed, f"player{n}") for n in range(players)]
        watchers.append(Player(url, seed, "starter", episodes=1))
        for watcher in watchers:
            watcher.start()
        deadline = time.monotonic() + START_S
        while not all(watcher.samples for watcher in watchers):
            assert time.monotonic() < deadline, "the watchers do not begin"
            time.sleep(0.01)
        return watchers

    def _samples_since(self, time_: float) -> list[Sample]:
        """Those that ended since then, or are waited for."""
        return [
            sample
            for watcher in self.watchers
            for sample in [*list(watcher.samples), *watcher.waiting()]
            if sample.began_at + sample.took_s >= time_
        ]

    def measure(self, attack: Attack) -> Result:
        part, is_long = self._options["part"], self._options["is_long"]
        size = part * (attack.long_size if is_long else 1.0)
        seconds = attack.seconds * (3.0 if is_long else max(0.5, min(1.0, part)))
        seed = self._options["seed"]
        target = Target(self.server.url, ATTACKER, OTHERS, seed, size, seconds)
        before = read_usage(self.server.process.pid)
        peak = PeakUsage(self.server.process.pid)
        began_at = time.monotonic()
        if attack.is_beside:
            target.server, target.watchers = self.server, self.watchers
            report = _run(attack.name, target)
        else:
            report = _run_apart(attack, target)
        took_s = time.monotonic() - began_at
        self._wait_for_each(began_at + took_s)
        during = Latency.of(self._samples_since(began_at))
        peak_usage = peak.end()
        back_s = self._time_until_back(before)
        after = read_usage(self.server.process.pid)
        watched = self._end_watching(attack)
        return Result(
            attack, report, watched, self.calm, during, before, peak_usage, after,
            back_s, took_s, self._count_tracebacks(),
        )  # fmt: skip

    def _wait_for_each(self, ended_at: float) -> None:
        """Until what was begun during the attack has succeeded, or too late."""
        deadline = time.monotonic() + WAIT_S
        while time.monotonic() < deadline and any(
            sample.began_at < ended_at
            for watcher in self.watchers
            for sample in watcher.waiting()
        ):
            time.sleep(0.02)

    def _time_until_back(self, before: Usage) -> float:
        began_at = time.monotonic()
        while (waited_s := time.monotonic() - began_at) < BACK_S:
            now = read_usage(self.server.process.pid)
            if (
                now.rss - before.rss < RSS_BACK_GROWTH
                and now.files - before.files < FILES_BACK_GROWTH
            ):
                return waited_s
            time.sleep(0.1)
        return math.nan

    def _end_watching(self, attack: Attack) -> Report:
        """Judge what they saw."""
        for watcher in self.watchers:
            watcher.end()
        watched = Report()
        histories = []
        for watcher in self.watchers:
            watched.merge(watcher.report)
            if isinstance(watcher, Player):
                histories += watcher.histories
        try:
            with RawClient(self.server.url, WATCHER, timeout_s=60) as client:
                watched.violations += check_histories(
                    client, histories, is_fault_expected=attack.is_fault_expected
                )
                _stop_unfinished(client, histories)
        except (NoAnswer, OSError) as error:
            watched.violations.append(f"the runs cannot be read: {error!r}")
            return watched
        return watched

    def _count_tracebacks(self) -> int:
        """Those since it was asked for the last time."""
        count = self.server.log().count("Traceback") - self._tracebacks
        self._tracebacks += count
        return count

    def watch_again(self, attack: Attack) -> None:
        """New watchers with runs of their own, for the next attack on this server."""
        self.watchers = self._start_watchers(attack.watchers)

    def close(self) -> None:
        for watcher in self.watchers:
            watcher.end()
        self._stack.close()


def _stop_unfinished(client: RawClient, histories: list[History]) -> None:
    """Their sessions would hold simulators, of which the account has only its share."""
    for history in histories:
        if not history.is_done:
            path = f"/v1/runs/{history.run_id}/stop"
            client.request("POST", path, {"mode": "abort"})


def _run_apart(attack: Attack, target: Target) -> Report:
    """In a process of its own, which leaves the processors to the server."""
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["tests.campaigns.attack.attacks"])
    with ProcessPoolExecutor(1, context, initializer=_be_nice) as pool:
        return pool.submit(_run, attack.name, target).result()


def _be_nice() -> None:
    os.nice(NICENESS)


def _run(name: str, target: Target) -> Report:
    from tests.campaigns.attack.attacks import ATTACKS

    try:
        return ATTACKS[name].run(target)
    except NoAnswer as error:
        return Report(hangs=1, violations=[f"no answer: {error!r}"])
    except Exception as error:  # noqa: BLE001 - the other attacks go on
        where = traceback.extract_tb(error.__traceback__)[-1]
        return Report(violations=[f"the attack failed: {error!r} in {where.name}"])
