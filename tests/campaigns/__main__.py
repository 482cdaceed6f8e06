"""`python -m tests.campaigns attack`, `chaos`, `soak`, `stops`: use it, disturb it.

Prints a line for each attack, round or fault and a verdict for each promise, and writes
both to build/NAME.md; exit code 1 when a promise is broken.
"""

from __future__ import annotations

import argparse
import sys
import time

from tests.campaigns.attack import attack_command as attack
from tests.campaigns.attack.attacks import ATTACKS
from tests.campaigns.chaos import chaos_command as chaos
from tests.campaigns.chaos.chaos_faults import FAULTS
from tests.campaigns.soak import soak_command as soak
from tests.campaigns.soak.soak_host import FAULTS as HOST_FAULTS
from tests.campaigns.stops import stops_command as stops
from tests.support.cells.stop_cases import LIMITS_S

CAMPAIGNS = {
    "attack": (attack, tuple(ATTACKS)),
    "chaos": (chaos, tuple(FAULTS)),
    "soak": (soak, tuple(HOST_FAULTS)),
    "stops": (stops, tuple(LIMITS_S)),
}


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="python -m tests.campaigns", description=__doc__
    )
    subparsers = parser.add_subparsers(dest="campaign", required=True)
    for name, (command, choices) in CAMPAIGNS.items():
        subparser = subparsers.add_parser(name, description=command.__doc__)
        subparser.add_argument("--long", action="store_true", help="for hours")
        subparser.add_argument(
            "--only", default="", metavar="NAMES", help=f"of: {', '.join(choices)}"
        )
        subparser.add_argument("--seed", type=int, default=1)
        command.add_arguments(subparser)
    options = parser.parse_args()
    command, choices = CAMPAIGNS[options.campaign]
    names = [name.strip() for name in options.only.split(",") if name.strip()]
    if unknown := set(names) - set(choices):
        parser.error(f"unknown names: {', '.join(sorted(unknown))}")
    began_at = time.monotonic()
    is_kept = command.run(options, names or list(choices))
    print(f"{time.monotonic() - began_at:.0f} s, seed {options.seed}")
    return int(not is_kept)


if __name__ == "__main__":
    sys.exit(main())
