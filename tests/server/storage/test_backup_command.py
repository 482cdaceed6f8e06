"""`proctor admin backup`: everything in one folder, while the server runs."""

from __future__ import annotations

import contextlib
import shutil
import signal
import sqlite3
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from reference_record.command_line.click_commands import Options
from reference_record.formats.bundle import open_bundle
from reference_record.verification import verify
from reference_server.http.tokens import admin_command as admin
from reference_server.settings import Settings
from reference_server.storage.backup_command import KeptFiles, back_up
from reference_server.storage.connection.database import StoreFailed
from tests.support.server.http_runs import attach, predict_body, submit, worker_path
from tests.support.servers import ReferenceServer


def play(server: ReferenceServer) -> str:
    with server.client() as client:
        run_id = submit(client, "score")
        turn = attach(client, run_id)
        path = f"{worker_path(run_id)}/predict"
        client.post(path, json=predict_body(turn, score=0.5, end=1)).raise_for_status()
    return run_id


@pytest.mark.slow("servers")
def test_a_server_starts_from_a_backup(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A second backup has what is new, and with --prune not what is gone."""
    first, second = tmp_path / "first", tmp_path / "second"
    for folder in (first, second):
        folder.mkdir()
    monkeypatch.setenv("PROCTOR_DATABASE", str(first / "proctor.sqlite"))
    backup = ["backup", str(tmp_path / "backup")]
    with ReferenceServer(first) as server:
        old = play(server)
        assert admin.main(backup) == 0
        new = play(server)
        capsys.readouterr()
        assert admin.main(backup) == 0
        assert "records: 2 files, 1 of them new" in capsys.readouterr().out
        server.end(signal.SIGTERM)
    gone = first / "proctor.sqlite.records" / old
    shutil.rmtree(gone)
    assert admin.main([*backup, "--prune"]) == 0
    said = capsys.readouterr().out
    assert "records: 1 files, 0 of them new; 1 removed" in said
    copied = sorted(path.name for path in (tmp_path / "backup").iterdir())
    endings = ("", ".key", ".records", ".seeds", ".signing-key")
    assert copied == [f"proctor.sqlite{ending}" for ending in endings]
    for path in (tmp_path / "backup").rglob("*"):
        assert path.stat().st_mode & 0o077 == 0, path
    shutil.copytree(tmp_path / "backup", second, dirs_exist_ok=True)
    with ReferenceServer(second) as server, server.client() as client:
        for run_id in (old, new):
            assert client.get(f"/v1/runs/{run_id}").json()["state"] == "completed"
        record = tmp_path / "record"
        record.write_bytes(client.get(f"/v1/runs/{new}/record").content)
        assert verify(open_bundle(record)).episodes == 1
    kept = (first / "proctor.sqlite.signing-key").read_bytes()
    assert (second / "proctor.sqlite.signing-key").read_bytes() == kept


@pytest.mark.parametrize("place", [".", "records", "records/run_1/backup"])
def test_a_backup_into_the_server_itself_is_refused(tmp_path: Path, place: str) -> None:
    made = {"db.key": tmp_path / "db.key", "records": tmp_path / "records"}
    made["db.key"].touch()
    made["records"].mkdir()
    kept = KeptFiles("sqlite:///x", "db", tmp_path, made, {})
    args = Options(folder=tmp_path / place, prune=True)
    with pytest.raises(StoreFailed, match=r"of the server itself|is inside"):
        back_up(kept, args)
    assert sorted(tmp_path.iterdir()) == sorted(made.values())


@pytest.mark.parametrize(
    ("database", "name", "records"),
    [
        ("postgresql://host/name", "postgresql", "records"),
        ("elsewhere/db", "db", "db.records"),
    ],
)
def test_files_of_other_places_get_the_names_that_a_server_looks_for(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    database: str,
    name: str,
    records: str,
) -> None:
    """The server has no folder beside its database: settings name all places."""
    monkeypatch.chdir(tmp_path)
    files = {n: tmp_path / n for n in ("sealing_key", "seed_secret", "signing_key")}
    for file in files.values():
        file.touch()
    for folder in ("shared", "shared.imported"):
        (tmp_path / folder).mkdir()
    given: dict[str, Any] = {n: str(file) for n, file in files.items()}
    settings = Settings(
        database=database, records_dir=str(tmp_path / "shared"), **given
    )
    with contextlib.closing(sqlite3.connect(tmp_path / "db")) as connection:
        connection.execute("CREATE TABLE runs (number)")
    url = f"sqlite:///{tmp_path / 'db'}"
    kept = replace(admin._kept_files(settings), database_url=url)
    back_up(kept, Options(folder=tmp_path / "backup", prune=False))
    names = {name, records, f"{records}.imported"}
    names |= {f"{name}.{ending}" for ending in ("key", "seeds", "signing-key")}
    assert {path.name for path in (tmp_path / "backup").iterdir()} == names
    assert not kept.folder.exists()


def test_without_a_database_there_is_no_backup(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("PROCTOR_DATABASE", str(tmp_path / "none.sqlite"))
    assert admin.main(["backup", str(tmp_path / "backup")]) == 2
    said = f"there is no {tmp_path}/none.sqlite, which a server makes when it starts"
    assert said in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
