"""Archives that were handed in, as files: received within a bound, examined, kept.

An archive has its name only when it is whole and on disk. What reads it first is a
process of its own (`verify_process.py`): it may be hostile.

    IMPORTS/imp_4f2a.proctor    a record in which nothing is wrong
    IMPORTS/.imp_4f2a.part      bytes that are being received or examined
"""

from __future__ import annotations

import asyncio
import hashlib
import os
import sys
from collections.abc import AsyncIterator
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import msgspec

from reference_record.broken import ARCHIVE, BrokenRecord
from reference_server.records.verify_process import Found, RecordFacts

SUFFIX, DRAFT_SUFFIX = ".proctor", ".part"
# Parts of a body are collected up to this size: a write is a switch to a thread.
WRITE_BYTES = 2**20
# A record of 4 GiB is read through in a tenth of it.
EXAMINE_S_MAX = 600.0


@dataclass(frozen=True, slots=True)
class Draft:
    """Bytes that were received, on disk."""

    path: Path
    size_bytes: int
    sha256: str


class ImportFiles:
    """The files of imports below one folder; None for one that `close` removes."""

    def __init__(self, folder: Path | None) -> None:
        self._temporary = None if folder else TemporaryDirectory(prefix="proctor-")
        self._folder = folder or Path(self._temporary.name if self._temporary else "")
        # One at a time: the processors are there for those who play.
        self._examining = asyncio.Lock()

    def open(self, import_ids: set[str]) -> None:
        """Make the folder, and remove what is no import's. Raises OSError."""
        self._folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        for path in self._folder.iterdir():
            if path.suffix == DRAFT_SUFFIX or path.stem not in import_ids:
                path.unlink()

    def close(self) -> None:
        if self._temporary is not None:
            self._temporary.cleanup()

    def path(self, import_id: str) -> Path:
        return self._folder / f"{import_id}{SUFFIX}"

    def draft_path(self, import_id: str) -> Path:
        return self._folder / f".{import_id}{DRAFT_SUFFIX}"

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

    async def examine(self, draft: Draft) -> RecordFacts:
        """REC-113: what the record says; raises BrokenRecord."""
        async with self._examining:
            process = await asyncio.create_subprocess_exec(
                *(
                    sys.executable,
                    "-P",
                    "-m",
                    "reference_server.records.verify_process",
                ),
                str(draft.path.absolute()),
                stdin=asyncio.subprocess.DEVNULL,
                stdout=asyncio.subprocess.PIPE,
                env=_environment(),
                start_new_session=True,  # a terminal's Ctrl-C is the server's to handle
            )
            try:
                said, _ = await asyncio.wait_for(process.communicate(), EXAMINE_S_MAX)
            except TimeoutError:
                said = b""
            finally:
                if process.returncode is None:
                    process.kill()
                    await process.wait()
        try:
            found = msgspec.json.decode(said, type=Found)
        except msgspec.DecodeError as error:
            detail = "it takes more memory or time than a verifier has for it"
            raise BrokenRecord(ARCHIVE, "REC-030", detail) from error
        if found.facts is None:
            assert found.broken is not None
            raise BrokenRecord(
                found.broken.file, found.broken.rule, found.broken.detail
            )
        return found.facts

    async def keep(self, import_id: str, draft: Draft) -> None:
        """Give the draft its name, durably. Raises OSError."""
        await asyncio.to_thread(_rename_durably, draft.path, self.path(import_id))

    def remove(self, import_id: str) -> None:
        """Remove all that is there of an import."""
        for path in (self.draft_path(import_id), self.path(import_id)):
            path.unlink(missing_ok=True)


def _environment() -> dict[str, str]:
    """Without the server's settings: tokens and database passwords are there."""
    root = str(Path(__file__).parents[2])
    paths = [root, *filter(None, [os.environ.get("PYTHONPATH")])]
    kept = {k: v for k, v in os.environ.items() if not k.startswith("PROCTOR_")}
    return kept | {"PYTHONPATH": os.pathsep.join(paths)}


def _rename_durably(draft: Path, path: Path) -> None:
    with draft.open("rb") as file:
        os.fsync(file.fileno())
    draft.rename(path)
    if os.name == "posix":
        folder = os.open(path.parent, os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)
