"""Passes bytes between a caller and the policy in a sandbox, as they are."""

from __future__ import annotations

import asyncio
import contextlib
import socket

_PART_BYTES = 2**16


async def relay(
    reader: asyncio.StreamReader,
    writer: asyncio.StreamWriter,
    connection: socket.socket,
) -> None:
    """Until one side has closed: then nothing that the other sends has a reader.

    connection: to the policy; it is closed. The caller closes its own side.
    """
    connection.setblocking(False)
    policy_reader, policy_writer = await asyncio.open_connection(sock=connection)
    try:
        ways = {
            asyncio.ensure_future(_copy(reader, policy_writer)),
            asyncio.ensure_future(_copy(policy_reader, writer)),
        }
        try:
            await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for way in ways:
                way.cancel()
            await asyncio.gather(*ways, return_exceptions=True)
    finally:
        policy_writer.close()


async def _copy(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    with contextlib.suppress(OSError):
        while part := await reader.read(_PART_BYTES):
            writer.write(part)
            await writer.drain()
