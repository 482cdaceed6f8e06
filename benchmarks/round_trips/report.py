"""The report of the round trips: tables and targets.

Everything is computed from its section of benchmarks.json, so that every figure in the
text was measured. The targets are the project's requirements; they are shown whether
met or not.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from benchmarks import performance_page
from benchmarks.results import Json

TITLES = {
    "state": "State only: 23 floats",
    "camera": "One camera of 224 × 224, raw",
    "cameras": "Four cameras of 480 × 640, raw",
}
NAMES = {
    "tcp": "raw TCP, the same bytes",
    "openpi": "openpi-client, WebSocket",
    "grpc": "dm_env_rpc, gRPC",
    "ebench": "EBench's way: FastAPI, pickle, requests",
    "openenv": "OpenEnv, WebSocket",
    "ours msgpack": "**Proctor, MessagePack**, `reference_client`",
    "ours msgpack small": "**Proctor, MessagePack**, http.client",
    "ours json": "**Proctor, JSON**, http.client",
    "ours json jpeg": "**Proctor, JSON, JPEG**, decoded to arrays",
    "ours json jpeg files": "**Proctor, JSON, JPEG**, left as files",
}
PEERS = ("openpi", "grpc", "ebench", "openenv")


class Target(NamedTuple):
    """measured: how many times `slow` takes as long as `fast`, p50 against p50."""

    text: str
    bound: str
    measured: float
    is_met: bool


def tables(section: Json) -> str:
    """A table for each scenario, the targets, and the machine and versions."""
    parts = []
    for scenario, title in TITLES.items():
        if played := section["scenarios"].get(scenario):
            parts.append(f"### {title}\n\n{_table(played)}")
    parts.append("### Targets\n\n" + _targets_table(targets(section)))
    parts.append(_where(section))
    return "\n\n".join(parts)


def targets(section: Json) -> list[Target]:
    """The targets whose contenders were measured."""
    scenarios = section["scenarios"]
    found = []
    for scenario, slow, fast, sign, bound, text in _target_table():
        played = scenarios.get(scenario, {})
        if slow not in played or fast not in played:
            continue
        ratio = played[slow]["p50_ms"] / played[fast]["p50_ms"]
        is_met = ratio <= bound if sign == "≤" else ratio >= bound
        found.append(Target(text, f"{sign} {bound:g}", ratio, is_met))
    return found


def _target_table() -> Sequence[tuple[str, str, str, str, float, str]]:
    """scenario, slow, fast, whether the ratio is at most or at least, bound, text."""
    ours, json = "ours msgpack", "ours json"
    four, state = "four cameras: ", "state only: "
    return [
        ("cameras", ours, "tcp", "≤", 2, f"{four}MessagePack to raw TCP"),
        *(
            ("cameras", peer, ours, "≥", 2, f"{four}{_plain(peer)} to MessagePack")
            for peer in PEERS
        ),
        ("state", ours, "openpi", "≤", 3, f"{state}MessagePack to {_plain('openpi')}"),
        *(
            ("state", peer, ours, "≥", 1, f"{state}{_plain(peer)} to MessagePack")
            for peer in PEERS[1:]
        ),
        ("state", "ebench", json, "≥", 1, f"{state}{_plain('ebench')} to JSON"),
        *(
            (
                *("cameras", "ebench", f"{json} jpeg{files}", "≥", 1),
                f"{four}{_plain('ebench')}, raw, to JSON with JPEG, {what}",
            )
            for files, what in (("", "decoded"), (" files", "left as files"))
        ),
    ]


def _plain(name: str) -> str:
    return NAMES[name].partition(",")[0].partition(":")[0]


def _table(played: Mapping[str, Json]) -> str:
    limit = played["tcp"]["p50_ms"]
    rows = [
        [
            NAMES[name],
            ms(one["p50_ms"]),
            ms(one["p99_ms"]),
            f"{one['p50_ms'] / limit:.1f}",
            size(one["up_bytes"]),
            size(one["down_bytes"]),
            f"{one['server_cpu_s']:.2f}",
            f"{one['client_cpu_s']:.2f}",
            str(one["turns"]),
        ]
        for name, one in sorted(played.items(), key=lambda item: item[1]["p50_ms"])
    ]
    head = [
        *("", "p50, ms", "p99, ms", "× TCP", "up", "down"),
        *("server, CPU s", "client, CPU s", "turns"),
    ]
    return performance_page.table(head, rows)


def _targets_table(found: Sequence[Target]) -> str:
    rows = [
        [one.text, f"{one.measured:.2f}", one.bound, "yes" if one.is_met else "**no**"]
        for one in found
    ]
    head = ["p50 to p50", "measured", "target", "met"]
    return performance_page.table(head, rows)


def _where(section: Json) -> str:
    on = section["measured_on"]
    versions = {**on["versions"], **on.get("peers", {})}
    versions.pop("python", None)
    listed = ", ".join(
        f"{name} {version}" for name, version in sorted(versions.items())
    )
    loads = " ".join(map(str, on["load_before"]))
    return (
        f"Measured on {on['date']}: {on['cores']} cores ({on['processor']}), Python "
        f"{on['python']}, load before {loads}, {section['rounds']} rounds, seed "
        f"{section['seed']}. {listed}."
    )


def ms(value: float) -> str:
    """Three digits."""
    if value >= 100:
        return f"{value:.0f}"
    return f"{value:.3f}" if value < 1 else f"{value:#.3g}"


def size(count: int) -> str:
    if count < 10_000:
        return f"{count} B"
    return f"{count / 1e3:.0f} kB" if count < 1_000_000 else f"{count / 1e6:.2f} MB"
