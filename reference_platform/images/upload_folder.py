"""Files that accounts upload: in parts, each durable, and complete by their digest.

A file of an account is named by its digest. Another account that knows the digest has
nothing of it: it must upload the bytes. The bytes that have arrived survive a kill of
the platform, and the next part begins where they end. No part is held in memory.
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import hashlib
import os
import re
import shutil
import time
from collections.abc import AsyncIterator
from dataclasses import dataclass
from pathlib import Path

from reference_record.recordings.recording_file import sync_folder
from reference_server.rules.refusal import Refused

MAX_BYTES = 16 * 2**30
# All files of one account together.
ACCOUNT_BYTES_MAX = 64 * 2**30
_FREE_BYTES = 2**30
_NO_ROOM = (errno.ENOSPC, errno.EDQUOT)
_DIGEST = re.compile(r"sha256:([0-9a-f]{64})")
_ACCOUNT = re.compile(r"[a-z0-9][a-z0-9_.-]{0,127}")


@dataclass(frozen=True, slots=True)
class Upload:
    """offset: how many bytes have arrived. is_complete: its digest is right."""

    offset: int
    is_complete: bool


class UploadFolder:
    """Implements Uploads; every method raises Refused."""

    def __init__(
        self,
        folder: Path,
        max_bytes: int = MAX_BYTES,
        account_bytes: int = ACCOUNT_BYTES_MAX,
    ) -> None:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        self._folder = folder
        self._max_bytes = max_bytes
        self._account_bytes = account_bytes
        self._locks: dict[Path, asyncio.Lock] = {}

    def path_of(self, account: str, digest: str) -> Path:
        """The complete file. Raises KeyError."""
        path = self._path(account, digest)
        if not path.is_file():
            raise KeyError(digest)
        return path

    def state(self, account: str, digest: str) -> Upload:
        """A complete file counts as arrived now: a new submission is about to name it.

        So the end of an earlier submission of the same bytes does not remove it.
        """
        path = self._path(account, digest)
        with contextlib.suppress(FileNotFoundError):
            now = time.time()  # the clock of submissions; that of the kernel is coarser
            os.utime(path, (now, now))
            return Upload(path.stat().st_size, is_complete=True)
        part = _part_of(path)
        return Upload(part.stat().st_size if part.is_file() else 0, is_complete=False)

    def check(self, digest: str, size: int) -> None:
        """Whether such a file may be uploaded."""
        if not _DIGEST.fullmatch(digest):
            wrong = [("/digest", "must be sha256: and 64 hexadecimal digits")]
            raise Refused("invalid_request", "The digest is wrong.", errors=wrong)
        if not 0 < size <= self._max_bytes:
            text = f"An upload has 1 to {self._max_bytes} bytes."
            raise Refused("invalid_request", text, errors=[("/size", text)])

    async def append(
        self,
        account: str,
        digest: str,
        size: int,
        offset: int,
        parts: AsyncIterator[bytes],
    ) -> Upload:
        """Add bytes at an offset, which must be where the file ends now (HST-020).

        size: of the whole file. When it has arrived, its digest is checked; a file with
        another one is removed, and the upload begins anew (HST-021).
        """
        path = self._path(account, digest)
        lock = self._locks.setdefault(path, asyncio.Lock())
        if lock.locked():
            text = "Another request uploads this file now; try again when it has ended."
            raise Refused("unavailable", text)
        async with lock:
            state = self.state(account, digest)
            if state.is_complete:
                return state
            if offset != state.offset:
                raise Refused(
                    "invalid_request",
                    f"The file has {state.offset} bytes; go on at that offset.",
                    errors=[("/offset", f"must be {state.offset}")],
                )
            try:
                await self._append(path, size, offset, parts)
                return await self._finish(path, digest, size)
            except OSError as error:
                if error.errno not in _NO_ROOM:
                    raise
                raise _disk_is_full() from error

    async def _append(
        self, path: Path, size: int, offset: int, parts: AsyncIterator[bytes]
    ) -> None:
        """Raises OSError, too: what is free now may be used before it is written."""
        if shutil.disk_usage(self._folder).free - _FREE_BYTES < size - offset:
            raise _disk_is_full()
        part = _part_of(path)
        part.parent.mkdir(mode=0o700, exist_ok=True)
        used = sum(map(_size_of, part.parent.iterdir()))
        if used - offset + size > self._account_bytes:
            text = f"The files of an account have at most {self._account_bytes} "
            text += "bytes; those of submissions that have ended are removed."
            act = "Stop a submission that is not needed, or wait until one has ended."
            raise Refused("quota_exceeded", text, act=act)
        await _write(part, offset, size, parts)

    def remove(self, account: str, digest: str, before: float) -> None:
        """Unless it arrived later than that: then another submission will name it."""
        path = self._path(account, digest)
        for file in (path, _part_of(path)):
            with contextlib.suppress(FileNotFoundError):
                if file.stat().st_mtime <= before:
                    file.unlink()

    async def _finish(self, path: Path, digest: str, size: int) -> Upload:
        part = _part_of(path)
        arrived = part.stat().st_size
        if arrived < size:
            return Upload(arrived, is_complete=False)
        if await asyncio.to_thread(_digest_of, part) != digest:
            part.unlink()
            text = "The bytes have another digest; the upload begins anew."
            raise Refused("invalid_request", text, errors=[("/digest", text)])
        part.rename(path)
        await asyncio.to_thread(sync_folder, path.parent)
        return Upload(size, is_complete=True)

    def _path(self, account: str, digest: str) -> Path:
        match = _DIGEST.fullmatch(digest)
        if match is None or not _ACCOUNT.fullmatch(account):
            raise Refused("not_found", "There is no such upload.")
        return self._folder / account / match[1]


def _disk_is_full() -> Refused:
    return Refused("unavailable", "The disk of the platform is full.")


def _size_of(file: Path) -> int:
    """0 for one that was removed meanwhile, as its submission has ended."""
    with contextlib.suppress(FileNotFoundError):
        return file.stat().st_size
    return 0


async def _write(
    part: Path, offset: int, size: int, parts: AsyncIterator[bytes]
) -> None:
    """Raises Refused for bytes beyond the size. Those before stay (HST-022)."""
    with await asyncio.to_thread(part.open, "ab") as file:
        try:
            async for content in parts:
                offset += len(content)
                if offset > size:
                    text = f"The file has more than its {size} bytes."
                    raise Refused("invalid_request", text, errors=[("/size", text)])
                if content:
                    await asyncio.to_thread(file.write, content)
        finally:
            file.flush()
            await asyncio.to_thread(os.fsync, file.fileno())


def _part_of(path: Path) -> Path:
    return path.with_suffix(".part")


def _digest_of(path: Path) -> str:
    with path.open("rb") as file:
        return f"sha256:{hashlib.file_digest(file, 'sha256').hexdigest()}"
