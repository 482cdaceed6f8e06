"""Files that people keep: the one before stays whole until the new one is.

A full disk, a quota or the end of the program leaves the old file, and never a half.
`make generate` copies this file to the kit.
"""

from __future__ import annotations

import contextlib
import os
import shutil
from collections.abc import Iterator
from pathlib import Path


@contextlib.contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Give the place of a draft beside a file; after the block, it becomes the file.

    A link stays a link, and the rights of the file stay. A place that is not a file of
    a disk, such as /dev/stdout, is written itself.
    """
    if path.absolute().parts[1:2] == ("dev",) or (path.exists() and not path.is_file()):
        yield path
        return
    target = path.resolve() if path.is_symlink() else path
    draft = target.with_name(f".{target.name}.{os.getpid()}.part")
    try:
        yield draft
        if target.exists():
            shutil.copymode(target, draft)
        draft.replace(target)
    except BaseException:
        with contextlib.suppress(OSError):
            draft.unlink()
        raise


def replace_file(path: Path, content: str | bytes) -> None:
    """Write a whole file, a text in UTF-8, in the place of one that may exist."""
    if isinstance(content, str):
        content = content.encode("utf-8", "replace")
    with replacing(path) as draft:
        draft.write_bytes(content)
