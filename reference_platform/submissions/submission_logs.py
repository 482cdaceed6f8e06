"""The logs of submissions: files of lines, durable when they are written, and bounded.

A policy can fill its part and no more; the acts of the platform are always
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
_FULL = "The log is full: what the policy prints from here on is left out."
_encode = msgspec.json.Encoder().encode
_decoder = msgspec.json.Decoder(LogLine)


@dataclass(slots=True)
class _Written:
    """The size of one log on the disk. policy_bytes: of the texts of the policy."""

    lines: int = 0
    policy_bytes: int = 0


class FileLogs:
    """One file per submission; the methods may be called by any thread.

    is_ended: whether a submission has ended, so that no line comes any more.
    """

    def __init__(
        self,
        folder: Path,
        is_ended: Callable[[str], bool],
        policy_bytes_max: int = POLICY_BYTES_MAX,
    ) -> None:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        self._folder = folder
        self._is_ended = is_ended
        self._policy_bytes_max = policy_bytes_max
        self._written: dict[str, _Written] = {}
        self._lock = threading.Lock()

    def write(
        self, submission_id: str, source: Literal["policy", "platform"], text: str
    ) -> None:
        now = time.time()
        with self._lock:
            written = self._state_of(submission_id)
            lines = list(self._admitted(written, source, text))
            encoded = []
            for line_source, line in lines:
                written.lines += 1
                log_line = LogLine(written.lines, now, line_source, line)
                encoded.append(_encode(log_line) + b"\n")
            if encoded:
                self._append(submission_id, b"".join(encoded))

    def read(self, submission_id: str, after: int = 0) -> Sequence[LogLine]:
        return self._read_from(submission_id, 0, after)[0]

    async def follow(
        self, submission_id: str, after: int = 0
    ) -> AsyncIterator[LogLine]:
        offset = 0
        while True:
            # Asked before the lines are read: what is written last is not missed.
            is_ended = self._is_ended(submission_id)
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
        """HST-025: the lines that are written."""
        lines: list[tuple[Literal["policy", "platform"], str]] = []
        for line in text.splitlines():
            if source == "policy":
                if written.policy_bytes >= self._policy_bytes_max:
                    break
                written.policy_bytes += len(line.encode(errors="replace")) + 1
                lines.append((source, line))
                if written.policy_bytes >= self._policy_bytes_max:
                    lines.append(("platform", _FULL))
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
            path = self._path(submission_id)
            if path.exists() and path.stat().st_size > end:
                os.truncate(path, end)
        return written

    def _append(self, submission_id: str, content: bytes) -> None:
        flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | os.O_CLOEXEC
        file_fd = os.open(self._path(submission_id), flags, 0o600)
        with os.fdopen(file_fd, "ab") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())

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
