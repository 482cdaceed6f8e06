"""Where a simulator draws its raw images, so that they need no copy on their way out.

A canvas is memory that the simulator process shares with its parent, in two halves:
each observation is drawn into the half that the one before it did not use, and the
parent sends the pixels from there. Memory lasts one episode: whatever is still being
sent, or kept to be sent again, is never drawn over by somebody else's episode.

A simulator may draw elsewhere; then its pixels are copied, as they are where memory
cannot be shared (Linux only), and in the first observation, whose size nobody knows.
Which means nobody has to know this file to write a simulator.
"""

from __future__ import annotations

import contextlib
import fcntl
import mmap
import os
from math import prod
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

_ALIGNMENT = 64  # bytes; what vector instructions like
_SEALS = ("F_SEAL_SHRINK", "F_SEAL_GROW")  # memory that shrinks kills its readers
_CAN_SHARE = hasattr(os, "memfd_create") and hasattr(fcntl, "F_ADD_SEALS")


class SharedMemoryRegion(NamedTuple):
    """A file descriptor of this process, and its size in bytes."""

    descriptor: int
    size: int


class SharedFrameBuffer:
    """The two halves, and how far the present one is drawn on."""

    def __init__(self) -> None:
        self._half_bytes = 0
        self._wanted_bytes = 0
        self._used_bytes = 0
        self._half = 0
        self._memory: NDArray[np.uint8] | None = None
        self._pending_mapping: SharedMemoryRegion | None = None
        self._unacknowledged: list[int] = []

    def begin_episode(self) -> None:
        """Other memory from here on; what was drawn stays with who holds it."""
        self._memory = None
        self._half_bytes = 0

    def swap(self) -> None:
        """Another observation is drawn from here on."""
        self._wanted_bytes = max(self._wanted_bytes, self._used_bytes)
        self._used_bytes = 0
        self._half = 1 - self._half
        if self._wanted_bytes > self._half_bytes and _CAN_SHARE:
            self._share(2 * self._wanted_bytes)
            self._half_bytes = self._wanted_bytes

    def allocate(self, height: int, width: int, channels: int = 3) -> NDArray[np.uint8]:
        """(height, width, channels), uint8, contiguous, with anything in it."""
        shape = (height, width, channels)
        start = self._used_bytes
        self._used_bytes += -(-prod(shape) // _ALIGNMENT) * _ALIGNMENT
        if self._memory is None or self._used_bytes > self._half_bytes:
            return np.empty(shape, np.uint8)
        start += self._half * self._half_bytes
        return self._memory[start : start + prod(shape)].reshape(shape)

    def place_of(self, pixels: NDArray[np.uint8]) -> tuple[int, int] | None:
        """Offset and length in the memory, if the pixels stand there."""
        if self._memory is None or not pixels.flags.c_contiguous:
            return None
        start: int = pixels.ctypes.data - self._memory.ctypes.data
        inside = 0 <= start <= self._memory.nbytes - pixels.nbytes
        return (start, pixels.nbytes) if inside else None

    def pending_mapping(self) -> SharedMemoryRegion | None:
        """New memory that the parent has to map before it reads on, told once."""
        pending, self._pending_mapping = self._pending_mapping, None
        if pending is not None:
            self._unacknowledged.append(pending.descriptor)
        return pending

    def acknowledge(self) -> None:
        """What was told so far is mapped, so that its descriptors can go."""
        while self._unacknowledged:
            os.close(self._unacknowledged.pop())

    def _share(self, size: int) -> None:
        descriptor = os.memfd_create("canvas", os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING)
        os.ftruncate(descriptor, size)
        for seal in _SEALS:
            fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, getattr(fcntl, seal))
        self._memory = np.frombuffer(mmap.mmap(descriptor, size), np.uint8)
        if self._pending_mapping is not None:  # never told, never used
            os.close(self._pending_mapping.descriptor)
        self._pending_mapping = SharedMemoryRegion(descriptor, size)


def map_memory(pid: int, shared: SharedMemoryRegion) -> memoryview:
    """The memory of a child process, to be read. Raises OSError, ValueError."""
    descriptor = os.open(f"/proc/{pid}/fd/{shared.descriptor}", os.O_RDONLY)
    with contextlib.closing(os.fdopen(descriptor, "rb")) as file:
        seals = fcntl.fcntl(file, fcntl.F_GET_SEALS)
        if (
            not seals & fcntl.F_SEAL_SHRINK
            or os.fstat(descriptor).st_size < shared.size
        ):
            raise ValueError("memory that could shrink is not read")
        return memoryview(mmap.mmap(descriptor, shared.size, prot=mmap.PROT_READ))


FRAME_BUFFER = (
    SharedFrameBuffer()
)  # a simulator process has one simulator, and so one canvas
