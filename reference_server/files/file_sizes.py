"""The bytes that files and folders take, also while others change them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path


def size_of(paths: Iterable[Path]) -> int:
    """The bytes of files, and of all files in folders; what is gone has none."""
    return sum(
        _size(file)
        for path in paths
        for file in (path.rglob("*") if path.is_dir() else [path])
    )


def _size(path: Path) -> int:
    try:
        return path.stat().st_size if path.is_file() else 0
    except OSError:
        return 0
