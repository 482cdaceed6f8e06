"""The cost of recording: CPU of server and simulators for a turn, with and without.

A benchmark that only counts is measured and one that simulates physics. Two servers,
one that records and one that does not, play blocks of turns in turn, so that a busy
machine slows both. CPU time is that of the server and all its children, by the clocks
of their processes. The difference is the median over pairs of blocks, one played after
the other.
"""

import statistics
import tempfile
from contextlib import ExitStack
from pathlib import Path
from typing import NamedTuple

from benchmarks import measuring
from benchmarks.measured_server import ServerProcess, TimedRun, running_server, submit
from tests.support.sim.calibration_action import calibration_action

TITLE = "Recording"
BENCHMARKS = ("calibration", "tabletop_state")
BLOCKS, BLOCKS_TRIED, NOT_COUNTED = 40, 4, 2
TURNS_AN_EPISODE = 200
TURNS_A_BLOCK = TURNS_AN_EPISODE  # each block has the end of one episode
SHARE_MAX = 0.05  # what is promised


class Spent(NamedTuple):
    """Seconds of CPU: of the server itself, and of all that it started."""

    server: float
    others: float


def measure(*, trying: bool) -> str:
    """Measure both benchmarks."""
    where = measuring.machine()
    rows = []
    for benchmark_id in BENCHMARKS:
        with tempfile.TemporaryDirectory() as scratch:
            blocks = BLOCKS_TRIED if trying else BLOCKS
            rows.append(_row(benchmark_id, _play(benchmark_id, blocks, Path(scratch))))
    head = ["CPU of a turn, µs", "without", "with recordings", "difference", "< 5 %"]
    return f"{measuring.table(head, rows)}\n\n{where}"


def _play(benchmark_id: str, blocks: int, scratch: Path) -> dict[str, list[Spent]]:
    """The CPU time of each block, without recordings and with them."""
    with ExitStack() as stack:
        servers = {}
        for mode in ("off", "actions"):
            folder = scratch / mode
            folder.mkdir()
            server = running_server(folder / "bench.sqlite", PROCTOR_RECORDINGS=mode)
            servers[mode] = stack.enter_context(server)
        runs = {
            mode: _run(server, benchmark_id, blocks + 1)
            for mode, server in servers.items()
        }
        spent: dict[str, list[Spent]] = {mode: [] for mode in servers}
        for mode in measuring.in_turn(list(servers), blocks):
            before = _spent(servers[mode])
            for _ in range(TURNS_A_BLOCK):
                runs[mode].play()
            after = _spent(servers[mode])
            block = [now - then for now, then in zip(after, before, strict=True)]
            spent[mode].append(Spent(*block))
    return {mode: seconds[NOT_COUNTED:] for mode, seconds in spent.items()}


def _run(server: ServerProcess, benchmark_id: str, episodes: int) -> TimedRun:
    if benchmark_id == "calibration":
        options = {"tasks": ["count"] * episodes, "max_steps": TURNS_AN_EPISODE}
        run_id = submit(server, benchmark_id, options=options)
        return TimedRun(server, run_id, calibration_action())
    spaces = server.ask("GET", f"/v1/benchmarks/{benchmark_id}")["action_space"]
    middle = {
        name: [sum(ends) / 2 for ends in zip(of["minimum"], of["maximum"], strict=True)]
        for name, of in spaces.items()
    }
    return TimedRun(server, submit(server, benchmark_id), middle)


def _spent(server: ServerProcess) -> Spent:
    own_s = server.cpu_s()
    return Spent(own_s, measuring.tree_cpu_s(server.process.pid) - own_s)


def _row(benchmark_id: str, spent: dict[str, list[Spent]]) -> list[str]:
    cells = []
    for blocks in spent.values():
        server, others = (
            statistics.median(part) / TURNS_A_BLOCK * 1e6
            for part in zip(*blocks, strict=True)
        )
        cells.append(f"{server + others:.0f} ({server:.0f} in the server)")
    pairs = zip(spent["actions"], spent["off"], strict=True)
    share = statistics.median(sum(on) / sum(off) - 1 for on, off in pairs)
    kept = measuring.verdict(is_met=share < SHARE_MAX)
    return [f"`{benchmark_id}`", *cells, f"{share:+.1%}", kept]
