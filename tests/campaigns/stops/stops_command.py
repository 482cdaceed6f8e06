"""Random stops of a robot: every one has to arrive in its time."""

from __future__ import annotations

import argparse
import random
import tempfile
import threading
import time
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import Self

from tests.campaigns import campaign_page as page
from tests.campaigns.promises import percentile
from tests.support.cells.stop_cases import CASES, LIMITS_S, Stopped, stop_bench

CASES_IN_LONG = 1000
CASES_IN_SHORT = 50
SLEEP_S = 0.005


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--cases", type=int, default=0, help="how many")


def run(options: argparse.Namespace, names: Sequence[str]) -> bool:
    """Play so many cases of the named causes; whether each stop was in time."""
    count = options.cases or (CASES_IN_LONG if options.long else CASES_IN_SHORT)
    chance = random.Random(options.seed)
    cases = [case for case in CASES if case[0] in names]
    played: list[Stopped] = []
    excused = 0
    with (
        tempfile.TemporaryDirectory() as folder,
        stop_bench(Path(folder)) as bench,
        Sleeper() as sleeper,
    ):
        for number in range(count):
            sleeper.longest_s = 0.0
            stopped = bench.play_case(*chance.choice(cases), chance)
            played.append(stopped)
            late_s = stopped.after_s - stopped.limit_s
            excused += not stopped.moved_after and 0 < late_s <= sleeper.longest_s
            if not stopped.is_right or number % 50 == 49:
                slept = f"a sleeper was late by {sleeper.longest_s * 1e3:.0f} ms"
                print(f"{number + 1} of {count}: {stopped}; {slept}", flush=True)
    late = (
        f"In {excused} of the cases that were late, a thread of the campaign that only "
        "sleeps was late by at least as much."
    )
    lines = [*report(played), late]
    print("\n".join(lines))
    page.write("stops", f"seed {options.seed}", verdicts=[], cases=lines)
    return all(stopped.is_right for stopped in played)


class Sleeper:
    """A thread that sleeps: how late it wakes is how long the machine was busy.

    longest_s: since it was set.
    """

    def __init__(self) -> None:
        self.longest_s = 0.0
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._sleep, daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._thread.join()

    def _sleep(self) -> None:
        while not self._ended.is_set():
            began = time.monotonic()
            time.sleep(SLEEP_S)
            late_s = time.monotonic() - began - SLEEP_S
            self.longest_s = max(self.longest_s, late_s)


def report(played: Sequence[Stopped]) -> list[str]:
    """A table of the causes, in the Markdown of the page."""
    by_cause: dict[str, list[Stopped]] = defaultdict(list)
    for stopped in played:
        by_cause[stopped.cause].append(stopped)
    rows = []
    for cause, limit_s in LIMITS_S.items():
        if of := by_cause[cause]:
            right = sum(stopped.is_right for stopped in of)
            times_s = [stopped.after_s for stopped in of]
            shown = percentile(times_s, 0.5), max(times_s), limit_s
            times = (f"{seconds * 1e3:.0f} ms" for seconds in shown)
            rows.append([cause, str(len(of)), str(right), *times])
    header = ("cause", "cases", "in time", "median", "longest", "limit")
    right = sum(stopped.is_right for stopped in played)
    lines = page.table(header, rows)
    return [*lines, "", f"{right} of {len(played)} stops were in time."]
