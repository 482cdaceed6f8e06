"""Messages between processes: MessagePack, with its length in front."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Final, TypeVar

import msgspec

if TYPE_CHECKING:  # a simulator process reads without it
    import asyncio

LENGTH: Final = struct.Struct(">I")
BYTES_MAX: Final = 2**24
MessageT = TypeVar("MessageT")

_encoder = msgspec.msgpack.Encoder()


def frame(message: msgspec.Struct) -> bytearray:
    """The message with its length in front of it."""
    buffer = bytearray(LENGTH.size)
    _encoder.encode_into(message, buffer, LENGTH.size)
    LENGTH.pack_into(buffer, 0, len(buffer) - LENGTH.size)
    return buffer


async def read_message(
    reader: asyncio.StreamReader, decoder: msgspec.msgpack.Decoder[MessageT]
) -> MessageT | None:
    """The next message; None when the other side has ended, or broke the protocol."""
    try:
        (length,) = LENGTH.unpack(await reader.readexactly(LENGTH.size))
        if length > BYTES_MAX:
            return None
        return decoder.decode(await reader.readexactly(length))
    except (OSError, EOFError, msgspec.DecodeError):
        return None
