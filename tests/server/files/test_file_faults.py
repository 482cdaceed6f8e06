"""Why a file cannot be used, in words."""

from __future__ import annotations

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
