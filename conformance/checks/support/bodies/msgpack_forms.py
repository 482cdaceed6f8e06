"""MessagePack in every format that it has for a value, which encoders seldom choose.

Contains requests only; the checks state the expected responses.
"""

import struct
from typing import Any

# Widths in bytes of lengths and integers.
WIDTHS = (1, 2, 4)
_UNSIGNED = {1: ">B", 2: ">H", 4: ">I"}
_INTEGERS = {1: 0xCC, 2: 0xCD, 4: 0xCE}  # uint 8, 16, 32
_SIGNED = {1: 0xD0, 2: 0xD1, 4: 0xD2}  # int 8, 16, 32
_TEXTS = {1: 0xD9, 2: 0xDA, 4: 0xDB}
_LISTS = {2: 0xDC, 4: 0xDD}
_MAPS = {2: 0xDE, 4: 0xDF}


def pack(value: Any, width: int, is_signed: bool) -> bytes:
    """Encode with lengths and integers of a width; floats that are whole as integers.

    Other floats take four bytes, and have to be exact in them.
    """
    if isinstance(value, float) and not value.is_integer():
        return b"\xca" + struct.pack(">f", value)
    if isinstance(value, int | float):
        format_ = _UNSIGNED[width].lower() if is_signed else _UNSIGNED[width]
        first = (_SIGNED if is_signed else _INTEGERS)[width]
        return bytes([first]) + struct.pack(format_, int(value))
    if isinstance(value, str):
        text = value.encode()
        return _head(_TEXTS, width, len(text)) + text
    if isinstance(value, list):
        parts = [pack(entry, width, is_signed) for entry in value]
        return _head(_LISTS, max(width, 2), len(value)) + b"".join(parts)
    parts = [
        pack(part, width, is_signed) for member in value.items() for part in member
    ]
    return _head(_MAPS, max(width, 2), len(value)) + b"".join(parts)


def _head(formats: dict[int, int], width: int, length: int) -> bytes:
    return bytes([formats[width]]) + struct.pack(_UNSIGNED[width], length)
