"""Encrypts the API keys of policy servers before they are stored (PUSH-016, FLE-017).

The encryption key is a file next to the database, created at the first start with
access for its owner only: a copy of the database without that file reveals no API key.
The encryption is Fernet of the library `cryptography`; no cryptography is implemented
here. It must not know runs or submissions.
"""

from __future__ import annotations

import hmac
from pathlib import Path

from cryptography.fernet import Fernet, InvalidToken

from reference_record.formats.private_file import read_or_create


class DecryptionFailed(Exception):
    """The text was encrypted with another key, or by another program."""


class KeyEncryption:
    """Encrypts texts with the key in a file.

    Without a file the key is in memory, and what it encrypted is lost with the process.
    """

    def __init__(self, path: Path | None = None) -> None:
        self._path = path
        self._use(Fernet.generate_key())

    def open(self) -> None:
        """Read or create the file. Raises OSError, and ValueError if it has no key."""
        if self._path is not None:
            self._use(read_or_create(self._path, Fernet.generate_key))

    def _use(self, key: bytes) -> None:
        self._fernet, self._key = Fernet(key), key

    def encrypt(self, secret: str) -> str:
        return self._fernet.encrypt(secret.encode()).decode()

    def digest(self, secret: str) -> str:
        """A digest that is equal for equal texts, and shows nothing without the key."""
        return hmac.digest(self._key, secret.encode(), "sha256").hex()

    def decrypt(self, encrypted: str) -> str:
        """Raises DecryptionFailed."""
        try:
            return self._fernet.decrypt(encrypted.encode()).decode()
        except InvalidToken as error:
            raise DecryptionFailed from error
