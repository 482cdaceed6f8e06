"""`python -m benchmarks PART …`: measures parts, writes their sections of the page.

`make bench` runs the first five parts, on a machine that should have nothing else to
do; the page is build/performance.md. With `--try` a part is short and only printed. The
peers of the round trips are in .venv-bench; `ray_turns` runs in .venv-cluster.
docs/host/performance.md and docs/host/cluster.md describe the parts.
"""

import argparse
import importlib
import sys
from typing import Protocol

from benchmarks import measuring
from benchmarks.round_trips import compared_turns

MODULES = {
    "round_trips": "round_trips.compared_turns",
    "throughput": "round_trips.throughput",
    "growth": "growth.storage_growth",
    "pages": "growth.page_speed",
    "recording_cost": "round_trips.recording_cost",
    "turn_parts": "round_trips.turn_parts",
    "external": "round_trips.external_simulators",
    "postgresql": "growth.postgresql_growth",
    "records": "growth.record_speed",
    "forwarded_turns": "cluster.forwarded_turns",
    "killed_owners": "cluster.killed_owners",
    "many_workers": "cluster.many_workers",
    "capacity": "cluster.cluster_capacity",
    "ray_turns": "cluster.ray_turns",
}
OF_MAKE_BENCH = list(MODULES)[:5]


class MeasuredPart(Protocol):
    """A module that measures. TITLE: of its section of the page."""

    TITLE: str

    def measure(self, *, trying: bool) -> str:
        """Give the text of the section. trying: a short run will do."""


def main() -> int:
    """Return 2 where an environment is missing."""
    options = _options()
    if options.only and options.parts == ["round_trips"]:
        plan = dict.fromkeys(options.scenarios, options.only)
        measuring.say(compared_turns.compare(plan, options.rounds))
        return 0
    if "round_trips" in options.parts and not compared_turns.PEERS_PYTHON.exists():
        print("the peers are not installed: make .venv-bench/ready", file=sys.stderr)
        return 2
    for name in options.parts:
        part: MeasuredPart = importlib.import_module(f"benchmarks.{MODULES[name]}")
        text = part.measure(trying=options.is_tried)
        measuring.say(text)
        if not options.is_tried:
            measuring.put(name, part.TITLE, text)
    return 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks", description=__doc__.partition("\n")[2]
    )
    every = ", ".join(MODULES)
    parser.add_argument("parts", nargs="*", default=OF_MAKE_BENCH, help=every)
    parser.add_argument(
        "--try", action="store_true", dest="is_tried", help="short, and only printed"
    )
    chosen = parser.add_argument_group("for round_trips alone, only printed")
    names = list(compared_turns.NAMES)
    chosen.add_argument("--only", nargs="+", choices=names, metavar="NAME")
    every_scenario = list(compared_turns.TITLES)
    chosen.add_argument(
        *("--scenarios", "--scenario"),
        nargs="+",
        choices=every_scenario,
        default=every_scenario,
    )
    chosen.add_argument("--rounds", type=int, default=compared_turns.ROUNDS)
    options = parser.parse_args()
    if strange := set(options.parts) - MODULES.keys():
        parser.error(f"there is no part {', '.join(strange)}; there are {every}")
    return options


if __name__ == "__main__":
    sys.exit(main())
