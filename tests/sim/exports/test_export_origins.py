"""Every export names its record, and for each of its episodes the recording."""

import json
from collections.abc import Callable, Mapping
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from reference_record.formats.video_origin import read_origin
from reference_sim.exports.__main__ import main
from reference_sim.exports.source import open_source
from tests.support.sim.echo_records import save_echo

# The statements that are named anywhere in an export, and index → recording.
Origins = tuple[set[str], Mapping[int, str]]


def of_videos(folder: Path) -> Origins:
    origins = [read_origin(path) for path in folder.rglob("*.mp4")]
    assert None not in origins
    said = [one for one in origins if one is not None]
    return (
        {one.statement_sha256 for one in said},
        {one.episode_index: one.recording_sha256 for one in said},
    )


def of_tables(folder: Path) -> Origins:
    statements = {
        pq.read_schema(path).metadata[b"statement_sha256"].decode()
        for path in folder.glob("*.parquet")
    }
    rows = pq.read_table(folder / "episodes.parquet").to_pylist()
    return statements, {row["episode_index"]: row["recording_sha256"] for row in rows}


def of_data_set(folder: Path) -> Origins:
    said = json.loads((folder / "meta" / "proctor.json").read_text())
    (path,) = (folder / "meta" / "episodes").rglob("*.parquet")
    rows = pq.read_table(path, partitioning=None).to_pylist()
    named = "proctor/episode_index", "proctor/recording_sha256"
    recordings = {row[named[0]]: row[named[1]] for row in rows}
    statements, of_files = of_videos(folder)
    assert of_files.items() <= recordings.items()
    return statements | {said["statement_sha256"]}, recordings


def of_evaluation(folder: Path) -> Origins:
    (path,) = folder.rglob("*.json")
    said = json.loads(path.read_text())["source_metadata"]["additional_details"]
    (samples,) = folder.rglob("*.jsonl")
    lines = [json.loads(line) for line in samples.read_text().splitlines()]
    return {said["statement_sha256"]}, {
        int(one["sample_id"].rpartition("/")[2]): one["metadata"]["recording_sha256"]
        for one in lines
    }


@pytest.mark.parametrize(
    ("kind", "read", "episodes"),
    [
        ("video", of_videos, [0, 1]),
        ("lerobot", of_data_set, [0, 1]),
        ("parquet", of_tables, None),
        ("every-eval-ever", of_evaluation, None),
    ],
)
def test_an_export_names_its_record_and_recordings(
    kind: str, read: Callable[[Path], Origins], episodes: list[int] | None, folder: Path
) -> None:
    record = save_echo(folder)
    job = {"kind": kind, "record": str(record), "episodes": episodes}
    assert main([json.dumps(job | {"output": str(folder / "made")})]) == 0
    source = open_source(record)
    recordings = {
        line.index: line.recording.sha256
        for line in source.lines()
        if line.recording is not None and (episodes is None or line.index in episodes)
    }
    assert read(folder / "made") == ({source.statement_sha256}, recordings)
