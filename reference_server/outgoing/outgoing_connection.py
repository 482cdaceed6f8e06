"""One connection to another program of the host: to a node, or to that of accounts.

Requests follow one another over it.

The callbacks of the event loop parse an answer (httptools), and one future wakes who
waits for it: httpcore's way through locks, streams and generators took a node three
times as long as a turn, and its sockets of Unix fail now and then where a reader is
cancelled. It raises httpcore's errors, as other outgoing connections do.
"""

from __future__ import annotations

import asyncio
import re
from collections import deque
from collections.abc import AsyncIterator
from select import POLLIN, poll
from typing import cast

import httpcore
import httptools

from reference_server.outgoing.streamed_exchange import (
    HOP_BY_HOP,
    Headers,
    StreamedBody,
)
from reference_server.process.inline_work import ImmediateFuture

# From so much of an answer on that its reader has not taken, no more is received.
_HELD_BYTES_MAX = 2**18
_PORT = 80
# The connection frames a body itself: what others say of that is not written.
_NOT_WRITTEN = HOP_BY_HOP | {b"content-length"}
_TOKEN = rb"[!#$%&'*+.^_`|~0-9A-Za-z-]+"
# A whole head (RFC 9112, section 2.1).
_HEAD = re.compile(
    rb"%b [^\x00-\x20\x7f]+ HTTP/1\.1\r\n(?:%b: [^\x00\r\n]*\r\n)*\r\n"
    % (_TOKEN, _TOKEN)
)


class OutgoingConnection(asyncio.Protocol):
    """Requests of one connection, and the answer to the last of them.

    status, headers: of the answer, once `send` has returned.
    """

    def __init__(self) -> None:
        self._loop = asyncio.get_running_loop()
        self._transport: asyncio.Transport | None = None
        self._input = poll()
        self._idle_since = 0.0
        self._waiting: ImmediateFuture[None] | None = None
        self._may_write: asyncio.Future[None] | None = None
        self._error: Exception | None = None
        self._is_answered = True
        self._begin("")

    def _begin(self, method: str) -> None:
        self._parser = httptools.HttpResponseParser(self)
        self._is_bodiless = method == "HEAD"
        self._is_headed, self._is_answered = False, not method
        self._is_sent = not method
        self._parts: deque[bytes] = deque()
        self._held_bytes = 0
        self.status = 0
        self.headers: Headers = []

    @classmethod
    async def open(
        cls, url: httpcore.URL, timeout_s: float | None, path: str | None = None
    ) -> OutgoingConnection:
        """Open a connection to the host of the URL, or to the Unix socket at the path.

        Raises httpcore.ConnectError and httpcore.ConnectTimeout.
        """
        loop = asyncio.get_running_loop()
        host, port = url.host.decode("ascii"), url.port or _PORT
        try:
            async with asyncio.timeout(timeout_s):
                if path is not None:
                    _, connection = await loop.create_unix_connection(cls, path)
                else:
                    _, connection = await loop.create_connection(cls, host, port)
        except TimeoutError as error:
            raise httpcore.ConnectTimeout(str(error)) from error
        except OSError as error:
            raise httpcore.ConnectError(str(error)) from error
        return connection

    # --- one request ---

    async def send(
        self,
        method: str,
        target: bytes,
        headers: Headers,
        content: bytes | StreamedBody = b"",
    ) -> None:
        """Send a request; returns when its answer has begun.

        The headers of the framing are written for the bytes of `content`; those that
        are given, and others of a single connection, are left out.
        Raises httpcore.NetworkError, httpcore.ProtocolError, and what `content` raises.
        """
        self._begin(method)
        head = _head_of(method, target, [*_end_to_end(headers), _framing(content)])
        if isinstance(content, bytes):
            self._write(head + content)
            self._is_sent = True
        else:
            self._is_sent = await self._send_parts(head, content)
        while not self._is_headed:
            await self._wait()

    async def _send_parts(self, head: bytes, content: StreamedBody) -> bool:
        """Send the head with the first part of the body: a turn is one packet.

        Returns False where the program has answered, or is lost, before it has all.
        """
        unsent, size, is_chunked = head, 0, content.length is None
        async for part in content:
            if self._is_answered or self._error is not None:
                return False
            size += len(part)
            if content.length is not None and size > content.length:
                break
            if part:  # an empty chunk would be the last one
                self._write(unsent + (_chunk(part) if is_chunked else part))
                unsent = b""
            if self._may_write is not None:
                await self._may_write
        if content.length not in (None, size):
            # It would read what follows as a part of this body, or the reverse.
            text = "a body is not as long as was announced"
            self._fail(httpcore.LocalProtocolError(text))
            return False
        self._write(unsent + (_chunk(b"") if is_chunked else b""))
        return True

    def _write(self, data: bytes) -> None:
        """Where the connection is lost, the answer that may be there says more."""
        if data and self._transport is not None and not self._transport.is_closing():
            self._transport.write(data)

    async def aiter_stream(self) -> AsyncIterator[bytes]:
        """The parts of the answer's body. Raises as `send` does."""
        while True:
            while self._parts:
                part = self._parts.popleft()
                self._held_bytes -= len(part)
                yield part
            if self._is_answered:
                return
            if self._transport is not None and not self._transport.is_reading():
                self._transport.resume_reading()
            await self._wait()

    async def aread(self) -> bytes:
        """The whole body of the answer."""
        return b"".join([part async for part in self.aiter_stream()])

    async def _wait(self) -> None:
        """Return when more of the answer has come."""
        if self._error is not None:
            raise self._error
        self._waiting = ImmediateFuture(self._loop)
        try:
            await self._waiting
        finally:
            self._waiting = None

    # --- between two requests ---

    @property
    def is_idle(self) -> bool:
        """Whether another request may be sent."""
        is_done = self._is_sent and self._is_answered and not self._parts
        return is_done and self._error is None and not self._is_bodiless

    def rest(self) -> None:
        """It has no request from now on."""
        self._idle_since = self._loop.time()

    def has_expired(self, expiry_s: float) -> bool:
        """Whether it has rested for too long, or the program has closed it."""
        is_old = self._loop.time() >= self._idle_since + expiry_s
        # Unread input can only be the end of the connection: nothing was asked.
        return is_old or not self.is_idle or bool(self._input.poll(0))

    def close(self) -> None:
        """Close it at once, whatever is under way."""
        if self._transport is not None:
            self._transport.abort()

    # --- what the event loop calls ---

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        # uvloop's transports have no base class of asyncio.
        self._transport = cast("asyncio.Transport", transport)
        self._input.register(transport.get_extra_info("socket").fileno(), POLLIN)

    def data_received(self, data: bytes) -> None:
        if self._is_answered:  # nothing was asked
            return self._fail(httpcore.RemoteProtocolError("more than one answer"))
        try:
            self._parser.feed_data(data)
        except httptools.HttpParserError as error:
            return self._fail(httpcore.RemoteProtocolError(str(error)))
        # The reader of a whole answer resumes nothing: the next one would not be read.
        is_too_much = self._held_bytes > _HELD_BYTES_MAX and not self._is_answered
        if is_too_much and self._transport is not None:
            self._transport.pause_reading()
        self._wake()
        return None

    def connection_lost(self, exc: Exception | None) -> None:
        error: Exception
        if exc is None and self._is_headed and not self._is_framed():
            self._is_answered = True  # the end of the connection is that of the body
        if exc is None:
            error = httpcore.RemoteProtocolError("it closed the connection")
        else:
            error = httpcore.ReadError(str(exc))
            error.__cause__ = exc
        self._fail(error)
        self.resume_writing()

    def _is_framed(self) -> bool:
        framing = {b"content-length", b"transfer-encoding"}
        return any(name.lower() in framing for name, _ in self.headers)

    def pause_writing(self) -> None:
        if self._may_write is None and self._error is None:
            self._may_write = self._loop.create_future()

    def resume_writing(self) -> None:
        may_write, self._may_write = self._may_write, None
        if may_write is not None and not may_write.done():
            may_write.set_result(None)

    def _fail(self, error: Exception) -> None:
        self._error = self._error or error
        self.close()
        self._wake()

    def _wake(self) -> None:
        if self._waiting is not None:
            self._waiting.set_result(None)

    # --- what the parser calls ---

    def on_message_begin(self) -> None:
        if self._is_headed:
            self._fail(httpcore.RemoteProtocolError("more than one answer"))

    def on_header(self, name: bytes, value: bytes) -> None:
        self.headers.append((name, value))

    def on_headers_complete(self) -> None:
        self.status = self._parser.get_status_code()
        if self.status < 200:
            self.headers = []
            return
        self._is_headed = True
        self._is_answered = self._is_bodiless

    def on_body(self, body: bytes) -> None:
        if self._error is None:
            self._parts.append(body)
            self._held_bytes += len(body)

    def on_message_complete(self) -> None:
        if not self._is_headed:  # the answer follows
            return
        self._is_answered = True
        if not self._parser.should_keep_alive() and self._error is None:
            self._error = httpcore.RemoteProtocolError("it closes the connection")


def _head_of(method: str, target: bytes, headers: Headers) -> bytes:
    """Raises httpcore.LocalProtocolError where the program would read another head."""
    lines = [b"%b %b HTTP/1.1\r\n" % (method.encode("ascii"), target)]
    lines += [b"%b: %b\r\n" % header for header in headers]
    lines.append(b"\r\n")
    head = b"".join(lines)
    if head.count(b"\n") != len(lines) or not _HEAD.fullmatch(head):
        text = "the head of a request cannot be sent: another one would be read"
        raise httpcore.LocalProtocolError(text)
    return head


def _end_to_end(headers: Headers) -> Headers:
    return [pair for pair in headers if pair[0].lower() not in _NOT_WRITTEN]


def _framing(content: bytes | StreamedBody) -> tuple[bytes, bytes]:
    length = len(content) if isinstance(content, bytes) else content.length
    if length is None:
        return b"transfer-encoding", b"chunked"
    return b"content-length", b"%d" % length


def _chunk(part: bytes) -> bytes:
    """An empty part is the end of the body."""
    return b"%x\r\n%b\r\n" % (len(part), part)
