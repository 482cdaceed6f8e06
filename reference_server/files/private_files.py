"""Files that only the account which runs the server may read: keys, tokens, databases.

It knows paths and permissions, and nothing of what the files are for.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable
from pathlib import Path

_OWNER_ONLY = 0o600


def read_or_create(path: Path, make: Callable[[], bytes]) -> bytes:
    """The stripped content of the file, which is made by `make` if it does not exist.

    Two servers that start at once agree. Raises OSError.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f"{path.name}.{os.getpid()}")
    temporary.touch(mode=_OWNER_ONLY)
    try:
        with temporary.open("wb") as file:
            file.write(make())
            file.flush()
            os.fsync(file.fileno())
        # Atomic: the file appears complete or not at all, and never replaces another.
        os.link(temporary, path)
    except FileExistsError:
        pass
    finally:
        temporary.unlink()
    return path.read_bytes().strip()


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
        owner = model.stat()
        os.chown(path, owner.st_uid, owner.st_gid, follow_symlinks=False)


def restrict(path: Path) -> None:
    """Take the access of all but the owner from a file, if it exists."""
    with contextlib.suppress(FileNotFoundError, PermissionError):
        mode = path.stat().st_mode
        if mode & 0o077:
            path.chmod(mode & 0o700)
