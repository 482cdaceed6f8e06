"""What the server and its launcher send each other (launcher.py), framed as commands
of a simulator are. It imports no Ray.
"""

from __future__ import annotations

import asyncio
import struct
from typing import TypeVar

import msgspec

_HEADER = struct.Struct(">I")


class MachineCheck(msgspec.Struct, frozen=True):
    """What a machine has to have before it may simulate.

    software: as `software()` on the server. folder, marker: where recordings are
    written, and the name of a file in it; empty if nothing is recorded.
    """

    software: dict[str, str]
    folder: str = ""
    marker: str = ""


# To the launcher


class Connect(msgspec.Struct, tag="connect", frozen=True):
    """Join the cluster; the first message.

    resources: of one simulator, by Ray's names. checks_machines: look at every machine
    that has room for a simulator before the answer.
    """

    address: str
    resources: dict[str, float]
    machine: MachineCheck
    checks_machines: bool


class StartActor(msgspec.Struct, tag="start", frozen=True):
    """number: names the actor in all later messages."""

    number: int


class KillActor(msgspec.Struct, tag="kill", frozen=True):
    number: int


# From the launcher


class Connected(msgspec.Struct, tag="connected", frozen=True):
    """machines: those that could hold a simulator."""

    machines: int


class Rejected(msgspec.Struct, tag="rejected", frozen=True):
    """The cluster cannot be used; the launcher ends. reason: one sentence."""

    reason: str


class ActorReady(msgspec.Struct, tag="ready", frozen=True):
    """It listens there for one connection, which begins with the secret."""

    number: int
    host: str
    port: int
    secret: bytes


class ActorEnded(msgspec.Struct, tag="ended", frozen=True):
    """It has ended, or did not start."""

    number: int
    reason: str


ToLauncher = Connect | StartActor | KillActor
FromLauncher = Connected | Rejected | ActorReady | ActorEnded
MessageT = TypeVar("MessageT")

_encoder = msgspec.msgpack.Encoder()
TO_LAUNCHER: msgspec.msgpack.Decoder[ToLauncher] = msgspec.msgpack.Decoder(ToLauncher)
FROM_LAUNCHER: msgspec.msgpack.Decoder[FromLauncher] = msgspec.msgpack.Decoder(
    FromLauncher
)


def frame(message: ToLauncher | FromLauncher) -> bytes:
    body = _encoder.encode(message)
    return _HEADER.pack(len(body)) + body


async def read_message(
    reader: asyncio.StreamReader, decoder: msgspec.msgpack.Decoder[MessageT]
) -> MessageT | None:
    """The next message; None when the sender has ended."""
    try:
        (length,) = _HEADER.unpack(await reader.readexactly(_HEADER.size))
        return decoder.decode(await reader.readexactly(length))
    except (asyncio.IncompleteReadError, ConnectionError):
        return None
