"""API keys of policy servers at rest: sealed, so that the database gives none away.

The sealing key is a file beside the database, made at the first start and readable by
its owner alone. A copy of the database without it holds no secret. Authenticated
encryption is Fernet's (`cryptography`); nothing of it is ours.
"""

from __future__ import annotations

import os
from pathlib import Path

from cryptography.fernet import Fernet, InvalidToken


class DecryptionFailed(Exception):
    """The text was sealed with another key, or is none of ours."""


class KeyEncryption:
    """Seals texts with the key in a file; without a file, until the process ends."""

    def __init__(self, path: Path | None = None) -> None:
        self._path = path
        self._fernet = Fernet(Fernet.generate_key())

    def open(self) -> None:
        """Read or make the file. Raises OSError, and ValueError if it has no key."""
        if self._path is not None:
            self._fernet = Fernet(_key(self._path))

    def encrypt(self, secret: str) -> str:
        return self._fernet.encrypt(secret.encode()).decode()

    def decrypt(self, encrypted: str) -> str:
        """Raises SealBroken."""
        try:
            return self._fernet.decrypt(encrypted.encode()).decode()
        except InvalidToken as error:
            raise DecryptionFailed from error


def _key(path: Path) -> bytes:
    """The key in the file, made with it; two servers that start at once agree."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f"{path.name}.{os.getpid()}")
    temporary.touch(mode=0o600)
    try:
        temporary.write_bytes(Fernet.generate_key())
        # Appears whole or not at all, and never in place of one that is there.
        os.link(temporary, path)
    except FileExistsError:
        pass
    finally:
        temporary.unlink()
    return path.read_bytes().strip()
