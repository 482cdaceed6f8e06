"""Records that are made to be slow and large are handed in while others play."""

from __future__ import annotations

import statistics
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest

from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import MANIFEST, MANIFEST_BYTES_MAX
from tests.support.processes import peak_bytes
from tests.support.record.hostile_records import lengthened, resigned
from tests.support.record.played_records import save_calibration_record
from tests.support.server.http_runs import predict_body
from tests.support.servers import ReferenceServer
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("servers")

ON = {"PROCTOR_RECORD_IMPORTS": "on"}
ZIP = {"Content-Type": "application/zip"}
QUIET_TURNS = 300
# With shares of two processors for all that a gate runs at once.
RATIO_MAX, STALL_S_MAX = 20, 1.0


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    folder = tmp_path_factory.mktemp("record")
    bundle = open_bundle(save_calibration_record(folder / "r.proctor", folder))
    return {name: bundle.read(name) for name in bundle.sizes}


class Turns:
    """Plays one turn after another. seconds: how long each took."""

    def __init__(self, client: httpx.Client) -> None:
        self.seconds: list[float] = []
        self._client = client
        # More turns than are played while a slow machine reads a record.
        options = {"tasks": ["count"] * 100, "max_steps": 10_000}
        body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
        run = client.post("/v1/runs", json=body | {"options": options}).json()
        self._worker = f"/v1/runs/{run['run_id']}/workers/w"
        self._turn: dict[str, Any] = client.put(
            self._worker, json={"attach_key": "key"}
        ).json()

    def play(self) -> None:
        body = predict_body(self._turn)
        started = time.perf_counter()
        answer = self._client.post(f"{self._worker}/predict", json=body)
        self.seconds.append(time.perf_counter() - started)
        assert answer.status_code == 200, answer.text
        self._turn = answer.json()

    @contextmanager
    def beside(self) -> Iterator[None]:
        """Play in a thread."""
        ended = threading.Event()

        def play() -> None:
            while not ended.is_set():
                self.play()

        thread = threading.Thread(target=play)
        thread.start()
        try:
            yield
        finally:
            ended.set()
            thread.join()


def p99(seconds: list[float]) -> float:
    return statistics.quantiles(seconds, n=100)[98]


def finished(client: httpx.Client, import_id: str) -> dict[str, Any]:
    shown: dict[str, Any] = {}

    def is_finished() -> bool:
        shown.update(client.get(f"/v1/records/{import_id}").json())
        return bool(shown["state"] == "finished")

    wait_until(is_finished, "the import is finished", 60)
    return shown


def test_a_large_manifest_stalls_no_turn(
    tmp_path: Path, files: dict[str, bytes]
) -> None:
    """As large as it may be, of what takes most memory. Expect turns as without it."""
    size = MANIFEST_BYTES_MAX - len(files[MANIFEST]) - 100
    large = lengthened(files[MANIFEST], b'{"a":{}}', size)
    archive = resigned(files, MANIFEST, large)
    with (
        ReferenceServer(tmp_path, **ON) as server,
        server.client("alice") as alice,
        server.client("bob") as bob,
    ):
        turns = Turns(alice)
        for _ in range(QUIET_TURNS):
            turns.play()
        quiet, before = turns.seconds, peak_bytes(server.process.pid)
        found = []
        for _ in range(3):  # a pause of the machine comes once, a stall each time
            turns.seconds = []
            with turns.beside():
                taken = bob.post("/v1/records", content=archive, headers=ZIP)
                assert taken.status_code == 202, taken.text
                shown = finished(bob, taken.json()["import_id"])
            assert "the manifests differ" in shown["reason"]
            found.append((p99(turns.seconds) / p99(quiet), max(turns.seconds)))
            ratio, longest_s = found[-1]
            if ratio < RATIO_MAX and longest_s < STALL_S_MAX:
                break
            bob.delete(taken.headers["Location"]).raise_for_status()
        else:
            pytest.fail(f"p99 beside that of a quiet server, longest in s: {found}")
        grown = peak_bytes(server.process.pid) - before
    assert grown < 3 * len(archive)
