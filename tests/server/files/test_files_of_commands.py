"""The files that commands of the operator write: whose they are, and when none can."""

from __future__ import annotations

import asyncio
import os
import resource
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from reference_record.keys import load_or_make
from reference_server.http.auth import hash_of
from reference_server.http.tokens import admin_command as admin
from reference_server.records.recordings import Recordings

FOLDER_OWNER, FILE_OWNER, GROUP = 12345, 12346, 12347
ALICE = f"# tokens\nalice:read:sha256={hash_of('a')}\n"
# Each command, and the file that it writes.
WRITERS = {
    "token add bob": "server.db.tokens",
    "token revoke alice": "server.db.tokens",
    "keys rotate": "server.db.signing-key",
    "page": "server.db.operator.html",
    "page -o page.html": "page.html",
    "backup copies": "copies/server.db.tokens",
    "db backup copy": "copy",
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of a server, with its files."""
    folder = tmp_path / "var"
    folder.mkdir()
    monkeypatch.chdir(folder)
    monkeypatch.setenv("PROCTOR_DATABASE", str(folder / "server.db"))
    (folder / "server.db").touch()
    assert admin.main(["db", "upgrade"]) == 0
    load_or_make(folder / "server.db.signing-key")
    for name in ("server.db.key", "server.db.seeds", "server.db.tokens"):
        (folder / name).touch(mode=0o600)
    (folder / "server.db.tokens").write_text(ALICE)
    (folder / "server.db.records").mkdir()
    return folder


def owner_and_mode(path: Path) -> tuple[int, int, int]:
    status = path.stat()
    return status.st_uid, status.st_gid, stat.S_IMODE(status.st_mode)


@pytest.mark.skipif(os.geteuid() != 0, reason="only root gives files away")
@pytest.mark.parametrize("command", WRITERS)
def test_root_leaves_files_to_the_user_of_the_server(
    folder: Path, command: str
) -> None:
    """Expect the owner and the mode of the file before, or else those of its folder."""
    for path in [folder, *folder.rglob("*")]:
        os.chown(path, FOLDER_OWNER, GROUP)
    path = folder / WRITERS[command]
    had_it = path.exists()
    assert admin.main(command.split()) == 0
    assert owner_and_mode(path) == (FOLDER_OWNER, GROUP, 0o600)
    if command == "db backup copy":  # it replaces nothing
        return
    kept = folder / "server.db.tokens" if command.startswith("backup") else path
    os.chown(kept, FILE_OWNER, GROUP)
    mode = 0o600 if had_it else 0o640  # a secret is its owner's alone
    path.chmod(mode)
    assert admin.main(command.replace("revoke alice", "add carol").split()) == 0
    assert owner_and_mode(path) == (FILE_OWNER, GROUP, mode)


@contextmanager
def no_file_may_grow() -> Iterator[None]:
    """As on a full disk: files are made, and the first byte is refused."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


@pytest.mark.parametrize("command", WRITERS)
def test_a_command_that_cannot_write_names_the_file_and_leaves_nothing(
    folder: Path, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    def content() -> dict[Path, bytes]:
        """Without the files that lock the database and the tokens for a moment."""
        files = [path for path in folder.rglob("*") if path.is_file()]
        locks = (".lock", ".db-wal", ".db-shm")
        return {path: path.read_bytes() for path in files if path.suffix not in locks}

    before = content()
    with no_file_may_grow():
        assert admin.main(command.split()) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert str(folder) in said or WRITERS[command].split("/")[0] in said
    assert "Errno" not in said
    assert content() == before


def test_a_full_disk_begins_no_recording(tmp_path: Path) -> None:
    """Also where files can still be made, and are empty."""
    recordings = Recordings(tmp_path)
    asyncio.run(recordings.check_writable())
    with no_file_may_grow(), pytest.raises(OSError, match=str(tmp_path)):
        asyncio.run(recordings.check_writable())
    asyncio.run(recordings.close())
    assert list(tmp_path.iterdir()) == []
