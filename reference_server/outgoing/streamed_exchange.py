"""A request of a client that another program answers: sent on to it, and back.

Bodies are streamed in both directions, so that uploads, records and event streams pass
and nothing is kept in memory. Which headers pass is the caller's to say.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Sequence
from contextlib import AbstractAsyncContextManager
from typing import Protocol, TypeAlias

import httpcore
from starlette.types import Message, Receive, Scope, Send

Headers: TypeAlias = list[tuple[bytes, bytes]]

NOT_REACHED = (
    httpcore.NetworkError,
    httpcore.TimeoutException,
    httpcore.ProtocolError,
)


# Headers of a single connection (RFC 9110, section 7.6.1).
HOP_BY_HOP = {
    *(b"connection", b"keep-alive", b"proxy-connection", b"te", b"trailer"),
    *(b"transfer-encoding", b"upgrade", b"expect"),
}


class StreamedBody:
    """The body of a request, part by part.

    length: of all parts, as it was announced; None if it was not.
    """

    def __init__(self, parts: AsyncIterator[bytes], length: int | None) -> None:
        self._parts, self.length = parts, length

    def __aiter__(self) -> AsyncIterator[bytes]:
        return self._parts


class StreamedAnswer(Protocol):
    """An answer that has begun."""

    @property
    def status(self) -> int: ...
    @property
    def headers(self) -> Headers: ...
    def aiter_stream(self) -> AsyncIterator[bytes]:
        """The parts of its body."""


OpenStream = Callable[..., AbstractAsyncContextManager[StreamedAnswer]]


class ClientLeft(Exception):
    """The client left before its request was complete."""


class StreamedExchange:
    """One request, and its answer.

    is_begun, is_answered: the head, or all, of the answer was sent to the client.
    has_no_reader: the client has left.
    """

    def __init__(self, scope: Scope, receive: Receive, send: Send) -> None:
        self._scope, self._receive, self._send = scope, receive, send
        self._body_read = asyncio.Event()
        self.is_begun = self.is_answered = self.has_no_reader = False

    async def answer(
        self,
        open_stream: OpenStream,
        origin: httpcore.URL,
        headers: Headers,
        *,
        kept_back: set[bytes],
    ) -> None:
        """Send the whole answer, part by part.

        headers: of the request. kept_back: those of the answer that are not for the
        client.
        Raises ClientLeft, and what `open_stream` raises.
        """
        async with open_stream(
            self._scope["method"],
            _url_below(origin, self._scope),
            headers=headers,
            content=await self._body(),
        ) as response:
            await self._start(response.status, _without(response.headers, kept_back))
            left, is_complete = _length_of(response.headers), False
            async for part in response.aiter_stream():
                # A client that has the whole answer may send its next request at once:
                # the last part must be known as the last one.
                left = None if left is None else left - len(part)
                is_complete = left == 0
                await self._send(_body(part, more=not is_complete))
        if not is_complete:
            await self._send(_body(b"", more=False))
        self.is_answered = True

    async def _start(self, status: int, headers: Headers) -> None:
        self.is_begun = True
        await self._send(
            {"type": "http.response.start", "status": status, "headers": headers}
        )

    async def _body(self) -> bytes | StreamedBody:
        """The bytes of a body that is here as a whole, else a stream of them.

        The scope of a turn may be that of an earlier one, whose body had another
        length: it says only of a stream how long that will be.
        """
        names = {name for name, _ in self._scope["headers"]}
        if not names & {b"content-length", b"transfer-encoding"}:
            self._body_read.set()
            return b""
        first, more = await self._read_part()
        if not more:
            return first
        return StreamedBody(self._parts(first), _length_of(self._scope["headers"]))

    async def _parts(self, first: bytes) -> AsyncIterator[bytes]:
        part, more = first, True
        while more:
            if part:
                yield part
            part, more = await self._read_part()
        if part:
            yield part

    async def _read_part(self) -> tuple[bytes, bool]:
        """The next part of the body, and whether more follows."""
        message = await self._receive()
        if message["type"] == "http.disconnect":
            self.has_no_reader = True
            raise ClientLeft
        more = message.get("more_body", False)
        if not more:
            self._body_read.set()
        return message.get("body", b""), more

    async def wait_until_client_left(self) -> None:
        """No answer is needed any more; what the other program has begun goes on."""
        await self._body_read.wait()
        while (await self._receive())["type"] != "http.disconnect":
            pass
        self.has_no_reader = True


def headers_without(scope: Scope, dropped: set[bytes]) -> Headers:
    """The headers of a request but for these; chunks of a body stay chunks."""
    headers: Headers = scope["headers"]
    kept = [(name, value) for name, value in headers if name not in dropped]
    if any(name == b"transfer-encoding" for name, _ in headers):
        kept.append((b"transfer-encoding", b"chunked"))
    return kept


def _without(headers: Headers, dropped: set[bytes]) -> Headers:
    lower = ((name.lower(), value) for name, value in headers)
    return [pair for pair in lower if pair[0] not in dropped]


def _url_below(origin: httpcore.URL, scope: Scope) -> httpcore.URL:
    target = scope.get("raw_path") or scope["path"].encode()
    if query := scope["query_string"]:
        target += b"?" + query
    return httpcore.URL(
        scheme=origin.scheme, host=origin.host, port=origin.port, target=target
    )


def _length_of(headers: Sequence[tuple[bytes, bytes]]) -> int | None:
    lengths = [value for name, value in headers if name.lower() == b"content-length"]
    return int(lengths[0]) if lengths else None


def _body(part: bytes, *, more: bool) -> Message:
    return {"type": "http.response.body", "body": part, "more_body": more}
