"""Whether a server on SQLite slows down or grows with the data that it has stored.

Databases are filled with finished runs, a real server is started on each, and requests
are sent to them alternately, over one connection each: costs are compared within one
execution of this program, never with an earlier one. The server's memory is measured
before and after thousands of runs were read, played and submitted, and under a thousand
idle long polls and event streams; and the bytes that a turn writes to disk.
"""

import asyncio
import contextlib
import shutil
import statistics
import tempfile
import time
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from benchmarks import measuring
from benchmarks.growth.filled_databases import FIRST_FINISHED, TASKS, DatabaseCase, fill
from benchmarks.measured_server import (
    TOKEN,
    ServerProcess,
    TimedRun,
    running_server,
    submit,
)
from tests.support.sim.calibration_action import calibration_action

TITLE = "Growth on SQLite"
ROUNDS, ROUNDS_TRIED = 100, 7
WARM_UP = 5  # rounds that are not counted
LIMIT = 50  # of a page
WAITING, WAITED_S = 1000, 30.0
QUEUED = 3000
TURNS = 200  # inside one episode
OPTIONS = {"tasks": [*TASKS] * 25}
DATABASE_CASES = (
    DatabaseCase("10^2", 1, 100),
    DatabaseCase("10^4", 100, 100),
    DatabaseCase("10^6", 10_000, 100),
    DatabaseCase("1000 in one run", 300, 1000, same=True),
    DatabaseCase("1000 in every run", 300, 1000),
)


def measure(*, trying: bool) -> str:
    """Measure everything. trying: without the large database, and less of each."""
    cases = DATABASE_CASES[:2] if trying else DATABASE_CASES
    divisor = 100 if trying else 1
    where = measuring.machine()
    with tempfile.TemporaryDirectory() as scratch:
        directory = Path(scratch)
        for case in cases:
            fill(directory / case.file, case)
        smallest = directory / cases[0].file
        large_file = directory / cases[1 if trying else 2].file
        waiting, waited_s = WAITING // divisor, WAITED_S / divisor
        sentences = [
            *memory_sentences(large_file, divisor),
            waiting_sentence("long polls", poll, large_file, waiting, waited_s),
            waiting_sentence("event streams", follow, large_file, waiting, waited_s),
            disk_sentence(large_file),
            queue_sentence(smallest, QUEUED // divisor, 40 // divisor + 1),
        ]
        rounds = ROUNDS_TRIED if trying else ROUNDS
        compared = measure_requests(directory, cases, rounds)
    lines = "\n".join(f"- {sentence}" for sentence in sentences)
    return f"{compared}\n\n{lines}\n\n{where}"


# --- what a request costs ---


@dataclass
class TimedRequests:
    """The requests to one database's server, and the seconds that each took."""

    case: DatabaseCase
    server: ServerProcess
    seconds: dict[str, list[float]] = field(default_factory=dict)
    _finished_index: int = 0

    def round(self, number: int) -> None:
        """Every operation once; `attach` uses a run that has no session yet."""
        fresh = f"/v1/runs/ready_{number}/workers/w"
        self.time("get_run", "GET", self._finished())
        self.time("get_score", "GET", f"{self._finished()}/score")
        episodes = f"{self._finished()}/episodes?limit={LIMIT}"
        self.time("list_episodes", "GET", episodes)
        pages = f"limit={LIMIT}"
        if self.case.runs > LIMIT and not self.case.same:
            below = LIMIT + number * LIMIT % (self.case.runs - LIMIT)
            pages += f"&cursor={FIRST_FINISHED + below}"
        self.time("list_runs", "GET", f"/v1/runs?{pages}")
        run_id = self.submit()
        self.server.ask("POST", f"/v1/runs/{run_id}/stop", {})
        turn = self.time("attach", "PUT", fresh, {"attach_key": "k"})
        self.server.ask("DELETE", f"{fresh}?session_id={turn['session_id']}")

    def submit(self) -> str:
        """The id of a new run of 100 episodes."""
        body = {"benchmark_id": "calibration", "policy": {"name": "growth"}}
        made = self.time("submit", "POST", "/v1/runs", {**body, "options": OPTIONS})
        return str(made["run_id"])

    def _finished(self) -> str:
        """The run requested longest ago: the least likely in memory."""
        self._finished_index += not self.case.same
        return f"/v1/runs/completed_{self._finished_index % self.case.runs}"

    def p50_ms(self) -> dict[str, float]:
        """The median of each operation."""
        return {
            name: 1000 * statistics.median(seconds)
            for name, seconds in self.seconds.items()
        }

    def time(self, name: str, *request: Any) -> Any:
        began_at = time.perf_counter()
        answer = self.server.ask(*request)
        spent_s = time.perf_counter() - began_at
        self.seconds.setdefault(name, []).append(spent_s)
        return answer


def measure_requests(
    directory: Path, cases: tuple[DatabaseCase, ...], rounds: int
) -> str:
    """A server on each database; the table of their requests."""
    with contextlib.ExitStack() as servers:
        requests = [
            TimedRequests(
                case, servers.enter_context(running_server(directory / case.file))
            )
            for case in cases
        ]
        return compare_requests(requests, rounds)


def compare_requests(requests: list[TimedRequests], rounds: int) -> str:
    """Play rounds in turn; a row for each operation, a column for each database."""
    for number in range(rounds):
        for each in requests:
            if number == WARM_UP:
                each.seconds.clear()
            each.round(number)
    p50_ms = [each.p50_ms() for each in requests]
    rows = [
        [
            f"`{name}`",
            *(f"{p50[name]:.1f} ({p50[name] / p50_ms[0][name]:.2f})" for p50 in p50_ms),
        ]
        for name in p50_ms[0]
    ]
    head = ["p50 in ms (ratio)", *(each.case.name for each in requests)]
    return measuring.table(head, rows)


def queue_sentence(path: Path, length: int, rounds: int) -> str:
    """p50 beside a long queue, as a ratio to that beside a short one.

    The servers have no room, and a worker of each plays nevertheless: it attached while
    there was room.
    """
    with contextlib.ExitStack() as servers:
        queues = []
        for waiting in (0, length):
            own = path.with_suffix(f".{waiting}")
            shutil.copy(path, own)
            running = running_server(own, PROCTOR_MAX_ACTIVE_RUNS="1")
            requests = TimedRequests(DATABASE_CASES[0], servers.enter_context(running))
            played = TimedRun(requests.server, "ready_0", calibration_action())
            submit_idle_runs(requests.server, waiting)
            queues.append((requests, played))
        for number in range(rounds + WARM_UP):
            for requests, played in queues:
                if number == WARM_UP:
                    requests.seconds.clear()
                run_id = requests.submit()
                requests.time("get_run", "GET", f"/v1/runs/{run_id}")
                taken = measuring.seconds_of(played.play)
                requests.seconds.setdefault("turn", []).append(taken)
    short, long = (requests.p50_ms() for requests, _ in queues)
    ratio = {name: long[name] / short[name] for name in short}
    return (
        f"Beside {length} queued runs a submit takes {ratio['submit']:.2f} times as "
        f"long as beside few, `get_run` of the last one {ratio['get_run']:.2f} times, "
        f"a turn {ratio['turn']:.2f} times."
    )


# --- the server's memory, and its disk ---


def read_finished_runs(server: ServerProcess, numbers: range) -> float:
    """Read finished runs; returns the server's memory afterwards, in MB."""
    for number in numbers:
        for path in ("", "/score", "/episodes"):
            server.ask("GET", f"/v1/runs/completed_{number}{path}")
    return server.memory_mb()


def play_runs(server: ServerProcess, count: int) -> float:
    """Play runs of one episode from submit to detach; returns the memory then, MB."""
    for _ in range(count):
        run_id = submit(server, "calibration", options={"tasks": ["score"]})
        played = TimedRun(server, run_id, calibration_action())
        played.play(end=1.0)
        played.detach()
    return server.memory_mb()


def submit_idle_runs(server: ServerProcess, count: int) -> float:
    """Submit runs that are never played; returns the server's memory, in MB."""
    for _ in range(count):
        submit(server, "calibration", options=OPTIONS)
    return server.memory_mb()


def memory_sentences(path: Path, divisor: int) -> list[str]:
    """RSS in MB: after a few and after many finished, played and waiting runs."""
    few, many = 600 // divisor, 3600 // divisor
    played = 300 // divisor, 1000 // divisor
    with running_server(path) as server:
        start_mb = server.memory_mb()
        grown = [
            (
                f"{few} and {many} finished runs were read",
                read_finished_runs(server, range(few)),
                read_finished_runs(server, range(few, many)),
            ),
            (
                f"{played[0]} and {played[1]} more were played to their end",
                play_runs(server, played[0]),
                play_runs(server, played[1] - played[0]),
            ),
            (
                f"{played[0]} and {played[1]} more were submitted and left idle",
                submit_idle_runs(server, played[0]),
                submit_idle_runs(server, played[1] - played[0]),
            ),
        ]
    return [
        f"On {path.stem} the server starts with {start_mb:.0f} MB.",
        *(
            f"After {event} it has {few_mb:.0f} and {many_mb:.0f} MB."
            for event, few_mb, many_mb in grown
        ),
    ]


def disk_sentence(path: Path) -> str:
    """Bytes that turns inside one episode send to disk; and one that ends it."""
    with running_server(path) as server:
        played = TimedRun(server, "ready_0", calibration_action())
        before = server.written_bytes()
        for _ in range(TURNS):
            played.play()
        inside = server.written_bytes() - before
        played.play(end=1.0)
        ending = server.written_bytes() - before - inside
    return (
        f"{TURNS} turns inside an episode write {inside} bytes to disk; the turn that "
        f"ends it {ending}."
    )


# --- idle waiting clients ---

Connection = tuple[asyncio.StreamReader, asyncio.StreamWriter]


async def connected(netloc: str, path: str) -> tuple[Connection, str]:
    """A connection, and the beginning of a request for the path."""
    address, _, port = netloc.rpartition(":")
    connection = await asyncio.open_connection(address, int(port))
    head = f"GET {path} HTTP/1.1\r\nHost: {netloc}\r\n"
    return connection, head + f"Authorization: Bearer {TOKEN}\r\n"


async def follow(netloc: str, number: int) -> Connection:
    """Events of a run of its own, in which nothing happens."""
    path = f"/v1/runs/ready_{number}/events"
    (reader, writer), head = await connected(netloc, path)
    writer.write(f"{head}\r\n".encode())
    await reader.readuntil(b"\nevent: run\n")
    return reader, writer


async def poll(netloc: str, number: int) -> Connection:
    """A get_run that waits for a change of a run of its own."""
    path = f"/v1/runs/completed_{number}"
    (reader, writer), head = await connected(netloc, path)
    writer.write(f"{head}\r\n".encode())
    answered = (await reader.readuntil(b"\r\n\r\n")).decode().lower()
    lines = [line for line in answered.splitlines() if ": " in line]
    headers = dict(line.split(": ", 1) for line in lines)
    await reader.readexactly(int(headers["content-length"]))
    head += f"If-None-Match: {headers['etag']}\r\nPrefer: wait=120\r\n\r\n"
    writer.write(head.encode())
    await writer.drain()
    return reader, writer


def waiting_sentence(
    name: str,
    wait: Callable[[str, int], Awaitable[Connection]],
    path: Path,
    count: int,
    seconds: float,
) -> str:
    """Memory in MB and CPU share of idle waiting clients, each for another run."""

    async def measure_waiting() -> tuple[float, float]:
        waiting = [await wait(server.netloc, number) for number in range(count)]
        await asyncio.sleep(3.0)
        cpu_s, began_at = server.cpu_s(), time.monotonic()
        await asyncio.sleep(seconds)
        share = (server.cpu_s() - cpu_s) / (time.monotonic() - began_at)
        after_mb = server.memory_mb()
        for _, writer in waiting:
            writer.close()
        return share, after_mb

    with running_server(path) as server:
        play_runs(server, 20)  # what happens once
        before_mb = server.memory_mb()
        share, after_mb = asyncio.run(measure_waiting())
    return (
        f"{count} idle {name}, each for a run of its own, cost "
        f"{after_mb - before_mb:.0f} MB and {100 * share:.1f} % of a core."
    )
