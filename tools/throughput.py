"""How much of the simulator's own speed is left when it is played over the protocol.

`python tools/throughput.py` plays the same control steps of `tabletop_state` in
bare Python loops, one process each, and through a whole reference server with the same
number of workers, in turn (A B A B …) on the same cores, and prints the ratio for each
length of chunk. Sessions, exactly-once, scoring and the store are at work as always.

A client here is a thread with one kept connection, MessagePack both ways: what a policy
costs is its own affair, what a client costs is counted.
"""

from __future__ import annotations

import argparse
import http.client
import json
import multiprocessing
import os
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import uuid
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import msgspec

BENCHMARK = "tabletop_state"
TASK, SPLIT = "push", "val_train"
MAX_STEPS = 200
MSGPACK = {"Content-Type": "application/msgpack", "Accept": "application/msgpack"}
HOME = {
    "joint_position": [0.0, 0.3, 0.0, 1.6, 0.0, 1.2416, 0.0],
    "gripper": [1.0],
}
ROUNDS = 3


def bare_loop(seconds: float, chunk: int, together: Any, counted: Any) -> None:
    """Plays episodes until the time is over; observes after each chunk."""
    from reference_sim import catalog
    from reference_sim.episode import Episode

    simulator = catalog.make(catalog.resolve(BENCHMARK).world)
    together.wait()
    ends_at = time.monotonic() + seconds
    steps, seed = 0, 0
    while time.monotonic() < ends_at:
        episode = Episode(
            simulator,
            TASK,
            seed,
            split=SPLIT,
            max_steps=MAX_STEPS,
            success_rule="any_step",
        )
        seed += 1
        simulator.observe()
        while not episode.ended and time.monotonic() < ends_at:
            steps += sum(1 for _ in episode.play([HOME] * chunk))
            simulator.observe()
    counted.put(steps)


def bare(workers: int, seconds: float, chunk: int) -> float:
    """Control steps per second of all processes together."""
    spawn = multiprocessing.get_context("spawn")
    counted = spawn.SimpleQueue()
    together = spawn.Barrier(workers)
    crew = [
        spawn.Process(target=bare_loop, args=(seconds, chunk, together, counted))
        for _ in range(workers)
    ]
    for one in crew:
        one.start()
    told = [int(counted.get()) for _ in range(workers)]
    for one in crew:
        one.join()
    return sum(told) / seconds


class Client:
    """One worker of a run."""

    def __init__(self, url: str, token: str, run_id: str, number: int) -> None:
        self._connection = http.client.HTTPConnection(urlsplit(url).netloc)
        self._path = f"/v1/runs/{run_id}/workers/w{number}"
        self._headers = {"Authorization": f"Bearer {token}", **MSGPACK}
        self.steps = 0

    def _ask(self, method: str, path: str, body: Any) -> Any:
        self._connection.request(
            method, path, msgspec.msgpack.encode(body), self._headers
        )
        answer = self._connection.getresponse()
        read = msgspec.msgpack.decode(answer.read())
        if answer.status != 200:
            raise RuntimeError(f"{method} {path}: {read}")
        return read

    def attach(self) -> None:
        turn = self._ask("PUT", self._path, {"attach_key": uuid.uuid4().hex})
        self._session, self._seq = turn["session_id"], 0

    def play(self, seconds: float, chunk: int) -> None:
        """Counts the steps that were answered in time."""
        ends_at = time.monotonic() + seconds
        actions = [{"values": HOME}] * chunk
        while time.monotonic() < ends_at:
            self._seq += 1
            body = {"session_id": self._session, "seq": self._seq, "actions": actions}
            turn = self._ask("POST", f"{self._path}/predict", body)
            if turn["done"]:
                raise RuntimeError("the run is over before the time is")
            self.steps += turn["executed_steps"]


def protocol(url: str, token: str, workers: int, seconds: float, chunk: int) -> float:
    """Control steps per second of all workers together."""
    connection = http.client.HTTPConnection(urlsplit(url).netloc)
    body = {
        "benchmark_id": BENCHMARK,
        "policy": {"name": "throughput"},
        "max_workers": workers,
    }
    headers = {"Authorization": f"Bearer {token}", "Content-Type": "application/json"}
    connection.request("POST", "/v1/runs", json.dumps(body), headers)
    run_id = json.loads(connection.getresponse().read())["run_id"]
    crew = [Client(url, token, run_id, number) for number in range(workers)]
    for one in crew:
        one.attach()
    threads = [threading.Thread(target=one.play, args=(seconds, chunk)) for one in crew]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    connection.request("POST", f"/v1/runs/{run_id}/stop", "{}", headers)
    connection.getresponse().read()
    return sum(one.steps for one in crew) / seconds


def measure(url: str, token: str, workers: int, seconds: float) -> None:
    """Prints a line for each length of chunk: medians, and the worst share."""
    for chunk in (1, 8, 32):
        bares, ours = [], []
        for _ in range(ROUNDS):
            bares.append(bare(workers, seconds, chunk))
            ours.append(protocol(url, token, workers, seconds, chunk))
        shares = [own / plain for own, plain in zip(ours, bares, strict=True)]
        print(
            f"chunk {chunk:2}: bare {statistics.median(bares):6.0f} steps/s, "
            f"protocol {statistics.median(ours):6.0f}, "
            f"share {statistics.median(shares):.2f} (worst {min(shares):.2f})",
            flush=True,
        )


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--workers", type=int, default=16)
    arguments.add_argument("--seconds", type=float, default=2.0)
    options = arguments.parse_args()
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    token = "throughput"  # noqa: S105 - opens nothing but this server
    with tempfile.TemporaryDirectory() as directory:
        settings = {
            "PROCTOR_PORT": "0",
            "PROCTOR_TOKENS": f"bench:read+run:{token}",
            "PROCTOR_DATABASE": str(Path(directory, "bench.sqlite")),
        }
        server = subprocess.Popen(
            [sys.executable, "-m", "reference_server"],
            env={**os.environ, **settings},
            stdout=subprocess.PIPE,
            text=True,
        )
        try:
            assert server.stdout is not None
            url = next(
                word
                for line in server.stdout
                for word in line.split()
                if word.startswith("http://")
            )
            measure(url.rstrip(",;."), token, options.workers, options.seconds)
        finally:
            server.terminate()
            server.wait()
    return 0


if __name__ == "__main__":
    sys.exit(main())
