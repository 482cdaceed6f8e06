"""The one form of zip that an archive of a record has (REC-002).

Every byte follows from the names and contents of the files: stored entries in a fixed
order, constant headers, no gaps, nothing before or after. So a reader needs no zip
library, which would have to choose between two directories that disagree, and a changed
byte is found wherever it stands.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import BinaryIO

from reference_record.broken import ARCHIVE, UNPACK, BrokenRecord, UnusableRecord
from reference_record.formats.names import (
    ARCHIVE_BYTES_MAX,
    FILES_MAX,
    NAME_BYTES_MAX,
    check_name,
    order,
    printable_name,
)

BLOCK_BYTES = 2**20
# Version 1.0, no flags, stored, 1980-01-01 00:00:00; then CRC-32, twice the size, the
# length of the name, no extra field.
_LOCAL = struct.Struct("<4sHHHHHIIIHH")
_CENTRAL = struct.Struct("<4sHHHHHHIIIHHHHHII")
_END = struct.Struct("<4sHHHHIIH")
_LOCAL_MAGIC, _CENTRAL_MAGIC, _END_MAGIC = b"PK\x03\x04", b"PK\x01\x02", b"PK\x05\x06"
_CONSTANTS = (10, 0, 0, 0, 0x21)
_METHOD = 2  # the place of the compression among them


@dataclass(frozen=True, slots=True)
class ArchiveEntry:
    """A file in an archive; offset: of its local header."""

    name: str
    size: int
    crc32: int
    offset: int = 0

    @property
    def data_offset(self) -> int:
        return self.offset + _LOCAL.size + len(self.name)


@dataclass(frozen=True, slots=True)
class Content:
    """The content of one file. blocks: yields the bytes, anew with every call."""

    size: int
    crc32: int
    blocks: Callable[[], Iterable[bytes]]


def archive_size(contents: Iterable[tuple[str, Content]]) -> int:
    """The number of bytes of the archive; raises UnusableRecord if there is none."""
    total = _END.size
    for name, content in contents:
        total += _LOCAL.size + _CENTRAL.size + 2 * len(name) + content.size
    if total > ARCHIVE_BYTES_MAX:
        raise UnusableRecord("a record of 4 GiB or more is a directory, not an archive")
    return total


def stream_archive(contents: Iterable[tuple[str, Content]]) -> Iterator[bytes]:
    """REC-002: the bytes of the archive, block by block.

    Raises UnusableRecord when a file no longer has the bytes that were announced.
    """
    ordered = sorted(contents, key=lambda item: order(item[0]))
    archive_size(ordered)
    offset, entries = 0, []
    for name, content in ordered:
        entry = ArchiveEntry(name, content.size, content.crc32, offset)
        entries.append(entry)
        yield _local(entry)
        yield from _checked_blocks(entry, content)
        offset = entry.data_offset + entry.size
    yield _directory(entries, offset)


def _checked_blocks(entry: ArchiveEntry, content: Content) -> Iterator[bytes]:
    size = crc = 0
    for block in content.blocks():
        size, crc = size + len(block), zlib.crc32(block, crc)
        if size <= entry.size:
            yield block
    if (size, crc) != (entry.size, entry.crc32):
        raise UnusableRecord(f"{entry.name} changed while it was read")


def read_entries(file: BinaryIO, size: int) -> list[ArchiveEntry]:
    """REC-002: the files of an archive of `size` bytes; raises BrokenRecord.

    Reads the headers alone: the contents are judged by who reads them.
    """
    entries: list[ArchiveEntry] = []
    position = 0
    while True:
        file.seek(position)
        magic = file.read(4)
        if magic != _LOCAL_MAGIC:
            break
        entry = _read_local(file, position)
        _check_next(entries, entry, size)
        entries.append(entry)
        position = entry.data_offset + entry.size
    if not entries:
        detail = "this is no zip archive" if magic else "the file is empty"
        raise BrokenRecord(ARCHIVE, "REC-002", detail)
    _check_directory(file, entries, position)
    return entries


def _read_local(file: BinaryIO, position: int) -> ArchiveEntry:
    header = _LOCAL_MAGIC + file.read(_LOCAL.size - 4)
    if len(header) < _LOCAL.size:
        raise BrokenRecord(ARCHIVE, "REC-002", "it ends in the header of a file")
    _, *constants, crc, size, size_again, name_length, extra = _LOCAL.unpack(header)
    name_bytes = file.read(min(name_length, NAME_BYTES_MAX))
    try:
        name = name_bytes.decode("ascii")
    except UnicodeDecodeError:
        name = "?"
    if tuple(constants) != _CONSTANTS or extra or size != size_again:
        is_compressed = constants[_METHOD] != 0
        detail = (
            "it is compressed; a record has its files as they are"
            if is_compressed
            else f"the header at byte {position} is not as a record has it"
        )
        file_name = printable_name(name) or ARCHIVE
        raise BrokenRecord(file_name, "REC-002", detail, way_out=UNPACK)
    if len(name_bytes) < name_length:
        detail = f"the name of the file at byte {position} is cut or too long"
        raise BrokenRecord(ARCHIVE, "REC-002", detail)
    check_name(name, size)
    return ArchiveEntry(name, size, crc, position)


def _check_next(entries: list[ArchiveEntry], entry: ArchiveEntry, size: int) -> None:
    if len(entries) >= FILES_MAX:
        raise BrokenRecord(ARCHIVE, "REC-030", f"at most {FILES_MAX} files are read")
    if entries and order(entries[-1].name) >= order(entry.name):
        twice = entries[-1].name == entry.name
        detail = "it stands twice" if twice else "it stands out of order"
        raise BrokenRecord(entry.name, "REC-002", detail, way_out=UNPACK)
    if entry.data_offset + entry.size > size:
        raise BrokenRecord(
            entry.name, "REC-002", "the archive ends inside of this file"
        )


def _check_directory(
    file: BinaryIO, entries: list[ArchiveEntry], position: int
) -> None:
    expected = _directory(entries, position)
    file.seek(position)
    actual = file.read(len(expected) + 1)
    if actual == expected:
        return
    way_out = UNPACK
    if len(actual) < len(expected) and expected.startswith(actual):
        detail, way_out = "it is cut: its directory is not whole", ""
    elif actual.startswith(expected):
        detail = "bytes stand behind its end"
    else:
        detail = f"its directory, at byte {position}, does not fit its files"
    raise BrokenRecord(ARCHIVE, "REC-002", detail, way_out=way_out)


def _local(entry: ArchiveEntry) -> bytes:
    sizes = (entry.crc32, entry.size, entry.size, len(entry.name), 0)
    return _LOCAL.pack(_LOCAL_MAGIC, *_CONSTANTS, *sizes) + entry.name.encode()


def _directory(entries: list[ArchiveEntry], offset: int) -> bytes:
    central = b"".join(
        _CENTRAL.pack(
            *(_CENTRAL_MAGIC, 10, *_CONSTANTS),
            *(entry.crc32, entry.size, entry.size, len(entry.name)),
            *(0, 0, 0, 0, 0, entry.offset),
        )
        + entry.name.encode()
        for entry in entries
    )
    count = len(entries)
    return central + _END.pack(_END_MAGIC, 0, 0, count, count, len(central), offset, 0)
