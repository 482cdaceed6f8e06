"""A double frame buffer in shared memory: raw images reach the server without a copy.

The memory is shared between a simulator process and its parent, in two halves: each
observation is rendered into the half that the previous one did not use, and the parent
sends the pixels from there. The next episode uses other memory, so images that are
still being sent, or stored for a repeated request, are never overwritten by it. The one
after it draws into the memory before, if the parent has no view of it any more: the
first write to a new page takes longer than to draw it.

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
    """A file descriptor of this process, and its size in bytes.

    number: another one for other memory.
    """

    number: int
    descriptor: int
    size: int


class SharedFile(NamedTuple):
    """The same as a file for a program of this machine: path, instead of descriptor."""

    number: int
    path: str
    size: int


class _SharedMemory(NamedTuple):
    """address: where this process has the pixels; NumPy takes long to say it."""

    region: SharedMemoryRegion
    pixels: NDArray[np.uint8]
    address: int


class SharedFrameBuffer:
    """The two halves, and the number of bytes used of the current one."""

    def __init__(self) -> None:
        self._half_bytes = 0
        self._wanted_bytes = 0
        self._used_bytes = 0
        self._half = 0
        self._memory: _SharedMemory | None = None
        self._before: _SharedMemory | None = None
        self._shared = 0
        self._pending_mapping: SharedMemoryRegion | None = None
        self._left: list[int] = []  # descriptors that the parent may still have to open
        self._can_share = _CAN_SHARE

    def keep_private(self) -> None:
        """Share nothing: the parent is on another machine, and pixels are sent."""
        self._can_share = False

    def begin_episode(self, unread: int = 0) -> None:
        """Use other memory; views of the last one stay valid.

        unread: the number of memory that the parent has no view of; 0 for none.
        """
        before, self._before, self._memory = self._before, self._memory, None
        self._half_bytes = 0
        if before is None:
            return
        number, descriptor, size = before.region
        if number == unread and size >= 2 * self._wanted_bytes:
            self._use(before)
        else:
            self._left.append(descriptor)

    def forget(self) -> None:
        """Draw over nothing: the pictures so far are those of another run."""
        self.begin_episode()
        self.begin_episode()

    def swap(self) -> None:
        """Begin another observation, in the other half."""
        self._wanted_bytes = max(self._wanted_bytes, self._used_bytes)
        self._used_bytes = 0
        self._half = 1 - self._half
        if self._wanted_bytes > self._half_bytes and self._can_share:
            self._share(2 * self._wanted_bytes)

    def allocate(self, height: int, width: int, channels: int = 3) -> NDArray[np.uint8]:
        """An uninitialized array (height, width, channels), uint8, contiguous."""
        shape = (height, width, channels)
        start = self._used_bytes
        self._used_bytes += -(-prod(shape) // _ALIGNMENT) * _ALIGNMENT
        if self._memory is None or self._used_bytes > self._half_bytes:
            return np.empty(shape, np.uint8)
        start += self._half * self._half_bytes
        return self._memory.pixels[start : start + prod(shape)].reshape(shape)

    def place_of(self, pixels: NDArray[np.uint8]) -> tuple[int, int] | None:
        """Offset and length in the shared memory, if the pixels are in it."""
        if self._memory is None or not pixels.flags.c_contiguous:
            return None
        start: int = pixels.ctypes.data - self._memory.address
        inside = 0 <= start <= self._memory.region.size - pixels.nbytes
        return (start, pixels.nbytes) if inside else None

    @property
    def file(self) -> SharedFile:
        """The memory of the arrays that `place_of` has a place for."""
        if self._memory is None:
            return SharedFile(0, "", 0)
        number, descriptor, size = self._memory.region
        return SharedFile(number, f"/proc/{os.getpid()}/fd/{descriptor}", size)

    def pending_mapping(self) -> SharedMemoryRegion | None:
        """Memory that the parent has to read from in the next reply; once."""
        pending, self._pending_mapping = self._pending_mapping, None
        return pending

    def acknowledge(self) -> None:
        """The parent has mapped all that it was to map: close what is not used."""
        while self._left:
            os.close(self._left.pop())

    def _use(self, memory: _SharedMemory) -> None:
        self._memory, self._pending_mapping = memory, memory.region
        self._half_bytes = memory.region.size // 2

    def _share(self, size: int) -> None:
        if self._memory is not None:  # it is too small
            self.begin_episode()
        flags = os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING
        descriptor = os.memfd_create("frame_buffer", flags)
        os.ftruncate(descriptor, size)
        for seal in _SEALS:
            fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, getattr(fcntl, seal))
        pixels = np.frombuffer(mmap.mmap(descriptor, size), np.uint8)
        self._shared += 1
        region = SharedMemoryRegion(self._shared, descriptor, size)
        self._use(_SharedMemory(region, pixels, pixels.ctypes.data))


def map_memory(pid: int, shared: SharedMemoryRegion) -> mmap.mmap:
    """Map the memory of a child process, read-only. Raises OSError, ValueError."""
    descriptor = os.open(f"/proc/{pid}/fd/{shared.descriptor}", os.O_RDONLY)
    with contextlib.closing(os.fdopen(descriptor, "rb")) as file:
        seals = fcntl.fcntl(file, fcntl.F_GET_SEALS)
        if (
            not seals & fcntl.F_SEAL_SHRINK
            or os.fstat(descriptor).st_size < shared.size
        ):
            raise ValueError("the memory is not sealed against shrinking")
        return mmap.mmap(descriptor, shared.size, access=mmap.ACCESS_READ)


def is_viewed(memory: mmap.mmap) -> bool:
    """Whether a view of mapped memory exists, which is what refuses a resize first."""
    try:
        memory.resize(len(memory))
    except BufferError:
        return True
    except TypeError:  # it is mapped for reading
        return False
    raise AssertionError("memory that is mapped for reading was resized")


# One per process, because a simulator process has one simulator.
FRAME_BUFFER = SharedFrameBuffer()
