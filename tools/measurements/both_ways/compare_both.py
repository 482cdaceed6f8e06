"""A benchmark by the protocol and in a loop of its own: every episode is the same.

`PYTHON -m tools both-ways push_t`, `aloha`, `panda_lift` or `metaworld`,
where PYTHON is that of the environment that has the package. An expert plays a split
twice. Ends with 1 if the steps, the success, the return or one observation
of one episode differ.
"""

from __future__ import annotations

import importlib
import sys

from tools.measurements.both_ways.compared_benchmark import ComparedBenchmark
from tools.measurements.both_ways.play import (
    differing,
    max_steps_of,
    play_by_protocol,
    play_directly,
)

NAMES = ("aloha", "metaworld", "panda_lift", "push_t")


def main(*, compared: str, episodes: int | None) -> int:
    if compared not in NAMES:
        print(f"both-ways: no {compared}; have {', '.join(NAMES)}", file=sys.stderr)
        return 2
    module = importlib.import_module(f"tools.measurements.both_ways.{compared}")
    benchmark: ComparedBenchmark = module.COMPARED
    served = play_by_protocol(benchmark, episodes)
    direct = play_directly(benchmark, sorted(served.outcomes), max_steps_of(benchmark))
    for (task, seed), outcome in direct.outcomes.items():
        print(f"{task}, seed {seed}: {outcome}")
        if outcome != served.outcomes[task, seed]:
            print(f"  by protocol {served.outcomes[task, seed]}")
    different = differing(direct, served)
    successes = sum(outcome.success for outcome in served.outcomes.values())
    print(
        f"{len(served.outcomes)} episodes, {successes} succeed, "
        f"{len(different)} differ; turns a second: "
        f"{direct.turns_per_s:.1f} directly, {served.turns_per_s:.1f} by protocol"
    )
    return 1 if different or not served.outcomes else 0
