"""`python -m … FOLDER ROUNDS`: the measurements that need no second process.

Runs in the environment that has all the libraries. FOLDER contains the samples. Prints
one line of JSON: versions, and for each question, column and contender the median of
one call. A column's name ends with its unit.
"""

from __future__ import annotations

import importlib.metadata
import json
import os
import platform
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from benchmarks.libraries import (
    interleaved_timing,
    jpeg,
    response_parsing,
    samples,
    structures,
)
from benchmarks.round_trips import observations

Questions = dict[str, dict[str, tuple[list[interleaved_timing.Contender], Any]]]
PACKAGES = (
    *("aiohttp", "granian", "h11", "httptools", "httpx", "hypercorn", "msgpack"),
    *("msgspec", "numpy", "orjson", "ormsgpack", "pillow", "pybase64", "requests"),
    *("simplejpeg", "urllib3", "uvicorn", "uvloop"),
)


def main() -> None:
    folder, rounds = Path(sys.argv[1]), int(sys.argv[2])
    state = samples.read(folder, samples.STATE)
    cameras = samples.read(folder, samples.CAMERAS)
    questions: Questions = {
        "parsing": {"answer_us": response_parsing.contenders(state)},
        "messagepack": {
            "encode_us": structures.msgpack_encoded(state),
            "decode_us": structures.msgpack_decoded(state),
            "decode_pictures_us": structures.msgpack_decoded(cameras),
        },
        "json": {
            "encode_us": structures.json_encoded(state),
            "decode_us": structures.json_decoded(state),
            "encode_pictures_ms": structures.json_encoded(cameras),
            "decode_pictures_ms": structures.json_decoded(cameras),
        },
    }
    drawn = observations.pictures(observations.SCENARIOS["cameras"])
    pictures = list(drawn.values())
    with ThreadPoolExecutor(os.cpu_count()) as threads:
        questions["jpeg"] = {
            "encode_ms": jpeg.encoded(pictures, map),
            "encode_threads_ms": jpeg.encoded(pictures, threads.map),
            "decode_ms": jpeg.decoded(pictures, map),
            "decode_threads_ms": jpeg.decoded(pictures, threads.map),
        }
        figures = {
            question: {
                column: _measured(column, *contenders, rounds)
                for column, contenders in columns.items()
            }
            for question, columns in questions.items()
        }
    figures["jpeg"]["files_kb"] = jpeg.sizes_kb(pictures)
    print(json.dumps({**_facts(), "figures": figures}))


def _measured(
    column: str,
    contenders: list[interleaved_timing.Contender],
    expected: Any,
    rounds: int,
) -> dict[str, float]:
    unit_ns = interleaved_timing.UNITS_NS[column.rpartition("_")[2]]
    took = interleaved_timing.medians_ns(contenders, expected, rounds)
    return {name: round(ns / unit_ns, 4) for name, ns in took.items()}


def _facts() -> dict[str, object]:
    return {
        "python": platform.python_version(),
        "versions": {name: importlib.metadata.version(name) for name in PACKAGES},
    }


if __name__ == "__main__":
    main()
