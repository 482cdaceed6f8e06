"""The owner of a run is killed while many workers play: none of them loses anything."""

from __future__ import annotations

import itertools
import json
import threading
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import httpx
import pytest
from mcap.reader import make_reader

from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import recording_name
from reference_sim.replay.__main__ import main as replay
from tests.support.server.cluster_nodes import Cluster
from tests.support.server.http_runs import predict_body, submit, worker_path
from tests.support.server.postgresql_server import PostgresqlServer
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts three servers")

EPISODES, WORKERS, LENGTH = 24, 8, 12


class Worker:
    """Sends each request until a node answers it, at the next node each time.

    answers: of its turns, none of which is lost or answered twice.
    """

    def __init__(self, clients: Sequence[httpx.Client], run_id: str, name: str) -> None:
        self._clients = itertools.cycle(clients)
        self._path = worker_path(run_id, name)
        self.answers: list[dict[str, Any]] = []

    def play(self) -> None:
        turn = self._send("PUT", self._path, {"attach_key": "a"})
        while not turn["done"]:
            before, step = turn, turn["episode"]["step"] + 1
            values = {"score": step / LENGTH, "end": float(step == LENGTH)}
            body = predict_body(turn, **values)
            turn = self._send("POST", f"{self._path}/predict", body)
            self.answers.append(turn)
            assert turn["seq"] == before["seq"] + 1
            assert turn["rewards"] == [step / LENGTH]
            assert "fault" not in turn

    def _send(self, method: str, path: str, body: dict[str, Any]) -> dict[str, Any]:
        while True:
            try:
                answer = next(self._clients).request(method, path, json=body)
            except httpx.TransportError:
                continue
            if answer.status_code != 503:
                assert answer.status_code == 200, answer.text
                return dict(answer.json())


def recorded_seqs(record: Path, index: int) -> list[int]:
    data = open_bundle(record).read(recording_name(index))
    path = record.with_suffix(".mcap")
    path.write_bytes(data)
    with path.open("rb") as opened:
        return [
            json.loads(message.data)["seq"]
            for _, channel, message in make_reader(opened).iter_messages()
            if channel.topic == "/turn"
        ]


def test_a_run_is_what_it_is_without_a_kill(
    tmp_path: Path, postgresql: PostgresqlServer, capsys: pytest.CaptureFixture[str]
) -> None:
    settings = {"PROCTOR_FAILOVER": "replay", "PROCTOR_LOG_LEVEL": "info"}
    with Cluster.of(tmp_path, postgresql.create(), 3, **settings) as cluster:
        options = {"max_steps": LENGTH + 1}
        run_id = submit(cluster.clients[0], *["count"] * EPISODES, options=options)
        workers = [
            Worker([node.client() for node in cluster.nodes], run_id, f"w{number}")
            for number in range(WORKERS)
        ]
        half, killed = EPISODES * LENGTH // 3, threading.Event()

        def kill_owners() -> None:
            """The second one has the run from the first one, or not."""
            for number in range(2):
                played = half * (number + 1)
                wait_until(
                    lambda played=played: sum(len(w.answers) for w in workers) > played,  # type: ignore[misc]
                    "the workers have played",
                )
                cluster.kill(number)
            killed.set()

        with ThreadPoolExecutor(WORKERS + 1) as threads:
            playing = [threads.submit(worker.play) for worker in workers]
            threads.submit(kill_owners).result()
            for played in playing:
                played.result()
        assert killed.is_set()
        client = cluster.clients[2]
        listed = client.get(f"/v1/runs/{run_id}/episodes").json()["episodes"]
        assert [one["attempt"] for one in listed] == [1] * EPISODES
        assert [one["faults"] for one in listed] == [0] * EPISODES
        for one in listed:
            result = one["result"]
            assert (result["steps"], result["terminated"]) == (LENGTH, True)
            total = sum(step / LENGTH for step in range(1, LENGTH + 1))
            assert result["total_reward"] == pytest.approx(total)
        assert sum(len(w.answers) for w in workers) == EPISODES * LENGTH
        record = tmp_path / "run.proctor"
        record.write_bytes(client.get(f"/v1/runs/{run_id}/record").content)
    for index in range(EPISODES):
        seqs = recorded_seqs(record, index)
        assert seqs == list(range(seqs[0], seqs[0] + LENGTH))
    assert replay([str(record), "--no-verdict"]) == 0
    assert capsys.readouterr().out.startswith(f"exact: {EPISODES} of {EPISODES}")
