"""The origin in a video names its episode; other files have none, or a false one."""

import struct
from pathlib import Path

import pytest

from reference_record.formats.video_origin import (
    BOXES_MAX,
    ORIGIN_BYTES_MAX,
    VideoOrigin,
    append_origin,
    read_origin,
)
from tests.support.parsing.parsing_work import assert_linear

ORIGIN = VideoOrigin(
    run_id="run_1",
    statement_sha256="0" * 64,
    episode_index=3,
    recording_sha256="1" * 64,
    camera="front",
    replay="outcome",
    turn=2,
)


def box(content: bytes, type_: bytes = b"mdat") -> bytes:
    return struct.pack(">I4s", 8 + len(content), type_) + content


def long_box(content: bytes) -> bytes:
    return struct.pack(">I4sQ", 1, b"mdat", 16 + len(content)) + content


def with_origin(path: Path, before: bytes) -> Path:
    path.write_bytes(before)
    append_origin(path, ORIGIN)
    return path


@pytest.mark.parametrize(
    "before",
    [
        b"",
        box(b"isom", b"ftyp") + box(b"x" * 100),
        long_box(b"x" * 100),
        box(b"0123456789abcdef and more", b"uuid"),
    ],
)
def test_an_origin_is_read_behind_other_boxes(before: bytes, tmp_path: Path) -> None:
    path = with_origin(tmp_path / "a.mp4", before)
    assert read_origin(path) == ORIGIN
    assert path.read_bytes().startswith(before)


def test_a_file_that_does_not_say_it_once_says_nothing(tmp_path: Path) -> None:
    whole = with_origin(tmp_path / "whole.mp4", box(b"x")).read_bytes()
    own_type = whole[len(box(b"x")) + 8 :][:16]
    files = [
        b"",
        b"x" * 7,
        b"no MP4 file, and long enough for some boxes",
        box(b"isom", b"ftyp"),
        whole[:-1],
        whole + whole,
        whole.replace(b"run_1", b"run_\xff"),
        whole.replace(b'"outcome"', b'"success"'),
        struct.pack(">I4s", 1, b"mdat") + b"cut",
        struct.pack(">I4sQ", 1, b"mdat", 8) + whole,
        struct.pack(">I4s", 0, b"mdat") + whole,
        struct.pack(">I4s", 7, b"mdat") + whole,
        box(own_type + b"[" * (ORIGIN_BYTES_MAX + 1), b"uuid"),
        box(own_type + b"[" * ORIGIN_BYTES_MAX, b"uuid"),
        box(b"") * BOXES_MAX + whole,
    ]
    for number, data in enumerate(files):
        path = tmp_path / f"{number}.mp4"
        path.write_bytes(data)
        assert read_origin(path) is None, (number, data[:40])


def test_many_boxes_are_read_with_linear_work(tmp_path: Path) -> None:
    path = tmp_path / "a.mp4"

    def read(size: int) -> None:
        path.write_bytes(box(b"") * (size // 8))
        read_origin(path)

    assert_linear(read, 8 * BOXES_MAX, "boxes")
