"""`proctor admin db`: what a host does with a database while a server may use it."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from reference_server.http.tokens.admin_command import main
from reference_server.storage.connection import server_lock
from reference_server.storage.connection.server_lock import lock_of
from reference_server.storage.tables.schema_version import VERSIONS
from tests.support.server.databases import UsedDatabase
from tests.support.server.server_parts import (
    ServerParts,
    calibration_run,
    open_server_parts,
    run_scenario,
)


@pytest.fixture(autouse=True)
def _use(database: UsedDatabase, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PROCTOR_DATABASE", database.setting)


async def save_run(parts: ServerParts) -> None:
    assert await parts.store.insert(calibration_run(), None, "")


@contextmanager
def expect_failure(capsys: pytest.CaptureFixture[str], text: str) -> Iterator[None]:
    """One line on stderr has the text."""
    yield
    error = capsys.readouterr().err
    assert text in error
    assert error.count("\n") == 1


def test_a_consistent_database_passes(
    database: UsedDatabase, capsys: pytest.CaptureFixture[str]
) -> None:
    run_scenario(database, save_run)
    assert main(["db", "check"]) == 0
    assert "content: consistent" in capsys.readouterr().out


def test_an_inconsistent_database_does_not(
    database: UsedDatabase, capsys: pytest.CaptureFixture[str]
) -> None:
    run_scenario(database, save_run)
    database.execute("DELETE FROM manifests")
    assert main(["db", "check"]) == 2
    assert "problem: 1 runs without their manifest" in capsys.readouterr().out


def test_an_older_database_is_upgraded_on_command(
    database: UsedDatabase,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """In the folder of its server, which has a key and no id yet."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "var").mkdir()
    (tmp_path / "var" / "postgresql.key").touch()
    run_scenario(database, save_run)
    database.make_unversioned()
    with expect_failure(capsys, "see `proctor admin db upgrade`"):
        assert main(["db", "check"]) == 2
    with expect_failure(capsys, "run `proctor admin db upgrade`"):
        assert main(["keys", "list"]) == 2
    assert main(["db", "upgrade"]) == 0
    assert f"is of version {VERSIONS[-1]} (before: none)" in capsys.readouterr().out
    assert main(["db", "check"]) == 0


def test_an_upgrade_is_refused_while_a_server_runs(
    database: UsedDatabase,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(server_lock, "WAIT_S", 0.05)

    async def upgrade_meanwhile() -> int:
        lock = lock_of(database.url, lambda: None)
        await lock.acquire()
        try:
            return await asyncio.to_thread(main, ["db", "upgrade"])
        finally:
            await lock.release()

    with expect_failure(capsys, "another server uses it"):
        assert asyncio.run(upgrade_meanwhile()) == 2


async def test_a_backup_is_the_database_of_one_moment(
    database: UsedDatabase,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Made while the server is open. It can be used, and is its owner's alone."""
    path = tmp_path / "backup"
    if database.server is not None:
        programs = f"{database.server.programs}:{os.environ['PATH']}"
        monkeypatch.setenv("PATH", programs)
    async with open_server_parts(database) as parts:
        await save_run(parts)
        assert await asyncio.to_thread(main, ["db", "backup", str(path)]) == 0
    assert path.stat().st_mode & 0o777 == 0o600
    if database.server is None:
        assert UsedDatabase.of_file(path).count("runs") == 1
    else:
        assert path.read_bytes().startswith(b"PGDMP")
    with expect_failure(capsys, "exists already"):
        assert await asyncio.to_thread(main, ["db", "backup", str(path)]) == 2


def test_a_backup_does_not_follow_a_link(
    database: UsedDatabase, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The file that it names would be made with the permissions of any file."""
    path = tmp_path / "backup"
    path.symlink_to(tmp_path / "elsewhere")
    if database.server is None:
        run_scenario(database, save_run)
    with expect_failure(capsys, "exists already"):
        assert main(["db", "backup", str(path)]) == 2
    assert not path.exists()
    assert path.is_symlink()


def test_a_backup_that_fails_leaves_nothing(
    database: UsedDatabase,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("PATH", "")
    text = "there is no /" if database.server is None else "pg_dump is not installed"
    with expect_failure(capsys, text):
        assert main(["db", "backup", str(tmp_path / "backup")]) == 2
    assert not (tmp_path / "backup").exists()
