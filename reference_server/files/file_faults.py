"""Says why a file cannot be used, in words: without numbers of errors and classes."""

from __future__ import annotations

import contextlib
import errno
import os
import pwd
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Final

# SQLite says "disk I/O error" for a disk that is full.
_ROOM_BYTES: Final = 2**16


def describe_file_fault(error: Exception, path: Path | None) -> str:
    """The reason, with the file or folder that was refused.

    error: of the system, or of SQLite, perhaps inside of one of its users.
    """
    is_of_system = isinstance(error, OSError) and error.errno != errno.ENOSPC
    if path is not None and not is_of_system and _free_bytes(path) < _ROOM_BYTES:
        return f"no space is left on the disk of {path}"
    if isinstance(error, OSError) and error.strerror:
        named = error.filename if isinstance(error.filename, str) else path
        text = error.strerror if named is None else f"{named}: {error.strerror}"
        if isinstance(error, PermissionError) and named is not None:
            text += _of_another_user(Path(named))
        return text
    text = str(getattr(error, "orig", None) or error).partition("\n")[0]
    if path is None or os.access(path.parent, os.W_OK) or not path.parent.exists():
        return text
    return f"{text}: the folder {path.parent.absolute()} cannot be written"


@contextlib.contextmanager
def naming(path: Path) -> Iterator[None]:
    """Give an OSError the file at which it was, which a write by a number has not."""
    try:
        yield
    except OSError as error:
        if isinstance(error.filename, str) or not error.errno:
            raise
        raise OSError(error.errno, error.strerror, str(path)) from error


def _of_another_user(path: Path) -> str:
    """`; it belongs to A, and this program runs as B`, if those are two users."""
    while not path.exists() and path != path.parent:
        path = path.parent
    owner, user = path.stat().st_uid, os.geteuid()
    if owner == user:
        return ""
    subject = "it" if path.is_file() else str(path)
    names = _name_of_user(owner), _name_of_user(user)
    return "; {} belongs to {}, and this program runs as {}".format(subject, *names)


def _name_of_user(number: int) -> str:
    try:
        return pwd.getpwuid(number).pw_name
    except KeyError:
        return f"user {number}"


def _free_bytes(path: Path) -> int:
    for folder in path.absolute().parents:
        if folder.is_dir():
            return shutil.disk_usage(folder).free
    return _ROOM_BYTES
