"""Why a file cannot be used, in words."""

from __future__ import annotations

import os
import shutil
import sqlite3
from pathlib import Path
from types import SimpleNamespace

import pytest
import sqlalchemy as sa

from reference_server.files.file_faults import describe_file_fault

DISK = sqlite3.OperationalError("disk I/O error")
NOT_OPENED = sqlite3.OperationalError("unable to open database file")
WRAPPED = sa.exc.OperationalError("INSERT …", {}, DISK)


@pytest.mark.parametrize(
    ("error", "free", "said"),
    [
        (
            PermissionError(13, "Permission denied", "var"),
            2**30,
            "var: Permission denied",
        ),
        (DISK, 2**30, "FILE: disk I/O error"),
        (WRAPPED, 2**30, "FILE: disk I/O error"),
        (NOT_OPENED, 2**30, "FILE: unable to open database file"),
        (IsADirectoryError(21, "Is a directory"), 2**30, "FILE: Is a directory"),
        (WRAPPED, 0, "no space is left on the disk of FILE"),
        (
            OSError(28, "No space left on device"),
            0,
            "no space is left on the disk of FILE",
        ),
    ],
    ids=str,
)
def test_a_fault_is_a_sentence(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    error: Exception,
    free: int,
    said: str,
) -> None:
    usage = {"free": free}
    monkeypatch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(**usage))
    file = tmp_path / "missing" / "file.sqlite"
    assert describe_file_fault(error, file) == said.replace("FILE", str(file))


def test_a_file_of_another_user_is_named_with_both(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect it of the file, or of the folder in which it cannot be made."""
    owner = tmp_path.owner()
    monkeypatch.setattr(os, "access", lambda *_: False)
    file, missing = tmp_path / "db", tmp_path / "none" / "db"
    file.touch()
    texts = []
    of_this_user = f"of this user, {owner}, and cannot be written: see chmod"
    for user in (os.geteuid(), 61_234):
        monkeypatch.setattr(os, "geteuid", lambda user=user: user)
        for path in (file, missing):
            error = PermissionError(13, "Permission denied", str(path))
            texts.append(describe_file_fault(error, path))
    ends = f"belongs to {owner}, and this program runs as user 61234"
    assert texts == [
        f"{file}: Permission denied; it is {of_this_user}",
        f"{missing}: Permission denied; {tmp_path} is {of_this_user}",
        f"{file}: Permission denied; it {ends}",
        f"{missing}: Permission denied; {tmp_path} {ends}",
    ]


def test_a_file_system_that_is_only_read_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect it also where SQLite says neither the file nor why."""
    monkeypatch.setattr(
        os, "statvfs", lambda _: SimpleNamespace(f_flag=os.ST_RDONLY, f_bavail=0)
    )
    monkeypatch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=0))
    texts = [
        describe_file_fault(error, tmp_path / "db")
        for error in (NOT_OPENED, OSError(30, "Read-only file system"))
    ]
    assert texts == [
        f"{tmp_path}/db: unable to open database file; its file system is read-only",
        f"{tmp_path}/db: Read-only file system",
    ]
