"""Old recordings are removed; records are signed one after another, once."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

import pytest

from reference_record.broken import UnusableRecord
from reference_record.keys import load_or_make
from reference_server.process import age_guard
from reference_server.records import run_records
from reference_server.records.run_records import (
    HostSettings,
    RecordUnavailable,
    RunRecords,
)

HEAD = "completed", 0.0


class FewRuns:
    """A store and recordings of runs that ended at the given times."""

    is_shared = False

    def __init__(self, *answers: dict[str, tuple[str, float]]) -> None:
        self.answers, self.removed = list(answers), list[str]()
        self.failures = 0
        self.deleted: set[str] = set()
        self.transactions = self

    async def write_in_turn(self, _: Any) -> None:
        """Store nothing: no test here asks which keys there are."""

    def open(self) -> None:
        pass

    async def check_storage(self) -> None:
        pass

    async def close(self) -> None:
        pass

    async def heads(self, _: Sequence[str]) -> dict[str, Any]:
        return {
            run_id: Head(state, ended)
            for run_id, (state, ended) in self.answers.pop(0).items()
        }

    async def deleted_ids(self, _: Sequence[str]) -> set[str]:
        return self.deleted

    def remove_drafts(self) -> None:
        pass

    async def newest_change(self) -> float:
        return 0.0

    def runs_with_leftovers(self, _since_wall: float) -> list[str]:
        return []

    def run_ids(self) -> list[str]:
        if self.failures:
            self.failures -= 1
            raise FileNotFoundError
        return ["r"]

    async def remove_run(self, run_id: str) -> None:
        self.removed.append(run_id)


class Head:
    def __init__(self, state: str, updated_at_wall: float) -> None:
        self.state, self.updated_at_wall = state, updated_at_wall


def records_of(runs: FewRuns, keep_days: float = 1) -> RunRecords:
    anything: Any = runs
    settings = HostSettings("host", Path("key"), keep_days=keep_days)
    return RunRecords(anything, anything, settings)


def test_a_run_that_goes_on_meanwhile_keeps_its_recordings() -> None:
    runs = FewRuns({"r": HEAD, "s": HEAD}, {"r": ("running", 0.0)}, {"s": HEAD})
    asyncio.run(records_of(runs).remove_old(1e9))
    assert runs.removed == ["s"]


async def test_removal_goes_on_after_the_folder_could_not_be_read(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(age_guard, "ALL_AFTER_S", 0.0)
    runs = FewRuns({"r": HEAD}, {"r": HEAD})
    records, runs.failures = records_of(runs), 2
    for _ in range(3):
        assert runs.removed == []
        await records._remove()
    assert runs.removed == ["r"]


async def test_what_is_left_of_a_deleted_run_is_removed() -> None:
    """The server ended before it removed the files; old recordings are kept here."""
    runs = FewRuns()
    runs.failures, runs.deleted = 1, {"r"}
    records = records_of(runs, keep_days=0)
    for _ in range(2):
        assert runs.removed == []
        await records._remove()
    assert runs.removed == ["r"]


async def test_the_key_of_the_server_is_made_its_owners_alone(tmp_path: Path) -> None:
    """A volume that is mounted may have given it to a group."""
    path, nothing = tmp_path / "key", cast(Any, FewRuns())
    key = load_or_make(path)
    path.chmod(0o660)
    settings = HostSettings("host", path, keep_days=0)
    records = RunRecords(nothing, nothing, settings)
    await records.open()
    assert records.key.keyid == key.keyid
    await records.close()
    assert path.stat().st_mode & 0o777 == 0o600


class Line:
    def __init__(self, size: int) -> None:
        self.recording = Size(size)


class Size:
    def __init__(self, size: int) -> None:
        self.bytes = size


@pytest.mark.parametrize("sizes", [[2**31, 2**31], [1] * 65_001])
def test_what_no_record_can_have_is_refused_before_it_is_read(sizes: list[int]) -> None:
    lines: Any = [Line(size) for size in sizes]
    with pytest.raises(RecordUnavailable, match="more than a record can have"):
        run_records._refuse_too_large(lines)
    run_records._refuse_too_large(lines[:1])


@pytest.mark.parametrize(
    ("there", "said"),
    [
        ([1, 2], "does not have 1 of its 3 recordings any more: 00000.mcap. "),
        ([], "does not have 3 of its 3 recordings any more: 00000.mcap, 00001.mcap, "),
        ([0, 1, 2], "cannot be read: episodes/00001.mcap is not what was recorded."),
    ],
)
def test_recordings_that_are_gone_are_named(
    there: list[int], said: str, tmp_path: Path
) -> None:
    for index in there:
        (tmp_path / f"{index:05}.mcap").touch()
    files = {
        f"episodes/{index:05}.mcap": tmp_path / f"{index:05}.mcap" for index in range(3)
    }
    error = UnusableRecord("episodes/00001.mcap is not what was recorded")
    assert said in run_records._what_is_lost(files, error)
