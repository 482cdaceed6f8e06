"""`python -m tests.chaos.kit_runs`: the whole kit through the balancer of three nodes.

Nodes over one PostgreSQL, a balancer without affinity, and another seed in each run.
With --kill one node after another is killed and started again meanwhile. The kit is
given one URL and cannot kill anything itself, so rows about a crash are not judged.
Prints a line for each run; exit code 1 when a rule was not found obeyed.
"""

from __future__ import annotations

import argparse
import contextlib
import itertools
import signal
import sys
import tempfile
import threading
from collections.abc import Iterator
from pathlib import Path

from tests.attack.attacked_server import ATTACKER, WATCHER, WATCHER_READS
from tests.chaos.chaos_campaign import NODES
from tests.chaos.chaos_cluster import ChaosCluster
from tools.measurements.false_alarms import alarms_of, read_report

TOKENS = {
    "PROCTOR_TOKEN": WATCHER,
    "PROCTOR_TOKEN_2": ATTACKER,
    "PROCTOR_TOKEN_READ": WATCHER_READS,
}
FIRST_SEED = 2000
# A node that was started again is left alone for so long, more than its lease.
BETWEEN_KILLS_S = 8.0


def main() -> int:
    options = _options()
    alarms = 0
    with (
        tempfile.TemporaryDirectory(prefix="kit-runs-") as directory,
        ChaosCluster.open(
            Path(directory), size=NODES, lease_s=options.lease_s, seed=1
        ) as cluster,
        _kill_nodes(cluster) if options.kill else contextlib.nullcontext([0]) as kills,
    ):
        for number in range(options.runs):
            seed, before = FIRST_SEED + number, kills[0]
            report = Path(directory, f"report-{seed}")
            found = read_report(report, seed, ["--url", cluster.url], **TOKENS)
            wrong = alarms_of(found)
            alarms += bool(wrong)
            print(
                f"seed {seed}  {found['elapsed_s']:6.1f} s  {kills[0] - before} kills  "
                f"{found['conclusion'].splitlines()[0]}  {found['counts']['MUST']}",
                *(f"    {id_}  {text}" for id_, text in wrong.items()),
                sep="\n",
                flush=True,
            )
    print(f"{options.runs - alarms} of {options.runs} runs without an alarm")
    return int(alarms > 0)


@contextlib.contextmanager
def _kill_nodes(cluster: ChaosCluster) -> Iterator[list[int]]:
    """One after another, until the end; how often, as the only entry of a list."""
    kills, is_over = [0], threading.Event()

    def kill() -> None:
        for node in itertools.cycle(cluster.nodes):
            if is_over.wait(BETWEEN_KILLS_S):
                return
            node.end(signal.SIGKILL)
            kills[0] += 1
            node.start()

    thread = threading.Thread(target=kill, name="kills")
    thread.start()
    try:
        yield kills
    finally:
        is_over.set()
        thread.join()


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m tests.chaos.kit_runs", description=__doc__
    )
    parser.add_argument("--runs", type=int, default=20, metavar="N")
    parser.add_argument("--kill", action="store_true", help="nodes, meanwhile")
    parser.add_argument("--lease-s", type=float, default=5.0, help="of nodes")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
