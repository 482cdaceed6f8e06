"""One connection to a node: bodies in parts, and answers that break off."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Awaitable, Callable

import httpcore
import pytest

from reference_server.outgoing.outgoing_connection import OutgoingConnection
from reference_server.outgoing.streamed_exchange import Headers, StreamedBody
from tests.support.waiting import wait_in_loop

Serve = Callable[[asyncio.StreamReader, asyncio.StreamWriter], Awaitable[None]]
HOST: Headers = [(b"host", b"node")]
CHUNKED = b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n"


@contextlib.asynccontextmanager
async def _connected(serve: Serve) -> AsyncIterator[OutgoingConnection]:
    """A connection to a server that does this with each of its connections."""

    async def serve_and_close(
        reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        with contextlib.suppress(asyncio.IncompleteReadError, ConnectionError):
            await serve(reader, writer)
        writer.close()
        with contextlib.suppress(ConnectionError):
            await writer.wait_closed()
        closed.set()

    closed = asyncio.Event()
    async with await asyncio.start_server(serve_and_close, "127.0.0.1", 0) as server:
        port = server.sockets[0].getsockname()[1]
        url = httpcore.URL(f"http://127.0.0.1:{port}")
        connection = await OutgoingConnection.open(url, 30.0)
        try:
            async with asyncio.timeout(30):
                yield connection
        finally:
            connection.close()
            await closed.wait()


async def _ask(connection: OutgoingConnection) -> bytes:
    await connection.send("GET", b"/path", HOST)
    return await connection.aread()


def _answers(*answers: bytes) -> Serve:
    """Send one of these for each head of a request, then close the connection."""

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        for answer in answers:
            await reader.readuntil(b"\r\n\r\n")
            writer.write(answer)
        await writer.drain()

    return serve


async def test_a_body_is_sent_part_by_part() -> None:
    received: asyncio.Future[bytes] = asyncio.get_running_loop().create_future()

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        await reader.readuntil(b"\r\n\r\n")
        received.set_result(await reader.readuntil(b"0\r\n\r\n"))
        writer.write(b"HTTP/1.1 204 No Content\r\n\r\n")

    async def parts() -> AsyncIterator[bytes]:
        yield b"seven b"
        yield b"ytes"

    async with _connected(serve) as connection:
        await connection.send("POST", b"/path", HOST, StreamedBody(parts(), None))
        assert connection.status == 204
        assert await received == b"7\r\nseven b\r\n4\r\nytes\r\n0\r\n\r\n"


async def test_the_framing_of_a_body_is_that_of_its_bytes() -> None:
    """Else the node reads the end of a body as the next request."""
    received: asyncio.Future[bytes] = asyncio.get_running_loop().create_future()

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        received.set_result(await reader.readuntil(b"body"))
        writer.write(b"HTTP/1.1 204 No Content\r\n\r\n")

    of_one_connection = [
        *((b"content-length", b"2"), (b"Content-Length", b"3"), (b"te", b"trailers")),
        *((b"Transfer-Encoding", b"chunked"), (b"connection", b"close")),
        *((b"Upgrade", b"websocket"), (b"expect", b"100-continue")),
    ]
    async with _connected(serve) as connection:
        headers = [*of_one_connection, *HOST]
        await connection.send("POST", b"/path", headers, b"the body")
        assert await received == (
            b"POST /path HTTP/1.1\r\nhost: node\r\ncontent-length: 8\r\n\r\nthe body"
        )


@pytest.mark.parametrize(
    ("method", "target", "header"),
    [
        ("GET", b"/path", (b"name", b"value\r\nhost: other")),
        ("GET", b"/path", (b"name", b"value\r\n\r\nGET / HTTP/1.1")),
        ("GET", b"/path", (b"name", b"value\nhost: other")),
        ("GET", b"/path", (b"name", b"value\0")),
        ("GET", b"/path", (b"name: value\r\nhost", b"other")),
        ("GET", b"/path", (b"content-length ", b"2")),
        ("GET", b"/path HTTP/1.1\r\nhost: other\r\n\r\n", HOST[0]),
        ("GET /", b"/path", HOST[0]),
    ],
)
async def test_a_head_that_a_node_would_read_otherwise_is_not_sent(
    method: str, target: bytes, header: tuple[bytes, bytes]
) -> None:
    async def serve(reader: asyncio.StreamReader, _: asyncio.StreamWriter) -> None:
        assert await reader.read() == b""

    async with _connected(serve) as connection:
        with pytest.raises(httpcore.LocalProtocolError):
            await connection.send(method, target, [header])
        assert not connection.is_idle


@pytest.mark.parametrize(
    ("head", "is_whole"),
    [
        (b"HTTP/1.0 200 OK\r\n\r\n", True),
        (b"HTTP/1.1 200 OK\r\nConnection: close\r\n\r\n", True),
        (b"HTTP/1.1 200 OK\r\nContent-Length: 5\r\n\r\n", False),
        (CHUNKED, False),
    ],
)
async def test_only_a_body_without_framing_ends_with_the_connection(
    head: bytes, is_whole: bool
) -> None:
    part = b"4\r\nbody\r\n" if head == CHUNKED else b"body"
    async with _connected(_answers(head + part)) as connection:
        if is_whole:
            assert await _ask(connection) == b"body"
        else:
            with pytest.raises(httpcore.RemoteProtocolError, match="closed"):
                await _ask(connection)
        assert not connection.is_idle


@pytest.mark.parametrize("announced", [6, 8])
async def test_a_body_of_another_length_than_announced_ends_the_connection(
    announced: int,
) -> None:
    async def parts() -> AsyncIterator[bytes]:
        yield b"sev"
        yield b"en b"

    async def serve(reader: asyncio.StreamReader, _: asyncio.StreamWriter) -> None:
        await reader.read()

    async with _connected(serve) as connection:
        body = StreamedBody(parts(), announced)
        with pytest.raises(httpcore.LocalProtocolError):
            await connection.send("POST", b"/path", HOST, body)
        assert not connection.is_idle
        transport = connection._transport
        assert transport is not None
        assert transport.is_closing()


async def test_a_body_that_is_refused_is_not_sent_to_its_end() -> None:
    refusal = b"HTTP/1.1 413 Content Too Large\r\nContent-Length: 0\r\n\r\n"

    async def endless() -> AsyncIterator[bytes]:
        while True:
            yield b"part"
            await asyncio.sleep(0)

    async with _connected(_answers(refusal, b"")) as connection:
        body = StreamedBody(endless(), None)
        await connection.send("POST", b"/path", HOST, body)
        assert connection.status == 413
        assert not connection.is_idle


async def test_an_answer_of_unknown_length_leaves_the_connection_usable() -> None:
    async with _connected(
        _answers(CHUNKED + b"2\r\nok\r\n0\r\n\r\n", b"")
    ) as connection:
        await connection.send("GET", b"/path", HOST)
        assert not connection.is_idle
        assert await connection.aread() == b"ok"
        assert connection.is_idle


async def test_an_answer_to_head_has_no_body() -> None:
    head = b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\n"
    async with _connected(_answers(head, b"")) as connection:
        await connection.send("HEAD", b"/path", HOST)
        assert await connection.aread() == b""


async def test_an_answer_that_waits_for_its_reader_is_received_no_further() -> None:
    """A node that passes a record on to a slow client does not hold all of it."""
    size = 2**26
    head = b"HTTP/1.1 200 OK\r\nContent-Length: %d\r\n\r\n" % size
    async with _connected(_answers(head + bytes(size))) as connection:
        await connection.send("GET", b"/path", HOST)
        transport = connection._transport
        assert transport is not None
        await wait_in_loop(lambda: not transport.is_reading())
        assert connection._held_bytes < size / 8
        assert sum([len(part) async for part in connection.aiter_stream()]) == size


@pytest.mark.parametrize(
    "answer", [b"", b"HTTP/1.1 200 OK\r\n", CHUNKED + b"2\r\nok", b"no HTTP\r\n\r\n"]
)
async def test_an_answer_that_breaks_off_is_an_error(answer: bytes) -> None:
    async with _connected(_answers(answer)) as connection:
        with pytest.raises(httpcore.RemoteProtocolError):
            await _ask(connection)
        assert not connection.is_idle


async def test_more_than_one_answer_is_read_by_no_other_request() -> None:
    answer = b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nok"
    async with _connected(_answers(answer + answer, b"")) as connection:
        with contextlib.suppress(httpcore.RemoteProtocolError):
            await _ask(connection)
        assert not connection.is_idle
