"""`python -m benchmarks`: measures, writes build/benchmarks.json, build/performance.md.

`make bench` runs all of it, on a machine that should have nothing else to do. With
`--try` few rounds are played and nothing is written; `page` measures nothing and writes
the page anew from benchmarks.json. storage_growth.py is a command of its own.
"""

from __future__ import annotations

import argparse
import os
import sys

from benchmarks import performance_page, results
from benchmarks.libraries import library_comparison, tables
from benchmarks.round_trips import chart, contender_registry, report
from benchmarks.round_trips import measurement as round_trips
from benchmarks.throughput import measurement as throughput

ALL_CONTENDERS = (
    *("tcp", *contender_registry.PEERS),
    *("ours msgpack", "ours msgpack small", "ours json"),
)
PLAN = {
    "state": ALL_CONTENDERS,
    "camera": ALL_CONTENDERS,
    "cameras": (*ALL_CONTENDERS, "ours json jpeg", "ours json jpeg files"),
}
ROUNDS, ROUNDS_TRIED = 200, 5
PARTS = ("round_trips", "throughput", "libraries")
BUSY = 0.25  # load of each core above which figures are unreliable


def main() -> int:
    options = _options()
    if contender_registry.PEERS_PYTHON.exists() or _needs_no_peers(options):
        _measure(options)
        return 0
    print("the peers are not installed: make .venv-bench/ready", file=sys.stderr)
    return 2


def _needs_no_peers(options: argparse.Namespace) -> bool:
    if "libraries" in options.parts:
        return False
    names = options.only or ALL_CONTENDERS
    return "round_trips" not in options.parts or not set(names) & set(
        contender_registry.PEERS
    )


def _measure(options: argparse.Namespace) -> None:
    load = os.getloadavg()[0]
    if load > BUSY * (os.cpu_count() or 1):
        _say(f"machine is loaded (load {load:.1f}): absolute figures are unreliable")
    if "round_trips" in options.parts:
        _round_trips(options)
    if "throughput" in options.parts:
        body = {
            "measured_on": results.machine(),
            **throughput.measure(options.try_, _say),
        }
        if options.try_:
            _say(throughput.tables(body))
        else:
            results.update("throughput", body)
    if "libraries" in options.parts:
        body = library_comparison.measure(options.try_, _say)
        _say(tables.tables(body))
        if not options.try_:
            results.update("libraries", body)
    if not options.try_:
        write()


def _round_trips(options: argparse.Namespace) -> None:
    before = results.machine()  # the load is that of the moment before
    plan = {
        scenario: [
            name for name in PLAN[scenario] if name in (options.only or PLAN[scenario])
        ]
        for scenario in options.scenarios
    }
    if not _needs_no_peers(options):
        before["peers"] = round_trips.peers_versions()
    rounds = ROUNDS_TRIED if options.try_ else ROUNDS
    body = {
        "measured_on": before,
        **round_trips.measure(plan, options.rounds or rounds, _say),
    }
    for target in report.targets(body):
        verdict = "met" if target.is_met else "NOT MET"
        _say(f"{target.measured:7.2f} ({target.bound}) {verdict}: {target.text}")
    if not options.try_:
        results.update("round_trips", body)


def write() -> None:
    """Write the page and the chart from benchmarks.json."""
    sections = results.read()
    if section := sections.get("round_trips"):
        performance_page.put(
            "round_trips", "Round trips", f"{chart.LINK}\n\n{report.tables(section)}"
        )
        chart.FILE.write_text(chart.svg(section))
    if section := sections.get("throughput"):
        performance_page.put("throughput", "Throughput", throughput.tables(section))
    if section := sections.get("libraries"):
        performance_page.put(
            "libraries", "Libraries: HTTP and encoding", tables.tables(section)
        )


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks", description=__doc__.partition("\n")[2]
    )
    every = ", ".join((*PARTS, "page"))
    parser.add_argument("parts", nargs="*", default=PARTS, help=f"some of {every}")
    parser.add_argument("--scenarios", nargs="+", choices=PLAN, default=list(PLAN))
    parser.add_argument("--only", nargs="+", choices=PLAN["cameras"], metavar="NAME")
    parser.add_argument("--rounds", type=int, help=f"instead of {ROUNDS}")
    parser.add_argument(
        "--try", action="store_true", dest="try_", help="short, and writes nothing"
    )
    options = parser.parse_args()
    if strange := set(options.parts) - {*PARTS, "page"}:
        parser.error(f"there is no part {', '.join(strange)}; there are {every}")
    if options.only or options.scenarios != list(PLAN):
        options.try_ = True  # the page shows all contenders
    return options


def _say(text: str) -> None:
    print(text, flush=True)


if __name__ == "__main__":
    sys.exit(main())
