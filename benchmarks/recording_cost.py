"""What recording costs: CPU of the server and its simulators for a turn, both ways.

`python -m benchmarks.recording_cost` measures a benchmark that only counts and one that
simulates physics. Two servers, one that records and one that does not, play blocks of
turns in turn, so that a busy machine slows both. CPU time is that of the server and all
its children, by the clocks of their processes; Linux only. The difference is the median
over pairs of blocks, one played after the other.
"""

from __future__ import annotations

import argparse
import statistics
import tempfile
import time
from pathlib import Path
from typing import Any, NamedTuple

import httpx

from tests.support.servers import ReferenceServer
from tests.support.sim.calibration_action import calibration_action

CALIBRATION = "calibration"
BENCHMARKS = (CALIBRATION, "tabletop_state")
TURNS_AN_EPISODE = 200
TURNS_A_BLOCK = TURNS_AN_EPISODE  # each block has the end of one episode


class Spent(NamedTuple):
    """Seconds of CPU: of the server itself, and of all that it started."""

    server: float
    others: float


class PlayedServer:
    """A server, and a run in which blocks of turns are played."""

    def __init__(
        self, server: ReferenceServer, benchmark_id: str, episodes: int
    ) -> None:
        self._pid = server.process.pid
        self._client = server.client()
        body: dict[str, Any] = {"benchmark_id": benchmark_id, "policy": {"name": "p"}}
        if benchmark_id == CALIBRATION:
            tasks = ["count"] * episodes
            body["options"] = {"tasks": tasks, "max_steps": TURNS_AN_EPISODE}
            self._values = calibration_action()
        else:
            self._values = self._read_middle_of_actions(benchmark_id)
        self._run = self._client.post("/v1/runs", json=body).json()["run_id"]
        worker = f"/v1/runs/{self._run}/workers/w"
        self._path = f"{worker}/predict"
        self._turn = self._client.put(worker, json={"attach_key": "k"}).json()

    def _read_middle_of_actions(self, benchmark_id: str) -> dict[str, list[float]]:
        """An action in the middle of every range."""
        answer = self._client.get(f"/v1/benchmarks/{benchmark_id}").raise_for_status()
        return {
            name: [
                sum(ends) / 2 for ends in zip(of["minimum"], of["maximum"], strict=True)
            ]
            for name, of in answer.json()["action_space"].items()
        }

    def cpu_of_block(self) -> Spent:
        """Of one block of turns."""
        before = cpu_seconds(self._pid)
        for _ in range(TURNS_A_BLOCK):
            body = {
                "session_id": self._turn["session_id"],
                "seq": self._turn["seq"] + 1,
                "actions": [{"values": self._values}],
            }
            answer: httpx.Response = self._client.post(self._path, json=body)
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
    parser.add_argument("--benchmark", help="its id; else both")
    options = parser.parse_args()
    for benchmark_id in [options.benchmark] if options.benchmark else BENCHMARKS:
        spent = measure(benchmark_id, options.blocks)
        print(f"{benchmark_id}:")
        print(*report(spent), sep="\n")


def measure(benchmark_id: str, blocks: int) -> dict[str, list[Spent]]:
    """Of each block, without recordings and with them."""
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
                "off": PlayedServer(plain, benchmark_id, blocks + 1),
                "actions": PlayedServer(recording, benchmark_id, blocks + 1),
            }
            for number in range(blocks):
                for ways in sorted(spent, reverse=bool(number % 2)):
                    spent[ways].append(played[ways].cpu_of_block())
    return spent


def report(spent: dict[str, list[Spent]]) -> list[str]:
    """Lines; the first two blocks are not counted."""
    lines = []
    for ways, seconds in spent.items():
        server, others = (
            statistics.median(part) / TURNS_A_BLOCK * 1e6
            for part in zip(*seconds[2:], strict=True)
        )
        lines.append(
            f"recordings={ways:8} {server + others:6.0f} µs of CPU for a turn: "
            f"{server:.0f} in the server, {others:.0f} in its simulator"
        )
    pairs = list(zip(spent["actions"], spent["off"], strict=True))[2:]
    share = statistics.median(sum(one) / sum(other) - 1 for one, other in pairs)
    lines.append(
        f"difference {share:+.1%}, {len(pairs)} pairs of {TURNS_A_BLOCK} turns"
    )
    return lines


if __name__ == "__main__":
    main()
