"""Copies all that a platform has to keep, while it runs, and puts it back.

The database is copied first, as of one moment. Then the files: what it names is there,
or was removed since because its submission has ended. Unpacked images are not kept:
they are unpacked again.
"""

from __future__ import annotations

import contextlib
import shutil
import sqlite3
from collections.abc import Iterator
from pathlib import Path
from typing import Final

DATABASE: Final = "platform.sqlite"
FOLDERS: Final = ("uploads", "logs", "presets")
SOCKET_NAMES: Final = "sockets.secret"  # what their names are made of


class BackupFailed(Exception):
    """The text says why, and what to do."""


def back_up(database: Path, submissions: Path, target: Path) -> Iterator[str]:
    """Copy into a folder, again what is new; a line for each part.

    Raises BackupFailed and OSError.
    """
    target.mkdir(mode=0o700, parents=True, exist_ok=True)
    new = target / f"{DATABASE}.new"
    new.unlink(missing_ok=True)
    _copy_database(database, new)
    new.replace(target / DATABASE)
    yield f"{DATABASE}: {(target / DATABASE).stat().st_size} bytes"
    for name in FOLDERS:
        yield _copy_folder(submissions / name, target / name)
    if (submissions / SOCKET_NAMES).exists():
        shutil.copy2(submissions / SOCKET_NAMES, target / SOCKET_NAMES)
        yield SOCKET_NAMES


def restore(source: Path, database: Path, submissions: Path) -> Iterator[str]:
    """Copy a backup to where nothing is. Raises BackupFailed and OSError."""
    if not (source / DATABASE).exists():
        raise BackupFailed(f"{source} is no backup: it has no {DATABASE}")
    for place in (database, submissions):
        if place.exists():
            text = f"{place} exists; move it away, or name another place"
            raise BackupFailed(f"{text}, so that nothing is overwritten")
    database.parent.mkdir(parents=True, exist_ok=True)
    _copy_database(source / DATABASE, database)
    yield f"{database}: {database.stat().st_size} bytes"
    submissions.mkdir(mode=0o711, parents=True)
    for name in FOLDERS:
        yield _copy_folder(source / name, submissions / name)
    if (source / SOCKET_NAMES).exists():
        shutil.copy2(source / SOCKET_NAMES, submissions / SOCKET_NAMES)
        yield SOCKET_NAMES


def _copy_database(source: Path, target: Path) -> None:
    """As of one moment, also while it is written; checked. Raises BackupFailed."""
    target.touch(mode=0o600)
    with (
        contextlib.closing(sqlite3.connect(source)) as read,
        contextlib.closing(sqlite3.connect(target)) as written,
    ):
        read.backup(written)
        (verdict,) = written.execute("PRAGMA integrity_check").fetchone()
    if verdict != "ok":
        raise BackupFailed(f"the copy of {source} is damaged: {verdict}")


def _copy_folder(source: Path, target: Path) -> str:
    """Files that are new or changed; those that the platform removes are skipped."""
    files = copied = 0
    for path in (source, *sorted(source.rglob("*"))):
        place = target / path.relative_to(source)
        with contextlib.suppress(FileNotFoundError):
            if path.is_dir():
                place.mkdir(mode=0o700, parents=True, exist_ok=True)
                shutil.copymode(path, place)  # sandboxes enter those of presets
                continue
            files += 1
            seen = path.stat()
            if not place.exists() or _differs(place, seen.st_size, seen.st_mtime):
                shutil.copy2(path, place)
                copied += 1
    return f"{target.name}: {files} files, {copied} of them new"


def _differs(place: Path, size: int, changed_at: float) -> bool:
    known = place.stat()
    return known.st_size != size or known.st_mtime != changed_at
