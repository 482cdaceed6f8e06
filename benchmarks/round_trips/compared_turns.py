"""The round trip of predict, compared with alternatives.

For each scenario all contenders run at once and play alternately, by
interleaved_rounds.py. A round gives each contender the same time, so a faster one plays
more turns. A contender that fails ends the measurement; none is omitted silently. Peers
run with their real packages in their own virtual environment, `.venv-bench`; ours is
the reference server with the benchmark `still_life`. Targets are shown whether met or
not.
"""

import json
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks import measuring
from benchmarks.measured_server import TOKEN
from benchmarks.round_trips import interleaved_rounds
from benchmarks.round_trips.interleaved_rounds import (
    Contender,
    ContenderPair,
    TurnTimes,
)

TITLE = "Round trips"
TITLES = {
    "state": "State only: 23 floats",
    "camera": "One camera of 224 × 224, raw",
    "cameras": "Four cameras of 480 × 640, raw",
}
NAMES = {
    "tcp": "raw TCP, the same bytes",
    "openpi": "openpi-client, WebSocket",
    "dm_env_rpc": "dm_env_rpc, gRPC",
    "ebench": "EBench's way: FastAPI, pickle, requests",
    "openenv": "OpenEnv, WebSocket",
    "ours msgpack": "**Proctor, MessagePack**, `reference_client`",
    "ours msgpack small": "**Proctor, MessagePack**, http.client",
    "ours json": "**Proctor, JSON**, http.client",
    "ours json jpeg": "**Proctor, JSON, JPEG**, decoded to arrays",
    "ours json jpeg files": "**Proctor, JSON, JPEG**, left as files",
}
PEERS = ("openpi", "dm_env_rpc", "ebench", "openenv")
# name → media type and codec of the small client; none: the reference client's session
OURS: dict[str, tuple[str, ...]] = {
    "ours msgpack": (),
    "ours msgpack small": ("msgpack", "raw"),
    "ours json": ("json", "raw"),
    "ours json jpeg": ("json", "jpeg"),
    "ours json jpeg files": ("json", "jpeg-files"),
}
PLAN = {"state": list(NAMES)[:-2], "camera": list(NAMES)[:-2], "cameras": list(NAMES)}
ROUNDS, ROUNDS_TRIED = 200, 5
WARM_UP_TURNS = 30
TURNS_MAX = 20
SHARE_S = 0.02  # of a round, for a contender that is slower than that many turns
PEERS_PYTHON = measuring.ROOT / ".venv-bench" / "bin" / "python"
_PROCESS = "benchmarks.round_trips.contender_process"
_OUR_SERVER = "benchmarks.round_trips.still_life.still_life_server"
_VERSIONS = """
import importlib.metadata, json, sys
print(json.dumps({name: importlib.metadata.version(name) for name in sys.argv[1:]}))
"""
PEERS_PACKAGES = (
    *("dm-env-rpc", "fastapi", "grpcio", "openenv-core", "openpi-client", "requests"),
    *("uvicorn", "uvloop", "websockets"),
)
PACKAGES = ("httptools", "msgspec", "numpy", "simplejpeg", "uvicorn", "uvloop")

Played = Mapping[str, TurnTimes]


def measure(*, trying: bool) -> str:
    """Compare all contenders in all scenarios."""
    return compare(PLAN, ROUNDS_TRIED if trying else ROUNDS)


def compare(plan: Mapping[str, Sequence[str]], rounds: int) -> str:
    """Give the section. plan: scenario → names of contenders."""
    where = measuring.machine(PACKAGES)
    if any(name in PEERS for names in plan.values() for name in names):
        where += f"; the peers: {_peers_versions()}"
    scenarios = {name: play_scenario(name, plan[name], rounds) for name in plan}
    parts = [
        f"### {TITLES[scenario]}\n\n{table_of(played)}"
        for scenario, played in scenarios.items()
    ]
    parts.append("### Targets\n\n" + targets_table(targets(scenarios)))
    return "\n\n".join([*parts, f"{rounds} rounds. {where}."])


def contender(name: str, scenario: str, scratch: Path) -> Contender:
    """scratch: a folder for the databases of our servers."""
    if name not in OURS:
        python = str(PEERS_PYTHON if name in PEERS else sys.executable)
        run = [python, "-m", _PROCESS]
        serve, play = ["serve", name, scenario], ["play", name, "{}", scenario]
        return Contender(name, [*run, *serve], [*run, *play])
    database = str(scratch / f"{name.replace(' ', '_')}_{scenario}.sqlite")
    module = "small_client" if OURS[name] else "reference_session"
    return Contender(
        name,
        [sys.executable, "-m", _OUR_SERVER, "--port", "0", "--database", database],
        [
            *(sys.executable, "-m", _PROCESS),
            *("play", module, "{}", scenario, *OURS[name]),
        ],
        {"PROCTOR_TOKENS": f"bench:read+run:{TOKEN}"},
    )


def play_scenario(scenario: str, names: Sequence[str], rounds: int) -> Played:
    """The times of each contender's turns."""
    with tempfile.TemporaryDirectory() as scratch:
        contenders = [contender(name, scenario, Path(scratch)) for name in names]
        measuring.say(f"{scenario}: starting {', '.join(names)}")
        with interleaved_rounds.started(contenders) as pairs:
            turns = {pair.name: _warm_up(pair) for pair in pairs}
            measuring.say(f"{scenario}: playing {rounds} rounds")
            return interleaved_rounds.play(pairs, rounds, turns)


def _warm_up(pair: ContenderPair) -> int:
    """How many turns it shall play in a round."""
    pair.play(2, whole=True)
    tried = pair.play(2)
    if statistics.mean(tried.ns) / 1e9 <= SHARE_S:
        tried = pair.play(WARM_UP_TURNS)
    return max(1, min(TURNS_MAX, int(SHARE_S * 1e9 / statistics.median(tried.ns))))


def _peers_versions() -> str:
    command = [str(PEERS_PYTHON), "-c", _VERSIONS, *PEERS_PACKAGES]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    versions: dict[str, Any] = json.loads(done.stdout)
    return ", ".join(f"{name} {version}" for name, version in versions.items())


# --- the report ---


class Target(NamedTuple):
    """measured: how many times `slow` takes as long as `fast`, p50 against p50."""

    text: str
    bound: str
    measured: float
    is_met: bool


def targets(scenarios: Mapping[str, Played]) -> list[Target]:
    """The targets whose contenders were measured."""
    judged = []
    for scenario, slow, fast, sign, bound, text in _target_table():
        played = scenarios.get(scenario, {})
        if slow not in played or fast not in played:
            continue
        ratio = played[slow].percentile_ms(50) / played[fast].percentile_ms(50)
        is_met = ratio <= bound if sign == "≤" else ratio >= bound
        judged.append(Target(text, f"{sign} {bound:g}", ratio, is_met))
    return judged


def _target_table() -> Sequence[tuple[str, str, str, str, float, str]]:
    """scenario, slow, fast, whether the ratio is at most or at least, bound, text."""
    ours, json_ = "ours msgpack", "ours json"
    four, state = "four cameras: ", "state only: "
    return [
        ("cameras", ours, "tcp", "≤", 2, f"{four}MessagePack to raw TCP"),
        *(
            ("cameras", peer, ours, "≥", 2, f"{four}{_plain(peer)} to MessagePack")
            for peer in PEERS
        ),
        *(
            ("state", ours, "openpi", "≤", most, f"{state}MessagePack to openpi-client")
            for most in (3, 1.5)
        ),
        *(
            ("state", peer, ours, "≥", 1, f"{state}{_plain(peer)} to MessagePack")
            for peer in PEERS[1:]
        ),
        ("state", "ebench", json_, "≥", 1, f"{state}{_plain('ebench')} to JSON"),
        *(
            (
                *("cameras", "ebench", f"{json_} jpeg{files}", "≥", 1),
                f"{four}{_plain('ebench')}, raw, to JSON with JPEG, {kept}",
            )
            for files, kept in (("", "decoded"), (" files", "left as files"))
        ),
    ]


def _plain(name: str) -> str:
    return NAMES[name].partition(",")[0].partition(":")[0]


def table_of(played: Played) -> str:
    """A row for each contender, the fastest first."""
    fastest_ms = min(times.percentile_ms(50) for times in played.values())
    rows = []
    for name in sorted(played, key=lambda name: played[name].percentile_ms(50)):
        times = played[name]
        p50, p99 = times.percentile_ms(50), times.percentile_ms(99)
        cells = [*map(measuring.digits, (p50, p99)), f"{p50 / fastest_ms:.1f}"]
        cells += [f"{cpu:.2f}" for cpu in times.cpu_ms()]
        rows.append([NAMES[name], *cells, str(len(times.ns))])
    head = [
        *("", "p50, ms", "p99, ms", "× the fastest"),
        *("server, CPU ms", "client, CPU ms", "turns"),
    ]
    return measuring.table(head, rows)


def targets_table(judged: Sequence[Target]) -> str:
    rows = []
    for each in judged:
        met = measuring.verdict(is_met=each.is_met)
        rows.append([each.text, f"{each.measured:.2f}", each.bound, met])
    return measuring.table(["p50 to p50", "measured", "target", "met"], rows)
