"""Says why a file cannot be used, in words: without numbers of errors and classes."""

from __future__ import annotations

import os
import pwd
import shutil
from pathlib import Path
from typing import Final

# SQLite says "disk I/O error" for a disk that is full.
_ROOM_BYTES: Final = 2**16


def describe_file_fault(error: Exception, path: Path | None) -> str:
    """The reason, with the file or folder that was refused.

    error: of the system, or of SQLite, perhaps inside of one of its users.
    """
    if path is not None and _free_bytes(path) < _ROOM_BYTES:
        return f"no space is left on the disk of {path}"
    if isinstance(error, OSError) and error.strerror:
        named = error.filename if isinstance(error.filename, str) else path
        text = f"{named}: {error.strerror}"
        if isinstance(error, PermissionError) and named is not None:
            text += _of_another_user(Path(named))
        return text
    return str(getattr(error, "orig", None) or error).partition("\n")[0]


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
