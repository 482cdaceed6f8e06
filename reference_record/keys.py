"""Ed25519 keys: the pair that signs records, the name of a public key, the key file."""

from __future__ import annotations

import base64
import binascii
import hashlib
import os
from pathlib import Path
from typing import Final

from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives.asymmetric.ed25519 import (
    Ed25519PrivateKey,
    Ed25519PublicKey,
)

from reference_record.broken import UnusableRecord
from reference_record.formats.private_file import read_or_create
from reference_record.formats.user_folders import config_folder

PUBLIC_KEY_BYTES: Final = 32
SIGNATURE_BYTES: Final = 64
KEYID_PREFIX: Final = "SHA256:"


def keyid_of(public_key: bytes) -> str:
    """REC-006: the name of a public key of 32 bytes."""
    return KEYID_PREFIX + hashlib.sha256(public_key).hexdigest()


def is_signature(public_key: bytes, signature: bytes, message: bytes) -> bool:
    """Whether the owner of the key signed the message (REC-006)."""
    if len(public_key) != PUBLIC_KEY_BYTES or len(signature) != SIGNATURE_BYTES:
        return False
    try:
        Ed25519PublicKey.from_public_bytes(public_key).verify(signature, message)
    except (InvalidSignature, ValueError):
        return False
    return True


class SigningKey:
    """A pair of keys. seed: the 32 secret bytes."""

    def __init__(self, seed: bytes) -> None:
        self._key = Ed25519PrivateKey.from_private_bytes(seed)
        self.public_key = self._key.public_key().public_bytes_raw()
        self.keyid = keyid_of(self.public_key)

    def sign(self, message: bytes) -> bytes:
        return self._key.sign(message)

    def content_of_file(self) -> bytes:
        """The secret as `load_or_make` reads it."""
        return base64.b64encode(self._key.private_bytes_raw()) + b"\n"


def make_key() -> SigningKey:
    """A new pair, in memory alone."""
    return SigningKey(Ed25519PrivateKey.generate().private_bytes_raw())


def load_or_make(path: Path) -> SigningKey:
    """The key in a file that its owner alone may read; made when there is none.

    Two processes that begin at the same time get the same key. Raises UnusableRecord.
    """
    content = read_or_create(path, lambda: make_key().content_of_file())
    if os.name == "posix" and path.stat().st_mode & 0o077:
        raise UnusableRecord(f"{path} can be read by others: chmod 600 {path}")
    try:
        return SigningKey(base64.b64decode(content, validate=True))
    except (ValueError, binascii.Error) as error:
        raise UnusableRecord(f"{path} holds no signing key") from error


def own_key_file() -> Path:
    """The key of the user of this machine, who replays records; a host has another.

    Raises RuntimeError where there is no home directory.
    """
    return config_folder() / "signing-key"


def own_keyid() -> str | None:
    """The name of the key with which this user signs replays; None without one."""
    try:
        path = own_key_file()
        return load_or_make(path).keyid if path.exists() else None
    except (OSError, RuntimeError, UnusableRecord):  # no home, or not readable
        return None
