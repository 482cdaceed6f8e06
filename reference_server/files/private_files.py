"""Files that only the account which runs the server may read: databases, locks.

It knows paths and permissions, and nothing of what the files are for.
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

from reference_record.command_line.replaced_file import give

_OWNER_ONLY = 0o600


def create_empty(path: Path) -> bool:
    """Create the file for its owner only, unless it or a link exists. Raises OSError.

    Returns whether it was created.
    root gives it to the owner of its folder: a server that is not root must read it.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        descriptor = os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, _OWNER_ONLY)
    except FileExistsError:
        return False
    os.close(descriptor)
    give_to_owner_of(path.parent, path)
    return True


def give_to_owner_of(model: Path, path: Path) -> None:
    """Give what root has made at `path` to the owner of `model`. Raises OSError."""
    if os.geteuid() == 0:
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW)
        try:
            give(descriptor, model.stat())
        finally:
            os.close(descriptor)


def restrict(path: Path) -> None:
    """Take the access of all but the owner from a file, if it exists."""
    with contextlib.suppress(FileNotFoundError, PermissionError):
        mode = path.stat().st_mode
        if mode & 0o077:
            path.chmod(mode & 0o700)
