"""A kept connection: what it sends, what it refuses, and how bodies arrive."""

import contextlib
import gzip
import socket
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import httpx
import pytest

from conformance.client.connections import kept_connection
from conformance.client.connections.connection_pool import ConnectionPool, Connections
from conformance.client.connections.kept_connection import (
    EndlessAnswer,
    HttpRequest,
    KeptConnection,
    WholeAnswer,
)
from conformance.client.connections.proxied_connection import ProxiedConnection
from tests.support.kit.endless_answers import ENDLESS, serve_parts
from tests.support.network.accepting_server import AcceptingServer
from tests.support.servers import TIMEOUT_S

SHORT = b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\n{}"


class ScriptedServer(AcceptingServer):
    """Receives one request for each answer on one connection."""

    def __init__(self, *answers: bytes, closes: bool = False) -> None:
        self.received: list[bytes] = []
        self.was_closed = threading.Event()
        self._answers, self._closes = iter(answers), closes
        super().__init__(self._answer_all)

    def _answer_all(self, connection: socket.socket) -> None:
        for answer in self._answers:
            self.received.append(connection.recv(2**16))
            connection.sendall(answer)
        if not self._closes and not connection.recv(1):
            self.was_closed.set()


@contextlib.contextmanager
def connect(server: ScriptedServer) -> Iterator[Connections]:
    with (
        contextlib.closing(server),
        contextlib.closing(ConnectionPool()) as pool,
        pool.borrow() as connections,
    ):
        yield connections


def request(
    server: ScriptedServer, headers: dict[str, str] | None = None, method: str = "POST"
) -> HttpRequest:
    url = httpx.URL(f"{server.url}/v1/runs?limit=1")
    named = {name.lower(): (name, value) for name, value in (headers or {}).items()}
    return HttpRequest(method, url, named, b'{"a": 1}', TIMEOUT_S)


def read(connections: Connections, sent: HttpRequest) -> bytes:
    return connections.to(sent.url).send(sent).read()


def test_a_request_is_sent_in_one_piece_and_the_connection_is_kept() -> None:
    server = ScriptedServer(SHORT, SHORT)
    with connect(server) as connections:
        for _ in range(2):
            assert read(connections, request(server, {"Accept": "x/y"})) == b"{}"
    host = server.url.removeprefix("http://")
    text = (
        f"POST /v1/runs?limit=1 HTTP/1.1\r\nHost: {host}\r\nAccept: x/y\r\n"
        'Content-Length: 8\r\n\r\n{"a": 1}'
    )
    assert server.received == [text.encode()] * 2


@pytest.mark.parametrize(
    ("name", "value", "is_plain"),
    [
        ("Accept", "x/y; q=0", True),
        ("Connection", "keep-alive", True),
        ("Connection", "close", False),
        ("Upgrade", "h2c", False),
        ("Host", "other.example", False),
        ("Content-Length", "8", False),
        ("A_b", "c", False),
        ("Name", "", False),
    ],
)
def test_a_plain_request_has_the_bytes_of_the_parser(
    name: str, value: str, is_plain: bool
) -> None:
    server = ScriptedServer()
    with connect(server) as connections:
        sent = request(server, {"X-First": "1", name: value})
        connection = connections.to(sent.url)
        assert isinstance(connection, KeptConnection)
        written = b"".join(connection._written(sent))
    assert sent.plain_bytes() == (written if is_plain else None)


def test_an_answer_that_arrives_whole_is_split_without_the_parser() -> None:
    plain = b"HTTP/1.1 422 Not Right\r\nContent-Type: a/b; c=d\r\nCONTENT-length: 2\r\n"
    whole = WholeAnswer.split("GET", plain + b"\r\n{}")
    assert whole is not None
    assert (whole.status, whole.body) == (422, b"{}")
    assert whole.headers == [(b"Content-Type", b"a/b; c=d"), (b"CONTENT-length", b"2")]


@pytest.mark.parametrize(
    ("written", "instead"),
    [
        (b"1.1", b"1.0"),
        (b" 200 ", b" 100 "),
        (b" 200 ", b" 204 "),
        (b" 200 ", b" 304 "),
        (b" 200 OK", b" 200"),
        (b"\r\n\r\n", b"\n\n"),
        (b": 2", b" : 2"),
        (b": 2", b": 2 "),
        (b": 2", b": 02"),
        (b": 2", b": 3"),
        (b": 2", b": 2\r\nContent-Length: 2"),
        (b": 2", b": 2\r\n a line that goes on"),
        (b": 2", b": 2\r\nName: \xff"),
        (b": 2", b": 2\r\nConnection: close"),
        (b"Content-Length: 2", b"Transfer-Encoding: chunked"),
        (b"Content-Length: 2", b"Name: value"),
        (b"{}", b"{}HTTP/1.1 200 OK"),
        (b"{}", b"{"),
    ],
)
def test_any_other_answer_is_left_to_the_parser(written: bytes, instead: bytes) -> None:
    assert WholeAnswer.split("GET", SHORT) is not None
    assert WholeAnswer.split("HEAD", SHORT) is None
    assert WholeAnswer.split("GET", SHORT.replace(written, instead, 1)) is None


def test_the_pool_closes_what_it_keeps() -> None:
    server = ScriptedServer(SHORT)
    with connect(server) as connections:
        read(connections, request(server))
    assert server.was_closed.wait(TIMEOUT_S)


def test_an_answer_that_has_ended_ends_no_later_request() -> None:
    arrived, is_ended = threading.Event(), threading.Event()

    def serve() -> None:
        last = SHORT.replace(b"\r\n\r\n", b"\r\nConnection: close\r\n\r\n")
        for number in range(2):
            connection, _ = listener.accept()
            with connection:
                connection.recv(2**16)
                if number:
                    arrived.set()
                    is_ended.wait(TIMEOUT_S)
                connection.sendall(last)

    with (
        socket.create_server(("127.0.0.1", 0)) as listener,
        ThreadPoolExecutor(2) as threads,
        contextlib.closing(Connections()) as connections,
    ):
        threads.submit(serve)
        url = httpx.URL(f"http://127.0.0.1:{listener.getsockname()[1]}/")
        sent = HttpRequest("GET", url, {}, None, TIMEOUT_S)
        first = connections.to(url).send(sent)
        assert first.read() == b"{}"
        second = threads.submit(read, connections, sent)
        assert arrived.wait(TIMEOUT_S)
        first.shut_down()
        is_ended.set()
        assert second.result(TIMEOUT_S) == b"{}"


def test_a_body_arrives_in_chunks_and_compressed() -> None:
    packed = gzip.compress(b"one body")
    head = b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\nContent-Encoding: gzip"
    chunks = b"".join(b"1\r\n%c\r\n" % byte for byte in packed) + b"0\r\n\r\n"
    server = ScriptedServer(head + b"\r\n\r\n" + chunks, SHORT)
    with connect(server) as connections:
        assert read(connections, request(server)) == b"one body"
        assert read(connections, request(server)) == b"{}"


def test_a_body_that_is_iterated_is_sent_in_chunks() -> None:
    server = ScriptedServer(b"HTTP/1.1 100 Continue\r\n\r\n" + SHORT)
    url = httpx.URL(server.url)
    with connect(server) as connections:
        sent = HttpRequest("PUT", url, {}, iter([b"ab"]), TIMEOUT_S)
        assert read(connections, sent) == b"{}"
    assert b"Transfer-Encoding: chunked" in server.received[0]


def test_headers_are_as_they_were_sent() -> None:
    head = b"HTTP/1.1 200 OK\r\nVary: a\r\nvary: b\r\nContent-Length: 2\r\n\r\n{}"
    server = ScriptedServer(head)
    with connect(server) as connections:
        sent = request(server)
        response = connections.to(sent.url).send(sent)
        assert response.headers.get_list("vary") == ["a", "b"]
        assert response.headers.raw[0] == (b"Vary", b"a")


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        (b"", "without sending a response"),
        (b"HTTP/1.1 200 OK\r\nContent-Length: 9\r\n\r\n{}", "without sending complete"),
        (b"HTTP/1.1 two hundred\r\n\r\n", "illegal status line"),
        (b"HTTP/1.1 200 OK\r\nContent-Length: two\r\n\r\n{}", "bad Content-Length"),
        (b"HTTP/1.1 200 OK\r\nA b: c\r\n\r\n", "illegal header line"),
    ],
)
def test_an_answer_that_is_not_http_is_none(answer: bytes, expected: str) -> None:
    server = ScriptedServer(answer, closes=True)
    with (
        pytest.raises(httpx.RemoteProtocolError, match=expected),
        connect(server) as connections,
    ):
        read(connections, request(server, method="GET"))


@pytest.mark.parametrize("headers", [{"Content-Length": "9"}, {"A b": "c"}])
def test_what_http_cannot_carry_is_not_sent(headers: dict[str, str]) -> None:
    server = ScriptedServer(SHORT)
    with connect(server) as connections:
        with pytest.raises(httpx.LocalProtocolError):
            read(connections, request(server, headers))
        assert server.received in ([], [b""])


def test_a_server_that_is_silent_is_a_timeout() -> None:
    server = ScriptedServer(b"HTTP/1.1 200 OK\r\n", SHORT)
    with connect(server) as connections, pytest.raises(httpx.ReadTimeout):
        read(connections, replace(request(server), timeout_s=0.05))


@pytest.mark.parametrize("way", ["directly", "by a proxy"])
@pytest.mark.parametrize("what", ENDLESS)
def test_an_answer_without_an_end_is_an_error(
    what: str, way: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(kept_connection, "BODY_BYTES_MAX", 2**22)
    is_refused = "header" in what or what == "trailers"
    if what == "interim answers":  # httpx accepts any number of them
        is_refused = way == "directly"
    expected: type[Exception] = EndlessAnswer
    timeout_s = 0.2
    if what == "silence":
        expected = httpx.ReadTimeout
    elif is_refused and "slow" not in what:
        expected = httpx.RemoteProtocolError
        timeout_s = TIMEOUT_S  # its bytes end it, however late they come
    with (
        serve_parts(ENDLESS[what]) as url,
        ConnectionPool().borrow() as connections,
    ):
        if way == "by a proxy":
            monkeypatch.setenv("http_proxy", url)
        named = url if way == "directly" else "http://proctor.example"
        sent = HttpRequest("GET", httpx.URL(f"{named}/v1"), {}, None, timeout_s)
        began_at = time.monotonic()
        with pytest.raises(expected):
            read(connections, sent)
        assert time.monotonic() - began_at < sent.answer_timeout_s + TIMEOUT_S


def test_a_refused_connection_and_another_scheme_are_errors() -> None:
    with socket.create_server(("127.0.0.1", 0)) as free:
        url = httpx.URL(f"http://127.0.0.1:{free.getsockname()[1]}")
    with ConnectionPool().borrow() as connections:
        with pytest.raises(httpx.ConnectError):
            read(connections, HttpRequest("GET", url, {}, None, TIMEOUT_S))
        with pytest.raises(httpx.UnsupportedProtocol):
            connections.to(httpx.URL("ftp://127.0.0.1/"))


def test_a_proxy_of_the_environment_gets_the_request(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """For another machine; for this one the proxy is not asked."""
    proxy = ScriptedServer(SHORT)
    monkeypatch.setenv("http_proxy", proxy.url)
    url = httpx.URL("http://proctor.example/v1")
    with contextlib.closing(proxy), ConnectionPool().borrow() as connections:
        connection = connections.to(url)
        assert isinstance(connection, ProxiedConnection)
        sent = HttpRequest("GET", url, {}, None, TIMEOUT_S)
        assert connection.send(sent).read() == b"{}"
        connections.close()
    assert proxy.received[0].startswith(b"GET http://proctor.example/v1 HTTP/1.1\r\n")
    server = ScriptedServer(SHORT)
    with connect(server) as connections:
        assert read(connections, request(server)) == b"{}"
