"""One kept HTTP/1.1 connection: a request out in one piece, its answer in.

The parser is llhttp, which httptools binds. Connecting, sending and receiving are here,
because an answer may be megabytes, which are received into the memory that they are
used in. It knows neither paths nor encodings, and repeats nothing.
"""

from __future__ import annotations

import socket
import ssl
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlsplit

import httptools
from urllib3.util.wait import wait_for_read

# What is received at once until the size of an answer is known: most answers whole.
_PIECE_BYTES = 2**16
_HEAD_BYTES_MAX = 2**17
ANSWER_BYTES_MAX = 2**30
_BREAKS_OFF = "the connection ended before the answer did"


class BrokenAnswer(OSError):
    """What came is no HTTP, breaks off, or is larger than anybody can mean."""


@dataclass(frozen=True, slots=True)
class Answer:
    """A whole answer. headers: names in lower case."""

    status: int
    reason: str
    headers: Mapping[str, str]
    body: bytes | memoryview


class HttpConnection:
    """A connection to the place of `url`, made when it is needed; for one thread.

    timeouts_s: to connect, and between two pieces of an answer.
    room: gives writable memory of a size for a large body.
    """

    def __init__(
        self,
        url: str,
        timeouts_s: tuple[float, float],
        buffer: Callable[[int], memoryview],
    ) -> None:
        parts = urlsplit(url)
        self._is_secure = parts.scheme == "https"
        self._host = parts.hostname or ""
        self._port = parts.port or (443 if self._is_secure else 80)
        self._timeouts_s = timeouts_s
        self._make_buffer = buffer
        self._piece = memoryview(bytearray(_PIECE_BYTES))
        self.sock: socket.socket | None = None

    def send_request(self, request: bytes) -> Answer:
        """Raises OSError when no answer comes, BrokenAnswer for one that is none."""
        if self._has_unexpected_data():
            self.close()
        try:
            if self.sock is None:
                self.sock = self._connect()
            self.sock.sendall(request)
            return self._read_answer(self.sock)
        except BaseException:
            self.close()  # what comes on it next would answer no question
            raise

    def close(self) -> None:
        if self.sock is not None:
            self.sock.close()
            self.sock = None

    def _has_unexpected_data(self) -> bool:
        """Nothing was asked: what can be read is the end, or no answer to anything."""
        if self.sock is None:
            return False
        # TLS may have read ahead of what the system knows.
        if isinstance(self.sock, ssl.SSLSocket) and self.sock.pending():
            return True
        return wait_for_read(self.sock, 0.0)

    def _connect(self) -> socket.socket:
        place = self._host, self._port
        made = socket.create_connection(place, self._timeouts_s[0])
        try:
            made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            if self._is_secure:
                context = ssl.create_default_context()
                context.set_alpn_protocols(["http/1.1"])
                made = context.wrap_socket(made, server_hostname=self._host)
            made.settimeout(self._timeouts_s[1])
        except BaseException:
            made.close()
            raise
        return made

    def _read_answer(self, sock: socket.socket) -> Answer:
        parser = _ResponseParser()
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

    def _feed(self, parser: _ResponseParser, sock: socket.socket) -> None:
        count = sock.recv_into(self._piece)
        parser.feed(self._piece[:count])

    def _receive_body(self, sock: socket.socket, begun: bytes, size: int) -> memoryview:
        """A body of known size: past the parser to where it will be used."""
        buffer = self._make_buffer(size)
        filled = len(begun)
        buffer[:filled] = begun
        while filled < size:
            count = sock.recv_into(buffer[filled:])
            if not count:
                raise BrokenAnswer(_BREAKS_OFF)
            filled += count
        return buffer


class _ResponseParser:
    """An answer while it comes: what the parser calls, and what is known of it.

    status: 0 until its head is complete.
    """

    def __init__(self) -> None:
        self._parser: Any = httptools.HttpResponseParser(self)
        self._fed = 0
        self.status = 0
        self.is_complete = False
        self.keeps_connection = False
        self.on_message_begin()

    def feed(self, piece: memoryview) -> None:
        """An empty piece is the end of the connection."""
        if not piece:
            if self.status < 200 or "transfer-encoding" in self.headers:
                raise BrokenAnswer(_BREAKS_OFF)
            self.is_complete = True  # the body has no other end
            return
        self._fed += len(piece)
        try:
            self._parser.feed_data(piece)
        except (httptools.HttpParserError, httptools.HttpParserUpgrade) as error:
            raise BrokenAnswer(f"what came is no answer in HTTP: {error}") from error
        if self._fed > (ANSWER_BYTES_MAX if self.status >= 200 else _HEAD_BYTES_MAX):
            raise BrokenAnswer("the answer has no end")

    def body(self) -> bytes:
        """What came of it so far."""
        return b"".join(self._parts)

    @property
    def size(self) -> int | None:
        """Of the body, if its head says so."""
        if self.status in (204, 304):  # they may name the size of another one's
            return None
        size = int(self.headers.get("content-length", -1))
        if size > ANSWER_BYTES_MAX:
            raise BrokenAnswer(f"the answer has {size} bytes")
        return None if size < 0 else size

    def on_message_begin(self) -> None:
        """Also of the answer behind an interim one (1xx), which says nothing to us."""
        if self.status >= 200:
            raise BrokenAnswer("two answers came to one request")
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
            raise BrokenAnswer(f"there is no status {self.status}")
        # Here only: at the end of the answer the parser has forgotten it.
        self.keeps_connection = self._parser.should_keep_alive()

    def on_body(self, part: bytes) -> None:
        self._parts.append(part)

    def on_message_complete(self) -> None:
        self.is_complete = self.status >= 200
