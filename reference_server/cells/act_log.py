"""Every act at the cells of a server, in a file that only grows: a line of JSON each.

A line is on disk before its act has an effect that a policy can see.
"""

from __future__ import annotations

import hashlib
import os
import secrets
import time
from collections import defaultdict
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec

from reference_server.files.private_files import create_empty
from reference_server.views.run_views import timestamp


class ActLog:
    """path: None keeps the acts in memory alone."""

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self.lines: list[dict[str, Any]] = []
        self._salt = secrets.token_hex(16)
        self._by_run: defaultdict[str, list[dict[str, Any]]] = defaultdict(list)

    def open(self) -> None:
        """Read what was done before. Raises OSError and ValueError."""
        if self._path is None or not self._path.exists():
            return
        text = self._path.read_bytes()
        whole = text.rfind(b"\n") + 1
        if whole < len(text):  # a crash has cut the last line
            os.truncate(self._path, whole)
        self.lines = [msgspec.json.decode(line) for line in text[:whole].splitlines()]
        if self.lines:
            self._salt = self.lines[0]["salt"]
        for line in self.lines:
            self._note_run(line)

    def add(self, **members: Any) -> None:
        """Append a line (PHY-022). Blocks for the disk. Raises OSError."""
        if not self.lines and "salt" not in members:
            if self._path is not None:
                create_empty(self._path)
            self.add(salt=self._salt)
        line = {"at": timestamp(time.time()), **members}
        self.lines.append(line)
        self._note_run(line)
        if self._path is not None:
            with self._path.open("ab") as file:
                file.write(msgspec.json.encode(line) + b"\n")
                file.flush()
                os.fsync(file.fileno())

    def of_run(self, run_id: str) -> Sequence[Mapping[str, Any]]:
        """The acts during trials of a run."""
        return self._by_run.get(run_id, ())

    def _note_run(self, line: dict[str, Any]) -> None:
        if "run" in line:
            self._by_run[line["run"]].append(line)

    def pseudonym(self, account: str) -> str:
        """The name of a person in records: the same on this server, of no account."""
        digest = hashlib.sha256(f"{self._salt}/{account}".encode()).hexdigest()
        return f"judge_{digest[:8]}"
