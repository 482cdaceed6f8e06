"""A PostgreSQL database and the folder with its keys and recordings are one pair."""

from __future__ import annotations

import asyncio
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from reference_server.http.tokens import admin_command as admin
from reference_server.storage.connection.transactions import Transactions
from reference_server.storage.folder_id import OtherFiles, claim_folder, require_files
from reference_server.storage.tables.database_tables import cluster_facts
from tests.support.paths import ROOT
from tests.support.processes import PROGRAM_S, run_program
from tests.support.server.databases import UsedDatabase
from tests.support.server.postgresql_server import PostgresqlServer

SERVER = [sys.executable, "-m", "reference_server", "--port", "0"]
COMMANDS = (
    *(["token", "add", "dora"], ["token", "list"], ["token", "revoke", "dora"]),
    *(["backup", "backup"], ["page"], ["keys", "rotate"], ["records", "usage"]),
)


async def claim(database: UsedDatabase, path: Path) -> None:
    transactions = Transactions(database.url)
    try:
        await transactions.open()
        await claim_folder(transactions, path)
    finally:
        await transactions.close()


def test_a_database_has_one_folder(database: UsedDatabase, tmp_path: Path) -> None:
    """The folder may move with its id, and be given up for another one."""
    first, moved = tmp_path / "first" / "db.id", tmp_path / "moved" / "db.id"
    asyncio.run(claim(database, first))
    require_files(database.url, first)
    asyncio.run(claim(database, first))
    with pytest.raises(OtherFiles, match=f"{first.parent} on .* has none: start "):
        asyncio.run(claim(database, moved))
    assert not moved.parent.exists()
    moved.parent.mkdir()
    moved.write_text("another")
    with pytest.raises(OtherFiles, match=r"has others: start .* if it is lost") as said:
        asyncio.run(claim(database, moved))
    with pytest.raises(OtherFiles, match="has others: give this command in the folder"):
        require_files(database.url, moved)
    assert f"write {first.read_text()} into {moved}, " in str(said.value)
    moved.write_text(f"{first.read_text()}\n")
    asyncio.run(claim(database, moved))
    require_files(database.url, moved)


@pytest.mark.parametrize("fact", ["records_folder", "seed_secret"])
def test_a_database_of_a_cluster_is_not_for_one_server(
    database: UsedDatabase, tmp_path: Path, fact: str
) -> None:
    """Its own files would be others; who has moved them here says so with its id."""
    path = tmp_path / "db.id"

    async def make_cluster() -> None:
        transactions = Transactions(database.url)
        try:
            await transactions.open()
            facts = {"host": "eval", fact: "of-all"}
            rows = [{"name": name, "value": value} for name, value in facts.items()]
            await transactions.write_in_turn(
                lambda c: c.execute(cluster_facts.insert(), rows)
            )
        finally:
            await transactions.close()

    asyncio.run(make_cluster())
    with pytest.raises(OtherFiles, match="is of a cluster, whose keys") as said:
        asyncio.run(claim(database, path))
    assert not path.exists()
    assert f"write of-all into {path}" in str(said.value)
    path.write_text("of-all")
    asyncio.run(claim(database, path))
    require_files(database.url, path)


def test_a_database_that_no_server_has_used_stays_empty(
    database: UsedDatabase, tmp_path: Path
) -> None:
    if database.path is not None:
        database.path.touch()
    path = tmp_path / "var" / "db.id"
    with pytest.raises(OtherFiles, match="no server that has used this database"):
        require_files(database.url, path)
    (tmp_path / "var").mkdir()
    (tmp_path / "var" / "db.key").touch()
    require_files(database.url, path)  # the server was one that knew no ids
    asyncio.run(claim(database, path))


@pytest.mark.slow("servers on PostgreSQL")
def test_other_folders_are_refused_and_a_backup_is_restored(
    postgresql: PostgresqlServer,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """As docs/host/operate.md says: with the files of a backup all is found again."""
    monkeypatch.setenv("PATH", f"{postgresql.programs}:{os.environ['PATH']}")
    url = postgresql.create()
    folders = [tmp_path / name for name in ("first", "other", "restored")]
    for folder in folders:
        folder.mkdir()
    first, other, restored = folders
    with serving(first, url):
        token, key = ((first / "var" / f"postgresql.{end}") for end in ("token", "key"))
        secrets = token.read_text(), key.read_text()
        (first / "var" / "records" / "run_1").mkdir()
        (first / "var" / "records" / "run_1" / "episode").touch()
    ended = run_program(SERVER, cwd=other, env=environment(url), timeout=PROGRAM_S)
    assert (ended.returncode, ended.stderr.count("\n")) == (2, 1)
    assert f"of this database are in {first}/var on " in ended.stderr
    monkeypatch.setenv("PROCTOR_DATABASE", url)
    monkeypatch.chdir(other)
    for command in COMMANDS:
        capsys.readouterr()
        assert admin.main(command) == 2, command
        said = capsys.readouterr()
        assert (said.out, f"{other}/var has none: give" in said.err) == ("", True)
    assert list(other.iterdir()) == []
    monkeypatch.chdir(first)
    backup = tmp_path / "backup"
    assert admin.main(["backup", str(backup)]) == 0
    copied = {path.name for path in backup.iterdir()}
    endings = ("", ".id", ".key", ".seeds", ".signing-key", ".token")
    assert copied == {*(f"postgresql{end}" for end in endings), "records"}
    shutil.copytree(backup, restored / "var")
    with serving(restored, url):
        pass
    kept = [restored / "var" / path.name for path in (token, key)]
    assert tuple(path.read_text() for path in kept) == secrets
    assert (restored / "var" / "records" / "run_1" / "episode").exists()


def environment(url: str) -> dict[str, str]:
    inherited = {k: v for k, v in os.environ.items() if k[:8] != "PROCTOR_"}
    return inherited | {"PROCTOR_DATABASE": url, "PYTHONPATH": str(ROOT)}


@contextmanager
def serving(folder: Path, url: str) -> Iterator[None]:
    """A server that is started in the folder."""
    with subprocess.Popen(
        SERVER, cwd=folder, env=environment(url), stdout=subprocess.PIPE, text=True
    ) as run:
        assert run.stdout is not None
        try:
            assert run.stdout.readline().startswith("Proctor listens at ")
            yield
        finally:
            run.terminate()
