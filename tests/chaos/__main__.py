"""`python -m tests.chaos`: break a cluster again and again while it is used, judge it.

Prints a line for each round; exit code 1 when a promise was broken. The table goes to
build/chaos.md.
"""

from __future__ import annotations

import argparse
import itertools
import os
import subprocess
import sys
import time

from tests.attack.verdicts import percentile
from tests.chaos import chaos_page
from tests.chaos.chaos_campaign import Campaign
from tests.chaos.chaos_faults import FAULTS
from tests.chaos.chaos_rounds import Counts, KeptRounds, faults_to_play
from tools.measurements.git_commit import read_commit


def main() -> int:
    options = _options()
    known = [
        name
        for name, fault in FAULTS.items()
        if options.simulators == "ray" or not fault.needs_ray
    ]
    names = [n.strip() for n in options.only.split(",") if n.strip()] or known
    if unknown := set(names) - set(known):
        raise SystemExit(f"unknown faults: {', '.join(sorted(unknown))}")
    began_at = time.monotonic()
    kept = _kept_rounds(options)
    others = [
        subprocess.Popen([*_command(options), "--seed", str(options.seed + number)])
        for number in range(1, options.clusters)
    ]
    _play(options, names, kept)
    ended = [other.wait() for other in others]
    kept.refresh()
    conditions = chaos_page.Conditions(
        sorted({one.seed for one in kept.rounds}),
        options.players,
        options.lease_s,
        percentile(kept.loads, 0.5),
        options.clusters,
    )
    print(*chaos_page.summary(kept.rounds, conditions), sep="\n")
    print(f"{time.monotonic() - began_at:.0f} s")
    chaos_page.write(kept.rounds, conditions)
    return int(any(ended) or any(one.findings for one in kept.rounds))


def _play(options: argparse.Namespace, names: list[str], kept: KeptRounds) -> None:
    """Rounds of one cluster, until enough were played."""
    began_at = time.monotonic()
    with Campaign.open(
        seed=options.seed,
        players=options.players,
        lease_s=options.lease_s,
        ray=options.simulators == "ray",
    ) as campaign:
        before = Counts()
        for number in itertools.count(options.first + kept.played_with(options.seed)):
            kept.refresh()
            chosen = names
            if options.long:
                chosen = [n for n in faults_to_play(kept.rounds) if n in names]
            is_over = number >= options.first + options.rounds and not options.long
            if is_over or not chosen or time.monotonic() - began_at > options.seconds:
                break
            load = os.getloadavg()[0]
            played = campaign.play(number, chosen)
            played.seed = options.seed
            played.counts, before = campaign.counts() - before, campaign.counts()
            kept.add(played, load)
            print(chaos_page.round_line(played), flush=True)


def _command(options: argparse.Namespace) -> list[str]:
    """For one more cluster of a long campaign; its seed is left out."""
    command = [sys.executable, "-m", "tests.chaos", "--long", "--only", options.only]
    for name in ("players", "lease_s", "first", "seconds", "simulators"):
        command += [f"--{name.replace('_', '-')}", str(getattr(options, name))]
    return command


def _kept_rounds(options: argparse.Namespace) -> KeptRounds:
    """Those of earlier starts of the same long campaign, else none."""
    if not options.long:
        return KeptRounds({}, file=None)
    commit, _ = read_commit()
    names = ("players", "lease_s", "only", "simulators")
    chosen = {name: getattr(options, name) for name in names}
    return KeptRounds({"commit": commit, **chosen})


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tests.chaos", description=__doc__)
    parser.add_argument("--rounds", type=int, default=100, metavar="N")
    parser.add_argument(
        "--long",
        action="store_true",
        help="until each fault was made as often as promised; goes on where it ended",
    )
    parser.add_argument(
        "--clusters",
        type=int,
        default=1,
        metavar="N",
        help="of --long: so many at once",
    )
    parser.add_argument("--first", type=int, default=0, help="number of the first one")
    parser.add_argument(
        "--seconds", type=float, default=float("inf"), help="begin no round later"
    )
    parser.add_argument(
        "--only", default="", metavar="NAMES", help=f"of: {', '.join(FAULTS)}"
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--players", type=int, default=6)
    parser.add_argument("--lease-s", type=float, default=5.0, help="of nodes")
    parser.add_argument(
        "--simulators",
        choices=["local", "ray"],
        default="local",
        help="processes of the nodes, or on a Ray cluster whose machines fail, too",
    )
    options = parser.parse_args()
    if options.clusters > 1 and not options.long:
        parser.error("several clusters share the rounds of --long only")
    return options


if __name__ == "__main__":
    sys.exit(main())
