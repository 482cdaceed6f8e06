"""Joins the parts of a recording into one MCAP file with compressed chunks.

The file is complete and on disk before its name exists; the parts stay until its caller
removes them. Memory is bounded by a chunk, whatever the length of the episode.
"""

from __future__ import annotations

import hashlib
import os
import struct
import threading
import zlib
from collections.abc import Sequence
from pathlib import Path
from typing import BinaryIO

import msgspec
import zstandard

from reference_record.recordings.recording import (
    CHANNEL,
    CHANNELS,
    CHUNK,
    CHUNK_INDEX,
    DATA_END,
    FOOTER,
    HEADER,
    MAGIC,
    MESSAGE,
    MESSAGE_HEAD,
    MESSAGE_INDEX,
    SCHEMA,
    STATISTICS,
    SUMMARY_OFFSET,
    WHOLE_HEAD,
    AttemptEvent,
    Message,
    Turn,
    channel_record,
    encode_message,
    record,
    schema_record,
    text,
)
from reference_record.recordings.recording_parts import json_of, parts_of, read_part

DRAFT_SUFFIX = ".draft"
CHUNK_BYTES = 1 << 20
# zstd's default, 3, takes longer on recordings and makes them larger.
LEVEL = 1


class Latency(msgspec.Struct, frozen=True):
    """Quantiles over the turns of an episode, milliseconds; 0 without a turn."""

    think_ms_p50: float
    think_ms_p99: float
    simulate_ms_p50: float
    simulate_ms_p99: float


class RecordingSummary(msgspec.Struct, frozen=True):
    """A finished recording: its file's hash and size, and what others list of it.

    first_digest: the digest of the state at the first step 0. last_digest: that of the
    state after the last turn, or at the last step 0 if there was no turn. Both are None
    if no attempt was begun.
    """

    sha256: str
    bytes: int
    turns: int
    first_digest: str | None
    last_digest: str | None
    latency: Latency


class _TurnFigures(msgspec.Struct):
    steps: int
    state_digest: str
    simulate_ms: float
    think_ms: float


class _Compressors(threading.local):
    """One compressor per thread: allocating it dominates a short episode's cost."""

    def __init__(self) -> None:
        self._of_levels: dict[int, zstandard.ZstdCompressor] = {}

    def of(self, level: int) -> zstandard.ZstdCompressor:
        if level not in self._of_levels:
            self._of_levels[level] = zstandard.ZstdCompressor(level=level)
        return self._of_levels[level]


_COMPRESSORS = _Compressors()
_TURN = msgspec.json.Decoder(_TurnFigures)
_ATTEMPT = msgspec.json.Decoder(AttemptEvent)


def join_parts(
    folder: Path,
    target: Path,
    last: Sequence[tuple[str, int, Message]],
    earlier: Sequence[Path] = (),
    *,
    steps: int | None = None,
    level: int = LEVEL,
) -> RecordingSummary:
    """Write all parts in `folder`, and then these messages, to the file `target`.

    Parts of a process that was killed are included (REC-124).
    last: topic, nanoseconds since 1970, message. earlier: folders whose parts come
    before. steps: how many the turns of the last attempt must have in all; None accepts
    any number. level: of zstd's compression. Raises OSError, and then leaves `target`
    as it was.
    """
    parts = [part for source in (*earlier, folder) for part in parts_of(source)]
    draft = target.with_suffix(DRAFT_SUFFIX)
    try:
        with _open_new(draft) as file:
            os.fchmod(file.fileno(), 0o600)
            summary = _write_all(_RecordingWriter(file, level), parts, last, steps)
            file.flush()
            os.fsync(file.fileno())
        draft.replace(target)
    except OSError:
        draft.unlink(missing_ok=True)
        raise
    sync_folder(target.parent)
    return summary


def _open_new(draft: Path) -> BinaryIO:
    """Open the draft for writing, in a folder that is made if it is missing."""
    try:
        return draft.open("wb")
    except FileNotFoundError:
        # An episode that was never begun has no folder yet: no simulator made one.
        draft.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        return draft.open("wb")


def _write_all(
    writer: _RecordingWriter,
    parts: Sequence[Path],
    last: Sequence[tuple[str, int, Message]],
    steps: int | None,
) -> RecordingSummary:
    figures = _Figures()
    for part in parts:
        try:
            for topic, at_ns, message in read_part(part):
                figures.add(topic, message)
                writer.add(topic, at_ns, json_of(message))
        except msgspec.MsgspecError as error:
            raise OSError(f"{part.name} has been damaged") from error
    if steps is not None and figures.steps != steps:
        raise OSError("its parts do not have the turns of the result")
    for topic, at_ns, said in last:
        writer.add(topic, at_ns, encode_message(said))
    writer.finish()
    return figures.summary(writer.digest, writer.size)


def sync_folder(folder: Path) -> None:
    """Flush the folder, so that the name of a new file survives a crash."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


class _Figures:
    """Collects the summary while messages are copied, so that none is read twice."""

    def __init__(self) -> None:
        self._first: str | None = None
        self._last: str | None = None
        self._think: list[float] = []
        self._simulate: list[float] = []
        self.steps: int | None = None  # in the last attempt; None before its turns

    def add(self, topic: str, message: Turn | bytes) -> None:
        if topic == "/turn":
            turn: Turn | _TurnFigures
            turn = message if isinstance(message, Turn) else _TURN.decode(message)
            self._last = turn.state_digest
            self.steps = (self.steps or 0) + turn.steps
            self._think.append(turn.think_ms)
            self._simulate.append(turn.simulate_ms)
        elif topic == "/attempt":
            event = _ATTEMPT.decode(json_of(message))
            if event.event == "started":
                self._first = self._first or event.state_digest
                self.steps = None
                if not self._think:
                    self._last = event.state_digest

    def summary(self, sha256: str, size: int) -> RecordingSummary:
        latency = Latency(*_quantiles(self._think), *_quantiles(self._simulate))
        return RecordingSummary(
            sha256, size, len(self._think), self._first, self._last, latency
        )


def _quantiles(values: list[float]) -> tuple[float, float]:
    """The median and the 99th percentile, each one of the values."""
    if not values:
        return 0.0, 0.0
    values.sort()
    last = len(values) - 1
    return values[last // 2], values[-(-last * 99 // 100)]


class _RecordingWriter:
    """Writes MCAP: chunks with an index each, and the summary that finds them."""

    def __init__(self, file: BinaryIO, level: int) -> None:
        self._file = file
        self._compressor = _COMPRESSORS.of(level)
        self._hash = hashlib.sha256()
        self._at = 0  # bytes written
        self._topics = {topic: number for number, topic in enumerate(CHANNELS, 1)}
        self._counts: dict[int, int] = {}
        self._chunk_indexes: list[bytes] = []
        self._spans: list[tuple[int, int]] = []  # first and last time of each chunk
        self._begin_chunk()
        self._write(MAGIC)
        self._write(record(HEADER, text("") + text("proctor")))
        for topic, channel in self._topics.items():
            self._declare(topic, channel)

    @property
    def size(self) -> int:
        return self._at

    @property
    def digest(self) -> str:
        return self._hash.hexdigest()

    def add(self, topic: str, at_ns: int, message: bytes) -> None:
        """Append a message, whose JSON is `message`, to the chunk."""
        channel = self._topics.get(topic)
        if channel is None:
            channel = self._topics[topic] = len(self._topics) + 1
            self._end_chunk()
            self._declare(topic, channel)
        count = self._counts.get(channel, 0)
        self._counts[channel] = count + 1
        self._places.setdefault(channel, []).extend((at_ns, len(self._chunk)))
        length = MESSAGE_HEAD.size + len(message)
        self._chunk += WHOLE_HEAD.pack(MESSAGE, length, channel, count, at_ns, at_ns)
        self._chunk += message
        if len(self._chunk) >= CHUNK_BYTES:
            self._end_chunk()

    def finish(self) -> None:
        """Write the last chunk and the summary; no message can be added afterwards."""
        self._end_chunk()
        self._write(record(DATA_END, struct.pack("<I", 0)))
        start, offsets = self._at, b""
        for kind, records in (
            (SCHEMA, [schema_record(*item) for item in self._topics.items()]),
            (CHANNEL, [channel_record(*item) for item in self._topics.items()]),
            (STATISTICS, [self._statistics()]),
            (CHUNK_INDEX, self._chunk_indexes),
        ):
            group_start = self._at
            self._write(b"".join(records))
            if self._at > group_start:
                group = struct.pack("<BQQ", kind, group_start, self._at - group_start)
                offsets += record(SUMMARY_OFFSET, group)
        offsets_start = self._at
        self._write(offsets)
        self._write(record(FOOTER, struct.pack("<QQI", start, offsets_start, 0)))
        self._write(MAGIC)

    def _begin_chunk(self) -> None:
        self._chunk = bytearray()
        # channel → time and offset of each message of the chunk, alternating.
        self._places: dict[int, list[int]] = {}

    def _end_chunk(self) -> None:
        if not self._chunk:
            return
        packed = self._compressor.compress(self._chunk)
        times = [at for entries in self._places.values() for at in entries[::2]]
        span, size = (min(times), max(times)), len(self._chunk)
        self._spans.append(span)
        start = self._at
        self._write(
            record(
                CHUNK,
                struct.pack("<QQQI", *span, size, zlib.crc32(self._chunk))
                + text("zstd")
                + struct.pack("<Q", len(packed))
                + packed,
            )
        )
        length, places = self._at - start, b""
        for channel, entries in self._places.items():
            places += struct.pack("<HQ", channel, self._at)
            pairs = struct.pack(f"<{len(entries)}Q", *entries)
            content = struct.pack("<HI", channel, len(pairs)) + pairs
            self._write(record(MESSAGE_INDEX, content))
        self._chunk_indexes.append(
            record(
                CHUNK_INDEX,
                struct.pack("<QQQQ", *span, start, length)
                + struct.pack("<I", len(places))
                + places
                + struct.pack("<Q", self._at - start - length)
                + text("zstd")
                + struct.pack("<QQ", len(packed), size),
            )
        )
        self._begin_chunk()

    def _declare(self, topic: str, number: int) -> None:
        self._write(schema_record(topic, number) + channel_record(topic, number))

    def _statistics(self) -> bytes:
        channels, chunks = len(self._topics), len(self._chunk_indexes)
        counts = b"".join(struct.pack("<HQ", *item) for item in self._counts.items())
        first = min((first for first, _ in self._spans), default=0)
        last = max((last for _, last in self._spans), default=0)
        content = struct.pack(
            "<QHIIIIQQI",
            *(sum(self._counts.values()), channels, channels, 0, 0, chunks),
            *(first, last, len(counts)),
        )
        return record(STATISTICS, content + counts)

    def _write(self, content: bytes) -> None:
        self._file.write(content)
        self._hash.update(content)
        self._at += len(content)
