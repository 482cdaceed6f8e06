"""The layout of LeRobotDataset, version 3.0: its files, their columns, its statistics.

Written by hand, so that it needs neither LeRobot nor torch; `make lerobot-check` loads
what comes of it with LeRobot itself. Knows no record and no simulator.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from io import FileIO
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from numpy.typing import NDArray

VERSION = "v3.0"
FILES_IN_CHUNK = 1000
DATA_BYTES_MAX = 100 * 2**20  # of a data file, before the next one is begun
DATA_PATH = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
VIDEO_PATH = "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4"
EPISODES_PATH = "meta/episodes/chunk-000/file-000.parquet"
QUANTILES = {"q01": 0.01, "q10": 0.1, "q50": 0.5, "q90": 0.9, "q99": 0.99}
IMAGES_FOR_STATISTICS = 100  # of an episode, at most
SIDE_FOR_STATISTICS = 150  # pixels, about

Json = dict[str, Any]
Statistics = dict[str, NDArray[np.float64]]
# Columns that LeRobot wants in every data set, behind the features of its own.
PLACES: Mapping[str, Json] = {
    "timestamp": {"dtype": "float32", "shape": [1], "names": None},
    **{
        name: {"dtype": "int64", "shape": [1], "names": None}
        for name in ("frame_index", "episode_index", "index", "task_index")
    },
}


def vector_feature(names: Sequence[str]) -> Json:
    return {"dtype": "float32", "shape": [len(names)], "names": list(names)}


def number_feature(dtype: str) -> Json:
    return {"dtype": dtype, "shape": [1], "names": None}


def video_feature(size: tuple[int, int], fps: int) -> Json:
    """size: width and height, in pixels."""
    width, height = size
    info = {
        "video.height": height,
        "video.width": width,
        "video.codec": "h264",
        "video.pix_fmt": "yuv420p",
        "video.is_depth_map": False,
        "video.fps": fps,
        "video.channels": 3,
        "has_audio": False,
    }
    shape, names = [height, width, 3], ["height", "width", "channels"]
    return {"dtype": "video", "shape": shape, "names": names, "info": info}


def file_place(number: int) -> dict[str, int]:
    """chunk_index and file_index of the file with this number."""
    chunk, file = divmod(number, FILES_IN_CHUNK)
    return {"chunk_index": chunk, "file_index": file}


class DataFiles:
    """The rows of all episodes, in Parquet files of a bounded size."""

    def __init__(self, folder: Path, features: Mapping[str, Json]) -> None:
        self._folder = folder
        self._features = {k: v for k, v in features.items() if v["dtype"] != "video"}
        self._schema = pa.schema(
            [(name, _arrow_type(feature)) for name, feature in self._features.items()]
        )
        self._number = -1
        self._writer: pq.ParquetWriter | None = None
        self._sink: FileIO | None = None

    def add(self, columns: Mapping[str, NDArray[Any]]) -> dict[str, int]:
        """One episode. columns: name → (frames, n) or (frames,). Returns its place."""
        if self._writer is None or self._bytes_written() > DATA_BYTES_MAX:
            self._begin_file()
        assert self._writer is not None
        arrays = [
            _arrow_array(columns[field.name], field.type) for field in self._schema
        ]
        self._writer.write_table(pa.table(arrays, schema=self._schema))
        return file_place(self._number)

    def close(self) -> None:
        if self._writer is not None:
            self._writer.close()
        if self._sink is not None:
            self._sink.close()
        self._writer = None

    def _bytes_written(self) -> int:
        return 0 if self._sink is None else os.fstat(self._sink.fileno()).st_size

    def _begin_file(self) -> None:
        self.close()
        self._number += 1
        path = self._folder / DATA_PATH.format(**file_place(self._number))
        path.parent.mkdir(parents=True, exist_ok=True)
        self._sink = path.open("wb", buffering=0)
        self._writer = pq.ParquetWriter(self._sink, self._schema)


def _arrow_type(feature: Json) -> pa.DataType:
    element = pa.from_numpy_dtype(np.dtype(feature["dtype"]))
    (size,) = feature["shape"]
    return element if size == 1 else pa.list_(element, size)


def _arrow_array(values: NDArray[Any], type_: pa.DataType) -> pa.Array:
    flat = np.ascontiguousarray(values).reshape(-1)
    if not pa.types.is_fixed_size_list(type_):
        return pa.array(flat.astype(type_.to_pandas_dtype()), type_)
    element = type_.value_type
    flat = flat.astype(element.to_pandas_dtype())
    return pa.FixedSizeListArray.from_arrays(pa.array(flat, element), type=type_)


# --- statistics ---


def number_statistics(values: NDArray[Any]) -> Statistics:
    """values: (frames,) or (frames, n) → one number for each column."""
    columns = values.reshape(len(values), -1).astype(np.float64)
    return _statistics(columns, len(values))


def image_statistics(images: Sequence[NDArray[np.uint8]]) -> Statistics:
    """images: (height, width, 3) → (3, 1, 1) for each colour, from 0 to 1."""
    pixels = np.concatenate([image.reshape(-1, 3) for image in images]) / 255
    statistics = _statistics(pixels, len(images))
    return {k: v if k == "count" else v.reshape(3, 1, 1) for k, v in statistics.items()}


def thinned(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """(height, width, 3), as large as statistics need it."""
    step = max(1, min(image.shape[:2]) // SIDE_FOR_STATISTICS)
    small = image[::step, ::step]
    return np.repeat(small, 3, axis=2) if image.shape[2] == 1 else small.copy()


def _statistics(columns: NDArray[np.float64], count: int) -> Statistics:
    moments = {
        "min": columns.min(axis=0),
        "max": columns.max(axis=0),
        "mean": columns.mean(axis=0),
        "std": columns.std(axis=0),
        "count": np.array([count]),
    }
    levels = np.quantile(columns, list(QUANTILES.values()), axis=0)
    return moments | dict(zip(QUANTILES, levels, strict=True))


def merge_statistics(first: Statistics, second: Statistics) -> Statistics:
    """The statistics of both together; LeRobot merges quantiles as weighted means."""
    counts = float(first["count"][0]), float(second["count"][0])
    share, rest = counts[0] / sum(counts), counts[1] / sum(counts)
    merged = {
        name: share * first[name] + rest * second[name] for name in ("mean", *QUANTILES)
    }
    spread = [
        part["std"] ** 2 + (part["mean"] - merged["mean"]) ** 2
        for part in (first, second)
    ]
    return merged | {
        "min": np.minimum(first["min"], second["min"]),
        "max": np.maximum(first["max"], second["max"]),
        "std": np.sqrt(share * spread[0] + rest * spread[1]),
        "count": first["count"] + second["count"],
    }


# --- meta/ ---


def write_meta(
    folder: Path,
    *,
    info: Mapping[str, Any],
    tasks: Sequence[str],
    episodes: Sequence[Mapping[str, Any]],
    statistics: Mapping[str, Statistics],
) -> None:
    """info.json, stats.json, tasks.parquet and the table of the episodes.

    info: the members that follow from the data. tasks: their texts, by task_index.
    episodes: the rows, with lists for statistics.
    """
    (folder / EPISODES_PATH).parent.mkdir(parents=True)
    place = {"meta/episodes/chunk_index": 0, "meta/episodes/file_index": 0}
    rows = [{**row, **place} for row in episodes]
    pq.write_table(pa.Table.from_pylist(rows), folder / EPISODES_PATH)
    _write_tasks(folder / "meta" / "tasks.parquet", tasks)
    lists = {name: as_lists(values) for name, values in statistics.items()}
    _write_json(folder / "meta" / "stats.json", lists)
    fixed = {
        "codebase_version": VERSION,
        "chunks_size": FILES_IN_CHUNK,
        "data_files_size_in_mb": DATA_BYTES_MAX // 2**20,
        "video_files_size_in_mb": 200,
        "data_path": DATA_PATH,
        "total_episodes": len(episodes),
        "total_tasks": len(tasks),
        "splits": {"train": f"0:{len(episodes)}"},
    }
    _write_json(folder / "meta" / "info.json", {**fixed, **info})


def as_lists(statistics: Statistics) -> dict[str, Any]:
    return {name: values.tolist() for name, values in statistics.items()}


def _write_tasks(path: Path, tasks: Sequence[str]) -> None:
    """LeRobot reads the texts as the index of a pandas table."""
    numbers = pa.array(range(len(tasks)), pa.int64())
    table = pa.table({"task_index": numbers, "task": pa.array(tasks, pa.string())})
    kinds = {"task_index": "int64", "task": "object"}
    columns = [
        {"name": name, "field_name": name, "pandas_type": pandas_type,
         "numpy_type": kinds[name], "metadata": None}
        for name, pandas_type in (("task_index", "int64"), ("task", "unicode"))
    ]  # fmt: skip
    said = {"index_columns": ["task"], "column_indexes": [], "columns": columns}
    pandas = json.dumps(said | {"pandas_version": "2.2.0"})
    pq.write_table(table.replace_schema_metadata({"pandas": pandas}), path)


def _write_json(path: Path, value: object) -> None:
    path.write_text(json.dumps(value, indent=4) + "\n")
