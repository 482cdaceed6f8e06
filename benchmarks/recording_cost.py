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
from typing import NamedTuple

import httpx

from tests.support.server.http_runs import predict_body
from tests.support.servers import ReferenceServer

TURNS_A_BLOCK = 100


class Spent(NamedTuple):
    """Seconds of CPU: of the server itself, and of all that it started."""

    server: float
    others: float


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
    """So far; with those that ended."""
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
    ticks, left = 0.0, list(children.get(pid, []))
    while left:
        one = left.pop()
        ticks += spent.get(one, 0.0)
        left += children.get(one, [])
    second = os.sysconf("SC_CLK_TCK")
    return Spent(spent.get(pid, 0.0) / second, ticks / second)


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
                "off": PlayedServer(plain, "count"),
                "actions": PlayedServer(recording, "count"),
            }
            for number in range(blocks):
                for ways in sorted(spent, reverse=bool(number % 2)):
                    spent[ways].append(played[ways].cpu_of_block())
    whole = {}
    for ways, seconds in spent.items():
        server, others = (
            statistics.mean(part) / TURNS_A_BLOCK * 1e6
            for part in zip(*seconds[2:], strict=True)
        )
        whole[ways] = server + others
        print(
            f"recordings={ways:8} {whole[ways]:6.0f} µs of CPU for a turn: "
            f"{server:.0f} in the server, {others:.0f} in its simulator"
        )
    share = whole["actions"] / whole["off"] - 1
    print(f"difference {share:+.1%}, {blocks} blocks of {TURNS_A_BLOCK} turns")


if __name__ == "__main__":
    main()
