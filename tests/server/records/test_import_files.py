"""The folder of records that were handed in, as a start of the server finds it."""

from __future__ import annotations

import asyncio
import logging
from pathlib import Path

import pytest

from reference_server.records.import_files import Draft, ImportFiles

FIRST, SECOND = (f"imp_{number:024x}" for number in (1, 2))


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_only_own_drafts_are_removed(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    """What the server did not write stays, and is named once."""
    others = [
        *("notes.txt", "thesis.proctor", f"{SECOND}.proctor", "imp_1.proctor"),
        *(".imp_x.part", f".{FIRST}.part.bak", ".hidden", f".{FIRST}.zip"),
    ]
    for name in (*others, f"{FIRST}.proctor", f".{SECOND}.part"):
        (tmp_path / name).write_text("x")
    (tmp_path / f".{'imp_' + 'a' * 24}.part").mkdir()
    with caplog.at_level(logging.WARNING):
        ImportFiles(tmp_path).open({FIRST})
    kept = sorted([*others, f"{FIRST}.proctor", f".imp_{'a' * 24}.part"])
    assert names(tmp_path) == kept
    (record,) = caplog.records
    assert f"{len(kept) - 1} files" in record.getMessage()
    assert ".hidden" in record.getMessage()


@pytest.mark.parametrize("has_row", [True, False])
def test_the_database_decides_what_a_crash_left_open(
    tmp_path: Path, has_row: bool, caplog: pytest.LogCaptureFixture
) -> None:
    """Between the archive and its row, when it is added and when it is deleted."""
    (tmp_path / f"{FIRST}.proctor").write_text("x")
    files = ImportFiles(tmp_path)
    files.begin_change(FIRST)
    with caplog.at_level(logging.WARNING):
        files.open({FIRST} if has_row else set())
    assert names(tmp_path) == ([f"{FIRST}.proctor"] if has_row else [])
    assert caplog.records == []


def test_what_is_kept_is_open_until_it_is_settled(tmp_path: Path) -> None:
    files = ImportFiles(tmp_path)
    draft = files.draft_path(FIRST)
    draft.write_text("x")
    asyncio.run(files.keep(FIRST, Draft(draft, 1, "")))
    assert names(tmp_path) == [f".{FIRST}.pending", f"{FIRST}.proctor"]
    files.settle(FIRST)
    files.open({FIRST})
    assert names(tmp_path) == [f"{FIRST}.proctor"]
    files.begin_change(FIRST)
    files.remove(FIRST)
    assert names(tmp_path) == []
