"""The checkpoint of a history: a signed note of C2SP, by the key that signs records.

Three lines (origin, size, root in base64), an empty line, a line for each signature.
"""

from __future__ import annotations

import base64
import binascii
import hashlib
import re
from dataclasses import dataclass

from reference_record.keys import SigningKey, is_signature

ED25519 = b"\x01"
_NOTE = re.compile(
    r"(?P<text>(?P<origin>[^\n+ ]{1,200})\n(?P<size>0|[1-9][0-9]{0,14})\n"
    r"(?P<root>[A-Za-z0-9+/]{43}=)\n)\n"
    r"(?P<signatures>(?:— [^\n+ ]+ [A-Za-z0-9+/=]+\n){1,16})"
)


class InvalidCheckpoint(ValueError):
    """The note is not a checkpoint, or is not signed by this key."""


@dataclass(frozen=True, slots=True)
class Checkpoint:
    """origin: the name of the log. root: 32 bytes."""

    origin: str
    tree_size: int
    root: bytes

    @property
    def text(self) -> str:
        """The lines that a signature covers: origin, size and root hash."""
        root = base64.b64encode(self.root).decode()
        return f"{self.origin}\n{self.tree_size}\n{root}\n"


def sign(checkpoint: Checkpoint, key: SigningKey) -> str:
    """The note, with one signature under the name of the origin."""
    signature = _key_id(checkpoint.origin, key.public_key) + key.sign(
        checkpoint.text.encode()
    )
    line = f"— {checkpoint.origin} {base64.b64encode(signature).decode()}\n"
    return f"{checkpoint.text}\n{line}"


def read(note: str, public_key: bytes) -> Checkpoint:
    """The checkpoint that the owner of the key signed. Raises InvalidCheckpoint."""
    form = _NOTE.fullmatch(note)
    if form is None:
        raise InvalidCheckpoint("it is no signed note of three lines")
    wanted = _key_id(form["origin"], public_key)
    for line in form["signatures"].splitlines():
        _, name, encoded = line.split(" ")
        try:
            signature = base64.b64decode(encoded, validate=True)
        except binascii.Error:
            continue
        signed = form["text"].encode()
        if name == form["origin"] and signature[:4] == wanted:
            if is_signature(public_key, signature[4:], signed):
                root = base64.b64decode(form["root"])
                return Checkpoint(form["origin"], int(form["size"]), root)
            raise InvalidCheckpoint("its signature is not right")
    raise InvalidCheckpoint("it is not signed by this key")


def _key_id(name: str, public_key: bytes) -> bytes:
    return hashlib.sha256(name.encode() + b"\n" + ED25519 + public_key).digest()[:4]
