"""The Parquet tables of a run hold what its record says, with units, in row groups."""

from pathlib import Path

import msgspec
import pyarrow.parquet as pq
import pytest

from reference_record.broken import UnusableRecord
from reference_record.formats.strict_json import canonical_json
from reference_record.recordings.recording import Turn
from reference_sim import benchmark_registry
from reference_sim.exports import parquet_tables
from reference_sim.exports.parquet_tables import write_tables
from reference_sim.exports.source import open_source
from tests.support.record.played_records import (
    OPTIONS,
    play_chunks,
    save_calibration_record,
    save_played_record,
)
from tests.support.record.sample_records import MANIFEST, Sample, make_archive


@pytest.fixture
def record(folder: Path) -> Path:
    return save_calibration_record(folder / "run-1.proctor", folder / "recordings")


def test_every_turn_comes_back_as_it_was_recorded(record: Path, tmp_path: Path) -> None:
    source = open_source(record)
    recorded = [
        (line.index, start, turn)
        for line in source.lines()
        for start, turn in source.turns(line)
    ]
    write_tables(source, tmp_path)
    rows = pq.read_table(tmp_path / "turns.parquet").to_pylist()
    assert len(rows) == len(recorded) == 6
    for row, (index, start, turn) in zip(rows, recorded, strict=True):
        actions = [
            {name: row[f"action_{name}"][step] for name in turn.actions[0]}
            for step in range(turn.steps)
        ]
        assert actions == list(turn.actions)
        assert (row["episode_index"], row["start_number"]) == (index, start)
        assert row["executed_at"].isoformat(timespec="milliseconds") == (
            turn.at.replace("Z", "+00:00")
        )
        same = ("attempt", "steps", "rewards", "score", "success", "ended")
        for name in (*same, "simulate_ms", "think_ms", "state_digest"):
            assert row[name] == getattr(turn, name), name


def test_every_episode_has_its_row(folder: Path) -> None:
    """Also one without a result, and one whose seed is the secret of the host."""
    found = benchmark_registry.resolve("calibration", OPTIONS | {"sealed": True})
    del found.manifest["episodes"][1]["seed"]
    path = folder / "run-1.proctor"
    save_played_record(path, folder / "recordings", found, play_chunks, only=(0, 2))
    write_tables(open_source(path), folder)
    rows = pq.read_table(folder / "episodes.parquet").to_pylist()
    shown = [(r["task"], r["split"], r["seed"], r["outcome"], r["score"]) for r in rows]
    assert shown == [
        ("score", "even", 1000, "success", 1.0),
        ("count", "odd", None, None, None),
        ("echo", "even", 1002, "success", 1.0),
    ]
    assert {row["benchmark_id"] for row in rows} == {"calibration"}


def test_units_and_provenance_are_in_the_metadata(record: Path, tmp_path: Path) -> None:
    source = open_source(record)
    write_tables(source, tmp_path)
    schema = pq.read_schema(tmp_path / "turns.parquet")
    assert schema.metadata[b"statement_sha256"].decode() == source.statement_sha256
    assert b"without a signature" in schema.metadata[b"note"]
    assert schema.field("action_delay_s").metadata[b"unit"] == b"s"
    assert schema.field("think_ms").metadata[b"unit"] == b"ms"
    for field in schema:
        assert field.metadata[b"meaning"], field.name


def test_rows_are_written_in_groups(
    record: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Memory does not grow with the run."""
    monkeypatch.setattr(parquet_tables, "ROWS_IN_GROUP", 4)
    write_tables(open_source(record), tmp_path)
    with pq.ParquetFile(tmp_path / "turns.parquet") as file:
        groups = map(file.metadata.row_group, range(file.num_row_groups))
        sizes = [group.num_rows for group in groups]
    assert sizes == [4, 2]


def test_a_start_after_a_fault_has_the_next_number(folder: Path) -> None:
    found = benchmark_registry.resolve("calibration", OPTIONS)
    path = folder / "run-1.proctor"
    save_played_record(path, folder / "recordings", found, play_chunks, faults=1)
    write_tables(open_source(path), folder)
    rows = pq.read_table(folder / "turns.parquet").to_pylist()
    assert [row["start_number"] for row in rows] == [1, 2, 2] * 3


def test_what_fits_no_table_is_refused(folder: Path) -> None:
    """Nothing has compared the actions of a record with the spaces of its manifest."""

    def other(index: int, _number: int, turn: Turn) -> Turn:
        return msgspec.structs.replace(turn, at="yesterday") if index else turn

    path = folder / "run-1.proctor"
    save_calibration_record(path, folder / "recordings", other)
    with pytest.raises(UnusableRecord, match="yesterday is no time"):
        write_tables(open_source(path), folder)
    spaces = {name: MANIFEST[name] for name in MANIFEST if name != "action_space"}
    sample = Sample()
    plan = msgspec.json.decode(sample.manifest)["episodes"]
    sample = Sample(manifest=canonical_json(spaces | {"episodes": plan}))
    path.write_bytes(make_archive(sample))
    with pytest.raises(UnusableRecord, match="no action space"):
        write_tables(open_source(path), folder)
