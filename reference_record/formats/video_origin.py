"""Writes into the file of a video which episode it shows, and reads it again.

The name and the folder of a file prove nothing, because both change when it is copied.
So each video has a box of its own at the end of the MP4 file, which players skip, with
the digest of the recording that was drawn. The box is not signed: the author of a video
can write any origin.
"""

from __future__ import annotations

import struct
import uuid
from pathlib import Path
from typing import BinaryIO, Final, Literal

import msgspec
from msgspec import Struct

# A box begins with its size and its type; size 1: eight bytes follow that have it, and
# 0: it ends with the file. A type of our own is 16 bytes behind the type `uuid`.
_HEAD = struct.Struct(">I4s")
_LONG_SIZE = struct.Struct(">Q")
_TYPE: Final = uuid.uuid5(uuid.NAMESPACE_URL, "urn:proctor:video-origin:v1").bytes
# A file of unknown origin may have any number of boxes of any size: so many are looked
# at, and a longer origin is not read.
BOXES_MAX: Final = 10_000
ORIGIN_BYTES_MAX: Final = 2**14


class VideoOrigin(Struct, frozen=True, kw_only=True):
    """The episode that a video shows.

    statement_sha256: the digest that names the record. recording_sha256: the digest of
    the episode's recording. replay: how the drawn episode compares with the recording.
    turn: the first turn with another state; None if all states are equal.
    """

    run_id: str
    statement_sha256: str
    episode_index: int
    recording_sha256: str
    camera: str
    replay: Literal["exact", "outcome", "diverged"]
    turn: int | None = None


def append_origin(path: Path, origin: VideoOrigin) -> None:
    """Write the origin behind a whole MP4 file that has none. Raises OSError."""
    content = _TYPE + msgspec.json.encode(origin)
    with path.open("ab") as file:
        file.write(_HEAD.pack(_HEAD.size + len(content), b"uuid") + content)


def read_origin(path: Path) -> VideoOrigin | None:
    """The origin; None unless the file holds exactly one. Raises OSError."""
    with path.open("rb") as file:
        contents = _origins(file, path.stat().st_size)
    if len(contents) != 1:
        return None
    try:
        return msgspec.json.decode(contents[0], type=VideoOrigin)
    except (msgspec.MsgspecError, ValueError):
        return None


def _origins(file: BinaryIO, size: int) -> list[bytes]:
    """The contents of the boxes of our type."""
    contents: list[bytes] = []
    position = 0
    for _ in range(BOXES_MAX):
        file.seek(position)
        head = file.read(_HEAD.size)
        if len(head) < _HEAD.size:
            break
        box_size, type_ = _HEAD.unpack(head)
        head_size = _HEAD.size
        if box_size == 1:
            long_size = file.read(_LONG_SIZE.size)
            if len(long_size) < _LONG_SIZE.size:
                break
            (box_size,) = _LONG_SIZE.unpack(long_size)
            head_size += _LONG_SIZE.size
        box_size = box_size or size - position
        if box_size < head_size or position + box_size > size:
            break  # this is not an MP4 file, or it is cut
        if type_ == b"uuid" and file.read(len(_TYPE)) == _TYPE:
            left = box_size - head_size - len(_TYPE)
            contents.append(file.read(left) if left <= ORIGIN_BYTES_MAX else b"")
        position += box_size
    return contents
