"""The client's connection against servers that send whatever they like."""

import contextlib
import socket
import ssl
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

from reference_client.protocol import http_connection
from reference_client.protocol.http_connection import (
    Answer,
    BrokenAnswer,
    HttpConnection,
)
from tests.support.network.accepting_server import AcceptingServer
from tests.support.server.certificates import create_certificate

TIMEOUTS_S = (5.0, 20.0)
REQUEST = b"POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 0\r\n\r\n"
OK = b"HTTP/1.1 200 OK\r\nX-Two: b\r\nContent-Length: 4\r\n\r\nbody"


class ScriptedServer(AcceptingServer):
    """Answers the n-th request with the pieces of the n-th script, each sent apart. A
    script that ends with None hangs up after it."""

    def __init__(
        self, scripts: Sequence[Sequence[bytes | None]], tls: ssl.SSLContext | None
    ) -> None:
        self._scripts = list(scripts)
        self._tls = tls
        super().__init__(self._talk)

    def _talk(self, sock: socket.socket) -> None:
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        if self._tls is not None:
            sock = self._tls.wrap_socket(sock, server_side=True)
        with sock:
            while self._scripts and _read_request(sock):
                for piece in self._scripts.pop(0):
                    if piece is None:
                        return
                    sock.sendall(piece)
            _read_request(sock)  # its end


def _read_request(sock: socket.socket) -> bool:
    received = b""
    while not received.endswith(b"\r\n\r\n"):
        part = sock.recv(4096)
        if not part:
            return False
        received += part
    return True


@contextlib.contextmanager
def scripted_server(
    *scripts: Sequence[bytes | None], tls: ssl.SSLContext | None = None
) -> Iterator[tuple[ScriptedServer, HttpConnection]]:
    server = ScriptedServer(scripts, tls)
    scheme = "https" if tls else "http"
    url = f"{scheme}://{'localhost' if tls else '127.0.0.1'}:{server.port}/base"
    client = HttpConnection(url, TIMEOUTS_S, lambda size: memoryview(bytearray(size)))
    try:
        yield server, client
    finally:
        client.close()
        server.close()


def answer_fields(answer: Answer) -> tuple[int, str, bytes]:
    return answer.status, answer.reason, bytes(answer.body)


def assert_ok(client: HttpConnection) -> None:
    answer = client.send_request(REQUEST)
    assert answer_fields(answer) == (200, "OK", b"body")


def test_a_connection_is_kept() -> None:
    with scripted_server([OK], [OK], [OK]) as (server, client):
        for _ in range(3):
            answer = client.send_request(REQUEST)
            assert answer_fields(answer) == (200, "OK", b"body")
            assert answer.headers == {"x-two": "b", "content-length": "4"}
        assert server.connections == 1


@pytest.mark.parametrize(
    "pieces",
    [
        [bytes([byte]) for byte in OK],
        [OK[:-4], OK[-4:]],
        [b"HTTP/1.1 103 Early Hints\r\nLink: x\r\n\r\n", OK],
        [b"HTTP/1.1 103 Early Hints\r\nLink: x\r\n\r\n" + OK],
        [
            b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n2\r\nbo\r\n",
            b"2\r\ndy\r\n0\r\n\r\n",
        ],
    ],
    ids=["bytes", "head and body", "interim", "interim at once", "chunks"],
)
def test_an_answer_may_come_in_any_pieces(pieces: list[bytes]) -> None:
    with scripted_server(pieces, [OK]) as (server, client):
        assert_ok(client)
        assert_ok(client)
        assert server.connections == 1


@pytest.mark.parametrize(
    "pieces",
    [
        [b"HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: 4\r\n\r\nbody"],
        [b"HTTP/1.0 200 OK\r\nContent-Length: 4\r\n\r\nbody"],
        [b"HTTP/1.1 200 OK\r\nConnection: close\r\n\r\nbo", b"dy", None],
        [b"HTTP/1.1 200 OK\r\n\r\nbody", None],
    ],
)
def test_a_closed_connection_is_not_reused(pieces: list[bytes | None]) -> None:
    with scripted_server(pieces, [OK]) as (server, client):
        assert_ok(client)
        assert_ok(client)
        assert server.connections == 2


KNOWN = (
    b"HTTP/1.1 200 OK\r\nDate: Mon, 30 Nov 2026 16:00:01 GMT\r\nX-Two: b\r\n"
    b"Content-Length: 4\r\nX-Request-Id: 1f\r\n\r\nbody"
)


@pytest.mark.parametrize(
    ("answer", "changed"),
    [
        (KNOWN, {}),
        (
            KNOWN.replace(b":01 GMT", b":59 GMT").replace(b": 1f", b": a b"),
            {"date": "Mon, 30 Nov 2026 16:00:59 GMT", "x-request-id": "a b"},
        ),
        (
            KNOWN.replace(b"h: 4", b"h: 0009").replace(b"body", b"long body"),
            {"content-length": "0009"},
        ),
        (KNOWN.replace(b": 1f", b":   1f  "), {"x-request-id": "1f  "}),
        (KNOWN.replace(b"X-Two: b", b"X-Two: c"), {"x-two": "c"}),
        (KNOWN.replace(b": 1f", b": \xe9"), {"x-request-id": "\xe9"}),
    ],
    ids=["same", "values", "length", "spaces", "another field", "latin-1"],
)
@pytest.mark.parametrize("is_whole", [True, False])
def test_an_answer_like_the_one_before_is_read_as_the_parser_reads_it(
    answer: bytes, changed: dict[str, str], is_whole: bool
) -> None:
    at = len(answer) if is_whole else answer.index(b"\r\n\r\n") + 6
    pieces = [answer[:at], answer[at:]]
    with scripted_server([KNOWN], pieces, [KNOWN]) as (server, client):
        first = client.send_request(REQUEST)
        second = client.send_request(REQUEST)
        assert second.headers == {**first.headers, **changed}
        size = int(second.headers["content-length"])
        assert answer_fields(second) == (200, "OK", answer[-size:])
        assert_ok(client)
        assert server.connections == 1


@pytest.mark.parametrize(
    ("answer", "why"),
    [
        ([KNOWN + b"HTTP/1.1"], "invalid HTTP response"),
        ([KNOWN.replace(b"h: 4", b"h: 9999999999")], "9999999999 bytes exceeds"),
        ([KNOWN.replace(b"h: 4", b"h: 99999999999")], "99999999999 bytes exceeds"),
        ([KNOWN.replace(b"h: 4", b"h: 4, 4")], "invalid HTTP response"),
        ([KNOWN[:-1], None], "connection closed before"),
    ],
)
def test_an_invalid_answer_like_the_one_before_is_an_error(
    answer: list[bytes | None], why: str
) -> None:
    with scripted_server([KNOWN], answer) as (_, client):
        assert_ok(client)
        with pytest.raises(BrokenAnswer, match=why):
            client.send_request(REQUEST)
        assert client.sock is None


def test_a_large_body_is_received_where_it_will_be_used() -> None:
    body = bytes(range(256)) * 4096
    head = b"HTTP/1.1 200 OK\r\nContent-Length: %d\r\n\r\n" % len(body)
    buffers = []

    def make_buffer(size: int) -> memoryview:
        buffers.append(memoryview(bytearray(size)))
        return buffers[-1]

    with scripted_server([head + body]) as (server, _):
        url = f"http://127.0.0.1:{server.port}"
        client = HttpConnection(url, TIMEOUTS_S, make_buffer)
        answer = client.send_request(REQUEST)
        client.close()
    assert answer.body is buffers[0]
    assert answer.body == body


@pytest.mark.parametrize(
    "head", [b"", b"Content-Length: 0\r\n", b"Content-Length: 9\r\n"]
)
def test_an_answer_may_have_no_body(head: bytes) -> None:
    answer = b"HTTP/1.1 304 Not Modified\r\n" + head + b"\r\n"
    with scripted_server([answer], [OK]) as (server, client):
        unchanged = client.send_request(REQUEST)
        assert answer_fields(unchanged) == (304, "Not Modified", b"")
        assert_ok(client)
        assert server.connections == 1


@pytest.mark.parametrize(
    ("pieces", "why"),
    [
        ([None], "connection closed before"),
        ([b"HTTP/1.1 200", None], "connection closed before"),
        ([OK[:-1], None], "connection closed before"),
        (
            [b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n2\r\nbo", None],
            "connection closed before",
        ),
        ([b"SSH-2.0-OpenSSH_9.6\r\n"], "invalid HTTP response"),
        ([b"HTTP/1.1 200 OK\r\nContent-Length: -4\r\n\r\nbody"], "invalid HTTP"),
        ([b"HTTP/1.1 200 OK\r\nContent-Length: 4x\r\n\r\nbody"], "invalid HTTP"),
        ([OK + OK], "invalid HTTP response"),
        ([b"HTTP/1.1 099 What\r\nContent-Length: 0\r\n\r\n"], "invalid HTTP response"),
        ([b"HTTP/1.1 101 X\r\nConnection: Upgrade\r\n\r\n"], "invalid HTTP"),
        (
            [
                b"HTTP/1.1 103 X\r\n\r\nHTTP/1.1 200 OK\r\n",
                *[b"X: " + b"y" * 2**15] * 8,
            ],
            "exceeds the size limit",
        ),
        ([b"HTTP/1.1 200 OK\r\nContent-Length: 99999999999\r\n\r\n"], "99999999999"),
        (
            [b"HTTP/1.1 200 OK\r\n", *[b"X: " + b"y" * 2**15 + b"\r\n"] * 8],
            "exceeds the size limit",
        ),
    ],
)
def test_an_invalid_answer_is_an_error_and_closes_the_connection(
    pieces: list[bytes | None], why: str
) -> None:
    with scripted_server(pieces, [OK]) as (server, client):
        with pytest.raises(BrokenAnswer, match=why):
            client.send_request(REQUEST)
        assert client.sock is None
    assert server.connections == 1


def test_an_endless_answer_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(http_connection, "ANSWER_BYTES_MAX", 2**18)
    head = b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n"
    chunk = b"10000\r\n" + b"x" * 2**16 + b"\r\n"
    with (
        scripted_server([head, *[chunk] * 5]) as (_, client),
        pytest.raises(BrokenAnswer, match="exceeds the size limit"),
    ):
        client.send_request(REQUEST)


def test_a_server_that_does_not_answer_times_out() -> None:
    with scripted_server([b"HTTP/1.1 200 OK\r\n"]) as (server, _):
        url = f"http://127.0.0.1:{server.port}"
        client = HttpConnection(
            url, (5.0, 0.05), lambda size: memoryview(bytearray(size))
        )
        with pytest.raises(TimeoutError):
            client.send_request(REQUEST)
        assert client.sock is None


def test_tls_verifies_the_name_in_the_certificate(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    authority, tls = create_certificate(tmp_path, "localhost")
    with scripted_server([OK], [OK], tls=tls) as (server, client):
        monkeypatch.setenv("SSL_CERT_FILE", str(authority))
        for _ in range(2):
            assert_ok(client)
        assert server.connections == 1
    body = b"x" * 9000
    large = b"HTTP/1.1 200 OK\r\nContent-Length: 9000\r\n\r\n" + body
    with_extra_bytes = [large[:4000], large[4000:] + OK]
    with scripted_server(with_extra_bytes, [OK], tls=tls) as (server, client):
        # Bytes that TLS has read ahead are not taken for the next request's answer.
        assert client.send_request(REQUEST).body == body
        assert_ok(client)
        assert server.connections == 2
    with scripted_server([OK], tls=tls) as (_, client):
        monkeypatch.delenv("SSL_CERT_FILE")
        with pytest.raises(ssl.SSLCertVerificationError):
            client.send_request(REQUEST)
