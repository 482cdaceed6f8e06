"""A request that is answered without ASGI: a turn, which is small and answered whole.

uvicorn's way through ASGI costs a turn as much as all rules together: events, messages,
a router and middlewares for a body that is here already, and for an answer that is one
piece. This class takes the place of uvicorn's cycle for such a request. Everything else
goes the general way, and so does a turn with anything unusual in its head.
"""

from __future__ import annotations

import logging
import os
import re
from collections.abc import Awaitable, Callable, Mapping, MutableMapping, Sequence
from typing import Any, NamedTuple, Protocol

from starlette.responses import Response

from reference_server.http.connections.joined_answer import JOINED_BYTES_MAX
from reference_server.http.connections.uvicorn_protocol import (
    STATUS_LINE,
    HttpToolsProtocol,
)

log = logging.getLogger("proctor.http")

# A larger body is read part by part, with pauses, as uvicorn does it.
DIRECT_BODY_BYTES_MAX = 2**16
# Headers that change the way of a request through uvicorn, or who its client is.
_UNUSUAL = frozenset(
    b"expect transfer-encoding upgrade x-forwarded-for x-forwarded-proto".split()
)
# The one Content-Length of a head, as nearly every client writes it.
_LENGTH = re.compile(rb"\r\ncontent-length: ?([0-9]+)\r\n", re.IGNORECASE)
_LENGTH_NAME = b"content-length"
_CLOSE = b"connection", b"close"
# Enough for DIRECT_BODY_BYTES_MAX. The parser reads a request with an empty body.
_LENGTH_DIGITS_MAX = 5
# A connection keeps one head for its whole life. That of a turn has 300 to 500 bytes.
_KNOWN_HEAD_BYTES_MAX = 2**12


class DirectAnswers(Protocol):
    """The operation that is answered so."""

    def path_of(self, method: bytes, url: bytes) -> Mapping[str, str] | None:
        """The parameters of the path; None for a request that goes the general way."""

    async def answer(self, scope: MutableMapping[str, Any], body: bytes) -> Response:
        """The whole answer; never raises.

        scope: may be that of an earlier request of the connection with the same head.
        """


def is_usual(headers: Sequence[tuple[bytes, bytes]], length: int | None) -> bool:
    """Whether nothing in the head asks for the general way. length: of the body."""
    return (
        length is not None
        and length <= DIRECT_BODY_BYTES_MAX
        and _UNUSUAL.isdisjoint([name for name, _ in headers])
    )


class KnownHead(NamedTuple):
    """The head of a request that was answered directly and was parsed as a whole.

    A client sends the same head with each turn, but for the length of the body: one
    that equals it to the byte need not be parsed again. before, after: around the
    digits of that length.
    """

    before: bytes
    after: bytes
    scope: MutableMapping[str, Any]

    @classmethod
    def of(cls, head: bytes, scope: MutableMapping[str, Any]) -> KnownHead | None:
        """Returns None where the length is not written as usual, and of a long head."""
        match = _LENGTH.search(head)
        is_long = len(head) > _KNOWN_HEAD_BYTES_MAX
        if match is None or is_long or head.lower().count(_LENGTH_NAME) > 1:
            return None
        return cls(head[: match.start(1)], head[match.end(1) :], scope)

    def find(self, data: bytes, position: int) -> tuple[int, int] | None:
        """The end of such a head that begins at `position`, and its body's length."""
        if not data.startswith(self.before, position):
            return None
        begin = position + len(self.before)
        after_max = begin + _LENGTH_DIGITS_MAX + len(self.after)
        end = data.find(self.after, begin, after_max)
        digits = data[begin:end] if end > begin else b""
        if not digits.isdigit() or digits.startswith(b"0"):
            return None
        length = int(digits)
        if length > DIRECT_BODY_BYTES_MAX:
            return None
        return end + len(self.after), length


class _NoEvent:
    """Nothing waits for the parts of a direct request."""

    def set(self) -> None:
        """Do nothing."""


class DirectCycle:
    """One request and its answer, with the members of a cycle that uvicorn uses."""

    message_event = _NoEvent()
    response_started = False
    response_complete = False
    disconnected = False
    more_body = True

    def __init__(
        self,
        connection: HttpToolsProtocol,
        scope: MutableMapping[str, Any],
        answer: Callable[[MutableMapping[str, Any], bytes], Awaitable[Response]],
        *,
        keep_alive: bool,
    ) -> None:
        self._connection, self.scope, self._answer = connection, scope, answer
        self.keep_alive = keep_alive
        self.body = bytearray()

    async def run(self) -> None:
        """Answer it, now that its body is complete."""
        self.more_body = False
        connection, body = self._connection, bytes(self.body)
        self.body = bytearray()
        try:
            response = await self._answer(self.scope, body)
            if await self._write(response):
                self.response_complete = True
                if _CLOSE in response.raw_headers:
                    self.keep_alive = False
                if not self.keep_alive:
                    connection.transport.close()
                connection.on_response_complete()
        except Exception:
            log.exception("an answer could not be sent")
        finally:
            if not self.response_complete:
                connection.transport.close()

    async def _write(self, response: Response) -> bool:
        """Send it; returns whether the client is still there."""
        body = getattr(response, "parts", None) or (bytes(response.body),)
        parts: list[bytes | memoryview] = [self._head_of(response), *body]
        if len(body) == 1 and len(body[0]) <= JOINED_BYTES_MAX:
            parts = [b"".join(parts)]
        else:
            parts = self._send_at_once(parts)
        for part in parts:
            if self._connection.flow.write_paused and not self.disconnected:
                await self._connection.flow.drain()
            if self.disconnected:
                return False
            self.response_started = True
            self._connection.transport.write(part)
        return True

    def _send_at_once(
        self, parts: list[bytes | memoryview]
    ) -> list[bytes | memoryview]:
        """Send what the socket takes in one system call; returns what is left.

        Each part that is sent by itself wakes the client. The rest goes to the
        transport part by part, so that the bounds of what waits there hold.
        """
        transport = self._connection.transport
        is_plain = transport.get_extra_info("sslcontext") is None
        if transport.is_closing() or transport.get_write_buffer_size() or not is_plain:
            return parts
        try:
            sent = os.writev(transport.get_extra_info("socket").fileno(), parts)
        except OSError:  # the transport meets the same
            return parts
        self.response_started = True
        while parts and sent >= len(parts[0]):
            sent -= len(parts.pop(0))
        return [memoryview(parts[0])[sent:], *parts[1:]] if parts else parts

    def _head_of(self, response: Response) -> bytes:
        lines = [STATUS_LINE[response.status_code]]
        for headers in (
            self._connection.server_state.default_headers,
            response.raw_headers,
        ):
            for name, value in headers:
                lines += (name, b": ", value, b"\r\n")
        if not self.keep_alive:
            lines.append(b"connection: close\r\n")
        lines.append(b"\r\n")
        return b"".join(lines)
