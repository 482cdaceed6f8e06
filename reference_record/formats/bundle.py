"""A record on disk: an archive or a directory, read within bounds.

Both give the same files. A reader never extracts anything, follows no link, and opens
nothing whose name `names.check_name` did not pass.
"""

from __future__ import annotations

import hashlib
import os
import stat
import zlib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from itertools import islice
from pathlib import Path
from typing import BinaryIO

from reference_record.broken import ARCHIVE, BrokenRecord
from reference_record.formats.archive import BLOCK_BYTES, ArchiveEntry, read_entries
from reference_record.formats.names import (
    FILES_MAX,
    FIXED,
    MOVE_OUT,
    RECORDINGS,
    STATEMENT,
    check_count,
    check_name,
    order,
    printable_name,
)

FOLDERS = ("episodes", "verdicts")
_RECORDING_MAGIC = b"\x89MCAP0\r\n"
# One run, all runs, and the files of the server around them.
_RECORDINGS_OF_SERVERS = ("*.mcap", "run_*/*.mcap", "*.records/run_*/*.mcap")


class Bundle:
    """The files of a record. sizes: name → bytes, in the order of an archive."""

    def __init__(self, sizes: Mapping[str, int]) -> None:
        check_count(list(sizes))
        self.sizes = sizes

    @contextmanager
    def open(self, name: str) -> Iterator[BinaryIO]:
        """The file as a stream that begins at its first byte."""
        raise NotImplementedError

    def blocks(self, name: str) -> Iterator[bytes]:
        """The bytes of a file; raises BrokenRecord when they are not all there."""
        left = self.sizes[name]
        with self.open(name) as file:
            while left:
                block = file.read(min(left, BLOCK_BYTES))
                if not block:
                    raise BrokenRecord(name, "REC-002", "the file is cut")
                left -= len(block)
                yield block

    def read(self, name: str) -> bytes:
        return b"".join(self.blocks(name))

    def sha256(self, name: str) -> str:
        """The digest of a file in hexadecimal digits; raises BrokenRecord."""
        digest, crc = hashlib.sha256(), 0
        for block in self.blocks(name):
            digest.update(block)
            crc = zlib.crc32(block, crc)
        self._check_crc(name, crc)
        return digest.hexdigest()

    def _check_crc(self, name: str, crc: int) -> None:
        pass


class _Archive(Bundle):
    def __init__(self, path: Path, entries: list[ArchiveEntry]) -> None:
        super().__init__({entry.name: entry.size for entry in entries})
        self._path = path
        self._entries = {entry.name: entry for entry in entries}

    @contextmanager
    def open(self, name: str) -> Iterator[BinaryIO]:
        with self._path.open("rb") as file:
            file.seek(self._entries[name].data_offset)
            yield file

    def _check_crc(self, name: str, crc: int) -> None:
        # REC-002: other programs refuse an archive whose checksum is wrong.
        if crc != self._entries[name].crc32:
            raise BrokenRecord(name, "REC-002", "its CRC-32 is not that of its bytes")


class _Directory(Bundle):
    def __init__(self, path: Path) -> None:
        paths = dict(islice(_files_of(path), FILES_MAX + 1))
        super().__init__({name: paths[name] for name in sorted(paths, key=order)})
        self._path = path

    @contextmanager
    def open(self, name: str) -> Iterator[BinaryIO]:
        # A file that became a link since it was listed is not opened.
        flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
        with os.fdopen(os.open(self._path / name, flags), "rb") as file:
            yield file


def open_bundle(path: Path) -> Bundle:
    """The record at a path; raises BrokenRecord, and OSError if it cannot be read."""
    if path.is_dir():
        _check_is_record(path)
        return _Directory(path)
    status = path.stat()
    if not stat.S_ISREG(status.st_mode):
        raise BrokenRecord(ARCHIVE, "REC-003", "this is neither a file nor a directory")
    with path.open("rb") as file:
        if file.read(len(_RECORDING_MAGIC)) == _RECORDING_MAGIC:
            detail = "this is no zip archive"
            raise BrokenRecord(ARCHIVE, "REC-002", detail, way_out=RECORDINGS)
        return _Archive(path, read_entries(file, status.st_size))


def _files_of(root: Path) -> Iterator[tuple[str, int]]:
    """REC-003: name and size of each file; a record has two folders and no links."""
    for folder in (root, *(root / name for name in FOLDERS)):
        if not folder.is_dir() or (folder.is_symlink() and folder != root):
            continue
        with os.scandir(folder) as entries:
            for entry in entries:
                name = Path(entry.path).relative_to(root).as_posix()
                status = entry.stat(follow_symlinks=False)
                if stat.S_ISDIR(status.st_mode) and name in FOLDERS:
                    continue
                if not stat.S_ISREG(status.st_mode):
                    detail = "a record's directory has regular files alone"
                    # No program puts links and devices there by itself.
                    way_out = MOVE_OUT if stat.S_ISDIR(status.st_mode) else ""
                    raise BrokenRecord(
                        printable_name(name), "REC-003", detail, way_out=way_out
                    )
                check_name(name, status.st_size)
                yield name, status.st_size


def _check_is_record(folder: Path) -> None:
    """REC-001: nothing is said on the files of a folder that is another one."""
    if (folder / STATEMENT).exists():
        return
    for inner in sorted(folder.iterdir()):
        if (inner / STATEMENT).is_file():
            detail = "a record's directory has regular files alone"
            way_out = "The record is in that folder: name it in place of this one."
            name = printable_name(inner.name)
            raise BrokenRecord(name, "REC-003", detail, way_out=way_out)
    is_kept = any(next(folder.glob(names), None) for names in _RECORDINGS_OF_SERVERS)
    way_out = RECORDINGS if is_kept else ""
    if not is_kept and not any((folder / name).exists() for name in FIXED):
        way_out = "This folder is not a record: name another."
    raise BrokenRecord(STATEMENT, "REC-001", "this file is missing", way_out=way_out)
