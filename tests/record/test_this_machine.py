"""The part of this machine that a process may use, as the system shows it."""

import os
import tempfile
import threading
from pathlib import Path

import pytest

from reference_record import this_machine
from reference_record.this_machine import (
    start_if_possible,
    temporary_folder,
    unusable_temporary_folder,
    usable_processors,
)


@pytest.fixture
def named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder that TMPDIR names, before anything was written there."""
    folder = tmp_path / "of the job"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    monkeypatch.setattr(tempfile, "tempdir", None)
    return folder


def test_a_temporary_folder_that_ends_is_replaced_for_every_later_file(
    named: Path,
) -> None:
    assert temporary_folder() == str(named)
    named.rmdir()
    replaced = temporary_folder()
    assert replaced != str(named)
    with tempfile.NamedTemporaryFile() as file:
        assert Path(file.name).parent == Path(replaced)


def test_a_folder_that_is_not_there_is_named_with_the_one_that_is_used(
    named: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert unusable_temporary_folder() == ""
    named.rmdir()
    said = unusable_temporary_folder()
    assert said.startswith(f"TMPDIR is {named}, which is not there: ")
    assert said.endswith(f" {temporary_folder()}")
    named.touch()  # a file is no folder
    assert "which is not there" in unusable_temporary_folder()
    monkeypatch.delenv("TMPDIR")
    assert unusable_temporary_folder() == ""


@pytest.mark.parametrize(
    ("membership", "files", "processors"),
    [
        ("0::/job/step\n", {}, 8),
        ("0::/job/step\n", {"job/step/cpu.max": "max 100000"}, 8),
        ("0::/job/step\n", {"job/step/cpu.max": "200000 100000"}, 2),
        ("0::/job/step\n", {"job/step/cpu.max": "150000 100000"}, 2),
        ("0::/job/step\n", {"job/cpu.max": "50000 100000"}, 1),
        ("0::/\n", {"cpu.max": "300000 100000"}, 3),
        (
            "4:cpu,cpuacct:/job\n3:memory:/other\n",
            {
                "cpu,cpuacct/job/cpu.cfs_quota_us": "400000",
                "cpu,cpuacct/job/cpu.cfs_period_us": "100000",
            },
            4,
        ),
        (
            "1:cpu:/\n",
            {"cpu/cpu.cfs_quota_us": "-1", "cpu/cpu.cfs_period_us": "100000"},
            8,
        ),
        ("0::/job\n", {"job/cpu.max": "9900000 100000"}, 8),
    ],
)
def test_processors_are_those_of_the_affinity_and_of_the_quota(
    membership: str,
    files: dict[str, str],
    processors: int,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for name, content in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)
    (tmp_path / "membership").write_text(membership)
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: range(8), raising=False)
    monkeypatch.setattr(this_machine, "_CGROUPS", tmp_path)
    monkeypatch.setattr(this_machine, "_MEMBERSHIP", tmp_path / "membership")
    assert usable_processors() == processors


def test_a_thread_that_only_speaks_may_be_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def refuse(_: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(threading.Thread, "start", refuse)
    assert not start_if_possible(threading.Thread())
