"""`python -m tests.chaos`: break a cluster again and again while it is used, judge it.

Prints a line for each round; exit code 1 when a promise was broken. With --write, the
table goes to docs/reliability.md.
"""

from __future__ import annotations

import argparse
import os
import sys
import time

from tests.chaos import chaos_page
from tests.chaos.chaos_campaign import Campaign, Round
from tests.chaos.chaos_faults import FAULTS


def main() -> int:
    options = _options()
    names = [n.strip() for n in options.only.split(",") if n.strip()] or list(FAULTS)
    if unknown := set(names) - set(FAULTS):
        raise SystemExit(f"unknown faults: {', '.join(sorted(unknown))}")
    began_at, load = time.monotonic(), os.getloadavg()[0]
    played: list[Round] = []
    with Campaign.open(
        seed=options.seed, players=options.players, lease_s=options.lease_s
    ) as campaign:
        numbers = range(options.first, options.first + options.rounds)
        for number in numbers:
            if time.monotonic() - began_at > options.seconds:
                break
            played.append(campaign.play(number, names))
            print(chaos_page.round_line(played[-1]), flush=True)
        counts = campaign.counts()
    conditions = chaos_page.Conditions(
        options.seed, options.players, options.lease_s, load, counts
    )
    print(*chaos_page.summary(played, conditions), sep="\n")
    print(f"{time.monotonic() - began_at:.0f} s")
    if options.write:
        chaos_page.write(played, conditions)
    return int(any(one.findings for one in played))


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tests.chaos", description=__doc__)
    parser.add_argument("--rounds", type=int, default=100, metavar="N")
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
