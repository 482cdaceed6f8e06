"""The files of an image or an archive as a tree in memory, and then on the disk.

Layers are applied to the tree, not to a folder: no path of an archive is opened while
it is read, so that no link of one can lead a later entry anywhere. When the tree is
complete it is written: folders first, files into folders that were made here, and links
last. Contents wait in a scratch folder under numbers.
"""

from __future__ import annotations

import os
import tarfile
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeAlias

from reference_platform.images.bounded_archives import (
    ForwardReader,
    InvalidArchive,
)

_NAME_BYTES_MAX = 255
_PATH_BYTES_MAX = 4095
_DEPTH_MAX = 128
_LINKS_FOLLOWED_MAX = 40
_WHITEOUT, _OPAQUE = ".wh.", ".wh..wh..opq"


@dataclass(slots=True)
class File:
    """content: its number in the scratch folder. Hard links share the object."""

    content: int
    is_program: bool


@dataclass(slots=True)
class Link:
    """A symbolic link; what it names is never looked at while an archive is read."""

    target: str


@dataclass(slots=True)
class Folder:
    """Its entries by name."""

    entries: dict[str, Node] = field(default_factory=dict)


Node: TypeAlias = File | Link | Folder


@dataclass(slots=True)
class Remarks:
    """Counts the things that were left out; `texts` is for the log."""

    devices: int = 0
    privileged: int = 0

    def texts(self) -> list[str]:
        texts = []
        if self.devices:
            texts.append(f"Devices and pipes were left out: {self.devices}.")
        if self.privileged:
            texts.append(
                f"The setuid and setgid bits of files were removed: {self.privileged}."
            )
        return texts


class FileTree:
    """The tree; scratch: an empty folder for contents."""

    def __init__(self, scratch: Path) -> None:
        self.root = Folder()
        self.remarks = Remarks()
        self._scratch = scratch
        self._contents = 0

    def add(self, entry: tarfile.TarInfo, reader: ForwardReader) -> None:
        """Apply an entry of a layer. Raises InvalidArchive."""
        path = _parts(entry.name)
        if not path:
            return
        folder, name = self._folder(path[:-1]), path[-1]
        if name == _OPAQUE:
            folder.entries.clear()
        elif name.startswith(_WHITEOUT):
            folder.entries.pop(name.removeprefix(_WHITEOUT), None)
        elif entry.isdir():
            if not isinstance(folder.entries.get(name), Folder):
                folder.entries[name] = Folder()
        elif entry.issym():
            self.add_link(path, entry.linkname)
        elif entry.islnk():
            folder.entries[name] = self._linked(entry.linkname)
        elif entry.issparse():
            raise InvalidArchive(f"{_shown(entry.name)} is a sparse file.")
        elif entry.isreg():
            self.remarks.privileged += bool(entry.mode & 0o6000)
            number = self._new_content()
            with (self._scratch / str(number)).open("xb") as file:
                reader.copy(entry.size, file)
            folder.entries[name] = File(number, bool(entry.mode & 0o111))
        else:
            self.remarks.devices += 1

    def add_link(self, path: list[str], target: str) -> None:
        """Raises InvalidArchive."""
        if not target or "\0" in target or len(os.fsencode(target)) > _PATH_BYTES_MAX:
            raise InvalidArchive(f"The link {_shown('/'.join(path))} names no path.")
        self._folder(path[:-1]).entries[path[-1]] = Link(target)

    def make_folders(self, names: Iterable[str]) -> None:
        """Empty folders of the root, whatever the archive has there."""
        for name in names:
            self.root.entries[name] = Folder()

    def write(self, target: Path) -> None:
        """Write the tree as a new folder. The tree cannot be used afterwards."""
        written: dict[int, Path] = {}
        links: list[tuple[Path, str]] = []
        waiting = [(target, self.root)]
        while waiting:
            place, folder = waiting.pop()
            place.mkdir(mode=0o755)
            for name, node in folder.entries.items():
                path = place / name
                if isinstance(node, Folder):
                    waiting.append((path, node))
                elif isinstance(node, Link):
                    links.append((path, node.target))
                elif (first := written.get(node.content)) is not None:
                    path.hardlink_to(first)
                else:
                    written[node.content] = path
                    content = self._scratch / str(node.content)
                    content.chmod(0o755 if node.is_program else 0o644)
                    content.rename(path)
        for path, link_target in links:
            path.symlink_to(link_target)

    def _new_content(self) -> int:
        self._contents += 1
        return self._contents

    def _folder(self, path: list[str]) -> Folder:
        """The folder of a path, made if it is missing. Raises InvalidArchive.

        Links are followed in the tree: a link of the image may name `usr/lib` as `lib`.
        """
        folders, left, followed = [self.root], list(reversed(path)), 0
        while left:
            name = left.pop()
            if name == "..":
                folders = folders[:-1] or [self.root]
                continue
            node = folders[-1].entries.get(name)
            if isinstance(node, Link):
                followed += 1
                if followed > _LINKS_FOLLOWED_MAX:
                    raise InvalidArchive(f"{_shown('/'.join(path))} is behind a loop.")
                if node.target.startswith("/"):
                    folders = [self.root]
                parts = [p for p in node.target.split("/") if p not in ("", ".")]
                left.extend(reversed(parts))
                continue
            if not isinstance(node, Folder):
                node = folders[-1].entries[name] = Folder()
            folders.append(node)
            if len(folders) > _DEPTH_MAX:
                raise InvalidArchive(f"{_shown('/'.join(path))} is too deep.")
        return folders[-1]

    def _linked(self, target: str) -> Node:
        path = _parts(target)
        node = self._folder(path[:-1]).entries.get(path[-1]) if path else None
        if node is None or isinstance(node, Folder):
            raise InvalidArchive(f"A hard link names {_shown(target)}, no file.")
        return node


def _parts(name: str) -> list[str]:
    """The names of a path. Raises InvalidArchive for one that no image needs."""
    parts = [part for part in name.split("/") if part not in ("", ".")]
    if ".." in parts:
        raise InvalidArchive(f"The path {_shown(name)} leaves its folder.")
    if "\0" in name or len(os.fsencode(name)) > _PATH_BYTES_MAX:
        raise InvalidArchive(f"The path {_shown(name)} is too long or has a NUL.")
    if any(len(os.fsencode(part)) > _NAME_BYTES_MAX for part in parts):
        raise InvalidArchive(f"The path {_shown(name)} has a name that is too long.")
    return parts


def _shown(name: str) -> str:
    return ascii(name[:120])
