"""A run as a LeRobotDataset, read without LeRobot: what it says is what was simulated.

`make lerobot-check` loads one with LeRobot itself (lerobot_dataset_checks.py).
"""

import json
from pathlib import Path
from typing import Any

import av
import numpy as np
import pyarrow.parquet as pq
import pytest

from reference_sim import benchmark_registry
from reference_sim.exports import lerobot_format
from reference_sim.exports.__main__ import main
from reference_sim.exports.lerobot_format import (
    image_statistics,
    merge_statistics,
    number_statistics,
)
from tests.support.record.played_records import save_played_record
from tests.support.sim.echo_records import ECHO, other_action, play_45_steps, save_echo


def export(record: Path, **more: Any) -> int:
    job = {"kind": "lerobot", "record": str(record), "json": True}
    return main([json.dumps(job | {"output": str(record.parent / "set")} | more)])


def rows_of(folder: Path, name: str) -> list[dict[str, Any]]:
    found = pq.read_table(folder / "set" / name, partitioning=None).to_pylist()
    return [dict(row) for row in found]


def test_a_frame_is_what_was_seen_and_then_done(folder: Path) -> None:
    """Of an episode with 45 steps: the state before each of them, and the action."""
    assert export(save_echo(folder), episodes=[0, 1]) == 0
    rows = rows_of(folder, "data/chunk-000/file-000.parquet")
    assert len(rows) == 90
    info = json.loads((folder / "set" / "meta" / "info.json").read_text())
    names = info["features"]["observation.state"]["names"]
    counted = [row["observation.state"][names.index("count")] for row in rows]
    assert counted == [*range(45)] * 2
    assert [row["index"] for row in rows] == [*range(90)]
    assert [row["episode_index"] for row in rows] == [0] * 45 + [1] * 45
    assert [row["next.done"] for row in rows] == ([False] * 44 + [True]) * 2
    assert rows[7]["timestamp"] == pytest.approx(0.7)
    assert info["fps"] == 10
    assert (info["total_episodes"], info["total_frames"]) == (2, 90)


def test_videos_show_what_was_seen(folder: Path) -> None:
    """As many pictures as frames, in a file for each episode that its row names."""
    assert export(save_echo(folder), episodes=[0, 1]) == 0
    episodes = rows_of(folder, lerobot_format.EPISODES_PATH)
    key = "observation.images.pattern"
    for row in episodes:
        path = lerobot_format.VIDEO_PATH.format(
            video_key=key,
            chunk_index=row[f"videos/{key}/chunk_index"],
            file_index=row[f"videos/{key}/file_index"],
        )
        with av.open(str(folder / "set" / path)) as container:
            frames = list(container.decode(video=0))
        assert len(frames) == row["length"] == 45
        assert row[f"videos/{key}/to_timestamp"] == 4.5
        assert frames[0].to_ndarray(format="rgb24").shape == (12, 16, 3)


def test_a_camera_that_not_all_tasks_have_is_left_out(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record = save_echo(folder)
    assert export(record) == 0
    info = json.loads((folder / "set" / "meta" / "info.json").read_text())
    assert [n for n in info["features"] if n.startswith("observation.images")] == []
    assert info["video_path"] is None
    capsys.readouterr()
    more = {"cameras": ["pattern"], "output": str(folder / "other")}
    assert export(record, **more) == 2
    assert "not all of these episodes have a camera pattern" in capsys.readouterr().err
    names = {path.name for path in folder.iterdir()}
    assert names == {"recordings", "run-1.proctor", "set"}


def test_diverged_is_left_out(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The other episode moves up, and the data set says what is missing."""
    assert export(save_echo(folder, other_action), episodes=[0, 1]) == 1
    out, err = capsys.readouterr()
    assert [one["episode"] for one in json.loads(out)["refused"]] == [1]
    assert "what left the record is left out" in err
    assert len(rows_of(folder, "data/chunk-000/file-000.parquet")) == 45
    assert len([*(folder / "set").rglob("*.mp4")]) == 1
    said = json.loads((folder / "set" / "meta" / "proctor.json").read_text())
    assert [one["episode"] for one in said["left_out"]] == [1]


def test_tasks_are_the_instructions(folder: Path) -> None:
    found = benchmark_registry.resolve("calibration", ECHO)
    record = folder / "run-1.proctor"
    recordings = folder / "recordings"
    save_played_record(record, recordings, found, play_45_steps, options=ECHO)
    assert export(record) == 0
    texts = ["Calibration task echo.", "Calibration task score."]
    tasks = rows_of(folder, "meta/tasks.parquet")
    assert [row["task"] for row in tasks] == texts
    assert [row["task_index"] for row in tasks] == [0, 1]
    rows = rows_of(folder, "data/chunk-000/file-000.parquet")
    assert [row["task_index"] for row in rows[::45]] == [0, 0, 1]


def test_a_file_that_is_full_is_followed_by_another(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(lerobot_format, "DATA_BYTES_MAX", 1)
    assert export(save_echo(folder), episodes=[0, 1]) == 0
    for number in (0, 1):
        rows = rows_of(folder, f"data/chunk-000/file-{number:03d}.parquet")
        assert {row["episode_index"] for row in rows} == {number}
    episodes = rows_of(folder, lerobot_format.EPISODES_PATH)
    assert [row["data/file_index"] for row in episodes] == [0, 1]


def test_statistics_of_two_parts_are_those_of_the_whole() -> None:
    values = np.random.default_rng(5).normal(size=(90, 3))
    merged = merge_statistics(*map(number_statistics, (values[:30], values[30:])))
    whole = number_statistics(values)
    for name in ("min", "max", "mean", "std", "count"):
        assert merged[name] == pytest.approx(whole[name]), name


def test_statistics_of_pictures_are_of_each_colour() -> None:
    picture = np.zeros((4, 6, 3), np.uint8)
    picture[..., 1] = 255
    found = image_statistics([picture, picture])
    assert found["mean"].shape == (3, 1, 1)
    assert found["mean"].reshape(3).tolist() == [0, 1, 0]
    assert found["count"].tolist() == [2]
