"""The secret that sealed seeds are drawn with, kept in a file beside the database.

With it the seeds of every sealed split can be computed; without it the host draws
others, and its runs are no longer comparable with earlier ones. It must not know how
seeds follow from it.
"""

from __future__ import annotations

import secrets
from pathlib import Path

from reference_record.formats.private_file import read_or_create
from reference_server.files.private_files import restrict

_BYTES = 32


class SeedSecret:
    """The secret in a file; without a file one in memory, lost with the process."""

    def __init__(self, path: Path | None = None) -> None:
        self._path = path
        self.value = secrets.token_bytes(_BYTES)

    def open(self) -> None:
        """Read or create the file. Raises OSError, and ValueError if it has none."""
        if self._path is None:
            return
        text = read_or_create(self._path, lambda: self.value.hex().encode() + b"\n")
        restrict(self._path)
        value = bytes.fromhex(text.decode())
        if len(value) < _BYTES:
            raise ValueError(f"a secret has {_BYTES} bytes in hexadecimal digits")
        self.value = value
