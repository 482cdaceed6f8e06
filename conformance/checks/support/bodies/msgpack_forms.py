"""MessagePack in every format that it has for a value, which encoders seldom choose.

Contains requests only; the checks state the expected responses.
"""

import struct
from typing import Any

# Widths in bytes of lengths and integers; 0: inside the first byte, where they fit.
WIDTHS = (0, 1, 2, 4, 8)
_UNSIGNED = {1: ">B", 2: ">H", 4: ">I", 8: ">Q"}
_INTEGERS = {1: 0xCC, 2: 0xCD, 4: 0xCE, 8: 0xCF}  # uint 8, 16, 32, 64
_SIGNED = {1: 0xD0, 2: 0xD1, 4: 0xD2, 8: 0xD3}  # int 8, 16, 32, 64
_TEXTS = {0: 0xA0, 1: 0xD9, 2: 0xDA, 4: 0xDB}
_LISTS = {0: 0x90, 2: 0xDC, 4: 0xDD}
_MAPS = {0: 0x80, 2: 0xDE, 4: 0xDF}
_FIT = {0xA0: 32, 0x90: 16, 0x80: 16}  # lengths that fit into the first byte


class Twice(str):
    """A key that a dict holds beside an equal one."""

    __slots__ = ()
    __hash__ = object.__hash__

    def __eq__(self, other: object) -> bool:
        return self is other


def pack(value: Any, width: int, is_signed: bool) -> bytes:
    """Encode with lengths and integers of a width; floats that are whole as integers.

    Other floats take four bytes, and have to be exact in them. Negative integers are
    signed in any case.
    """
    if isinstance(value, float) and not value.is_integer():
        return b"\xca" + struct.pack(">f", value)
    if isinstance(value, int | float):
        return _integer(int(value), width, is_signed)
    if isinstance(value, str):
        text = value.encode()
        return _head(_TEXTS, width, len(text)) + text
    if isinstance(value, list):
        parts = [pack(entry, width, is_signed) for entry in value]
        return _head(_LISTS, width, len(value)) + b"".join(parts)
    parts = [
        pack(part, width, is_signed) for member in value.items() for part in member
    ]
    return _head(_MAPS, width, len(value)) + b"".join(parts)


def _integer(value: int, width: int, is_signed: bool) -> bytes:
    if width == 0 and -32 <= value < 128:
        return struct.pack(">b", value)
    format_ = _UNSIGNED[width or 1]
    if is_signed or value < 0:
        return bytes([_SIGNED[width or 1]]) + struct.pack(format_.lower(), value)
    return bytes([_INTEGERS[width or 1]]) + struct.pack(format_, value)


def _head(formats: dict[int, int], width: int, length: int) -> bytes:
    if width == 0 and length < _FIT[formats[0]]:
        return bytes([formats[0] | length])
    width = min(offered for offered in formats if offered and offered >= min(width, 4))
    return bytes([formats[width]]) + struct.pack(_UNSIGNED[width], length)
