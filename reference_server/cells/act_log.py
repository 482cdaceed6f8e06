"""Every act at the cells of a server, in a file that only grows: a line of JSON each.

A line is on disk before its act has an effect that others can see: who shows one waits
for `flush` first. Nothing waits for the disk on the event loop, for a stop of any robot
may come meanwhile.
"""

from __future__ import annotations

import asyncio
import hashlib
import os
import secrets
import time
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import TypedDict, Unpack

import msgspec

from reference_record.texts.timestamps import timestamp
from reference_server.files.private_files import create_empty


class ActLine(TypedDict, total=False):
    """A line: at, and what its act says.

    The first line of a file has `salt` alone. benchmark to attempt: the trial at the
    cell. success to drawn: of a judgement.
    """

    at: str
    salt: str
    act: str
    operator: str
    reason: str
    phase: str
    benchmark: str
    cell: str
    trial: int
    run: str
    episode: str
    attempt: int
    success: bool
    score: float
    met: Sequence[int]
    note: str
    blind: bool
    drawn: bool


class ActLog:
    """path: None keeps the acts in memory alone."""

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self.lines: list[ActLine] = []
        self._on_disk = 0
        self._salt = secrets.token_hex(16)
        self._by_run: defaultdict[str, list[ActLine]] = defaultdict(list)

    def open(self) -> None:
        """Read what was done before. Raises OSError and ValueError."""
        if self._path is None or not self._path.exists():
            return
        text = self._path.read_bytes()
        whole = text.rfind(b"\n") + 1
        if whole < len(text):  # a crash has cut the last line
            os.truncate(self._path, whole)
        self.lines = [
            msgspec.json.decode(line, type=ActLine)
            for line in text[:whole].splitlines()
        ]
        self._on_disk = len(self.lines)
        if self.lines:
            if "salt" not in self.lines[0]:
                raise ValueError("it is no file of acts")
            self._salt = self.lines[0]["salt"]
        for line in self.lines:
            self._note_run(line)

    def add(self, **members: Unpack[ActLine]) -> None:
        """Append a line (PHY-022). Raises OSError."""
        if not self.lines and "salt" not in members:
            if self._path is not None:
                create_empty(self._path)
            self.add(salt=self._salt)
        line: ActLine = {"at": timestamp(time.time()), **members}
        self.lines.append(line)
        self._note_run(line)
        if self._path is not None:
            with self._path.open("ab") as file:
                file.write(msgspec.json.encode(line) + b"\n")

    async def flush(self) -> None:
        """Returns when each line that was added is on disk. Raises OSError."""
        path, count = self._path, len(self.lines)
        if path is None or count <= self._on_disk:
            return

        def write() -> None:
            with path.open("ab") as file:
                os.fsync(file.fileno())

        await asyncio.to_thread(write)
        self._on_disk = max(self._on_disk, count)

    def of_run(self, run_id: str) -> Sequence[ActLine]:
        """The acts during trials of a run."""
        return self._by_run.get(run_id, ())

    def _note_run(self, line: ActLine) -> None:
        if "run" in line:
            self._by_run[line["run"]].append(line)

    def pseudonym(self, account: str) -> str:
        """The name of a person in records: the same on this server, of no account."""
        digest = hashlib.sha256(f"{self._salt}/{account}".encode()).hexdigest()
        return f"judge_{digest[:8]}"

    def second_id(self, run_id: str, episode_id: str) -> str:
        """The name of an episode for a second judge, which shows neither."""
        name = f"{self._salt}/second/{run_id}/{episode_id}"
        return f"second_{hashlib.sha256(name.encode()).hexdigest()[:16]}"
