"""Lets the head of an answer leave together with the first part of its body.

uvicorn writes both as they come. On a connection without delay that is two packets, two
system calls, and a client that is woken for a head it can do nothing with.
"""

from __future__ import annotations

import asyncio

_LENGTH = b"\r\ncontent-length: "
# Only a body up to this size is copied behind its head.
JOINED_BYTES_MAX = 2**15


class JoinedAnswer:
    """Takes the place of uvicorn's transport while uvicorn writes one answer.

    A head without Content-Length is one of a stream, whose body may come late: it
    leaves at once. `flush` has to follow the last part: some answers have no body.
    """

    __slots__ = ("_head", "_is_begun", "_transport")

    def __init__(self, transport: asyncio.Transport) -> None:
        self._transport = transport
        self._head = b""
        self._is_begun = False

    def write(self, data: bytes | memoryview) -> None:
        """Write the head, or a part of the body."""
        if self._head:
            if len(data) <= JOINED_BYTES_MAX:
                data = b"".join((self._head, data))
            else:
                self._transport.write(self._head)
            self._head = b""
            self._transport.write(data)
        elif not self._is_begun and isinstance(data, bytes) and _LENGTH in data:
            self._is_begun, self._head = True, data
        else:
            self._is_begun = True
            self._transport.write(data)

    def flush(self) -> None:
        """Write a head that waits for a body."""
        if self._head:
            head, self._head = self._head, b""
            self._transport.write(head)

    def close(self) -> None:
        self.flush()
        self._transport.close()

    def is_closing(self) -> bool:
        return self._transport.is_closing()
