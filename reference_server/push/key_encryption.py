"""Encrypts the API keys of policy servers before they are stored (PUSH-016, FLE-017).

The encryption key is a file next to the database, created at the first start with
access for its owner only: a copy of the database without that file reveals no API key.
The encryption is Fernet of the library `cryptography`; no cryptography is implemented
here. It must not know runs or submissions.
"""

from __future__ import annotations

import os
from pathlib import Path

from cryptography.fernet import Fernet, InvalidToken


class DecryptionFailed(Exception):
    """The text was encrypted with another key, or by another program."""


class KeyEncryption:
    """Encrypts texts with the key in a file.

    Without a file the key is in memory, and what it encrypted is lost with the process.
    """

    def __init__(self, path: Path | None = None) -> None:
        self._path = path
        self._fernet = Fernet(Fernet.generate_key())

    def open(self) -> None:
        """Read or create the file. Raises OSError, and ValueError if it has no key."""
        if self._path is not None:
            self._fernet = Fernet(_key(self._path))

    def encrypt(self, secret: str) -> str:
        return self._fernet.encrypt(secret.encode()).decode()

    def decrypt(self, encrypted: str) -> str:
        """Raises DecryptionFailed."""
        try:
            return self._fernet.decrypt(encrypted.encode()).decode()
        except InvalidToken as error:
            raise DecryptionFailed from error


def _key(path: Path) -> bytes:
    """The key in the file, created if missing; two servers that start at once agree."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f"{path.name}.{os.getpid()}")
    temporary.touch(mode=0o600)
    try:
        temporary.write_bytes(Fernet.generate_key())
        # Atomic: the file appears complete or not at all, and never replaces another.
        os.link(temporary, path)
    except FileExistsError:
        pass
    finally:
        temporary.unlink()
    return path.read_bytes().strip()
