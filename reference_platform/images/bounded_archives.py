"""Reads hostile archives: every read is bounded, and goes forward.

tarfile reads a header of any size, and jumps where a header says. Behind these
readers neither is possible. They know bytes, and nothing of what an archive means.
"""

from __future__ import annotations

import gzip
import hashlib
import io
import math
import tarfile
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import BinaryIO, Protocol, cast

import zstandard

# A header of tar, with extended attributes, is smaller; contents are read in parts.
READ_BYTES_MAX = 2**20
# As `zstd --long` needs.
_WINDOW_BYTES_MAX = 2**27


class InvalidArchive(Exception):
    """The archive is refused; the message is for who has uploaded it."""


class Readable(Protocol):
    """A source of bytes."""

    def read(self, size: int, /) -> bytes: ...


class Budget:
    """How many bytes and entries all parts of an archive may unpack to."""

    def __init__(self, max_bytes: int, max_entries: int) -> None:
        self._max_bytes, self._bytes = max_bytes, 0
        self._max_entries, self._entries = max_entries, 0

    def spend_bytes(self, count: int) -> None:
        """Raises InvalidArchive."""
        self._bytes += count
        if self._bytes > self._max_bytes:
            raise InvalidArchive(
                f"It unpacks to more than {self._max_bytes} bytes, the most that this "
                "platform takes."
            )

    def spend_entry(self) -> None:
        """Raises InvalidArchive."""
        self._entries += 1
        if self._entries > self._max_entries:
            raise InvalidArchive(
                f"It has more than {self._max_entries} files, the most that this "
                "platform takes."
            )


class ForwardReader(io.RawIOBase):
    """A stream that is read once, from its begin to its end, within a budget."""

    def __init__(self, source: Readable, budget: Budget) -> None:
        self._source = source
        self._budget = budget
        self._position = 0
        self._header_end: float = math.inf

    def readable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    @property
    def position(self) -> int:
        """How many bytes were read."""
        return self._position

    def read(self, size: int = -1, /) -> bytes:
        """Exactly `size` bytes, less only at the end. Raises InvalidArchive."""
        if size < 0 or size > min(READ_BYTES_MAX, self._header_end - self._position):
            raise InvalidArchive("It has a header that is too large.")
        parts, left = [], size
        while left and (part := self._source.read(left)):
            parts.append(part)
            left -= len(part)
        self._budget.spend_bytes(size - left)
        self._position += size - left
        return b"".join(parts)

    @contextmanager
    def reading_header(self) -> Iterator[None]:
        """Bounds what is read inside: later versions of tarfile read it in pieces."""
        self._header_end = self._position + READ_BYTES_MAX
        yield
        self._header_end = math.inf

    def seek(self, offset: int, whence: int = io.SEEK_SET, /) -> int:
        """Forward only. Raises InvalidArchive."""
        if (offset, whence) == (0, io.SEEK_CUR):  # where it is
            return self._position
        if whence != io.SEEK_SET or offset < self._position:
            raise InvalidArchive("It has a header that points back.")
        while (left := offset - self._position) and self.read(
            min(left, READ_BYTES_MAX)
        ):
            pass
        return self._position

    def copy(self, size: int, target: BinaryIO) -> None:
        """The next bytes, all of them. Raises InvalidArchive."""
        while size:
            part = self.read(min(size, READ_BYTES_MAX))
            if not part:
                raise InvalidArchive("It is cut off.")
            target.write(part)
            size -= len(part)


class DigestReader:
    """The bytes of a file from an offset on, and their SHA-256."""

    def __init__(self, file: BinaryIO, offset: int, size: int) -> None:
        file.seek(offset)
        self._file, self._left = file, size
        self._hash = hashlib.sha256()

    def read(self, size: int, /) -> bytes:
        part = self._file.read(min(size, self._left, READ_BYTES_MAX))
        self._left -= len(part)
        self._hash.update(part)
        return part

    def check(self, digest: str) -> None:
        """Read what is left. Raises InvalidArchive unless it has this digest."""
        while self.read(READ_BYTES_MAX):
            pass
        if f"sha256:{self._hash.hexdigest()}" != digest:
            raise InvalidArchive(f"{digest} has another content than its name says.")


def decompressed(source: DigestReader) -> Readable:
    """A stream that is compressed with gzip or zstd, or not at all, by its begin."""
    begin = source.read(4)
    joined = _Joined(begin, source)
    if begin[:2] == b"\x1f\x8b":
        return gzip.GzipFile(fileobj=cast("BinaryIO", joined), mode="rb")
    if begin == b"\x28\xb5\x2f\xfd":
        reader = zstandard.ZstdDecompressor(max_window_size=_WINDOW_BYTES_MAX)
        return reader.stream_reader(cast("BinaryIO", joined), read_across_frames=True)
    return joined


@contextmanager
def archive_errors() -> Iterator[None]:
    """Raises InvalidArchive for the errors of libraries at a broken archive."""
    try:
        yield
    except (
        EOFError,
        OverflowError,
        RecursionError,
        NotImplementedError,
        ValueError,
        gzip.BadGzipFile,
        tarfile.TarError,
        zipfile.BadZipFile,
        zlib.error,
        zstandard.ZstdError,
    ) as error:
        raise InvalidArchive(f"It cannot be read: {str(error)[:200]}.") from error


def _opened(reader: ForwardReader) -> tarfile.TarFile:
    with reader.reading_header():  # the first one
        return tarfile.open(fileobj=reader, mode="r:")


def tar_entries(
    source: Readable, budget: Budget
) -> Iterator[tuple[tarfile.TarInfo, ForwardReader]]:
    """Each entry of a tar file; its content is read before the next, or skipped."""
    reader = ForwardReader(source, budget)
    with _opened(reader) as archive:
        entry = archive.next()
        while entry is not None:
            vars(archive)["members"].clear()  # else a million entries are kept
            budget.spend_entry()
            yield entry, reader
            reader.seek(archive.offset)
            with reader.reading_header():
                entry = archive.next()


class _Joined:
    """The bytes that were read already, and then the rest."""

    def __init__(self, begin: bytes, rest: DigestReader) -> None:
        self._begin, self._rest = begin, rest

    def read(self, size: int = READ_BYTES_MAX, /) -> bytes:
        if self._begin:
            part, self._begin = self._begin[:size], self._begin[size:]
            return part
        return self._rest.read(size)
