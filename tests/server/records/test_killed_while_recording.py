"""A server is killed again and again while workers play: its record stays true.

PROCTOR_TEST_KILLS=100 for the long form.
"""

from __future__ import annotations

import os
import random
import signal
import threading
import time
from collections import Counter
from pathlib import Path
from typing import Any

import httpx
import msgspec
import pytest

from reference_record.formats.bundle import open_bundle
from reference_record.formats.mcap_reader import McapReader
from reference_record.verification import verify
from tests.support.server.http_runs import predict_body, submit
from tests.support.servers import ReferenceServer

pytestmark = pytest.mark.slow("starts a server several times")

KILLS = int(os.environ.get("PROCTOR_TEST_KILLS", "3"))
WORKERS, EPISODES, TURNS = 4, 8, 6
MARK = "vector"


class Worker(threading.Thread):
    """Plays until the run is completed; each action carries a number of its own."""

    def __init__(self, client: httpx.Client, run_id: str, number: int) -> None:
        super().__init__()
        self._client = client
        self._path = f"/v1/runs/{run_id}"
        self._worker = f"{self._path}/workers/w{number}"
        self._number = number * 1_000_000
        self.received: list[float] = []

    def run(self) -> None:
        while True:
            try:
                if self._play_session():
                    return
            except (httpx.TransportError, KeyError):
                time.sleep(0.02)

    def _play_session(self) -> bool:
        """Whether the run is completed; raises KeyError after a problem."""
        if self._client.get(self._path).json()["state"] == "completed":
            return True
        key = f"key-{time.monotonic_ns()}"
        body = {"attach_key": key, "takeover": True}
        turn = self._client.put(self._worker, json=body).json()
        while not turn["done"]:
            self._number += 1
            end = float(turn["episode"]["step"] >= TURNS)
            values = {MARK: float(self._number), "end": end}
            turn = self._predict(predict_body(turn, **values))
            self.received.append(float(self._number))
        time.sleep(0.02)
        return False

    def _predict(self, body: dict[str, Any]) -> dict[str, Any]:
        answer = self._client.post(f"{self._worker}/predict", json=body)
        turn: dict[str, Any] = answer.json()
        return turn if "done" in turn else turn["no turn"]


def test_a_killed_server_forgets_no_turn_that_was_received(tmp_path: Path) -> None:
    with ReferenceServer(tmp_path) as server:
        run_id = submit(server.client(), *["score"] * EPISODES * max(1, KILLS // 3))
        workers = [Worker(server.client(), run_id, n) for n in range(1, WORKERS + 1)]
        for worker in workers:
            worker.start()
        for _ in range(KILLS):
            time.sleep(random.uniform(0.05, 0.4))
            server.end(signal.SIGKILL)
            server.start()
        for worker in workers:
            worker.join()
        answer = server.client().get(f"/v1/runs/{run_id}/record")
    assert answer.status_code == 200, answer.text
    path = tmp_path / "run.proctor"
    path.write_bytes(answer.content)
    bundle = open_bundle(path)
    report = verify(bundle)
    assert report.episodes == report.recordings
    recorded = Counter(marks_in(bundle))
    received = [mark for worker in workers for mark in worker.received]
    assert [mark for mark in received if recorded[mark] != 1] == []


def marks_in(bundle: Any) -> list[float]:
    """The number of each recorded action."""
    found = []
    for name in bundle.sizes:
        if not name.endswith(".mcap"):
            continue
        with bundle.open(name) as file:
            for topic, data in McapReader(name, file, bundle.sizes[name]).messages():
                if topic == "/turn":
                    turn = msgspec.json.decode(data)
                    found += [action[MARK][0] for action in turn["actions"]]
    return found
