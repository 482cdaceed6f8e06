"""Why another program gave no answer: what a log says."""

from __future__ import annotations

import asyncio
import socket

import httpcore
import msgspec
import pytest

from reference_server.outgoing.unanswered_requests import why_no_answer


async def failure_of_request(sent: bytes | None) -> BaseException:
    """A request fails. sent: the answer to it; None if nothing listens."""

    async def answer(
        reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        await reader.readuntil(b"\r\n\r\n")
        writer.write(sent or b"")
        writer.close()

    server = await asyncio.start_server(answer, "127.0.0.1", 0)
    port = server.sockets[0].getsockname()[1]
    if sent is None:
        server.close()
    try:
        async with httpcore.AsyncConnectionPool() as pool:
            await pool.request("GET", f"http://127.0.0.1:{port}/")
    except Exception as error:  # noqa: BLE001 - whatever the library raises
        return error
    finally:
        server.close()
    raise AssertionError("it was answered")


@pytest.mark.parametrize(
    ("sent", "text"),
    [
        (None, "Connection refused"),
        (b"", "Server disconnected without sending a response"),
        (b"HTTP/1.1 200 OK\r\ncontent-length: 9\r\n\r\nab", "peer closed connection"),
        (b"nonsense\r\n\r\n", "illegal status line"),
    ],
)
async def test_a_request_without_an_answer(sent: bytes | None, text: str) -> None:
    said = why_no_answer(await failure_of_request(sent))
    assert said.startswith(text)
    assert not said.endswith(".")
    assert "Error(" not in said


@pytest.mark.parametrize(
    ("error", "text"),
    [
        (socket.gaierror(-2, "Name or service not known"), "Name or service not known"),
        (httpcore.ReadTimeout(), "it did not answer in time"),
        (TimeoutError(), "it did not answer in time"),
        (httpcore.ReadError(), "the connection was cut"),
        (msgspec.DecodeError("Input data was truncated"),
         "its answer cannot be read (Input data was truncated)"),
    ],
)  # fmt: skip
def test_other_failures(error: BaseException, text: str) -> None:
    assert why_no_answer(error) == text
