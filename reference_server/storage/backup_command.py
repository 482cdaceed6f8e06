"""`proctor admin backup`: one command for everything that a server has to keep.

The database is copied first, as of one moment; what it names is on disk by then and
does not change any more, so the folders may be copied later, while the server runs.
A file has the name that the server looks for beside the database, wherever a setting
has placed it: a backup is restored by copying it there. Those that were elsewhere are
shown with their place.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from reference_record.command_line.click_commands import (
    Command,
    Options,
    argument,
    flag,
)
from reference_record.command_line.replaced_file import replacing
from reference_record.command_line.written_output import whole_or_gone
from reference_record.recordings.recording_file import DRAFT_SUFFIX
from reference_server.files.private_files import give_to_owner_of
from reference_server.storage import database_commands
from reference_server.storage.connection.database import StoreFailed


@dataclass(frozen=True, slots=True)
class KeptFiles:
    """All that a server keeps.

    database: its name in the backup. folder: of what is beside it. made: the name that
    a server without settings looks for there → a file or folder that each server makes
    at its start. others: those that it may have. storage: the URL of what has its
    recordings instead of a folder.
    """

    database_url: str
    database: str
    folder: Path
    made: Mapping[str, Path]
    others: Mapping[str, Path]
    storage: str = ""

    def named(self) -> Iterator[tuple[str, Path]]:
        """The name in the backup of all that is there, and where it is."""
        for name, path in [*self.made.items(), *self.others.items()]:
            if path.exists():
                yield path.name if self.is_beside(path) else name, path

    @property
    def owned(self) -> Path:
        """The folder whose owner the copies get.

        There is none beside the database where every file is elsewhere.
        """
        return self.folder if self.folder.exists() else Path()

    def is_beside(self, path: Path) -> bool:
        return path.parent.resolve() == self.folder.resolve()


def backup_command() -> Command:
    """The command of `proctor admin`; `do_with_kept` is its function."""
    prune = flag(
        "--prune", "also remove from the folder what the server has deleted since"
    )
    return Command(
        "backup",
        "copy the database, secrets, tokens, recordings and records that were handed "
        "in to a folder, also while the server runs; again, what is new",
        [argument("folder", "", type=Path), prune],
        do_with_kept=back_up,
    )


def back_up(kept: KeptFiles, args: Options) -> None:
    """Print what was copied. Raises StoreFailed and OSError."""
    target: Path = args.folder
    _check(target, kept)
    with whole_or_gone(target):
        _make_folder(target, kept.owned)
        with replacing(target / kept.database, is_private=True) as draft:
            database_commands.copy_database(kept.database_url, draft)
            give_to_owner_of(kept.owned, draft)
        print(f"{kept.database}: {(target / kept.database).stat().st_size} bytes")
        for name, path in kept.named():
            text = name
            if path.is_dir():
                text += f": {_copy_folder(path, target / name, prune=args.prune)}"
            else:
                _copy(path, target / name)
            print(text if kept.is_beside(path) else f"{text} (of {path.absolute()})")
        if kept.storage:
            print(
                "not copied: the recordings and the records that were handed in, which "
                f"are in {kept.storage}; back them up there"
            )


def _check(target: Path, kept: KeptFiles) -> None:
    """Raises StoreFailed where a backup would lack a file, or be copied into itself."""
    for path in kept.made.values():
        if not path.exists():
            raise StoreFailed(
                f"there is no {path.absolute()}, which a server makes when it starts: "
                "give this command in the folder of the server and with its settings"
            )
    for _, path in kept.named():
        folder = path if path.is_dir() else path.parent
        if target.resolve() == folder.resolve():
            raise StoreFailed(f"{target} is a folder of the server itself")
        if path.is_dir() and target.resolve().is_relative_to(path.resolve()):
            raise StoreFailed(f"{target} is inside {path}, which is to be copied")


def _copy_folder(source: Path, target: Path, *, prune: bool) -> str:
    """Copies what is new or has changed; returns how much that was."""
    _make_folder(target, source)
    there, copied, removed = set(), 0, 0
    for path in _files_below(source):
        copy = target / path.relative_to(source)
        there.add(copy)
        # A file may be finished, joined with others or removed meanwhile.
        with suppress(FileNotFoundError):
            if not _is_same(path, copy):
                _make_folder(copy.parent, path.parent)
                _copy(path, copy)
                copied += 1
    if prune and not there and any(_files_below(target)):
        raise StoreFailed(
            f"{source} has no file, so --prune would remove all of {target}: look "
            "whether its disk is there, or remove the folder yourself"
        )
    if prune:
        for copy in [path for path in _files_below(target) if path not in there]:
            copy.unlink()
            removed += 1
            with suppress(OSError):  # others are in it
                copy.parent.rmdir()
    text = f"{len(there)} files, {copied} of them new"
    return f"{text}; {removed} removed" if prune else text


def _make_folder(folder: Path, of: Path) -> None:
    """With the owner of the folder that is copied."""
    if not folder.exists():
        folder.mkdir(mode=0o700, parents=True)
        give_to_owner_of(of, folder)


def _files_below(folder: Path) -> Iterator[Path]:
    return (
        path
        for path in folder.rglob("*")
        if path.is_file() and path.suffix != DRAFT_SUFFIX
    )


def _is_same(path: Path, copy: Path) -> bool:
    if not copy.exists():
        return False
    before, after = path.stat(), copy.stat()
    same_time = before.st_mtime_ns == after.st_mtime_ns
    return same_time and before.st_size == after.st_size


def _copy(path: Path, copy: Path) -> None:
    """With its times, rights and owner; the old copy stays if this is interrupted."""
    with replacing(copy, is_private=True) as draft:
        shutil.copy2(path, draft)
        give_to_owner_of(path, draft)
