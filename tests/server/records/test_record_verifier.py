"""What the server believes of a record that another process has read for it."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

import msgspec
import pytest

from reference_record.broken import BrokenRecord, UnusableRecord
from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import MANIFEST
from reference_server.process.child_environment import child_environment
from reference_server.records import record_verifier, verify_process
from reference_server.records.import_replays import check_choice
from reference_server.records.record_verifier import ExaminationFailed, RecordVerifier
from reference_server.records.verify_process import CHOICE_BYTES_MAX
from reference_sim.replay.foreign_manifest import BenchmarkChoice
from tests.support.record.hostile_records import resigned
from tests.support.record.played_records import save_calibration_record

SHA256 = "0" * 64
CHOICE = BenchmarkChoice("calibration", {"tasks": ["score"]}, None, SHA256)


@pytest.fixture(scope="module")
def record(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("record")
    return save_calibration_record(folder / "r.proctor", folder)


def with_options(record: Path, folder: Path, options: Any) -> Path:
    """The record with other options in its statement."""
    bundle = open_bundle(record)
    files = {name: bundle.read(name) for name in bundle.sizes}
    path = folder / "changed.proctor"
    path.write_bytes(resigned(files, MANIFEST, files[MANIFEST], options=options))
    return path


@pytest.mark.parametrize(
    "changed",
    [
        {"options": {"tasks": ["score"] * 1001}},
        {"options": {"max_steps": 10**9}},
        {"options": {"more": 1}},
        {"options": {"tasks": "score"}},
        {"images": {"codec": {"a": 1}}},
        {"images": {"cameras": 1}},
        {"benchmark_id": "../calibration"},
    ],
)
def test_what_no_submission_may_have_is_not_resolved(changed: dict[str, Any]) -> None:
    check_choice(CHOICE)
    with pytest.raises(UnusableRecord, match="no run can be submitted"):
        check_choice(msgspec.structs.replace(CHOICE, **changed))


def test_a_record_is_read_for_its_replay(record: Path) -> None:
    recorded = asyncio.run(RecordVerifier().read_for_replay(record))
    assert recorded.choice.benchmark_id == "calibration"
    results = list(recorded.results())
    assert [one.index for one in results] == [0, 1, 2]
    assert results[0].recording == "episodes/00000.mcap"


def test_options_have_a_bound_before_the_server_sees_them(
    record: Path, tmp_path: Path
) -> None:
    """Just below it they arrive, and are refused by the schema of a submission."""
    kept = with_options(record, tmp_path, {"x": "y" * (CHOICE_BYTES_MAX - 1000)})
    recorded = asyncio.run(RecordVerifier().read_for_replay(kept))
    with pytest.raises(UnusableRecord):
        check_choice(recorded.choice)
    long = with_options(record, tmp_path, {"x": "y" * CHOICE_BYTES_MAX})
    with pytest.raises(BrokenRecord, match="of this length"):
        asyncio.run(RecordVerifier().read_for_replay(long))


def test_what_the_process_says_has_a_bound(
    record: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(record_verifier, "FOUND_BYTES_MAX", 100)
    with pytest.raises(ExaminationFailed, match="more than 100 bytes"):
        asyncio.run(RecordVerifier().examine("a", record))


def test_a_record_that_takes_too_long_is_not_called_broken(
    record: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A busy machine is no fault of it."""
    monkeypatch.setattr(record_verifier, "EXAMINE_S_MAX", 0.01)
    with pytest.raises(ExaminationFailed, match="not read through"):
        asyncio.run(RecordVerifier().examine("a", record))


def test_settings_and_passwords_are_not_passed_on(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for name in ("PROCTOR_TOKENS", "PGPASSWORD"):
        monkeypatch.setenv(name, "sesame")
    monkeypatch.setenv("OTHER_VARIABLE", "kept")
    environment = child_environment()
    assert "sesame" not in environment.values()
    assert environment["OTHER_VARIABLE"] == "kept"


def test_a_process_that_cannot_run_is_no_fault_of_the_record(
    record: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        record_verifier, "child_environment", lambda: {"PYTHONHOME": "/nowhere"}
    )
    with pytest.raises(ExaminationFailed, match="ended with 1"):
        asyncio.run(RecordVerifier().examine("a", record))


def test_a_record_that_reaches_the_bound_of_time_is_refused(
    record: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The system ends its process."""
    (tmp_path / "sitecustomize.py").write_text(
        "from reference_server.records import verify_process\n"
        "verify_process.CPU_S_MAX = 1\n"
        "verify_process._bound_this_process()\n"
        "while True: pass\n"
    )
    monkeypatch.setattr(
        record_verifier, "child_environment", lambda: {"PYTHONPATH": str(tmp_path)}
    )
    with pytest.raises(BrokenRecord, match="more memory or time"):
        asyncio.run(RecordVerifier().examine("a", record))


def test_memory_that_is_not_there_is_named(
    record: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(_: object) -> None:
        raise MemoryError

    monkeypatch.setattr(verify_process, "verify", fail)
    found = verify_process.examine(record)
    assert found.broken is not None
    assert (found.broken.file, found.broken.rule) == ("archive", "REC-030")
