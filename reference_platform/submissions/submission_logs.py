"""The logs of submissions: files of lines, durable when they are written, and bounded.

A policy can fill its part and no more (HST-025); the acts of the platform are always
written (HST-040). Lines that a full disk refuses stay in memory until they can be
written.
"""

from __future__ import annotations

import asyncio
import os
import threading
import time
from collections.abc import AsyncIterator, Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import msgspec

from reference_platform.submissions.interfaces import LogLine

POLICY_BYTES_MAX = 4 * 2**20
_LOOK_S = 0.2
_LAST_BYTES = 2**16  # longer than any line
_FULL = (
    "The log has the first {limit:g} MiB that the policy printed; what it prints from "
    "here on is left out."
)
_encode = msgspec.json.Encoder().encode
_decoder = msgspec.json.Decoder(LogLine)


@dataclass(slots=True)
class _Written:
    """One log. policy_bytes: of the texts of the policy. size: of the file.

    waiting: lines that are not on the disk yet.
    """

    lines: int = 0
    policy_bytes: int = 0
    size: int = 0
    waiting: bytes = b""


class FileLogs:
    """One file per submission; the methods may be called by any thread.

    is_ended: whether a submission has ended, so that no line comes any more.
    host_folders: whose paths participants do not see.
    """

    def __init__(
        self,
        folder: Path,
        is_ended: Callable[[str], bool],
        policy_bytes_max: int = POLICY_BYTES_MAX,
        host_folders: Sequence[Path] = (),
    ) -> None:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        self._folder = folder
        self.is_ended = is_ended
        self._policy_bytes_max = policy_bytes_max
        self.host_folders = host_folders
        # Why lines wait; empty if none does.
        self.problem = ""
        self._written: dict[str, _Written] = {}
        self._lock = threading.Lock()

    def write(
        self, submission_id: str, source: Literal["policy", "platform"], text: str
    ) -> None:
        now = time.time()
        with self._lock:
            written = self._state_of(submission_id)
            for line_source, line in self._admitted(written, source, text):
                written.lines += 1
                log_line = LogLine(written.lines, now, line_source, line)
                written.waiting += _encode(log_line) + b"\n"
            self._write_waiting(submission_id, written)

    def is_durable(self, submission_id: str) -> bool:
        with self._lock:
            return self._write_waiting(submission_id, self._state_of(submission_id))

    def last_text(self, submission_id: str) -> str:
        try:
            with self._path(submission_id).open("rb") as file:
                file.seek(max(0, file.seek(0, os.SEEK_END) - _LAST_BYTES))
                lines = file.read().splitlines()
            return _decoder.decode(lines[-1]).text if lines else ""
        except (FileNotFoundError, msgspec.DecodeError):
            return ""

    def read(self, submission_id: str, after: int = 0) -> Sequence[LogLine]:
        return self._read_from(submission_id, 0, after)[0]

    async def follow(
        self, submission_id: str, after: int = 0
    ) -> AsyncIterator[LogLine]:
        offset = 0
        while True:
            # Asked before the lines are read: what is written last is not missed.
            is_ended = self.is_ended(submission_id)
            lines, offset = await asyncio.to_thread(
                self._read_from, submission_id, offset, after
            )
            for line in lines:
                yield line
            if is_ended:
                return
            if not lines:
                await asyncio.sleep(_LOOK_S)

    def remove(self, submission_id: str) -> None:
        with self._lock:
            self._path(submission_id).unlink(missing_ok=True)
            self._written.pop(submission_id, None)

    def _admitted(
        self, written: _Written, source: Literal["policy", "platform"], text: str
    ) -> Sequence[tuple[Literal["policy", "platform"], str]]:
        """The lines that are kept: of the policy, the first bytes (HST-025).

        HST-040: a line of the platform says where they end.
        """
        lines: list[tuple[Literal["policy", "platform"], str]] = []
        for line in text.splitlines():
            if source == "policy":
                if written.policy_bytes >= self._policy_bytes_max:
                    break
                written.policy_bytes += len(line.encode(errors="replace")) + 1
                lines.append((source, line))
                if written.policy_bytes >= self._policy_bytes_max:
                    limit = self._policy_bytes_max / 2**20
                    lines.append(("platform", _FULL.format(limit=limit)))
            else:
                lines.append((source, line))
        return lines

    def _state_of(self, submission_id: str) -> _Written:
        """Read from the disk once. A line that was cut by a crash is removed."""
        written = self._written.get(submission_id)
        if written is None:
            written = self._written[submission_id] = _Written()
            lines, end = self._read_from(submission_id, 0, 0)
            written.lines = len(lines)
            texts = [line.text for line in lines if line.source == "policy"]
            written.policy_bytes = sum(len(text.encode()) + 1 for text in texts)
            written.size = end
        return written

    def _write_waiting(self, submission_id: str, written: _Written) -> bool:
        """Whether nothing waits any more; a part of a write is not left behind."""
        if not written.waiting:
            return True
        flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | os.O_CLOEXEC
        try:
            file_fd = os.open(self._path(submission_id), flags, 0o600)
            try:
                os.ftruncate(file_fd, written.size)
                if os.write(file_fd, written.waiting) < len(written.waiting):
                    return False
                os.fsync(file_fd)
            finally:
                os.close(file_fd)
        except OSError as error:
            self.problem = f"logs cannot be written: {error.strerror}"
            return False
        self.problem = ""
        written.size += len(written.waiting)
        written.waiting = b""
        return True

    def _read_from(
        self, submission_id: str, offset: int, after: int
    ) -> tuple[list[LogLine], int]:
        """The complete lines from an offset on, and where they end."""
        try:
            with self._path(submission_id).open("rb") as file:
                file.seek(offset)
                content = file.read()
        except FileNotFoundError:
            return [], offset
        end = content.rfind(b"\n") + 1
        lines = [_decoder.decode(line) for line in content[:end].splitlines()]
        return [line for line in lines if line.number > after], offset + end

    def _path(self, submission_id: str) -> Path:
        return self._folder / f"{submission_id}.jsonl"
