"""Reads code that was uploaded for a preset: a tar file, maybe compressed, or a zip."""

from __future__ import annotations

import stat
import tarfile
import zipfile
from pathlib import Path

from reference_platform.images.bounded_archives import (
    Budget,
    DigestReader,
    ForwardReader,
    InvalidArchive,
    decompressed,
    tar_entries,
)
from reference_platform.images.file_tree import FileTree

_LINK_BYTES_MAX = 4096
_ENCRYPTED = 0x1


def unpack_code(
    archive: Path, target: Path, scratch: Path, budget: Budget
) -> list[str]:
    """Write the files as a new folder. Returns remarks. Raises InvalidArchive."""
    tree = FileTree(scratch)
    if zipfile.is_zipfile(archive):
        _read_zip(archive, tree, budget)
    else:
        with archive.open("rb") as file:
            reader = DigestReader(file, 0, archive.stat().st_size)
            for entry, content in tar_entries(decompressed(reader), budget):
                tree.add(entry, content)
    if not tree.root.entries:
        raise InvalidArchive("It has no file.")
    tree.write(target)
    return tree.remarks.texts()


def _read_zip(archive: Path, tree: FileTree, budget: Budget) -> None:
    """Each entry as one of tar: the same rules hold for both."""
    with zipfile.ZipFile(archive) as file:
        for entry in file.infolist():
            budget.spend_entry()
            if entry.flag_bits & _ENCRYPTED:
                raise InvalidArchive("It is encrypted.")
            mode = entry.external_attr >> 16
            member = tarfile.TarInfo(entry.filename)
            member.mode, member.size = stat.S_IMODE(mode), entry.file_size
            with file.open(entry) as content:
                if entry.is_dir():
                    member.type = tarfile.DIRTYPE
                elif stat.S_ISLNK(mode):
                    member.type = tarfile.SYMTYPE
                    member.linkname = content.read(_LINK_BYTES_MAX).decode()
                elif stat.S_IFMT(mode) not in (0, stat.S_IFREG):
                    member.type = tarfile.FIFOTYPE
                tree.add(member, ForwardReader(content, budget))
