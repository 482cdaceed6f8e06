"""Files that people keep: the one before stays whole until the new one is.

A full disk, a quota or the end of the program leaves the old file, and never a half.
`make generate` copies this file to the kit.
"""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import socket
from collections.abc import Iterator
from pathlib import Path

_NAME_CHARS = 40  # of the file, in the name of its draft: a name has 255 bytes at most
_LINKS_MAX = 40
_DISK_IS_FULL = (errno.ENOSPC, errno.EDQUOT)


@contextlib.contextmanager
def replacing(path: Path, *, is_private: bool = False) -> Iterator[Path]:
    """Give the place of a draft beside a file; after the block, it becomes the file.

    A link stays a link, and the rights and the owner of the file stay; the draft of a
    file that is there is its owner's alone. A place that cannot be replaced is written
    itself: one of /dev or /proc, a pipe, a file with several names or of an owner to
    whom this user can give none, one in a folder that takes no new files, and one that
    is mounted. An OSError names the file.

    is_private: a new file is its owner's alone; root gives it to that of its folder.
    """
    target = _target_of(path)
    draft = None
    try:
        if not _must_stay(target):
            draft = _begin_draft(target, is_private=is_private)
        yield draft or path
        if draft is not None:
            _put_in_place(draft, target)
    except BaseException as error:
        if draft is not None:
            with contextlib.suppress(OSError):
                draft.unlink()
        if isinstance(error, OSError) and error.filename in (None, str(draft)):
            error.filename = str(path)
        raise


def replace_file(path: Path, content: str | bytes, *, is_private: bool = False) -> None:
    """Write a whole file, a text in UTF-8, in the place of one that may exist."""
    if isinstance(content, str):
        content = content.encode("utf-8", "replace")
    with replacing(path, is_private=is_private) as draft:
        draft.write_bytes(content)


def check_writable(path: Path) -> None:
    """Raise now the OSError that writing a whole file would raise in the end.

    A place that is neither a file nor a folder, such as a pipe, is left alone.
    """
    target = _target_of(path)
    if target.exists() and not (target.is_file() or target.is_dir()):
        return
    draft = None if _must_stay(target) else _begin_draft(target, is_private=True)
    if draft is not None:
        draft.unlink()
        return
    target.open("ab").close()


def _target_of(path: Path) -> Path:
    """Where links lead, up to a place such as /dev/stdout, which is one itself."""
    for _ in range(_LINKS_MAX):
        if _is_of_kernel(path) or not path.is_symlink():
            break
        path = path.parent / path.readlink()
    return path


def _is_of_kernel(path: Path) -> bool:
    return path.absolute().parts[1:2] in (("dev",), ("proc",))


def _must_stay(target: Path) -> bool:
    if _is_of_kernel(target):
        return True
    if not target.exists():
        return target.is_symlink()
    return not target.is_file() or target.stat().st_nlink > 1


def _begin_draft(target: Path, *, is_private: bool) -> Path | None:
    """An empty file beside the target; None where its folder or owner takes none."""
    writer = f"{socket.gethostname()}.{os.getpid()}"  # a container has few numbers
    name = f".{target.name[:_NAME_CHARS]}.{writer}.part"
    draft = target.with_name(name)
    old = target.stat() if target.exists() else None
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL
    try:
        draft.unlink(missing_ok=True)
        mode = 0o666 if old is None and not is_private else 0o600
        descriptor = os.open(draft, flags, mode)
    except OSError as error:
        if error.errno in _DISK_IS_FULL:
            raise
        return None
    try:
        if old is None and is_private and os.geteuid() == 0:
            old = target.parent.stat()
        if old is not None:
            give(descriptor, old)
    except OSError:
        draft.unlink()
        return None
    finally:
        os.close(descriptor)
    return draft


def give(descriptor: int, owner: os.stat_result) -> None:
    """Let the file have that owner and group. Raises OSError, as for most users."""
    now = os.fstat(descriptor)
    if (now.st_uid, now.st_gid) != (owner.st_uid, owner.st_gid):
        os.fchown(descriptor, owner.st_uid, owner.st_gid)


def _put_in_place(draft: Path, target: Path) -> None:
    if target.exists():
        shutil.copymode(target, draft)
    with draft.open("rb") as file:
        os.fsync(file.fileno())
    try:
        draft.replace(target)
    except OSError:  # it is mounted, or its folder lets nothing be removed
        shutil.copyfile(draft, target)
        draft.unlink()
