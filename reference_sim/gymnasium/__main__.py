"""`python -m reference_sim.gymnasium check BENCHMARK…`: checks your benchmarks.

BENCHMARK is a reference as of the server's option `--benchmarks`. Exit codes: 0 all
pass, 1 one of them has a fault, 2 unknown benchmark or invalid file.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

from reference_record.command_line.click_commands import (
    Command,
    Group,
    WrongUsage,
    argument,
    parse_options,
)
from reference_record.command_line.closed_output import run_program
from reference_sim.external import described_benchmark
from reference_sim.gymnasium import BadBenchmark
from reference_sim.gymnasium.benchmark_file import Benchmark, read
from reference_sim.gymnasium.registration import examine


def main(arguments: list[str] | None = None) -> int:
    what = argument(
        "what", "gymnasium:ID, FILE.toml, …",
        nargs=-1, required=True, metavar="BENCHMARK…",
    )  # fmt: skip
    check = Command("check", "check every task of a benchmark", [what])
    program = Group("python -m reference_sim.gymnasium", "", [check], help_text=__doc__)
    try:
        options = parse_options(program, arguments)
        verdicts = [_check(what) for what in options.what]
    except (BadBenchmark, WrongUsage) as error:
        print(error, file=sys.stderr)
        return 2
    return 0 if all(verdicts) else 1


def _check(what: str) -> bool:
    good = True
    for benchmark, folder in read(what):
        if benchmark.simulator is not None:
            good = _check_program(benchmark, folder) and good
            continue
        report = examine(benchmark, folder, _say)
        print(*report.get("tracebacks", ()), sep="\n", end="", file=sys.stderr)
        for kind in ("faults", "warnings", "notes"):
            for line in report.get(kind, ()):
                print(f"{benchmark.benchmark_id}: {kind.removesuffix('s')}: {line}")
        if not report["faults"]:
            total = report["manifest"]["episodes_total"]
            print(f"{benchmark.benchmark_id}: OK, {total} episodes")
        good = good and not report["faults"]
    return good


def _check_program(benchmark: Benchmark, folder: Path) -> bool:
    """Start it and play each of its tasks; a server that offers it ends that sooner."""
    try:
        name, definition = described_benchmark.definition(
            benchmark, folder, _say, try_s=math.inf
        )
    except BadBenchmark as error:
        print(f"{benchmark.benchmark_id}: fault: {error}")
        return False
    print(f"{name}: OK, {definition.describe({}, 1)['episodes_total']} episodes")
    return True


def _say(line: str) -> None:
    print(line, file=sys.stderr)


if __name__ == "__main__":
    sys.exit(run_program(main))
