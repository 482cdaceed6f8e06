"""Memory, descriptors and threads of the server's process."""

from __future__ import annotations

import contextlib
import threading
from dataclasses import dataclass

import psutil

SAMPLE_S = 0.05
MB = 10**6


@dataclass(frozen=True)
class Usage:
    """rss: bytes of memory in use; 0 everywhere of a process that has ended."""

    rss: int = 0
    files: int = 0
    threads: int = 0

    def max(self, other: Usage) -> Usage:
        return Usage(
            max(self.rss, other.rss),
            max(self.files, other.files),
            max(self.threads, other.threads),
        )


def read_usage(pid: int) -> Usage:
    with contextlib.suppress(psutil.Error):
        process = psutil.Process(pid)
        rss = process.memory_info().rss
        return Usage(rss, process.num_fds(), process.num_threads())
    return Usage()


class PeakUsage:
    """Samples in a thread; `peak` is the highest of each since it began."""

    def __init__(self, pid: int) -> None:
        self.peak = read_usage(pid)
        self._pid = pid
        self._is_ending = threading.Event()
        self._thread = threading.Thread(target=self._sample, daemon=True)
        self._thread.start()

    def _sample(self) -> None:
        while not self._is_ending.wait(SAMPLE_S):
            self.peak = self.peak.max(read_usage(self._pid))

    def end(self) -> Usage:
        self._is_ending.set()
        self._thread.join()
        return self.peak
