"""Pictures that are drawn once while the server runs, for all simulator processes.

A picture that a manifest fixes, such as that of a question, is the same in every
evaluation, and drawing it takes longer than all the rest of the item. The process that
forks simulators opens a file without a name, and its children share it: it needs no
lock and leaves nothing behind, however the server ends. Without that file, as where
processes are not forked, nothing is stored and every picture is drawn.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import tempfile
from typing import IO

import numpy as np
from numpy.typing import NDArray

SLOT_BYTES = 2**20  # 640 × 480 × 3 and a head
_DIGEST_BYTES = 32
_HEAD_BYTES = 2 * _DIGEST_BYTES


class PictureStore:
    """Pictures by slot. A slot holds one; what stands there under another key, or is
    half written, is as good as nothing."""

    def __init__(self) -> None:
        self._file: IO[bytes] | None = None

    def open(self) -> None:
        """Make the file. Called before processes are forked, which inherit it."""
        # A full or read-only disk: every picture is drawn.
        with contextlib.suppress(OSError):
            self._file = tempfile.TemporaryFile()  # noqa: SIM115 - open until the end

    def find(
        self, slot: int, key: str, shape: tuple[int, int, int]
    ) -> NDArray[np.uint8] | None:
        """The picture that was stored under this slot and key; None if there is none.

        shape: height, width, channels. key: everything that the picture depends on.
        """
        size = int(np.prod(shape))
        stored = self._read(slot, _HEAD_BYTES + size)
        pixels = stored[_HEAD_BYTES:]
        if len(pixels) < size or stored[:_HEAD_BYTES] != _head(key, pixels):
            return None
        return np.frombuffer(pixels, np.uint8).reshape(shape)

    def put(self, slot: int, key: str, picture: NDArray[np.uint8]) -> None:
        """Store a picture, unless there is no file or it is too large for a slot."""
        pixels = picture.tobytes()
        if self._file is None or len(pixels) > SLOT_BYTES - _HEAD_BYTES:
            return
        with contextlib.suppress(OSError):
            content = _head(key, pixels) + pixels
            os.pwrite(self._file.fileno(), content, slot * SLOT_BYTES)

    def close(self) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None

    def _read(self, slot: int, size: int) -> bytes:
        if self._file is None:
            return b""
        try:
            return os.pread(self._file.fileno(), size, slot * SLOT_BYTES)
        except OSError:
            return b""


def _head(key: str, pixels: bytes) -> bytes:
    """The digests that only a whole picture of this key begins with."""
    digests = (
        hashlib.blake2b(part, digest_size=_DIGEST_BYTES).digest()
        for part in (key.encode(), pixels)
    )
    return b"".join(digests)


PICTURES = PictureStore()
