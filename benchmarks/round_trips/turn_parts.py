"""Where the time of a turn goes.

One server, one connection, three requests in turn: `GET /livez`, which only the HTTP
library answers; a turn that is sent again, which the server answers from its memory;
and a new turn, which goes to the simulator's process, too. Each contains the one
before. Gives the time at the client, the CPU time of the server's process, of it that
inside the system, for each; and the CPU time of all processes that simulate.
"""

import os
import statistics
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from benchmarks import measuring
from benchmarks.measured_server import ServerProcess, TimedRun, running_server, submit
from tests.support.sim.calibration_action import calibration_action

TITLE = "Parts of a turn"
ROUNDS, ROUNDS_TRIED, REQUESTS, WARM_UP = 60, 3, 100, 5
SETTINGS = {"PROCTOR_RECORDINGS": "off", "PROCTOR_LOG_LEVEL": "warning"}


@dataclass
class Costs:
    """The costs of one kind of request: microseconds of each, CPU seconds of all."""

    taken_us: list[float] = field(default_factory=list)
    server_s: float = 0.0
    system_s: float = 0.0
    simulators_s: float = 0.0

    def row(self, kind: str) -> list[str]:
        each = [self.server_s, self.system_s, self.simulators_s]
        cpu_us = [1e6 * seconds / len(self.taken_us) for seconds in each]
        times_us = statistics.median(self.taken_us), *cpu_us
        return [kind, *(f"{us:.0f}" for us in times_us)]


def measure(*, trying: bool) -> str:
    """Play rounds; those of the warm-up are not counted."""
    where = measuring.machine()
    options = {"tasks": ["count"], "max_steps": 10_000}
    with (
        tempfile.TemporaryDirectory() as directory,
        running_server(Path(directory, "bench.sqlite"), **SETTINGS) as server,
    ):
        run_id = submit(server, "calibration", options=options)
        played = TimedRun(server, run_id, calibration_action())
        played.play()
        does: dict[str, Callable[[], object]] = {
            "`GET /livez`": lambda: server.ask("GET", "/livez"),
            "a turn again": played.repeat,
            "a new turn": played.play,
        }
        costs = {kind: Costs() for kind in does}
        for number in range(WARM_UP + (ROUNDS_TRIED if trying else ROUNDS)):
            if number == WARM_UP:
                costs = {kind: Costs() for kind in does}
            for kind, request in does.items():
                _play(server, request, costs[kind])
    head = ["", "client", "server CPU", "in the system", "simulators"]
    rows = [spent.row(kind) for kind, spent in costs.items()]
    return f"{measuring.table(head, rows)}\n\nMicroseconds of each request. {where}"


def _play(server: ServerProcess, request: Callable[[], object], costs: Costs) -> None:
    before = _cpu_s(server)
    costs.taken_us += [1e6 * measuring.seconds_of(request) for _ in range(REQUESTS)]
    spent = [now - then for now, then in zip(_cpu_s(server), before, strict=True)]
    costs.server_s += spent[0]
    costs.system_s += spent[1]
    costs.simulators_s += spent[2]


def _cpu_s(server: ServerProcess) -> tuple[float, float, float]:
    """Seconds of the server, of it in the system, and of its descendants."""
    pid = server.process.pid
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    system_s = int(fields[12]) / os.sysconf("SC_CLK_TCK")
    return server.cpu_s(), system_s, measuring.tree_cpu_s(pid) - server.cpu_s()
