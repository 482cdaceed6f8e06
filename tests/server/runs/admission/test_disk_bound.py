"""The bound of the whole disk: nothing new begins, and nothing is lost."""

from __future__ import annotations

from pathlib import Path

import pytest

from reference_server.files.file_sizes import size_of
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Attach
from reference_server.runs.admission.disk_bound import DiskBound
from reference_server.telemetry.counters import COUNTERS
from tests.support.server.http_runs import submit
from tests.support.server.server_parts import (
    calibration_run,
    expect_refusal,
    open_server_parts,
    predict_command,
)
from tests.support.servers import ReferenceServer


def test_sizes_are_added_up_over_files_and_folders(tmp_path: Path) -> None:
    (tmp_path / "a" / "b").mkdir(parents=True)
    for name, size in (("db", 5), ("a/1", 10), ("a/b/2", 20), ("elsewhere", 40)):
        (tmp_path / name).write_bytes(bytes(size))
    paths = [tmp_path / name for name in ("db", "a", "none")]
    assert size_of(paths) == 35


@pytest.mark.parametrize(
    ("max_bytes", "recorded", "is_full"),
    [(0, 1000, False), (101, 0, False), (100, 0, True), (101, 1, True), (99, 0, True)],
)
async def test_recordings_count_at_once(
    tmp_path: Path,
    caplog: pytest.LogCaptureFixture,
    max_bytes: int,
    recorded: int,
    is_full: bool,
) -> None:
    (tmp_path / "file").write_bytes(bytes(100))
    bound = DiskBound(max_bytes, [tmp_path])
    await bound.open()
    COUNTERS.recording_bytes += recorded
    try:
        if is_full:
            with pytest.raises(Refused, match="max_disk_bytes"):
                bound.check()
        else:
            bound.check()
    finally:
        COUNTERS.recording_bytes -= recorded
        await bound.close()
    assert ("nothing new begins" in caplog.text) is (is_full and not recorded)


async def test_an_episode_is_played_to_its_end_and_none_begins(tmp_path: Path) -> None:
    """Room that is made lets the run go on, in the same attempt."""
    bound = DiskBound(100)
    async with open_server_parts(tmp_path / "db", disk_bound=bound) as parts:
        run = await parts.registry.add(calibration_run("score", "count"), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        bound._measured = 100
        with expect_refusal("unavailable"):
            await parts.executor.predict(run, predict_command(turn, success=1, end=1))
        assert [episode.result is not None for episode in run.episodes] == [True, False]
        for _ in range(2):
            with expect_refusal("unavailable"):
                await parts.executor.attach(run, Attach("w", "another"))
        bound._measured = 0
        turn = await parts.executor.attach(run, Attach("w", "third"))
        assert turn["episode"]["attempt"] == 1
        assert [episode.faults for episode in run.episodes] == [0, 0]


@pytest.mark.slow("a server")
def test_a_server_at_its_bound_takes_no_run_and_shows_all(tmp_path: Path) -> None:
    with ReferenceServer(tmp_path, PROCTOR_MAX_DISK_BYTES="0") as server:
        with server.client() as client:
            run_id = submit(client, "score")
            server.end()
        server.settings["PROCTOR_MAX_DISK_BYTES"] = "1000"
        server.start()
        with server.client() as client:
            body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
            refused = client.post("/v1/runs", json=body)
            assert refused.status_code == 503
            assert "max_disk_bytes" in refused.json()["detail"]
            assert client.get(f"/v1/runs/{run_id}").status_code == 200
        assert "as many as max_disk_bytes allows" in server.log()
