"""A double frame buffer in shared memory: raw images reach the server without a copy.

The memory is shared between a simulator process and its parent, in two halves: each
observation is rendered into the half that the previous one did not use, and the parent
sends the pixels from there. Every episode uses new memory, so images that are still
being sent, or stored for a repeated request, are never overwritten by another episode.

A simulator may render elsewhere; then its pixels are copied, as they are on systems
without shared memory (it needs Linux) and in the first observation, whose size is not
yet known. A simulator can be written without knowing this module.
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

_ALIGNMENT = 64  # bytes; fast for vector instructions
_SEALS = ("F_SEAL_SHRINK", "F_SEAL_GROW")  # reading memory that shrank is a SIGBUS
_CAN_SHARE = hasattr(os, "memfd_create") and hasattr(fcntl, "F_ADD_SEALS")


class SharedMemoryRegion(NamedTuple):
    """A file descriptor of this process, and its size in bytes."""

    descriptor: int
    size: int


class SharedFile(NamedTuple):
    """The memory as a file for a program of this machine.

    number: another one for other memory. path: can be opened until the next command.
    """

    number: int
    path: str
    size: int


class SharedFrameBuffer:
    """The two halves, and the number of bytes used of the current one."""

    def __init__(self) -> None:
        self._half_bytes = 0
        self._wanted_bytes = 0
        self._used_bytes = 0
        self._half = 0
        self._memory: NDArray[np.uint8] | None = None
        self._pending_mapping: SharedMemoryRegion | None = None
        self._unacknowledged: list[int] = []
        self._file = SharedFile(0, "", 0)
        self._can_share = _CAN_SHARE

    def keep_private(self) -> None:
        """Share nothing: the parent is on another machine, and pixels are sent."""
        self._can_share = False

    def begin_episode(self) -> None:
        """Use new memory; views of the old memory stay valid."""
        self._memory = None
        self._half_bytes = 0

    def swap(self) -> None:
        """Begin another observation, in the other half."""
        self._wanted_bytes = max(self._wanted_bytes, self._used_bytes)
        self._used_bytes = 0
        self._half = 1 - self._half
        if self._wanted_bytes > self._half_bytes and self._can_share:
            self._share(2 * self._wanted_bytes)
            self._half_bytes = self._wanted_bytes

    def allocate(self, height: int, width: int, channels: int = 3) -> NDArray[np.uint8]:
        """An uninitialized array (height, width, channels), uint8, contiguous."""
        shape = (height, width, channels)
        start = self._used_bytes
        self._used_bytes += -(-prod(shape) // _ALIGNMENT) * _ALIGNMENT
        if self._memory is None or self._used_bytes > self._half_bytes:
            return np.empty(shape, np.uint8)
        start += self._half * self._half_bytes
        return self._memory[start : start + prod(shape)].reshape(shape)

    def place_of(self, pixels: NDArray[np.uint8]) -> tuple[int, int] | None:
        """Offset and length in the shared memory, if the pixels are in it."""
        if self._memory is None or not pixels.flags.c_contiguous:
            return None
        start: int = pixels.ctypes.data - self._memory.ctypes.data
        inside = 0 <= start <= self._memory.nbytes - pixels.nbytes
        return (start, pixels.nbytes) if inside else None

    @property
    def file(self) -> SharedFile:
        """The memory of the arrays that `place_of` has a place for."""
        return self._file

    def pending_mapping(self) -> SharedMemoryRegion | None:
        """New memory that the parent has to map before the next reply; once."""
        pending, self._pending_mapping = self._pending_mapping, None
        if pending is not None:
            self._unacknowledged.append(pending.descriptor)
        return pending

    def acknowledge(self) -> None:
        """The parent has mapped all pending memory: close its descriptors."""
        while self._unacknowledged:
            os.close(self._unacknowledged.pop())

    def _share(self, size: int) -> None:
        flags = os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING
        descriptor = os.memfd_create("frame_buffer", flags)
        os.ftruncate(descriptor, size)
        for seal in _SEALS:
            fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, getattr(fcntl, seal))
        self._memory = np.frombuffer(mmap.mmap(descriptor, size), np.uint8)
        if self._pending_mapping is not None:  # never reported, never used
            os.close(self._pending_mapping.descriptor)
        self._pending_mapping = SharedMemoryRegion(descriptor, size)
        path = f"/proc/{os.getpid()}/fd/{descriptor}"
        self._file = SharedFile(self._file.number + 1, path, size)


def map_memory(pid: int, shared: SharedMemoryRegion) -> memoryview:
    """Map the memory of a child process, read-only. Raises OSError, ValueError."""
    descriptor = os.open(f"/proc/{pid}/fd/{shared.descriptor}", os.O_RDONLY)
    with contextlib.closing(os.fdopen(descriptor, "rb")) as file:
        seals = fcntl.fcntl(file, fcntl.F_GET_SEALS)
        if (
            not seals & fcntl.F_SEAL_SHRINK
            or os.fstat(descriptor).st_size < shared.size
        ):
            raise ValueError("the memory is not sealed against shrinking")
        return memoryview(mmap.mmap(descriptor, shared.size, prot=mmap.PROT_READ))


# One per process, because a simulator process has one simulator.
FRAME_BUFFER = SharedFrameBuffer()
