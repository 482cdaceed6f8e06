"""The head of an answer and its body are one packet, and no head stays behind."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

import pytest

from reference_server.http.connections.joined_answer import (
    JOINED_BYTES_MAX,
    JoinedAnswer,
)
from tests.support.raw_answers import read_answer
from tests.support.server.bounded_server import bounded_server
from tests.support.servers import TIMEOUT_S

if TYPE_CHECKING:
    import asyncio

HEAD = b"HTTP/1.1 200 OK\r\ncontent-length: 2\r\n\r\n"
STREAM = b"HTTP/1.1 200 OK\r\ntransfer-encoding: chunked\r\n\r\n"
CONTINUE = b"HTTP/1.1 100 Continue\r\n\r\n"


class _Transport:
    """Keeps what is written; `None` is its close."""

    def __init__(self) -> None:
        self.written: list[bytes | None] = []

    def write(self, data: bytes | memoryview) -> None:
        self.written.append(bytes(data))

    def close(self) -> None:
        self.written.append(None)


def _written(
    *parts: bytes | memoryview, ends_with: str = "flush"
) -> list[bytes | None]:
    """What a transport is given for an answer of these parts."""
    transport = _Transport()
    answer = JoinedAnswer(cast("asyncio.Transport", transport))
    for part in parts:
        answer.write(part)
    getattr(answer, ends_with)()
    return transport.written


LARGE = bytes(JOINED_BYTES_MAX + 1)


@pytest.mark.parametrize(
    ("parts", "written"),
    [
        ([HEAD, b"ok"], [HEAD + b"ok"]),
        ([HEAD, memoryview(b"ok"), b"more"], [HEAD + b"ok", b"more"]),
        ([HEAD, LARGE], [HEAD, LARGE]),
        ([HEAD], [HEAD]),
        ([CONTINUE, HEAD, b"ok"], [CONTINUE, HEAD, b"ok"]),
        ([HEAD, b"a", HEAD], [HEAD + b"a", HEAD]),
    ],
)
def test_a_head_leaves_with_its_body(
    parts: list[bytes | memoryview], written: list[bytes | None]
) -> None:
    assert _written(*parts) == written


def test_a_head_that_is_all_leaves_before_the_connection_is_closed() -> None:
    assert _written(HEAD, ends_with="close") == [HEAD, None]


def test_the_head_of_a_stream_does_not_wait() -> None:
    transport = _Transport()
    JoinedAnswer(cast("asyncio.Transport", transport)).write(STREAM)
    assert transport.written == [STREAM]


def test_uvicorn_writes_answers_so(monkeypatch: pytest.MonkeyPatch) -> None:
    sizes: list[int] = []
    right = JoinedAnswer.write

    def write(self: JoinedAnswer, data: bytes | memoryview) -> None:
        sizes.append(len(data))
        right(self, data)

    monkeypatch.setattr(JoinedAnswer, "write", write)
    with bounded_server() as server, server.connect() as connection:
        connection.sendall(b"GET /now HTTP/1.1\r\nHost: x\r\n\r\n")
        connection.settimeout(TIMEOUT_S)
        assert len(connection.recv(4096)) == sum(sizes)
    assert len(sizes) == 2


def test_a_head_without_a_body_is_sent() -> None:
    """Of HEAD, whose answer has a length, on a connection that stays open."""
    request = b"HEAD /now HTTP/1.1\r\nHost: x\r\n\r\n"
    with bounded_server() as server, server.connect() as connection:
        connection.sendall(request)
        connection.settimeout(TIMEOUT_S)
        assert connection.recv(4096).startswith(b"HTTP/1.1 200")
        connection.sendall(request.replace(b"HEAD", b"GET"))
        assert read_answer(connection) == (200, b"ok")
