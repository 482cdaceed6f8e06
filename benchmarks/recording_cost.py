"""What recording costs: CPU of the server and its simulators for a turn, both ways.

`python -m benchmarks.recording_cost`. Two servers, one that records and one that does
not, play blocks of turns in turn, so that a busy machine slows both. CPU time is that
of the server and all its children, by the clocks of their processes; Linux only.
The difference is the median over pairs of blocks, one played after the other.
"""

from __future__ import annotations

import argparse
import statistics
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

import httpx

from tests.support.server.http_runs import predict_body
from tests.support.servers import ReferenceServer

TURNS_AN_EPISODE = 200
TURNS_A_BLOCK = TURNS_AN_EPISODE  # each block has the end of one episode


class Spent(NamedTuple):
    """Seconds of CPU: of the server itself, and of all that it started."""

    server: float
    others: float


class PlayedServer:
    """A server, and a run in which blocks of turns are played."""

    def __init__(self, server: ReferenceServer, task: str, episodes: int = 64) -> None:
        self._pid = server.process.pid
        self._client = server.client()
        body = {
            "benchmark_id": "calibration",
            "policy": {"name": "p"},
            "options": {"tasks": [task] * episodes, "max_steps": TURNS_AN_EPISODE},
        }
        self._run = self._client.post("/v1/runs", json=body).json()["run_id"]
        worker = f"/v1/runs/{self._run}/workers/w"
        self._path = f"{worker}/predict"
        self._turn = self._client.put(worker, json={"attach_key": "k"}).json()

    def cpu_of_block(self) -> Spent:
        """Of one block of turns."""
        before = cpu_seconds(self._pid)
        for _ in range(TURNS_A_BLOCK):
            answer: httpx.Response = self._client.post(
                self._path, json=predict_body(self._turn)
            )
            self._turn = answer.raise_for_status().json()
        after = cpu_seconds(self._pid)
        return Spent(after.server - before.server, after.others - before.others)


def cpu_seconds(pid: int) -> Spent:
    """So far; of those that have not ended."""
    children: dict[int, list[int]] = {}
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            fields = (entry / "stat").read_text().rpartition(")")[2].split()
        except OSError:  # it has ended meanwhile
            continue
        children.setdefault(int(fields[1]), []).append(int(entry.name))
    others, left = 0.0, list(children.get(pid, []))
    while left:
        one = left.pop()
        others += _process_clock(one)
        left += children.get(one, [])
    return Spent(_process_clock(pid), others)


def _process_clock(pid: int) -> float:
    """Seconds; clock_getcpuclockid(3), which Python has for threads only."""
    return time.clock_gettime(~pid << 3 | 2)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--blocks", type=int, default=40)
    blocks = parser.parse_args().blocks
    spent: dict[str, list[Spent]] = {"off": [], "actions": []}
    with tempfile.TemporaryDirectory() as directory:
        folders = {ways: Path(directory, ways) for ways in spent}
        for folder in folders.values():
            folder.mkdir()
        with (
            ReferenceServer(folders["off"], PROCTOR_RECORDINGS="off") as plain,
            ReferenceServer(folders["actions"]) as recording,
        ):
            played = {
                "off": PlayedServer(plain, "count", blocks + 1),
                "actions": PlayedServer(recording, "count", blocks + 1),
            }
            for number in range(blocks):
                for ways in sorted(spent, reverse=bool(number % 2)):
                    spent[ways].append(played[ways].cpu_of_block())
    for ways, seconds in spent.items():
        server, others = (
            statistics.median(part) / TURNS_A_BLOCK * 1e6
            for part in zip(*seconds[2:], strict=True)
        )
        print(
            f"recordings={ways:8} {server + others:6.0f} µs of CPU for a turn: "
            f"{server:.0f} in the server, {others:.0f} in its simulator"
        )
    pairs = list(zip(spent["actions"], spent["off"], strict=True))[2:]
    share = statistics.median(sum(one) / sum(other) - 1 for one, other in pairs)
    print(f"difference {share:+.1%}, {blocks} blocks of {TURNS_A_BLOCK} turns")


if __name__ == "__main__":
    main()
