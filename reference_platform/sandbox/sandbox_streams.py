"""Passes bytes between a caller and the policy in a sandbox, as they are."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import time
from collections.abc import Callable

_PART_BYTES = 2**16


async def relay(
    reader: asyncio.StreamReader,
    writer: asyncio.StreamWriter,
    connection: socket.socket,
) -> float | None:
    """Until one side has closed: then nothing that the other sends has a reader.

    connection: to the policy; it is closed. The caller closes its own side. Returns for
    how long a caller that left had waited for the first byte of an answer; None if the
    policy closed, or had begun to answer.
    """
    called_at: float | None = None

    def on_call() -> None:
        nonlocal called_at
        called_at = time.monotonic()

    def on_answer() -> None:
        nonlocal called_at
        called_at = None

    connection.setblocking(False)
    policy_reader, policy_writer = await asyncio.open_connection(sock=connection)
    try:
        calls = asyncio.ensure_future(_copy(reader, policy_writer, on_call))
        answers = asyncio.ensure_future(_copy(policy_reader, writer, on_answer))
        ways = {calls, answers}
        try:
            await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
            has_caller_left = calls.done() and not answers.done()
        finally:
            for way in ways:
                way.cancel()
            await asyncio.gather(*ways, return_exceptions=True)
    finally:
        policy_writer.close()
    if called_at is None or not has_caller_left:
        return None
    return time.monotonic() - called_at


async def _copy(
    reader: asyncio.StreamReader,
    writer: asyncio.StreamWriter,
    on_part: Callable[[], None],
) -> None:
    with contextlib.suppress(OSError):
        while part := await reader.read(_PART_BYTES):
            on_part()
            writer.write(part)
            await writer.drain()
