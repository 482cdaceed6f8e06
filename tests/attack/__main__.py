"""`python -m tests.attack`: attack the reference server, and judge it.

Prints a line for each attack and a verdict for each promise; exit code 1 when one is
broken. Both go to build/attack.md.
"""

from __future__ import annotations

import argparse
import os
import sys
import time

from tests.attack import reliability_page
from tests.attack.attacks import ATTACKS
from tests.attack.measurement import measure_all


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.attack", description=__doc__)
    parser.add_argument("--long", action="store_true", help="the long form: hours")
    parser.add_argument(
        "--only", default="", metavar="NAMES", help=f"of: {', '.join(ATTACKS)}"
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--part", type=float, default=1.0, help="of the size of the form, 0 to 1"
    )
    options = parser.parse_args()
    names = [n.strip() for n in options.only.split(",") if n.strip()] or list(ATTACKS)
    if unknown := set(names) - set(ATTACKS):
        parser.error(f"unknown attacks: {', '.join(sorted(unknown))}")
    began_at, load = time.monotonic(), os.getloadavg()[0]
    results = []
    chosen = [ATTACKS[name] for name in names]
    for result in measure_all(
        chosen, seed=options.seed, is_long=options.long, part=options.part
    ):
        results.append(result)
        print(reliability_page.console_line(result), flush=True)
    print(*reliability_page.promise_lines(results), sep="\n")
    print(f"{time.monotonic() - began_at:.0f} s, seed {options.seed}")
    results.sort(key=lambda result: names.index(result.attack.name))
    form = f"the {'long' if options.long else 'short'} form"
    if options.part != 1:
        form = f"a part of {options.part:g} of {form}"
    reliability_page.write(results, form=form, seed=options.seed, load=load)
    return int(any(result.broken for result in results))


if __name__ == "__main__":
    sys.exit(main())
