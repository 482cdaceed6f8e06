"""`proctor admin backup`: one command for everything that a server has to keep.

The database is copied first, as of one moment; what it names is on disk by then and
does not change any more, so the folders may be copied later, while the server runs.
The names are those beside a SQLite file: a backup is restored by copying it there.
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
from reference_record.recordings.recording_file import DRAFT_SUFFIX
from reference_server.storage import database_commands
from reference_server.storage.connection.database import StoreFailed

UNFINISHED = ".new"


@dataclass(frozen=True, slots=True)
class KeptFiles:
    """All that a server keeps; None for what is in memory alone.

    database: its name in the backup. files, folders: ending of the name → where it is.
    """

    database_url: str
    database: str
    files: Mapping[str, Path | None]
    folders: Mapping[str, Path | None]


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
    target.mkdir(mode=0o700, parents=True, exist_ok=True)
    draft = target / f"{kept.database}{UNFINISHED}"
    draft.unlink(missing_ok=True)
    database_commands.copy_database(kept.database_url, draft)
    size = draft.stat().st_size
    draft.replace(target / kept.database)
    print(f"{kept.database}: {size} bytes")
    for ending, path in kept.files.items():
        if path is not None and path.exists():
            _copy(path, target / f"{kept.database}.{ending}")
            print(f"{kept.database}.{ending}")
    for ending, folder in kept.folders.items():
        if folder is not None and folder.is_dir():
            name = f"{kept.database}.{ending}"
            print(f"{name}: {_copy_folder(folder, target / name, prune=args.prune)}")


def _check(target: Path, kept: KeptFiles) -> None:
    """Raises StoreFailed where a backup would be copied into itself."""
    used = [folder for folder in kept.folders.values() if folder is not None]
    used += [path.parent for path in kept.files.values() if path is not None]
    for folder in used:
        if target.resolve() == folder.resolve():
            raise StoreFailed(f"{target} is a folder of the server itself")
    for folder in filter(None, kept.folders.values()):
        if target.resolve().is_relative_to(folder.resolve()):
            raise StoreFailed(f"{target} is inside {folder}, which is to be copied")


def _copy_folder(source: Path, target: Path, *, prune: bool) -> str:
    """Copies what is new or has changed; returns how much that was."""
    target.mkdir(mode=0o700, exist_ok=True)
    there, copied, removed = set(), 0, 0
    for path in _files_below(source):
        copy = target / path.relative_to(source)
        there.add(copy)
        # A file may be finished, joined with others or removed meanwhile.
        with suppress(FileNotFoundError):
            if not _is_same(path, copy):
                copy.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
                _copy(path, copy)
                copied += 1
    if prune:
        for copy in [path for path in _files_below(target) if path not in there]:
            copy.unlink()
            removed += 1
            with suppress(OSError):  # others are in it
                copy.parent.rmdir()
    text = f"{len(there)} files, {copied} of them new"
    return f"{text}; {removed} removed" if prune else text


def _files_below(folder: Path) -> Iterator[Path]:
    return (
        path
        for path in folder.rglob("*")
        if path.is_file() and path.suffix not in (DRAFT_SUFFIX, UNFINISHED)
    )


def _is_same(path: Path, copy: Path) -> bool:
    if not copy.exists():
        return False
    before, after = path.stat(), copy.stat()
    same_time = before.st_mtime_ns == after.st_mtime_ns
    return same_time and before.st_size == after.st_size


def _copy(path: Path, copy: Path) -> None:
    """With its times and permissions; the old copy stays if this is interrupted."""
    draft = copy.with_name(copy.name + UNFINISHED)
    shutil.copy2(path, draft)
    draft.replace(copy)
