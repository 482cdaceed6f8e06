"""What recording costs: CPU of the server and its simulators for a turn, both ways.

`python -m benchmarks.recording_cost`. Two servers, one that records and one that does
not, play blocks of turns in turn, so that a busy machine slows both. CPU time is that
of the server and all its children, from /proc; Linux only.
"""

from __future__ import annotations

import argparse
import os
import statistics
import tempfile
from pathlib import Path

import httpx

from tests.support.server.http_runs import predict_body
from tests.support.servers import ReferenceServer

TURNS_A_BLOCK = 100


class PlayedServer:
    """A server, and a run in which blocks of turns are played."""

    def __init__(self, server: ReferenceServer, task: str) -> None:
        self._pid = server.process.pid
        self._client = server.client()
        body = {
            "benchmark_id": "calibration",
            "policy": {"name": "p"},
            "options": {"tasks": [task] * 64, "max_steps": 200},
        }
        self._run = self._client.post("/v1/runs", json=body).json()["run_id"]
        worker = f"/v1/runs/{self._run}/workers/w"
        self._path = f"{worker}/predict"
        self._turn = self._client.put(worker, json={"attach_key": "k"}).json()

    def cpu_of_block(self) -> float:
        """Seconds of CPU of one block of turns."""
        before = cpu_seconds(self._pid)
        for _ in range(TURNS_A_BLOCK):
            answer: httpx.Response = self._client.post(
                self._path, json=predict_body(self._turn)
            )
            self._turn = answer.raise_for_status().json()
        return cpu_seconds(self._pid) - before


def cpu_seconds(pid: int) -> float:
    """Of a process and its descendants, so far; those that ended included."""
    children: dict[int, list[int]] = {}
    spent: dict[int, float] = {}
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            fields = (entry / "stat").read_text().rpartition(")")[2].split()
        except OSError:  # it has ended meanwhile
            continue
        children.setdefault(int(fields[1]), []).append(int(entry.name))
        spent[int(entry.name)] = sum(map(int, fields[11:15]))
    ticks, left = 0.0, [pid]
    while left:
        one = left.pop()
        ticks += spent.get(one, 0.0)
        left += children.get(one, [])
    return ticks / os.sysconf("SC_CLK_TCK")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--blocks", type=int, default=40)
    blocks = parser.parse_args().blocks
    spent: dict[str, list[float]] = {"off": [], "actions": []}
    with tempfile.TemporaryDirectory() as directory:
        folders = {ways: Path(directory, ways) for ways in spent}
        for folder in folders.values():
            folder.mkdir()
        with (
            ReferenceServer(folders["off"], PROCTOR_RECORDINGS="off") as plain,
            ReferenceServer(folders["actions"]) as recording,
        ):
            played = {
                "off": PlayedServer(plain, "count"),
                "actions": PlayedServer(recording, "count"),
            }
            for number in range(blocks):
                for ways in sorted(spent, reverse=bool(number % 2)):
                    spent[ways].append(played[ways].cpu_of_block())
    per_turn = {
        ways: statistics.mean(seconds[2:]) / TURNS_A_BLOCK * 1e6
        for ways, seconds in spent.items()
    }
    share = per_turn["actions"] / per_turn["off"] - 1
    print(f"without recordings {per_turn['off']:.0f} µs of CPU for a turn")
    print(f"with recordings    {per_turn['actions']:.0f} µs of CPU for a turn")
    print(f"difference         {share:+.1%}, {blocks} blocks of {TURNS_A_BLOCK} turns")


if __name__ == "__main__":
    main()
