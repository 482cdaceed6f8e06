"""The round trip of predict, compared with alternatives: section `round_trips`.

For each scenario all contenders run at once and play alternately
(interleaved_rounds.py). A round gives each contender the same time, so a faster one
plays more turns. A contender that fails ends the measurement; none is omitted silently.
"""

from __future__ import annotations

import contextlib
import json
import statistics
import subprocess
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from benchmarks.results import Json
from benchmarks.round_trips import contender_registry, interleaved_rounds, observations
from benchmarks.round_trips.byte_counting_relay import ByteCounts

WARM_UP_TURNS = 30
TURNS_MAX = 20
SHARE_S = 0.02  # of a round, for a contender that is slower than that many turns
_VERSIONS = """
import importlib.metadata, json, platform, sys
found = {name: importlib.metadata.version(name) for name in sys.argv[1:]}
print(json.dumps({"python": platform.python_version(), **found}))
"""
PEERS_PACKAGES = (
    *("dm-env-rpc", "fastapi", "grpcio", "openenv-core", "openpi-client", "requests"),
    *("uvicorn", "uvloop", "websockets"),
)

Say = Callable[[str], None]


def measure(plan: Mapping[str, Sequence[str]], count: int, say: Say) -> Json:
    """The section. plan: scenario → names of contenders. count: rounds."""
    return {
        "seed": observations.SEED,
        "rounds": count,
        "warm_up_turns": WARM_UP_TURNS,
        "scenarios": {
            scenario: _scenario(scenario, names, count, say)
            for scenario, names in plan.items()
        },
    }


def _scenario(scenario: str, names: Sequence[str], count: int, say: Say) -> Json:
    with (
        tempfile.TemporaryDirectory() as scratch,
        contextlib.ExitStack() as standing,
    ):
        pairs = []
        for name in names:
            say(f"{scenario}: starting {name}")
            contender = contender_registry.contender(name, scenario, Path(scratch))
            pairs.append(
                standing.enter_context(interleaved_rounds.ContenderPair(contender))
            )
        turns = {pair.name: _warm_up(pair) for pair in pairs}
        say(f"{scenario}: playing {count} rounds")
        played = interleaved_rounds.play(pairs, count, turns)
        weights = {pair.name: pair.byte_counts for pair in pairs}
    shown = {name: _summary(played[name], weights[name]) for name in names}
    for name, one in shown.items():
        say(f"  {name:21} p50 {one['p50_ms']:8.3f} ms   p99 {one['p99_ms']:8.3f} ms")
    return shown


def _warm_up(pair: interleaved_rounds.ContenderPair) -> int:
    """How many turns it shall play in a round."""
    pair.play(2, whole=True)
    tried = interleaved_rounds.TurnTimes()
    pair.play(2, tried)
    slow = statistics.mean(tried.ns) / 1e9 > SHARE_S
    if not slow:
        tried = interleaved_rounds.TurnTimes()
        pair.play(WARM_UP_TURNS, tried)
    return max(1, min(TURNS_MAX, int(SHARE_S * 1e9 / statistics.median(tried.ns))))


def _summary(played: interleaved_rounds.TurnTimes, byte_counts: ByteCounts) -> Json:
    turns = len(played.ns)
    percentiles = statistics.quantiles(played.ns, n=100, method="inclusive")
    return {
        "turns": turns,
        "p50_ms": round(percentiles[49] / 1e6, 4),
        "p99_ms": round(percentiles[98] / 1e6, 4),
        "up_bytes": byte_counts.up,
        "down_bytes": byte_counts.down,
        # Per turn in ms, and so per thousand turns in seconds.
        "server_cpu_s": round(played.server_cpu_s / turns * 1000, 4),
        "client_cpu_s": round(played.client_cpu_s / turns * 1000, 4),
    }


def peers_versions() -> dict[str, Any]:
    """Of the peers' own environment. Raises FileNotFoundError if it is not there."""
    command = [str(contender_registry.PEERS_PYTHON), "-c", _VERSIONS, *PEERS_PACKAGES]
    completed = subprocess.run(command, check=True, capture_output=True, text=True)
    versions: dict[str, Any] = json.loads(completed.stdout)
    return versions
