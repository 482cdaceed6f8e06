"""A simulator in its own process, in C++ and in Python, beside the same one in a
simulator process.

One server plays the still picture of still_life/ in these ways, block by block in turn:
without cameras, with 32 actions in a turn, and with four cameras of 480 × 640. The
client sends a turn and reads the whole answer. A ratio is the median over pairs of
blocks, one played after the other. CPU is that of the server and all its processes. The
program in Python shows what this project's own simulators would cost as programs.
"""

import http.client
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import msgspec

from benchmarks import measuring
from benchmarks.measured_server import HEADERS, ServerProcess, running_server, submit
from benchmarks.round_trips import observations

TITLE = "Simulators in C++"
ROUNDS, ROUNDS_TRIED, WARM_UP, TURNS = 60, 12, 2, 50
STILL_LIFE = measuring.ROOT / "benchmarks" / "round_trips" / "still_life"
LIBRARIES = measuring.ROOT / "reference_sim" / "external" / "libraries"
PYTHON_PROGRAM = STILL_LIFE / "still_life_program.py"
SERVER = "benchmarks.round_trips.still_life.still_life_server"
MSGPACK = {**HEADERS, "Content-Type": "application/msgpack"}
MSGPACK["Accept"] = "application/msgpack"
RATIO_MAX = {"state": 1.2, "cameras": 1.3}  # what is promised of C++
CASES = [("state", 1), ("state", 32), ("cameras", 1)]  # with actions in a turn
WAYS = {"still_life": "simulator process", "external": "C++", "python": "Python"}


def measure(*, trying: bool) -> str:
    """Measure both scenarios."""
    where = measuring.machine()
    rounds = ROUNDS_TRIED if trying else ROUNDS
    with tempfile.TemporaryDirectory() as scratch:
        program = compile_still_life(Path(scratch))
        written = f"env LIBRARIES={LIBRARIES} {sys.executable} {PYTHON_PROGRAM}"
        references = ",".join(
            f"simulator:{command} {name}"
            for command in (program, written)
            for name in RATIO_MAX
        )
        with running_server(
            Path(scratch, "bench.sqlite"), SERVER, PROCTOR_BENCHMARKS=references
        ) as server:
            rows = [row for case in CASES for row in _rows(server, *case, rounds)]
    head = ["a turn", "way", "ms, p50", "ratio", "ms of CPU", "ratio", "promised"]
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

    def play(self, actions: int) -> None:
        """Play a turn."""
        self._number += 1
        action = observations.by_name(observations.action(self._number))
        body = {
            "session_id": self._turn["session_id"],
            "seq": self._turn["seq"] + 1,
            "actions": [{"values": action}] * actions,
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


def _rows(
    server: ServerProcess, scenario: str, actions: int, rounds: int
) -> Iterator[list[str]]:
    names = [f"{way}_{scenario}" for way in WAYS]
    runs = {name: MessagePackRun(server, name) for name in names}
    times: dict[str, list[float]] = {name: [] for name in names}
    cpu: dict[str, list[float]] = {name: [] for name in names}
    for name in measuring.in_turn(names, WARM_UP + rounds):
        before_s = measuring.tree_cpu_s(server.process.pid)
        turns = [
            measuring.seconds_of(partial(runs[name].play, actions))
            for _ in range(TURNS if actions == 1 else TURNS // 10)
        ]
        after_s = measuring.tree_cpu_s(server.process.pid)
        times[name].append(statistics.median(turns))
        cpu[name].append((after_s - before_s) / len(turns))
    for name, way in zip(names, WAYS.values(), strict=True):
        ratio, cpu_ratio = (
            statistics.median(
                mine / first
                for mine, first in zip(all_[name], all_[names[0]], strict=True)
            )
            for all_ in (times, cpu)
        )
        is_promised = way == "C++" and actions == 1
        most = RATIO_MAX[scenario]
        verdict = f"≤ {most} {measuring.verdict(is_met=ratio <= most)}"
        yield [
            scenario if actions == 1 else f"{scenario}, {actions} actions",
            way,
            f"{1e3 * statistics.median(times[name][WARM_UP:]):.3f}",
            f"{ratio:.2f}",
            f"{1e3 * statistics.median(cpu[name][WARM_UP:]):.3f}",
            f"{cpu_ratio:.2f}",
            verdict if is_promised else "",
        ]
