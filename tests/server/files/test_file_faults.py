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
WRAPPED = sa.exc.OperationalError("INSERT …", {}, DISK)


@pytest.mark.parametrize(
    ("error", "free", "said"),
    [
        (
            PermissionError(13, "Permission denied", "var"),
            2**30,
            "var: Permission denied",
        ),
        (DISK, 2**30, "disk I/O error"),
        (WRAPPED, 2**30, "disk I/O error"),
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
    file, missing = tmp_path / "db", tmp_path / "none" / "db"
    file.touch()
    texts = []
    for user in (os.geteuid(), 61_234):
        monkeypatch.setattr(os, "geteuid", lambda user=user: user)
        for path in (file, missing):
            error = PermissionError(13, "Permission denied", str(path))
            texts.append(describe_file_fault(error, path))
    ends = f"belongs to {owner}, and this program runs as user 61234"
    assert texts == [
        f"{file}: Permission denied",
        f"{missing}: Permission denied",
        f"{file}: Permission denied; it {ends}",
        f"{missing}: Permission denied; {tmp_path} {ends}",
    ]
