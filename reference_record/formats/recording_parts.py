"""The parts of a recording in progress: messages appended one by one.

A part is a sequence of MCAP's message records and nothing else, in a folder of its
episode. It has one writer, and each message is one write: when the writer is killed at
any moment, every message before that can be read. Who goes on writes another part, with
the next number.
"""

from __future__ import annotations

import errno
import os
import time
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

from reference_record.recording import (
    MESSAGE,
    MESSAGE_HEAD,
    RECORD_HEAD,
    TOPIC_IDS,
    Message,
    is_whole,
    message_record,
    text,
)

SUFFIX = ".part"
# The disk or a quota is full: no fault of what is recorded, nor of who records it.
NO_ROOM = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG})
# The topic of a camera, before the first message with this channel id.
CAMERA_TOPIC = 0xF0
_NAME_AT = MESSAGE_HEAD.size + 4


class PartWriter:
    """A new part in `folder`, behind all that are there. Raises OSError."""

    def __init__(self, folder: Path) -> None:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_APPEND | os.O_CLOEXEC
        self._path = folder / f"{_next_number(folder):06d}{SUFFIX}"
        self._file = os.open(self._path, flags, 0o600)
        self._has_message = False
        self._topics = dict(TOPIC_IDS)

    def write(self, topic: str, message: Message, at_ns: int | None = None) -> None:
        """On return a reader finds the message, whatever happens to this process.

        Raises OSError; nothing is left of a part whose first message cannot be written.
        """
        at_ns = time.time_ns() if at_ns is None else at_ns
        channel, written = self._topics.get(topic), b""
        if channel is None:
            channel = self._topics[topic] = len(self._topics) + 1
            name = text(topic)
            named = MESSAGE_HEAD.pack(channel, 0, at_ns, at_ns) + name
            written = RECORD_HEAD.pack(CAMERA_TOPIC, len(named)) + named
        written += message_record(channel, at_ns, message)
        try:
            self._write_all(written)
        except OSError:
            if not self._has_message:
                self._path.unlink(missing_ok=True)
            raise
        self._has_message = True

    def _write_all(self, written: bytes) -> None:
        taken = os.write(self._file, written)
        while taken < len(written):  # the disk is nearly full: the next one says so
            written = written[taken:]
            taken = os.write(self._file, written)
            if not taken:
                raise OSError("the disk took a part of a message only")

    def close(self) -> None:
        os.close(self._file)


def append_part(folder: Path, topic: str, message: Message) -> None:
    """Write one message as a part of its own."""
    part = PartWriter(folder)
    try:
        part.write(topic, message)
    finally:
        part.close()


def parts_of(folder: Path) -> list[Path]:
    """In the order in which they were begun."""
    return sorted(folder.glob(f"*{SUFFIX}"), key=_number_of)


def read_part(path: Path) -> Iterator[tuple[str, memoryview]]:
    """Topic and message, as the content of an MCAP message record.

    Ends where the part was cut. Raises OSError.
    """
    topics = {channel: topic for topic, channel in TOPIC_IDS.items()}
    with path.open("rb") as file:
        size = os.fstat(file.fileno()).st_size
        while (found := _read_record(file, size)) is not None:
            kind, content = found
            size -= RECORD_HEAD.size + len(content)
            channel = int.from_bytes(content[:2], "little")
            if kind == CAMERA_TOPIC:
                topics[channel] = content[_NAME_AT:].decode(errors="replace")
            elif kind == MESSAGE and channel in topics and is_whole(content):
                yield topics[channel], memoryview(content)
            else:  # what a power cut leaves of a file
                return


def _read_record(file: BinaryIO, size: int) -> tuple[int, bytes] | None:
    """None at the end, or where the record is not whole. size: what is left to read."""
    head = file.read(RECORD_HEAD.size)
    if len(head) < RECORD_HEAD.size:
        return None
    kind, length = RECORD_HEAD.unpack(head)
    if not MESSAGE_HEAD.size <= length <= size - len(head):
        return None
    return kind, file.read(length)


def _next_number(folder: Path) -> int:
    return 1 + max(map(_number_of, parts_of(folder)), default=0)


def _number_of(path: Path) -> int:
    return int(path.stem)
