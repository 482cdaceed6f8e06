"""One connection to a node: bodies in parts, and answers that break off."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Awaitable, Callable

import httpcore
import pytest

from reference_server.cluster.node_connection import Headers, NodeConnection
from tests.support.waiting import wait_in_loop

Serve = Callable[[asyncio.StreamReader, asyncio.StreamWriter], Awaitable[None]]
HOST: Headers = [(b"host", b"node")]
CHUNKED = b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n"


@contextlib.asynccontextmanager
async def _connected(serve: Serve) -> AsyncIterator[NodeConnection]:
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
        connection = await NodeConnection.open(url, 30.0)
        try:
            async with asyncio.timeout(30):
                yield connection
        finally:
            connection.close()
            await closed.wait()


async def _ask(connection: NodeConnection) -> bytes:
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
        headers = [*HOST, (b"transfer-encoding", b"chunked")]
        await connection.send("POST", b"/path", headers, parts())
        assert connection.status == 204
        assert await received == b"7\r\nseven b\r\n4\r\nytes\r\n0\r\n\r\n"


async def test_a_body_that_is_refused_is_not_sent_to_its_end() -> None:
    refusal = b"HTTP/1.1 413 Content Too Large\r\nContent-Length: 0\r\n\r\n"

    async def endless() -> AsyncIterator[bytes]:
        while True:
            yield b"part"
            await asyncio.sleep(0)

    async with _connected(_answers(refusal, b"")) as connection:
        await connection.send("POST", b"/path", [(b"content-length", b"9")], endless())
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
