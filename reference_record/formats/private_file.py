"""Small files that their owner alone may read, such as keys."""

from __future__ import annotations

import contextlib
import os
import stat
import tempfile
from collections.abc import Callable
from pathlib import Path


def read_or_create(path: Path, make: Callable[[], bytes]) -> bytes:
    """The stripped content of the file, which is made by `make` if it does not exist.

    The file is complete before it has its name, and never replaces another: two
    processes that begin at once both get what the first one made. Raises OSError.
    """
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        descriptor, draft = tempfile.mkstemp(prefix=f"{path.name}.", dir=path.parent)
        try:
            with os.fdopen(descriptor, "wb") as file:
                file.write(make())
                file.flush()
                os.fsync(file.fileno())
            with contextlib.suppress(FileExistsError):
                os.link(draft, path)
        finally:
            Path(draft).unlink()
    return path.read_bytes().strip()


def read_private(path: Path, bytes_max: int) -> bytes:
    """Raises OSError; PermissionError for a file that is not this user's alone."""
    with path.open("rb") as file:
        status = os.fstat(file.fileno())
        is_own = status.st_uid == os.getuid() and stat.S_ISREG(status.st_mode)
        if not is_own or status.st_mode & 0o077:
            raise PermissionError(f"{path} is not this user's alone")
        return file.read(bytes_max)
