"""Archives that were handed in, as files: received within a bound, and kept.

An archive has its name only when it is whole and on disk. Nothing here parses one.

    IMPORTS/imp_4f2a.proctor    a record in which nothing is wrong
    IMPORTS/.imp_4f2a.part      bytes that are being received or examined
    IMPORTS/.imp_4f2a.pending   its row is being added or deleted

Whatever else is there was not written here, and stays.
"""

from __future__ import annotations

import asyncio
import hashlib
import logging
import os
import re
import time
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from pathlib import Path

from reference_record.recordings.recording_file import sync_folder
from reference_server.files.object_storage import IMPORTED, ObjectStorage
from reference_server.records.recordings import refused_while_away, use_storage

log = logging.getLogger("proctor.imports")

SUFFIX, DRAFT_SUFFIX, PENDING_SUFFIX = ".proctor", ".part", ".pending"
_OWN_NAME = re.compile(r"\.?(imp_[0-9a-f]{24})(\.[a-z]+)", re.ASCII)
NAMED_MAX = 5
# A draft in a shared folder that is older was left by a node that was killed.
LEFT_S = 3600.0
# Parts of a body are collected up to this size: a write is a switch to a thread.
WRITE_BYTES = 2**20


@dataclass(frozen=True, slots=True)
class Draft:
    """Bytes that were received, on disk."""

    path: Path
    size_bytes: int
    sha256: str


class ImportFiles:
    """The files of imports below one folder; None for one that `close` removes.

    is_shared: other nodes may be receiving what is there. storage: has every archive;
    the folder is of this machine alone then.
    """

    def __init__(
        self,
        folder: Path,
        *,
        is_shared: bool = False,
        storage: ObjectStorage | None = None,
    ) -> None:
        self._is_shared, self._storage = is_shared, storage
        self._folder = folder

    def open(self, import_ids: set[str]) -> None:
        """Make the folder, and finish what a crash cut off. Raises OSError.

        import_ids: those of the database. An archive of no import is kept: the folder
        may be that of another server, or the database an older copy.
        """
        self._folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        unknown = [
            path.name
            for path in sorted(self._folder.iterdir())
            if not self._is_settled(path, import_ids)
        ]
        if unknown:
            named = ", ".join(unknown[:NAMED_MAX])
            text = "%s: %d files belong to no record of this database, and are kept: %s"
            log.warning(text, self._folder, len(unknown), named)

    def _is_settled(self, path: Path, import_ids: set[str]) -> bool:
        """Whether the file is known; what was left of an import is removed.

        In the order of names: `.imp_x.pending` comes before what it decides about.
        """
        own = _OWN_NAME.fullmatch(path.name)
        if own is None or path.is_dir():
            return False
        import_id = own[1]
        if self._is_shared and path != self.path(import_id) and _is_young(path):
            return True
        if path == self.draft_path(import_id):
            path.unlink(missing_ok=True)
        elif path == self._pending_path(import_id):
            if import_id not in import_ids:
                self.path(import_id).unlink(missing_ok=True)
            path.unlink(missing_ok=True)
        else:
            return path == self.path(import_id) and (
                import_id in import_ids or not path.exists()
            )
        return True

    def path(self, import_id: str) -> Path:
        return self._folder / f"{import_id}{SUFFIX}"

    def draft_path(self, import_id: str) -> Path:
        return self._folder / f".{import_id}{DRAFT_SUFFIX}"

    def _pending_path(self, import_id: str) -> Path:
        return self._folder / f".{import_id}{PENDING_SUFFIX}"

    async def receive(self, import_id: str, parts: AsyncIterator[bytes]) -> Draft:
        """Write a body to a draft. Raises OSError, and what `parts` raises."""
        path, digest, size = self.draft_path(import_id), hashlib.sha256(), 0
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        with os.fdopen(descriptor, "wb") as file:

            def write(data: bytes) -> None:
                digest.update(data)
                file.write(data)

            collected = bytearray()
            async for part in parts:
                size += len(part)
                collected += part
                if len(collected) >= WRITE_BYTES:
                    await asyncio.to_thread(write, bytes(collected))
                    collected.clear()
            await asyncio.to_thread(write, bytes(collected))
        return Draft(path, size, digest.hexdigest())

    async def keep(self, import_id: str, draft: Draft) -> None:
        """Give the draft its name, durably; `settle` has to follow.

        Raises OSError, and Refused where the storage is away.
        """
        self.begin_change(import_id)
        await asyncio.to_thread(_rename_durably, draft.path, self.path(import_id))
        if (storage := self._storage) is not None:
            path = self.path(import_id)
            await self._use(storage, storage.put, _name_in_storage(import_id), path)

    async def make_here(self, import_id: str) -> Path:
        """The archive, which another node may have received.

        Raises OSError, and Refused where the storage is away.
        """
        path, storage = self.path(import_id), self._storage
        if storage is not None and not path.exists():
            await self._use(storage, storage.fetch, _name_in_storage(import_id), path)
        return path

    def begin_change(self, import_id: str) -> None:
        """Its row is about to change: `open` looks how it did. Raises OSError."""
        self._pending_path(import_id).touch(0o600)

    def is_changing(self, import_id: str) -> bool:
        return self._pending_path(import_id).exists()

    def settle(self, import_id: str) -> None:
        """The database says what is true of it. Raises OSError."""
        self._pending_path(import_id).unlink(missing_ok=True)

    def remove(self, import_id: str) -> None:
        """Remove all that is there of an import."""
        for path in (self.draft_path(import_id), self.path(import_id)):
            path.unlink(missing_ok=True)
        self.settle(import_id)

    async def remove_stored(self, import_id: str) -> None:
        """Remove it for all nodes. Raises Refused where the storage is away."""
        if (storage := self._storage) is not None:
            await self._use(storage, storage.remove, [_name_in_storage(import_id)])

    async def _use(
        self, storage: ObjectStorage, work: Callable[..., None], *given: object
    ) -> None:
        with refused_while_away():
            await use_storage(storage, work, *given)


def _name_in_storage(import_id: str) -> str:
    return f"{IMPORTED}/{import_id}{SUFFIX}"


def _is_young(path: Path) -> bool:
    """Whether another node may still write it, or has just removed it."""
    try:
        return path.stat().st_mtime > time.time() - LEFT_S
    except OSError:
        return True


def _rename_durably(draft: Path, path: Path) -> None:
    with draft.open("rb") as file:
        os.fsync(file.fileno())
    draft.rename(path)
    if os.name == "posix":
        sync_folder(path.parent)
