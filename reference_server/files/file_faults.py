"""Says why a file cannot be used, in words: without numbers of errors and classes."""

from __future__ import annotations

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
        return f"{error.filename or path}: {error.strerror}"
    return str(getattr(error, "orig", None) or error).partition("\n")[0]


def _free_bytes(path: Path) -> int:
    for folder in path.absolute().parents:
        if folder.is_dir():
            return shutil.disk_usage(folder).free
    return _ROOM_BYTES
