"""Runs the whole kit through the balancer of three nodes, again and again.

`python -m tests.campaigns.chaos.kit_runs`: nodes over one PostgreSQL, a balancer
without affinity, and another seed in each run. With --kill one node after another is
killed and started again meanwhile. The kit is given one URL and cannot kill anything
itself, so rows about a crash are not judged.

A killed node ends the sessions of its runs, as the text allows, and a row that is
judged at that moment does not expect it. So with --kill rows that were not found obeyed
are judged again, while the kills go on, each time half as often, for some rows take
longer than what lies between two kills: what was found obeyed once was disturbed, what
never was is an alarm. Prints a line for each time; exit code 1 after an alarm.
"""

from __future__ import annotations

import argparse
import contextlib
import itertools
import signal
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from pathlib import Path

from tests.campaigns.campaign_server import ATTACKER, WATCHER, WATCHER_READS
from tests.campaigns.chaos.chaos_campaign import open_cluster
from tests.campaigns.chaos.chaos_faults import HOSTS
from tests.campaigns.chaos.clusters.chaos_cluster import ChaosCluster
from tests.support.network import hosts
from tools.measurements.false_alarms import REPORT, alarms_of, read_report

TOKENS = {
    "PROCTOR_TOKEN": WATCHER,
    "PROCTOR_TOKEN_2": ATTACKER,
    "PROCTOR_TOKEN_READ": WATCHER_READS,
}
FIRST_SEED = 2000
# A node that was started again is left alone for so long, more than its lease; twice as
# long each time that rows are judged again.
BETWEEN_KILLS_S = 8.0
# Seconds between two looks at the clock, and at whether the kills are over.
LOOK_S = 0.5
# How often rows are judged that may have met a kill.
TRIES_MAX = 6


class Kills:
    """Kills one node after another while it is entered. count: so far.

    between_s: seconds from a node that was started again to the next kill. What has
    ended the kills before is raised at the end.
    """

    def __init__(self, cluster: ChaosCluster) -> None:
        self._cluster = cluster
        self._is_over = threading.Event()
        self._failed: Exception | None = None
        self._thread = threading.Thread(target=self._run, name="kills")
        self.count, self.between_s = 0, BETWEEN_KILLS_S

    def __enter__(self) -> None:
        self._thread.start()

    def __exit__(self, *_: object) -> None:
        self._is_over.set()
        self._thread.join()
        if self._failed is not None:
            raise self._failed

    def _run(self) -> None:
        try:
            for node in itertools.cycle(self._cluster.nodes):
                started = time.monotonic()
                while time.monotonic() - started < self.between_s:  # it may change
                    if self._is_over.wait(LOOK_S):
                        return
                node.end(signal.SIGKILL)
                self.count += 1
                node.start()
        except Exception as error:  # noqa: BLE001 - raised at the end
            self._failed = error


class KitRuns:
    """The kit against one cluster, again and again. kills: of its nodes, or None.

    options: of the kit.
    """

    def __init__(
        self,
        cluster: ChaosCluster,
        directory: Path,
        kills: Kills | None,
        options: Sequence[str],
    ) -> None:
        self._cluster, self._directory, self._kills = cluster, directory, kills
        self._options = options

    def is_conformant(self, seed: int) -> bool:
        """After one whole run, and with kills after what has to be judged again."""
        if self._kills is not None:
            self._kills.between_s = BETWEEN_KILLS_S
        wrong = self._judge(seed, [])
        for _ in range(TRIES_MAX - 1):
            if not wrong or self._kills is None:
                break
            self._kills.between_s *= 2
            # The report as a whole is no row: the kit met a kill before it began.
            again = [] if REPORT in wrong else ["--only", ",".join(wrong)]
            wrong = self._judge(seed, again)
        return not wrong

    def _judge(self, seed: int, options: list[str]) -> dict[str, str]:
        before = self._kills.count if self._kills else 0
        report = self._directory / f"report-{seed}"
        given = ["--url", self._cluster.url, *self._options, *options]
        found = read_report(report, seed, given, TOKENS)
        wrong = alarms_of(found)
        kills = self._kills.count - before if self._kills else 0
        print(
            f"seed {seed}  {found['elapsed_s']:6.1f} s  {kills} kills  "
            f"{found['conclusion'].splitlines()[0]}  {found['counts']['MUST']}",
            *(
                f"    {id_}  {text}"
                for id_, text in wrong.items()
                if id_ == REPORT or REPORT not in wrong
            ),
            sep="\n",
            flush=True,
        )
        return wrong


def main() -> int:
    options = _options()
    if options.hosts and not hosts.is_inside():
        if reason := hosts.why_none():
            raise SystemExit(reason)
        return hosts.run_inside([sys.executable, "-m", __spec__.name, *sys.argv[1:]])
    kinds = {HOSTS} if options.hosts else set[str]()
    with (
        tempfile.TemporaryDirectory(prefix="kit-runs-") as directory,
        open_cluster(Path(directory), kinds, options.lease_s, seed=1) as cluster,
    ):
        kills = Kills(cluster) if options.kill else None
        quick = ["--quick"] if options.quick else []
        runs = KitRuns(cluster, Path(directory), kills, quick)
        with kills or contextlib.nullcontext():
            right = sum(
                runs.is_conformant(FIRST_SEED + number)
                for number in range(options.runs)
            )
    killed = f", {kills.count} nodes killed" if kills else ""
    print(f"{right} of {options.runs} runs without an alarm{killed}")
    return int(right < options.runs)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m tests.campaigns.chaos.kit_runs", description=__doc__
    )
    parser.add_argument("--runs", type=int, default=20, metavar="N")
    parser.add_argument("--kill", action="store_true", help="nodes, meanwhile")
    parser.add_argument("--quick", action="store_true", help="as QUICK=1 of the kit")
    parser.add_argument("--hosts", action="store_true", help="in network namespaces")
    parser.add_argument("--lease-s", type=float, default=5.0, help="of nodes")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
