"""Says why a file cannot be used, in words: without numbers of errors and classes."""

from __future__ import annotations

import errno
import os
import pwd
import shutil
from pathlib import Path
from typing import Final

# SQLite says "disk I/O error" for a disk that is full.
_ROOM_BYTES: Final = 2**16
# Texts of SQLite, which name no path: it may not write; the disk failed.
_NOT_ALLOWED: Final = (
    "unable to open database file",
    "attempt to write a readonly database",
)
_OF_DISK: Final = ("disk I/O error", "database or disk is full")


def describe_file_fault(error: Exception, path: Path | None = None) -> str:
    """The reason, with the file or folder that was refused.

    error: of the system, which may name the path itself, or of SQLite, perhaps inside
    of one of its users.
    """
    named = getattr(error, "filename", None)
    refused = Path(named) if isinstance(named, str) else path
    may_be_full = not isinstance(error, OSError) or error.errno == errno.ENOSPC
    for checked in filter(None, (path, refused) if may_be_full else ()):
        if _free_bytes(checked) < _ROOM_BYTES and not _is_read_only(checked):
            return f"no space is left on the disk of {checked}"
    if isinstance(error, OSError) and error.strerror:
        text = error.strerror if refused is None else f"{refused}: {error.strerror}"
        is_refused = isinstance(error, PermissionError)
    else:
        text = str(getattr(error, "orig", None) or error).partition("\n")[0]
        is_refused = text in _NOT_ALLOWED
        if refused is not None and text in (*_NOT_ALLOWED, *_OF_DISK):
            text = f"{refused}: {text}"
    return text + _why_refused(refused) if is_refused and refused else text


def _why_refused(path: Path) -> str:
    """A clause: the file system or the owner, if one of them is why; else nothing."""
    while not path.exists() and path != path.parent:
        path = path.parent
    if _is_read_only(path):
        return "; its file system is read-only"
    if path.is_file() and os.access(path, os.R_OK | os.W_OK):
        path = path.parent
    owner, user = path.stat().st_uid, os.geteuid()
    subject = "it" if path.is_file() else str(path)
    name = _name_of_user(user)
    if owner != user:
        owner_name = _name_of_user(owner)
        return f"; {subject} belongs to {owner_name}, and this program runs as {name}"
    if os.access(path, os.W_OK):
        return ""
    return f"; {subject} is of this user, {name}, and cannot be written: see chmod"


def _is_read_only(path: Path) -> bool:
    folder = _folder_of(path)
    return folder is not None and bool(os.statvfs(folder).f_flag & os.ST_RDONLY)


def _name_of_user(number: int) -> str:
    try:
        return pwd.getpwuid(number).pw_name
    except KeyError:
        return f"user {number}"


def _free_bytes(path: Path) -> int:
    folder = _folder_of(path)
    return _ROOM_BYTES if folder is None else shutil.disk_usage(folder).free


def _folder_of(path: Path) -> Path | None:
    place = path.absolute()
    return next((one for one in (place, *place.parents) if one.is_dir()), None)
