"""A simulator in its own process, in C++, beside the same one in a simulator process.

One server plays the still picture of still_life/ in both ways, block by block in turn:
without cameras, and with four of 480 × 640. The client sends a turn and reads the whole
answer. The ratio is the median over pairs of blocks, one played after the other.
"""

from __future__ import annotations

import http.client
import statistics
import subprocess
import tempfile
from pathlib import Path

import msgspec

from benchmarks import measuring
from benchmarks.measured_server import HEADERS, ServerProcess, running_server, submit
from benchmarks.round_trips import observations

TITLE = "Simulators in C++"
ROUNDS, ROUNDS_TRIED, WARM_UP, TURNS = 60, 12, 2, 50
STILL_LIFE = measuring.ROOT / "benchmarks" / "round_trips" / "still_life"
LIBRARIES = measuring.ROOT / "reference_sim" / "external" / "libraries"
SERVER = "benchmarks.round_trips.still_life.still_life_server"
MSGPACK = {**HEADERS, "Content-Type": "application/msgpack"}
MSGPACK["Accept"] = "application/msgpack"
RATIO_MAX = {"state": 1.2, "cameras": 1.3}  # what is promised


def measure(*, trying: bool) -> str:
    """Measure both scenarios."""
    where = measuring.machine()
    rounds = ROUNDS_TRIED if trying else ROUNDS
    with tempfile.TemporaryDirectory() as scratch:
        program = compile_still_life(Path(scratch))
        references = ",".join(f"simulator:{program} {name}" for name in RATIO_MAX)
        with running_server(
            Path(scratch, "bench.sqlite"), SERVER, PROCTOR_BENCHMARKS=references
        ) as server:
            rows = [_row(server, scenario, rounds) for scenario in RATIO_MAX]
    head = ["ms of a turn, p50", "simulator process", "C++", "ratio", "promised"]
    return f"{measuring.table(head, rows)}\n\n{where}"


def compile_still_life(folder: Path) -> Path:
    """The program, which needs a C++ compiler."""
    program = folder / "still_life"
    source = str(STILL_LIFE / "still_life.cpp")
    command = ["c++", "-O2", "-std=c++17", f"-I{LIBRARIES}", source, "-o", str(program)]
    subprocess.run(command, check=True)
    return program


class MessagePackRun:
    """A run whose turns are MessagePack, as those of reference_client."""

    def __init__(self, server: ServerProcess, benchmark_id: str) -> None:
        self._worker = f"/v1/runs/{submit(server, benchmark_id)}/workers/w"
        self._connection = http.client.HTTPConnection(server.netloc)
        self._turn = self._ask("PUT", self._worker, {"attach_key": "k"})
        self._number = 0

    def play(self) -> None:
        """Play a turn of one action."""
        self._number += 1
        action = observations.by_name(observations.action(self._number))
        body = {
            "session_id": self._turn["session_id"],
            "seq": self._turn["seq"] + 1,
            "actions": [{"values": action}],
        }
        self._turn = self._ask("POST", f"{self._worker}/predict", body)

    def _ask(self, method: str, path: str, body: dict[str, object]) -> dict[str, int]:
        data = msgspec.msgpack.encode(body)
        self._connection.request(method, path, data, MSGPACK)
        answer = self._connection.getresponse()
        read = answer.read()
        if answer.status != 200:
            raise RuntimeError(f"{method} {path}: {answer.status} {read[:300]!r}")
        turn: dict[str, int] = msgspec.msgpack.decode(read)
        return turn


def _row(server: ServerProcess, scenario: str, rounds: int) -> list[str]:
    names = [f"still_life_{scenario}", f"external_{scenario}"]
    runs = {name: MessagePackRun(server, name) for name in names}
    blocks: dict[str, list[float]] = {name: [] for name in names}
    for name in measuring.in_turn(names, WARM_UP + rounds):
        times = [measuring.seconds_of(runs[name].play) for _ in range(TURNS)]
        blocks[name].append(statistics.median(times))
    inside, outside = (blocks[name][WARM_UP:] for name in names)
    ratio = statistics.median(o / i for o, i in zip(outside, inside, strict=True))
    kept = measuring.verdict(is_met=ratio <= RATIO_MAX[scenario])
    cells = [f"{1e3 * statistics.median(part):.3f}" for part in (inside, outside)]
    return [scenario, *cells, f"{ratio:.2f}", f"≤ {RATIO_MAX[scenario]} {kept}"]
