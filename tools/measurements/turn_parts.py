"""`python -m tools.measurements.turn_parts`: where the time of a turn goes.

One server, one connection, three requests in turn: `GET /livez`, which only the HTTP
library answers; a turn that is sent again, which the server answers from its memory;
and a new turn, which goes to the simulator's process, too. Each contains the one
before. Prints the time at the client and the CPU time of the server's process, of it
that inside the system, for each; and the CPU time of all processes that simulate.
"""

from __future__ import annotations

import http.client
import json
import os
import statistics
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import urlsplit

from tests.campaigns.campaign_server import WATCHER, CampaignServer
from tests.support.server.http_runs import predict_body, worker_path

ROUNDS, REQUESTS, WARM_UP = 60, 100, 5
SETTINGS = {"PROCTOR_RECORDINGS": "off", "PROCTOR_LOG_LEVEL": "warning"}


@dataclass
class Costs:
    """Of one kind of request. Times in microseconds, CPU of each."""

    taken_us: list[float] = field(default_factory=list)
    cpu_us: float = 0.0
    system_us: float = 0.0
    simulator_us: float = 0.0


class TurnParts:
    """A server, and a run of `calibration` that is played over one connection."""

    def __init__(self, server: CampaignServer) -> None:
        self._server = server
        self._connection = http.client.HTTPConnection(urlsplit(server.url).netloc)
        body = {
            "benchmark_id": "calibration",
            "policy": {"name": "p"},
            "options": {"tasks": ["count"], "max_steps": 10_000},
        }
        run = json.loads(self._send("POST", "/v1/runs", json.dumps(body)))
        path, key = worker_path(run["run_id"]), json.dumps({"attach_key": "k"})
        self._turn = json.loads(self._send("PUT", path, key))
        self._path = f"{path}/predict"
        self._play_turn()
        self._does: dict[str, Callable[[], object]] = {
            "GET /livez": lambda: self._send("GET", "/livez"),
            "turn again": lambda: json.loads(
                self._send("POST", self._path, self._last)
            ),
            "new turn": self._play_turn,
        }
        self.costs = {kind: Costs() for kind in self._does}

    def _send(self, method: str, path: str, body: str | None = None) -> bytes:
        headers = {
            "Authorization": f"Bearer {WATCHER}",
            "Content-Type": "application/json",
        }
        self._connection.request(method, path, body, headers)
        answer = self._connection.getresponse()
        content = answer.read()
        assert answer.status < 300, content
        return content

    def _play_turn(self) -> None:
        self._last = json.dumps(predict_body(self._turn))
        self._turn = json.loads(self._send("POST", self._path, self._last))

    def play(self, *, is_counted: bool) -> None:
        """Requests of each kind."""
        for kind, costs in self.costs.items():
            before = self._cpu()
            for _ in range(REQUESTS):
                began_at = time.perf_counter()
                self._does[kind]()
                costs.taken_us.append(1e6 * (time.perf_counter() - began_at))
            spent = [now - then for now, then in zip(self._cpu(), before, strict=True)]
            if is_counted:
                costs.cpu_us += spent[0]
                costs.system_us += spent[1]
                costs.simulator_us += spent[2]
            else:
                costs.taken_us.clear()

    def _cpu(self) -> tuple[float, float, float]:
        """Microseconds of the server, of it in the system, and of simulators."""
        main = _cpu_us(self._server.process.pid)
        simulating = sum(sum(_cpu_us(pid)) for pid in self._server.simulators())
        return sum(main), main[1], simulating


def _cpu_us(pid: int) -> tuple[float, float]:
    """Of a process in user mode and in the system."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    tick_us = 1e6 / os.sysconf("SC_CLK_TCK")
    return int(fields[11]) * tick_us, int(fields[12]) * tick_us


def main() -> None:
    with (
        tempfile.TemporaryDirectory() as directory,
        CampaignServer(Path(directory), SETTINGS) as server,
    ):
        parts = TurnParts(server)
        for number in range(WARM_UP + ROUNDS):
            parts.play(is_counted=number >= WARM_UP)
    print("                 client   server CPU  in the system   simulators, us each")
    for kind, costs in parts.costs.items():
        count = len(costs.taken_us)
        print(
            f"{kind:14} {statistics.median(costs.taken_us):8.0f} "
            f"{costs.cpu_us / count:12.0f} {costs.system_us / count:14.0f} "
            f"{costs.simulator_us / count:12.0f}"
        )


if __name__ == "__main__":
    main()
