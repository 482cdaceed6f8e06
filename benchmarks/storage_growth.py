"""Measures whether the server slows down or grows with the data that it has stored.

`python -m benchmarks.storage_growth` fills databases with finished runs, starts a real
server on each and sends requests to them alternately, over one connection each: costs
are compared within one execution of this program, never with an earlier one. It also
measures the server's memory before and after thousands of runs were read, played and
submitted, and under a thousand idle long polls and event streams, and the bytes that a
turn writes to disk.

It writes the section `growth` of build/benchmarks.json and of build/performance.md.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import itertools
import json
import shutil
import statistics
import sys
import tempfile
import time
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from benchmarks import performance_page, results
from benchmarks.filled_databases import (
    FIRST_FINISHED,
    READY_RUNS,
    TASKS,
    DatabaseCase,
    ServerProcess,
    fill,
    running_server,
)
from benchmarks.round_trips.contenders.ours_client import TOKEN

WARM_UP = 5  # rounds that are not counted
LIMIT = 50  # of a page
WAITING = 1000
SUBMISSION = {
    "benchmark_id": "calibration",
    "policy": {"name": "growth"},
    "options": {"tasks": [*TASKS] * 25},
}
DATABASE_CASES = (
    DatabaseCase("10^2", 1, 100),
    DatabaseCase("10^4", 100, 100),
    DatabaseCase("10^6", 10_000, 100),
    DatabaseCase("1000 in one run", 300, 1000, same=True),
    DatabaseCase("1000 in every run", 300, 1000),
)
LARGE = DATABASE_CASES[2]


# --- what a request costs ---


@dataclass
class TimedRequests:
    """The requests to one database's server, and the seconds that each took."""

    database_case: DatabaseCase
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
        if self.database_case.runs > LIMIT and not self.database_case.same:
            below = LIMIT + number * LIMIT % (self.database_case.runs - LIMIT)
            pages += f"&cursor={FIRST_FINISHED + below}"
        self.time("list_runs", "GET", f"/v1/runs?{pages}")
        made = self.time("submit", "POST", "/v1/runs", SUBMISSION)
        self.server.ask("POST", f"/v1/runs/{made['run_id']}/stop", {})
        turn = self.time("attach", "PUT", fresh, {"attach_key": "k"})
        self.server.ask("DELETE", f"{fresh}?session_id={turn['session_id']}")

    def _finished(self) -> str:
        """The run requested longest ago: the least likely in memory."""
        self._finished_index += not self.database_case.same
        return f"/v1/runs/completed_{self._finished_index % self.database_case.runs}"

    def p50_ms(self) -> dict[str, float]:
        """Of each operation."""
        return {
            name: round(1000 * statistics.median(seconds), 2)
            for name, seconds in self.seconds.items()
        }

    def time(self, name: str, *request: Any) -> Any:
        started = time.perf_counter()
        answer = self.server.ask(*request)
        spent_s = time.perf_counter() - started
        self.seconds.setdefault(name, []).append(spent_s)
        return answer


def measure_requests(directory: Path, rounds: int) -> dict[str, Any]:
    """p50 of each operation and database, in ms, and as a ratio to the smallest."""
    with contextlib.ExitStack() as servers:
        requests = [
            TimedRequests(
                database_case,
                servers.enter_context(running_server(directory / database_case.file)),
            )
            for database_case in DATABASE_CASES
        ]
        return compare_requests(requests, rounds)


def compare_requests(requests: list[TimedRequests], rounds: int) -> dict[str, Any]:
    """Play rounds in turn; p50 in ms of each operation, and the ratio to the first."""
    for number in range(rounds):
        if number == WARM_UP:
            for one in requests:
                one.seconds.clear()
        for one in requests:
            one.round(number)
    p50_ms = {one.database_case.name: one.p50_ms() for one in requests}
    smallest = p50_ms[requests[0].database_case.name]
    return {
        name: {
            "p50_ms": {
                database_case: report[name] for database_case, report in p50_ms.items()
            },
            "ratio": {
                database_case: round(report[name] / smallest[name], 2)
                for database_case, report in p50_ms.items()
            },
        }
        for name in smallest
    }


def measure_queue(path: Path, length: int, rounds: int) -> dict[str, Any]:
    """p50 beside a long queue, as a ratio to that beside a short one."""
    with contextlib.ExitStack() as servers:
        queues = []
        for waiting in (0, length):
            own = path.with_suffix(f".{waiting}")
            shutil.copy(path, own)
            server = servers.enter_context(
                running_server(own, PROCTOR_MAX_ACTIVE_RUNS="1")
            )
            # Its worker attaches while there is room.
            queues.append(Queue(TimedRequests(DATABASE_CASES[0], server)))
            submit_idle_runs(server, waiting)
        for number in range(rounds + WARM_UP):
            for queue in queues:
                if number == WARM_UP:
                    queue.requests.seconds.clear()
                queue.round()
    short, long = (queue.requests.p50_ms() for queue in queues)
    ratio = {name: round(long[name] / short[name], 2) for name in short}
    return {"runs": length, "p50_ms": short, "ratio": ratio}


class Queue:
    """A server that has no room, and one worker that plays there nevertheless."""

    def __init__(self, requests: TimedRequests) -> None:
        self.requests = requests
        self._worker = "/v1/runs/ready_0/workers/w"
        turn = requests.server.ask("PUT", self._worker, {"attach_key": "k"})
        self._session_id, self._seqs = turn["session_id"], itertools.count(1)

    def round(self) -> None:
        made = self.requests.time("submit", "POST", "/v1/runs", SUBMISSION)
        self.requests.time("get_run", "GET", f"/v1/runs/{made['run_id']}")
        turn = predict(self._session_id, next(self._seqs))
        self.requests.time("predict", "POST", f"{self._worker}/predict", turn)


# --- the server's memory ---


def read_finished_runs(server: ServerProcess, numbers: range) -> float:
    """Read finished runs; returns the server's memory afterwards, in MB."""
    for number in numbers:
        for path in ("", "/score", "/episodes"):
            server.ask("GET", f"/v1/runs/completed_{number}{path}")
    return server.memory_mb()


def play(server: ServerProcess, count: int) -> float:
    """Play runs of one episode from submit to detach; returns the memory then, MB."""
    submission = {**SUBMISSION, "options": {"tasks": ["score"]}}
    for _ in range(count):
        run_id = server.ask("POST", "/v1/runs", submission)["run_id"]
        worker = f"/v1/runs/{run_id}/workers/w"
        turn = server.ask("PUT", worker, {"attach_key": "k"})
        server.ask("POST", f"{worker}/predict", predict(turn["session_id"], 1, end=1.0))
        server.ask("DELETE", f"{worker}?session_id={turn['session_id']}")
    return server.memory_mb()


def submit_idle_runs(server: ServerProcess, count: int) -> float:
    """Submit runs that are never played; returns the server's memory, in MB."""
    for _ in range(count):
        server.ask("POST", "/v1/runs", SUBMISSION)
    return server.memory_mb()


def predict(session_id: str, seq: int, end: float = 0.0) -> dict[str, Any]:
    names = ("score", "success", "delay_s", "fault")
    values = {name: [0.0] for name in names} | {"end": [end]}
    values |= {"vector": [0.0] * 8, "clipped": [0.0] * 2}
    return {"session_id": session_id, "seq": seq, "actions": [{"values": values}]}


def measure_memory(path: Path) -> dict[str, Any]:
    """RSS in MB: after a few and after many finished, played and waiting runs."""
    with running_server(path) as server:
        at_start = server.memory_mb()
        looked = [
            read_finished_runs(server, range(600)),
            read_finished_runs(server, range(600, 3600)),
        ]
        played = [play(server, 300), play(server, 700)]
        waiting = [submit_idle_runs(server, 300), submit_idle_runs(server, 700)]
    pairs = {"looked_at": looked, "played": played, "left_waiting": waiting}
    sizes = {
        name: {"few_mb": round(few, 1), "many_mb": round(many, 1)}
        for name, (few, many) in pairs.items()
    }
    return {"at_start_mb": round(at_start, 1), **sizes}


def measure_turns(path: Path, turns: int) -> dict[str, Any]:
    """Bytes that turns inside one episode send to disk; and one that ends it."""
    with running_server(path) as server:
        worker = "/v1/runs/ready_0/workers/w"
        session_id = server.ask("PUT", worker, {"attach_key": "k"})["session_id"]
        before = server.written_bytes()
        for seq in range(1, turns + 1):
            server.ask("POST", f"{worker}/predict", predict(session_id, seq))
        inside = server.written_bytes() - before
        last = predict(session_id, turns + 1, end=1.0)
        server.ask("POST", f"{worker}/predict", last)
        ending = server.written_bytes() - before - inside
    return {"turns": turns, "written_bytes": inside, "last_turn_bytes": ending}


# --- idle waiting clients ---

Connection = tuple[asyncio.StreamReader, asyncio.StreamWriter]


async def connected(netloc: str, path: str) -> tuple[Connection, str]:
    """A connection, and what a request for the path begins with."""
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
    said = (await reader.readuntil(b"\r\n\r\n")).decode().lower()
    named = dict(line.split(": ", 1) for line in said.splitlines() if ": " in line)
    await reader.readexactly(int(named["content-length"]))
    head += f"If-None-Match: {named['etag']}\r\nPrefer: wait=120\r\n\r\n"
    writer.write(head.encode())
    await writer.drain()
    return reader, writer


async def measure_waiting(
    path: Path,
    wait: Callable[[str, int], Awaitable[Connection]],
    count: int,
    seconds: float,
) -> dict[str, Any]:
    """Memory in MB and CPU share of idle waiting clients, each for another run."""
    with running_server(path) as server:
        read_finished_runs(server, range(8000, 8300))
        before_mb = server.memory_mb()
        waiting = [await wait(server.netloc, number) for number in range(count)]
        await asyncio.sleep(3.0)
        cpu_s, began = server.cpu_s(), time.monotonic()
        await asyncio.sleep(seconds)
        busy = (server.cpu_s() - cpu_s) / (time.monotonic() - began)
        after_mb = server.memory_mb()
        for _, writer in waiting:
            writer.close()
        await asyncio.sleep(3.0)
        left_mb = server.memory_mb()
    return {
        "waiting": count,
        "cost_mb": round(after_mb - before_mb, 1),
        "cpu_share": round(busy, 4),
        "kept_mb": round(left_mb - before_mb, 1),
    }


# --- the report ---


def report(body: dict[str, Any]) -> str:
    """Its section of build/performance.md."""
    names = [database_case.name for database_case in DATABASE_CASES]
    return "\n".join([requests_table(body["requests"], names), "", *sentences(body)])


def requests_table(requests: dict[str, Any], names: list[str]) -> str:
    """A row for each operation, a column for each of these databases."""
    rows = [
        [
            f"`{operation}`",
            *(f"{cost['p50_ms'][n]:.1f} ({cost['ratio'][n]:.2f})" for n in names),
        ]
        for operation, cost in requests.items()
    ]
    return performance_page.table(["p50 in ms (ratio)", *names], rows)


def sentences(body: dict[str, Any]) -> list[str]:
    """The figures without a table, one line each."""
    memory, turns, queue = body["memory"], body["turns"], body["queue"]["ratio"]
    idle = {"long-polls": body["long_polls"], "event streams": body["event_streams"]}
    weighed = {
        "looked_at": "600 and 3600 finished runs were read",
        "played": "300 and 1000 more were played to their end",
        "left_waiting": "300 and 1000 more were submitted and left idle",
    }
    report = [
        f"Beside 10^6 episodes the server starts with {memory['at_start_mb']:.0f} MB.",
        *(
            f"After {what} it has {memory[name]['few_mb']:.0f} and "
            f"{memory[name]['many_mb']:.0f} MB."
            for name, what in weighed.items()
        ),
        *(
            f"{cost['waiting']} idle {what}, each for a run of its own, cost "
            f"{cost['cost_mb']:.0f} MB and {100 * cost['cpu_share']:.1f} % of a core."
            for what, cost in idle.items()
        ),
        (
            f"{turns['turns']} turns inside an episode write {turns['written_bytes']} "
            f"bytes to disk; the turn that ends it {turns['last_turn_bytes']}."
        ),
        (
            f"Beside {body['queue']['runs']} queued runs a submit takes "
            f"{queue['submit']:.2f} times as long as beside few, `get_run` of the last "
            f"one {queue['get_run']:.2f} times, a turn {queue['predict']:.2f} times."
        ),
    ]
    return [f"- {line}" for line in report]


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__)
    most = f"at most {READY_RUNS}"
    arguments.add_argument("--rounds", type=int, default=100, help=most)
    arguments.add_argument("--poll-seconds", type=float, default=30.0)
    arguments.add_argument("--only", help="one part; it is printed and not written")
    arguments.add_argument("--keep", type=Path, help="where databases stay for another")
    options = arguments.parse_args()
    machine = results.machine()
    with contextlib.ExitStack() as held:
        directory = options.keep
        if directory is None:
            directory = Path(held.enter_context(tempfile.TemporaryDirectory()))
        directory.mkdir(exist_ok=True)
        for database_case in DATABASE_CASES:
            if not (directory / database_case.file).exists():
                fill(directory / database_case.file, database_case)
        large = directory / LARGE.file
        parts: dict[str, Callable[[], dict[str, Any]]] = {
            "requests": lambda: measure_requests(directory, options.rounds),
            "long_polls": lambda: asyncio.run(
                measure_waiting(large, poll, WAITING, options.poll_seconds)
            ),
            "event_streams": lambda: asyncio.run(
                measure_waiting(large, follow, WAITING, options.poll_seconds)
            ),
            "turns": lambda: measure_turns(large, 200),
            "memory": lambda: measure_memory(large),
            "queue": lambda: measure_queue(
                directory / DATABASE_CASES[0].file, 3000, 40
            ),
        }
        if options.only is not None:
            print(json.dumps(parts[options.only](), indent=1))
            return 0
        body = {name: part() for name, part in parts.items()}
    results.update("growth", {"measured_on": machine, **body})
    text = report(body)
    print(text)
    performance_page.put("growth", "Growth on SQLite", text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
