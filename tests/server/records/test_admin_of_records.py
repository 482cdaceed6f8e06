"""`proctor admin keys` and `proctor admin records` on the files of a server."""

from __future__ import annotations

import re
import shutil
import signal
import sqlite3
import time
from pathlib import Path

import httpx
import pytest

from reference_record.formats.bundle import open_bundle
from reference_record.verification import verify
from reference_server.http.tokens import admin_command as admin
from reference_server.records import admin_areas
from tests.support.servers import ReferenceServer
from tests.support.sim.calibration_action import calibration_action

DAY_S = 86_400


def complete_run(client: httpx.Client) -> str:
    """A run of one turn, played."""
    body = {
        "benchmark_id": "calibration",
        "policy": {"name": "p"},
        "options": {"tasks": ["score"]},
    }
    run = client.post("/v1/runs", json=body).raise_for_status().json()
    worker = f"/v1/runs/{run['run_id']}/workers/w"
    turn = client.put(worker, json={"attach_key": "k"}).raise_for_status().json()
    action = {"values": calibration_action(score=0.5, end=1)}
    predict = {"session_id": turn["session_id"], "seq": 1, "actions": [action]}
    client.post(f"{worker}/predict", json=predict).raise_for_status()
    return str(run["run_id"])


def age(folder: Path, run_id: str, days: float) -> None:
    """Let a run have ended so long ago."""
    with sqlite3.connect(folder / "proctor.sqlite") as connection:
        connection.execute(
            "UPDATE runs SET updated_at_wall = ? WHERE run_id = ?",
            (time.time() - days * DAY_S, run_id),
        )
    connection.close()


@pytest.fixture
def as_admin(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    database = tmp_path / "proctor.sqlite"
    database.touch()
    monkeypatch.setenv("PROCTOR_DATABASE", str(database))


@pytest.mark.slow("a server that is started twice")
@pytest.mark.usefixtures("as_admin")
def test_a_rotated_key_stays_published_and_its_records_valid(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """And the statements of both make one chain."""
    with ReferenceServer(tmp_path) as server, server.client() as client:
        first = complete_run(client)
        old = client.get(f"/v1/runs/{first}/record").content
        assert admin.main(["keys", "rotate"]) == 0
        assert "restart it" in capsys.readouterr().out
        assert len(client.get("/v1/keys").json()["keys"]) == 1
        server.end(signal.SIGTERM)
        server.start()
        second = complete_run(client)
        new = client.get(f"/v1/runs/{second}/record").content
        assert client.get(f"/v1/runs/{first}/record").content == old
        keys = client.get("/v1/keys").json()["keys"]
    reports = []
    for name, archive in (("old", old), ("new", new)):
        (tmp_path / name).write_bytes(archive)
        published = {key["keyid"]: "H" for key in keys}
        reports.append(verify(open_bundle(tmp_path / name), published))
    assert [report.levels for report in reports] == [["signed by H"]] * 2
    assert reports[0].keyid != reports[1].keyid
    previous = reports[1].evaluation.previous_statement_sha256
    assert previous == reports[0].statement_sha256
    retired = {key["keyid"]: key["retired_at"] is not None for key in keys}
    assert retired == {reports[0].keyid: True, reports[1].keyid: False}
    assert admin.main(["keys", "list"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == [r.keyid for r in reports[::-1]]
    assert "in use" in lines[0]
    assert "until 20" in lines[1]


@pytest.mark.slow("a server")
@pytest.mark.usefixtures("as_admin")
@pytest.mark.parametrize("is_stored", [False, True])
def test_old_recordings_are_removed_and_promised_ones_are_not(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    *,
    is_stored: bool,
) -> None:
    """is_stored: in object storage, which a backup names, and does not copy."""
    bucket, folder = tmp_path / "bucket", tmp_path / "proctor.sqlite.records"
    settings: dict[str, str] = {}
    if is_stored:
        folder, settings["PROCTOR_RECORDS_STORAGE"] = bucket, bucket.as_uri()
        monkeypatch.setenv("PROCTOR_RECORDS_STORAGE", bucket.as_uri())
    with ReferenceServer(tmp_path, **settings) as server, server.client() as client:
        old, new = (complete_run(client) for _ in range(2))
        age(tmp_path, old, 40)
        assert admin.main(["records", "prune", "--older-than", "30"]) == 2
        said = capsys.readouterr().err
        assert "a promise to keep all" in said
        assert "set PROCTOR_RECORDS_KEEP_DAYS=30 for the server, and here" in said
        monkeypatch.setenv("PROCTOR_RECORDS_KEEP_DAYS", "30")
        assert admin.main(["records", "prune", "--older-than", "29"]) == 2
        assert "less than 30 days" in capsys.readouterr().err
        assert admin.main(["records", "usage"]) == 0
        shown = capsys.readouterr().out
        assert "2 runs  oldest 40.0 days  calibration" in " ".join(shown.split("\n"))
        assert admin.main(["backup", str(tmp_path / "backup")]) == 0
        said = f"not copied: the recordings .* {bucket.as_uri()}"
        assert bool(re.search(said, capsys.readouterr().out)) == is_stored
        copied = list((tmp_path / "backup").glob("*.records/*/*.mcap"))
        assert len(copied) == (0 if is_stored else 2)
        if is_stored:  # it may be removed at any time
            shutil.rmtree(tmp_path / "proctor.sqlite.records" / old)
        words = ["records", "prune", "--older-than", "30"]
        assert admin.main([*words, "--dry-run"]) == 0
        assert f"would remove {old}\n1 run," in capsys.readouterr().out
        assert client.get(f"/v1/runs/{old}/record").status_code == 200
        assert admin.main(words) == 0
        assert f"removed {old}\n1 run," in capsys.readouterr().out
        assert {path.parent.name for path in folder.glob("*/*.mcap")} == {new}
        assert client.get(f"/v1/runs/{old}/record").status_code == 404
        assert client.get(f"/v1/runs/{old}/score").status_code == 200
        assert client.get(f"/v1/runs/{new}/record").status_code == 200
    assert admin.main(["records", "usage", "--runs"]) == 0
    of_run, total = capsys.readouterr().out.splitlines()
    assert of_run.endswith(new)
    assert total.endswith(f"in all, in {bucket.as_uri()}" if is_stored else "in all")
    assert of_run.split()[0] == total.split()[0] != "0"


@pytest.mark.usefixtures("as_admin")
@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["keys", "rotate"], "there is no key in"),
        (["records", "usage"], "there is no folder of recordings"),
    ],
)
def test_what_is_not_there_is_said_in_one_line(
    words: list[str], text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert admin.main(words) == 2
    said = capsys.readouterr().err
    assert text in said
    assert said.count("\n") == 1


def test_sizes_are_for_people() -> None:
    shown = [admin_areas._shown(size) for size in (0, 1023, 1536, 5 * 2**40)]
    assert shown == ["0 B", "1023 B", "1.5 KiB", "5120.0 GiB"]
