"""One persistent HTTP/1.1 connection: sends a request, receives the response.

Why no HTTP client library: on loopback, a request for 670 bytes takes 123 µs with this
module, 281 µs with http.client, 329 µs with aiohttp, 471 µs with urllib3 and 913 µs
with requests (`make bench`, "An HTTP client"). Images are megabytes; they
are received directly into the memory in which the policy reads them. Parsing is left to
a library: httptools, the binding of llhttp. A connection is opened by urllib3, which
knows proxies and TLS.

Knows neither paths nor encodings, and repeats nothing.
"""

from __future__ import annotations

import re
import select
import socket
import ssl
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, cast
from urllib.parse import urlsplit

import httptools
from urllib3.connection import HTTPConnection, ProxyConfig
from urllib3.util import parse_url
from urllib3.util.ssltransport import SSLTransport
from urllib3.util.wait import wait_for_read

# Received at once until the size of a response is known: most responses fit.
_PIECE_BYTES = 2**16
_HEAD_BYTES_MAX = 2**17
ANSWER_BYTES_MAX = 2**30
Stream = socket.socket | SSLTransport  # the latter is TLS inside of TLS
INCOMPLETE = "connection closed before the response was complete"
# Fields with another value in each answer; only the length says how it is read.
_CHANGING = re.compile(
    rb"(\r\n(?:content-length|date|x-request-id): )[ -~]+", re.IGNORECASE
)
_LENGTH_NAME = "content-length"
_LENGTH_PATTERN, _VALUE_PATTERN = rb"([0-9]{1,10})", rb"([!-~](?:[ -~]*[!-~])?)"
# A connection learns a few heads, because that takes as long as to parse many.
_HEADS_LEARNT_MAX = 4


def ascii_place(url: str) -> str:
    """HOST:PORT of a URL, as the header Host has it."""
    place = urlsplit(url).netloc
    return place if place.isascii() else place.encode("idna").decode()


class BrokenAnswer(OSError):
    """The response is not HTTP, is incomplete, or exceeds the size limit."""


class CutConnection(BrokenAnswer, ConnectionAbortedError):
    """The connection ended before the response was complete."""


class Answer(NamedTuple):
    """A complete response. headers: names in lower case."""

    status: int
    reason: str
    headers: Mapping[str, str]
    body: bytes | memoryview


def accept_all(_connected: socket.socket) -> None:
    """Everything may be sent there."""


class HttpConnection:
    """A connection to the host of `url`, opened when needed; for one thread.

    timeouts_s: to connect, and between two reads of a response.
    make_buffer: size → writable memory for a body of known size.
    check: raises for a connection on which nothing may be sent.

    target_prefix, proxy_headers: stand before the path, and are sent, in each request
    that a proxy forwards; both are empty without one. Raises BadProxy.
    """

    def __init__(
        self,
        url: str,
        timeouts_s: tuple[float, float],
        make_buffer: Callable[[int], memoryview],
        check: Callable[[socket.socket], None] = accept_all,
    ) -> None:
        self._check = check
        parts = urlsplit(url)
        self._is_secure = parts.scheme == "https"
        self._host = parts.hostname or ""
        self._port = parts.port or (443 if self._is_secure else 80)
        # Imported late: completion at a Tab imports this module, and often ends here.
        from proctor_client import find_route

        self._route = find_route(url)
        is_forwarded = bool(self._route.url) and not self._is_secure
        self.target_prefix = f"http://{ascii_place(url)}" if is_forwarded else ""
        self.proxy_headers = self._route.headers if is_forwarded else {}
        self._timeouts_s = timeouts_s
        self._make_buffer = make_buffer
        self._piece = memoryview(bytearray(_PIECE_BYTES))
        self._known_head: _KnownHead | None = None
        self._heads_learnt = 0
        self.sock: Stream | None = None
        # Made once for a connection, where the system has it: urllib3 makes one for
        # each look at the socket.
        self._input: select.poll | None = None

    def send_request(self, request: bytes) -> Answer:
        """Raises NO_ANSWER_ERRORS: without a response, BrokenAnswer for a bad one."""
        if self._has_unexpected_data():
            self.close()
        try:
            if self.sock is None:
                self.sock = self._connect()
            self.sock.sendall(request)
            return self._read_answer(self.sock)
        except BaseException:
            self.close()  # later bytes on it would belong to this request
            raise

    def limit_silence(self, longest_s: float) -> None:
        """Bound the time between two reads of a response, also of later ones."""
        connect_s, read_s = self._timeouts_s
        self._timeouts_s = connect_s, min(read_s, longest_s)
        if self.sock is not None:
            self.sock.settimeout(self._timeouts_s[1])

    def close(self) -> None:
        if self.sock is not None:
            self.sock.close()
            self.sock = None

    def _has_unexpected_data(self) -> bool:
        """Whether it was closed by the peer, or holds bytes that no request caused."""
        if self.sock is None:
            return False
        # TLS may have buffered bytes that the socket no longer shows.
        if isinstance(self.sock, ssl.SSLSocket) and self.sock.pending():
            return True
        if self._input is not None:
            return bool(self._input.poll(0))
        return wait_for_read(cast("socket.socket", self.sock), 0.0)

    def _connect(self) -> Stream:
        connection = self._connection_to_open()
        try:
            connection.connect()
            opened = connection.sock
            assert opened is not None
            self._check(opened)
            opened.settimeout(self._timeouts_s[1])
            if hasattr(select, "poll"):
                self._input = select.poll()
                self._input.register(opened, select.POLLIN)
        except BaseException:
            connection.close()
            raise
        connection.sock = None  # it is kept here, and not closed with its opener
        return opened

    def _connection_to_open(self) -> HTTPConnection:
        """To the server, or to its proxy, which opens a tunnel for TLS."""
        proxy = urlsplit(self._route.url)
        host, port = proxy.hostname or self._host, proxy.port or self._port
        if not (self._is_secure or proxy.scheme == "https"):
            return HTTPConnection(host, port, timeout=self._timeouts_s[0])
        from proctor_client.interim_answers import HttpsConnection
        from proctor_client.transport.tls_trust import client_context

        context, connect_s = client_context(), self._timeouts_s[0]
        if not (self._is_secure and self._route.url):
            return HttpsConnection(host, port, timeout=connect_s, ssl_context=context)
        tunnel = HttpsConnection(
            host,
            port,
            timeout=connect_s,
            ssl_context=context,
            proxy=parse_url(self._route.url),
            proxy_config=ProxyConfig(context, False, None, None),
        )
        headers = self._route.headers
        tunnel.set_tunnel(self._host, self._port, headers, scheme=proxy.scheme)
        return tunnel

    def _read_answer(self, sock: Stream) -> Answer:
        first = self._piece[: _receive_into(sock, self._piece)]
        known = None if self._known_head is None else self._known_head.find(first)
        if known is None:
            return self._parse_answer(sock, first)
        body = self._receive_body(sock, known.begun, known.size)
        return Answer(200, known.reason, known.headers, body)

    def _parse_answer(self, sock: Stream, first: memoryview) -> Answer:
        """first: what was received of it."""
        parser = _ResponseParser()
        parser.feed(first)
        is_usual = parser.status == 200 and parser.keeps_connection
        if is_usual and self._heads_learnt < _HEADS_LEARNT_MAX:
            self._heads_learnt += 1
            self._known_head = _KnownHead.of(bytes(first), parser)
        while parser.status < 200:
            self._feed(parser, sock)
        body: bytes | memoryview
        if (size := parser.size) is not None:
            body = self._receive_body(sock, parser.body(), size)
        else:
            while not parser.is_complete:
                self._feed(parser, sock)
            body = parser.body()
        if not parser.keeps_connection:
            self.close()
        return Answer(parser.status, parser.reason, parser.headers, body)

    def _feed(self, parser: _ResponseParser, sock: Stream) -> None:
        count = _receive_into(sock, self._piece)
        parser.feed(self._piece[:count])

    def _receive_body(
        self, sock: Stream, begun: bytes | memoryview, size: int
    ) -> memoryview:
        """A body of known size: received directly into the buffer, not parsed."""
        buffer = self._make_buffer(size)
        filled = len(begun)
        buffer[:filled] = begun
        while filled < size:
            count = _receive_into(sock, buffer[filled:])
            if not count:
                raise CutConnection(INCOMPLETE)
            filled += count
        return buffer


def _receive_into(sock: Stream, memory: memoryview) -> int:
    count = sock.recv_into(memory)
    assert isinstance(count, int)
    return count


class _KnownAnswer(NamedTuple):
    """size: of the body. begun: what has come of it."""

    reason: str
    headers: Mapping[str, str]
    size: int
    begun: memoryview


class _KnownHead:
    """The head of an answer that was parsed as a whole, to recognise the next one.

    A server sends the same head with each turn, but for the values of a few fields. One
    that equals it besides these would be parsed to the same, and is only compared.
    """

    def __init__(self, head: bytes, parser: _ResponseParser) -> None:
        self._reason, self._headers = parser.reason, parser.headers
        same, *rest = _CHANGING.split(head)
        pattern, self._names = re.escape(same), list[str]()
        for begin, same in zip(rest[::2], rest[1::2], strict=True):
            name = begin.decode().strip(": \r\n").lower()
            self._names.append(name)
            value = _LENGTH_PATTERN if name == _LENGTH_NAME else _VALUE_PATTERN
            pattern += re.escape(begin) + value + re.escape(same)
        self._match = re.compile(pattern).match

    @classmethod
    def of(cls, received: bytes, parser: _ResponseParser) -> _KnownHead | None:
        """received: what was parsed, with the whole head.

        None where it is not seen where the body begins, or the length is not written as
        usual.
        """
        head, end, begun = received.partition(b"\r\n\r\n")
        if not end or begun != parser.body():
            return None
        known = cls(head + end, parser)
        return known if _LENGTH_NAME in known._names else None

    def find(self, received: memoryview) -> _KnownAnswer | None:
        """The answer that begins here; None if it has another head, or is too long."""
        match = self._match(received)
        if match is None:
            return None
        values = map(bytes.decode, match.groups())
        changed = dict(zip(self._names, values, strict=True))
        size, begun = int(changed[_LENGTH_NAME]), received[match.end() :]
        if len(begun) > size or size > ANSWER_BYTES_MAX:
            return None
        return _KnownAnswer(self._reason, self._headers | changed, size, begun)


class _ResponseParser:
    """Collects one response from the callbacks of the parser.

    status: 0 until the head is complete.
    """

    def __init__(self) -> None:
        self._parser: Any = httptools.HttpResponseParser(self)
        self._fed = 0
        self.status = 0
        self.is_complete = False
        self.keeps_connection = False
        self.on_message_begin()

    def feed(self, piece: memoryview) -> None:
        """An empty piece means the end of the connection."""
        if not piece:
            if self.status < 200 or "transfer-encoding" in self.headers:
                raise CutConnection(INCOMPLETE)
            self.is_complete = True  # the end of the connection ends the body
            return
        self._fed += len(piece)
        try:
            self._parser.feed_data(piece)
        except (httptools.HttpParserError, httptools.HttpParserUpgrade) as error:
            raise BrokenAnswer(f"invalid HTTP response: {error}") from error
        if self._fed > (ANSWER_BYTES_MAX if self.status >= 200 else _HEAD_BYTES_MAX):
            raise BrokenAnswer("response exceeds the size limit")

    def body(self) -> bytes:
        """The body received so far."""
        return b"".join(self._parts)

    @property
    def size(self) -> int | None:
        """The size of the body, if the head declares it."""
        if self.status in (204, 304):  # their Content-Length is that of another body
            return None
        size = int(self.headers.get("content-length", -1))
        if size > ANSWER_BYTES_MAX:
            raise BrokenAnswer(f"response of {size} bytes exceeds the size limit")
        return None if size < 0 else size

    def on_message_begin(self) -> None:
        """Called also for the response after an interim one (1xx), which is ignored."""
        if self.status >= 200:
            raise BrokenAnswer("unexpected second response")
        self.reason = ""
        self.headers: dict[str, str] = {}
        self._parts: list[bytes] = []

    def on_status(self, reason: bytes) -> None:
        self.reason += reason.decode("latin-1")

    def on_header(self, name: bytes, value: bytes) -> None:
        self.headers[name.decode("latin-1").lower()] = value.decode("latin-1")

    def on_headers_complete(self) -> None:
        self.status = self._parser.get_status_code()
        if self.status < 100:
            raise BrokenAnswer(f"invalid status {self.status}")
        # Read here: the parser resets it at the end of the response.
        self.keeps_connection = self._parser.should_keep_alive()

    def on_body(self, part: bytes) -> None:
        self._parts.append(part)

    def on_message_complete(self) -> None:
        self.is_complete = self.status >= 200
