"""Unpacked images and code, by the digest of what was uploaded.

A folder is complete or not there: it is unpacked beside its place and renamed. Nothing
is left of an archive that was refused.
"""

from __future__ import annotations

import asyncio
import contextlib
import shutil
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import msgspec

from reference_platform.images.bounded_archives import InvalidArchive
from reference_platform.images.oci_archive import ImageProgram
from reference_platform.images.unpack_program import Refusal

UNPACK_S_MAX = 3600.0
# So much stays free on the host's disk, whatever an archive has.
_FREE_BYTES = 2**30
_PROGRAM_FILE, _ROOT = "program.json", "root"


class UnpackingFailed(Exception):
    """The platform could not unpack it; the archive is right."""


@dataclass(frozen=True, slots=True)
class Unpacked:
    """root: the folder with the files. program: what the archive says is started."""

    root: Path
    program: ImageProgram


class UnpackedRoots:
    """folder: where they are; users of sandboxes can enter it. max_bytes: of one."""

    def __init__(self, folder: Path, max_bytes: int = 32 * 2**30) -> None:
        folder.mkdir(mode=0o711, parents=True, exist_ok=True)
        self._folder = folder
        self._max_bytes = max_bytes
        self._locks: dict[str, asyncio.Lock] = {}
        for left in folder.glob(".new-*"):  # by a platform that was killed
            shutil.rmtree(left)

    async def get(
        self, kind: Literal["image", "code"], digest: str, archive: Path
    ) -> Unpacked:
        """Unpack it unless it was. Raises InvalidArchive, UnpackingFailed."""
        place = self._place(digest)
        async with self._locks.setdefault(digest, asyncio.Lock()):
            if not place.is_dir():
                await self._unpack(kind, archive, place)
        text = (place / _PROGRAM_FILE).read_bytes()
        return Unpacked(place / _ROOT, msgspec.json.decode(text, type=ImageProgram))

    async def check_image(self, archive: Path) -> None:
        """Whether it has an image for this machine; its layers are not read.

        Raises InvalidArchive, UnpackingFailed.
        """
        await _run_program("check", archive, self._folder / "unused", self._max_bytes)

    def remove(self, digest: str) -> None:
        shutil.rmtree(self._place(digest), ignore_errors=True)

    def _place(self, digest: str) -> Path:
        return self._folder / digest.replace(":", "-")

    async def _unpack(self, kind: str, archive: Path, place: Path) -> None:
        max_bytes = self._room_for(archive)
        new = Path(tempfile.mkdtemp(prefix=".new-", dir=self._folder))
        try:
            program = await _run_program(kind, archive, new / _ROOT, max_bytes)
            _publish(new, program, place)
        except BaseException:
            await asyncio.to_thread(shutil.rmtree, new)
            raise

    def _room_for(self, archive: Path) -> int:
        """How many bytes may be unpacked. Raises UnpackingFailed."""
        free = shutil.disk_usage(self._folder).free - _FREE_BYTES
        if free < archive.stat().st_size:
            raise UnpackingFailed("The disk of the platform is full.")
        return min(self._max_bytes, free)


def _publish(new: Path, program: ImageProgram, place: Path) -> None:
    (new / _PROGRAM_FILE).write_bytes(msgspec.json.encode(program))
    new.chmod(0o755)
    new.rename(place)


async def _run_program(
    kind: str, archive: Path, target: Path, max_bytes: int
) -> ImageProgram:
    process = await asyncio.create_subprocess_exec(
        sys.executable,
        "-m",
        "reference_platform.images.unpack_program",
        *(kind, str(archive), str(target), str(max_bytes)),
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
    )
    assert process.stdout is not None
    try:
        async with asyncio.timeout(UNPACK_S_MAX):
            output = await process.stdout.read()
            await process.wait()
    except TimeoutError as error:
        raise InvalidArchive("It takes too long to unpack.") from error
    finally:
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        await process.wait()
    if process.returncode != 0:
        raise UnpackingFailed(
            "The archive could not be unpacked; see the platform's log."
        )
    answer = msgspec.json.decode(output, type=dict)
    if "refused" in answer:
        raise InvalidArchive(msgspec.convert(answer, Refusal).refused)
    return msgspec.convert(answer, ImageProgram)
