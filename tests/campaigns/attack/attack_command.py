"""`python -m tests.campaigns attack`: attack the reference server, and judge it."""

from __future__ import annotations

import argparse
import os

from tests.campaigns.attack import attack_report as report
from tests.campaigns.attack.attacks import ATTACKS
from tests.campaigns.attack.measurement import measure_all


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--part", type=float, default=1.0, help="of the size of the form, 0 to 1"
    )


def run(options: argparse.Namespace, names: list[str]) -> bool:
    """Play these attacks; whether every promise was kept."""
    load = os.getloadavg()[0]
    results = []
    chosen = [ATTACKS[name] for name in names]
    for result in measure_all(
        chosen, seed=options.seed, is_long=options.long, part=options.part
    ):
        results.append(result)
        print(report.console_line(result), flush=True)
    print(*report.judge_all(results), sep="\n")
    results.sort(key=lambda result: names.index(result.attack.name))
    form = f"{options.part:g} of the {'long' if options.long else 'short'} form"
    report.write(results, f"seed {options.seed}, {form}, load before it {load:.1f}")
    return not any(result.broken for result in results)
