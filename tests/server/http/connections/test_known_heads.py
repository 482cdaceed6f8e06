"""A head that equals the one before, but for the length of its body, is not parsed."""

from __future__ import annotations

import asyncio
import re
import socket
import time
from collections.abc import Iterator
from typing import Any
from unittest.mock import Mock

import pytest
from starlette.requests import Request
from starlette.responses import Response

from reference_server.http.auth import Caller, Tokens, hash_of
from reference_server.http.connections.direct_cycle import (
    DIRECT_BODY_BYTES_MAX,
    KnownHead,
)
from reference_server.http.dispatch import (
    Operation,
    OperationCall,
    WholeRequests,
    perform,
)
from tests.support.raw_answers import read_answer, read_to_end
from tests.support.server.bounded_server import BoundedServer, server_of_turns

HEAD = b"POST /body HTTP/1.1\r\nHost: x\r\nContent-Length: %s\r\nA: b\r\n\r\n"
LENGTH_MAX = b"%d" % DIRECT_BODY_BYTES_MAX


def post(size: int) -> bytes:
    return HEAD % b"%d" % size + b"x" * size


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        (HEAD % b"7", (len(HEAD) - 1, 7)),
        (HEAD % b"12345", (len(HEAD) + 3, 12345)),
        (HEAD % LENGTH_MAX, (len(HEAD) + 3, DIRECT_BODY_BYTES_MAX)),
        (HEAD % b"7" + b"body", (len(HEAD) - 1, 7)),
        (HEAD % b"%d" % (DIRECT_BODY_BYTES_MAX + 1), None),
        (HEAD % b"0", None),  # its body is complete with its head
        (HEAD % b"07", None),
        (HEAD % b"", None),
        (HEAD % b"-7", None),
        (HEAD % b"+7", None),
        (HEAD % b"7 ", None),
        (HEAD % b"0x7", None),
        (HEAD % b"7,7", None),
        (HEAD % "٧".encode(), None),
        (HEAD % b"7\r\nA: b\r\nA: c", None),
        (HEAD % b"123456", None),
        ((HEAD % b"7")[:-1], None),
        ((HEAD % b"7").replace(b"A: b", b"A: c"), None),
        ((HEAD % b"7").replace(b"A: b", b"a: b"), None),
        ((HEAD % b"7").replace(b"/body", b"/bodz"), None),
    ],
)
def test_only_the_digits_of_its_length_may_differ(
    data: bytes, expected: tuple[int, int] | None
) -> None:
    known = KnownHead.of(HEAD % b"3", {})
    assert known is not None
    assert known.find(data, 0) == expected
    behind = None if expected is None else (expected[0] + 5, expected[1])
    assert known.find(b"12345" + data, 5) == behind


@pytest.mark.parametrize(
    "head",
    [
        HEAD.replace(b"Content-Length: %s\r\n", b""),
        HEAD % b"3\r\nContent-Length: 3",
        HEAD % b"3\r\nX-Content-Length: 3",
        HEAD % b"3, 3",
        HEAD % b"\t3",
        HEAD % b"3 ",
        (HEAD % b"3").replace(b"A: b", b"A: " + b"b" * 2**12),
    ],
)
def test_an_unusual_or_long_head_is_left_to_the_parser(head: bytes) -> None:
    assert KnownHead.of(head, {}) is None


PARTS = pytest.mark.parametrize(
    "cut",
    [
        pytest.param(lambda data: [data], id="at once"),
        pytest.param(lambda data: re.split(rb"(?<=\r\n\r\n)", data), id="by part"),
        pytest.param(lambda data: [data[:30], data[30:]], id="in the head"),
        pytest.param(lambda data: [data[:-1], data[-1:]], id="in the body"),
    ],
)


def send_parts(connection: socket.socket, parts: list[bytes]) -> None:
    for part in parts:
        connection.sendall(part)
        time.sleep(0.002)  # so that they arrive as they are


@pytest.fixture(scope="module", name="server")
def _server() -> Iterator[BoundedServer]:
    with server_of_turns(body_grace_s=0.25, rate_min=2**20) as server:
        yield server


@PARTS
def test_each_request_is_answered_as_if_it_were_parsed(
    server: BoundedServer, cut: Any
) -> None:
    other = post(4).replace(b"A: b", b"Other: head")
    requests = [post(3), post(5), post(0), post(2000), other, post(6), post(7)]
    sizes = (3, 5, 0, 2000, 4, 6, 7)
    with server.connect() as connection:
        for data, size in zip(requests, sizes, strict=True):
            send_parts(connection, cut(data))
            assert read_answer(connection) == (200, b"%d" % size)


def test_pipelined_requests_are_answered_in_order(server: BoundedServer) -> None:
    with server.connect() as connection:
        connection.sendall(b"".join(map(post, [3, 4, 0, 5, 6])))
        for size in (3, 4, 0, 5, 6):
            assert read_answer(connection) == (200, b"%d" % size)
        # Through ASGI, whose task reads the next request when it has answered.
        general = b"POST /else HTTP/1.1\r\nHost: x\r\nContent-Length: 0\r\n\r\n"
        connection.sendall(b"".join([post(7), general, post(8), general, post(9)]))
        for expected in (b"7", b"ok", b"8", b"ok", b"9"):
            assert read_answer(connection) == (200, expected)


@pytest.mark.parametrize(
    ("then", "expected"),
    [
        (b"GET\r\n\r\n", b"HTTP/1.1 400"),
        (post(9).replace(b"A: b", b"Host: y"), b"HTTP/1.1 400"),
        (post(9).replace(b"A: b", b"A: " + b"b" * 2**15), b"HTTP/1.1 431"),
        ((HEAD % b"9") + b"half", b"HTTP/1.1 408"),
    ],
)
def test_a_request_behind_it_has_the_bounds_of_every_other(
    server: BoundedServer, then: bytes, expected: bytes
) -> None:
    with server.connect() as connection:
        for size in (3, 4):
            connection.sendall(post(size))
            assert read_answer(connection) == (200, b"%d" % size)
        connection.sendall(then)
        assert read_to_end(connection).startswith(expected)


def test_a_token_is_checked_with_each_request() -> None:
    async def answer(call: OperationCall) -> Response:
        return Response(f"{call.account} {call.raw.decode()}")

    headers = [(b"authorization", b"Bearer secret")]
    scope = {
        "type": "http",
        "method": "POST",
        "path": "/",
        "headers": headers,
        "query_string": b"",
        "path_params": {},
    }
    body = Mock(model_validate=lambda data, **_: data)
    operation = Operation(answer, "run", body, reads=("application/json",))
    headers.append((b"content-type", b"application/json"))
    whole, tokens = WholeRequests(Request(scope)), Tokens({})

    def ask(text: bytes) -> bytes:
        whole.body = text
        asked = perform(whole.request, operation, tokens, 5, whole=whole)
        response = asyncio.run(asked)
        return b"%d %b" % (response.status_code, bytes(response.body)[:6])

    for account, scopes, expected in [
        ("a", {"run"}, b"200 a [1]"),
        ("b", {"run"}, b"200 b [1]"),
        ("b", {"read"}, b"403"),
        ("", set(), b"401"),
        ("a", {"run"}, b"200 a [1]"),
    ]:
        caller = Caller(account, frozenset(scopes))
        tokens.replace_those_of_file({hash_of("secret"): caller} if account else {})
        assert ask(b"[1]").startswith(expected)
    assert ask(b"[1,2,3]").startswith(b"413")
