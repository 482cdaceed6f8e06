"""`python -m tests.chaos`: break a cluster again and again while it is used, judge it.

Prints a line for each round; exit code 1 when a promise was broken. With --write, the
table goes to docs/reliability.md.
"""

from __future__ import annotations

import argparse
import itertools
import os
import sys
import time
from pathlib import Path

from tests.attack.verdicts import percentile
from tests.chaos import chaos_page
from tests.chaos.chaos_campaign import Campaign
from tests.chaos.chaos_faults import FAULTS
from tests.chaos.chaos_rounds import Counts, KeptRounds, faults_to_play
from tools.measurements.git_commit import read_commit


def main() -> int:
    options = _options()
    names = [n.strip() for n in options.only.split(",") if n.strip()] or list(FAULTS)
    if unknown := set(names) - set(FAULTS):
        raise SystemExit(f"unknown faults: {', '.join(sorted(unknown))}")
    began_at = time.monotonic()
    kept = _kept_rounds(options)
    with Campaign.open(
        seed=options.seed, players=options.players, lease_s=options.lease_s
    ) as campaign:
        before = Counts()
        for number in itertools.count(options.first + len(kept.rounds)):
            chosen = names
            if options.long:
                chosen = [n for n in faults_to_play(kept.rounds) if n in names]
            is_over = number >= options.first + options.rounds and not options.long
            if is_over or not chosen or time.monotonic() - began_at > options.seconds:
                break
            load = os.getloadavg()[0]
            played = campaign.play(number, chosen)
            played.counts, before = campaign.counts() - before, campaign.counts()
            kept.add(played, load)
            print(chaos_page.round_line(played), flush=True)
    conditions = chaos_page.Conditions(
        options.seed, options.players, options.lease_s, percentile(kept.loads, 0.5)
    )
    print(*chaos_page.summary(kept.rounds, conditions), sep="\n")
    print(f"{time.monotonic() - began_at:.0f} s")
    if options.write:
        chaos_page.write(kept.rounds, conditions)
    return int(any(one.findings for one in kept.rounds))


def _kept_rounds(options: argparse.Namespace) -> KeptRounds:
    """Those of earlier starts of the same long campaign, else none."""
    if not options.long:
        return KeptRounds({}, file=Path(os.devnull))
    commit, _ = read_commit()
    names = ("seed", "first", "players", "lease_s", "only")
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
    parser.add_argument("--write", action="store_true", help="rewrite its table")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
