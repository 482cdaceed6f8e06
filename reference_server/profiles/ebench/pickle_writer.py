"""Writes pickles of plain data without the module `pickle` (EBE-020).

Only the opcodes of plain values are written: a client can read the result with an
unpickler that permits no names. The pickles have protocol 2, which every Python 3
reads. `pickle_reader` reads pickles. This module must not know requests or runs.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Mapping
from typing import Any


def write(value: Any) -> bytes:
    """EBE-020: a pickle of dicts, lists, strings, numbers, booleans and None.

    bytes are written as text and must be UTF-8. Raises TypeError for anything else.
    """
    return b"".join((b"\x80\x02", *_written(value), b"."))


def _written(value: Any) -> Iterator[bytes]:
    match value:
        case None:
            yield b"N"
        case bool():
            yield b"\x88" if value else b"\x89"
        case int():
            yield _whole(value)
        case float():
            yield b"G" + struct.pack(">d", value)
        case str():
            yield from _text(value.encode("utf-8", "surrogatepass"))
        case bytes():
            yield from _text(value)
        case _:
            yield from _container(value)


def _container(value: Any) -> Iterator[bytes]:
    if isinstance(value, Mapping):
        yield b"}("
        for key, item in value.items():
            yield from _written(key)
            yield from _written(item)
        yield b"u"
    elif isinstance(value, list | tuple):
        yield b"]("
        for item in value:
            yield from _written(item)
        yield b"e"
    else:
        raise TypeError(f"{type(value).__name__} is no plain data")


def _text(encoded: bytes) -> Iterator[bytes]:
    yield b"X" + struct.pack("<I", len(encoded))
    yield encoded


def _whole(value: int) -> bytes:
    if -(2**31) <= value < 2**31:
        return b"J" + struct.pack("<i", value)
    size = value.bit_length() // 8 + 1
    return b"\x8a" + bytes([size]) + value.to_bytes(size, "little", signed=True)
