"""The history of a leaderboard as RFC 6962 and C2SP define it, computed from leaves.

Recursive and slow, after the text of section 2.1; a server need not do it so.
"""

import base64
import hashlib
import re
from collections.abc import Sequence
from dataclasses import dataclass

from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PublicKey

from conformance.verdicts.expect import Violation

_NOTE = re.compile(
    r"(?P<text>(?P<origin>[^\n+ ]+)\n(?P<size>0|[1-9][0-9]*)\n(?P<root>[^\n]+)\n)\n"
    r"(?P<signatures>(?:— [^\n ]+ [^\n ]+\n)+)"
)


@dataclass(frozen=True)
class ReadCheckpoint:
    """The content of a signed note; the root is in hexadecimal digits."""

    tree_size: int
    root_sha256: str


def tree_root(leaves: Sequence[bytes]) -> bytes:
    """Give MTH(leaves)."""
    if not leaves:
        return hashlib.sha256().digest()
    if len(leaves) == 1:
        return hashlib.sha256(b"\x00" + leaves[0]).digest()
    k = _power_below(len(leaves))
    both = tree_root(leaves[:k]) + tree_root(leaves[k:])
    return hashlib.sha256(b"\x01" + both).digest()


def inclusion_path(leaves: Sequence[bytes], index: int) -> list[str]:
    """Give PATH(index, leaves) in hexadecimal digits."""
    if len(leaves) == 1:
        return []
    k = _power_below(len(leaves))
    if index < k:
        return [*inclusion_path(leaves[:k], index), tree_root(leaves[k:]).hex()]
    return [*inclusion_path(leaves[k:], index - k), tree_root(leaves[:k]).hex()]


def consistency_proof(leaves: Sequence[bytes], old_size: int) -> list[str]:
    """Give PROOF(old_size, leaves) in hexadecimal digits."""
    return _subproof(old_size, leaves, is_whole=True)


def _subproof(m: int, leaves: Sequence[bytes], *, is_whole: bool) -> list[str]:
    if m == len(leaves):
        return [] if is_whole else [tree_root(leaves).hex()]
    k = _power_below(len(leaves))
    if m <= k:
        left = _subproof(m, leaves[:k], is_whole=is_whole)
        return [*left, tree_root(leaves[k:]).hex()]
    right = _subproof(m - k, leaves[k:], is_whole=False)
    return [*right, tree_root(leaves[:k]).hex()]


def _power_below(n: int) -> int:
    k = 1
    while 2 * k < n:
        k *= 2
    return k


def read_note(note: str, public_key: bytes) -> ReadCheckpoint:
    """Read a signed note; raises Violation where it is none by this key."""
    form = _NOTE.fullmatch(note)
    if form is None:
        raise Violation("a signed note of three lines", note)
    origin = form["origin"].encode()
    key_id = hashlib.sha256(origin + b"\n\x01" + public_key).digest()[:4]
    for line in form["signatures"].splitlines():
        _, name, encoded = line.split(" ")
        signature = _decoded(encoded)
        if name.encode() == origin and signature[:4] == key_id:
            _verify(public_key, signature[4:], form["text"])
            root = _decoded(form["root"]).hex()
            return ReadCheckpoint(int(form["size"]), root)
    raise Violation("a signature by the key that is in use", note)


def _decoded(text: str) -> bytes:
    try:
        return base64.b64decode(text, validate=True)
    except ValueError as error:
        raise Violation("base64 in a signed note", text) from error


def _verify(public_key: bytes, signature: bytes, text: str) -> None:
    key = Ed25519PublicKey.from_public_bytes(public_key)
    try:
        key.verify(signature, text.encode())
    except (InvalidSignature, ValueError) as error:
        raise Violation("a right signature of the note", text) from error
