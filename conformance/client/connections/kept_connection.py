"""One HTTP/1.1 connection that is kept: sends a request, receives the response.

A kit run is thousands of small requests, and a library with pools, redirects, cookies
and events takes 0.4 ms of CPU for each; this takes 0.1 ms, with the same parser (h11),
and sends a request in one piece. It refuses what HTTP forbids on both sides as httpx
does, with its exceptions. It repeats nothing and judges nothing.

h11 takes most of that time, so it sees neither the requests nor the answers that are
written like nearly all, and whole: their bytes are joined and split here.
"""

import contextlib
import math
import re
import selectors
import socket
import ssl
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Protocol

import h11
import httpx

from conformance.client.connections.connection_faults import is_own_error

# That of Linux takes four calls of the system where this takes one.
_Selector = getattr(selectors, "PollSelector", selectors.DefaultSelector)
_PIECE_BYTES = 2**16
_HEAD_BYTES_MAX = 100 * 1024
_KEPT_IDLE_S = 2.0
_INTERIM_MAX = 100
_UPGRADED = 101
_BETWEEN_PARTS_S = 0.005
# More than any answer that a kit run needs; an endless body ends here.
BODY_BYTES_MAX = 2**27
# The time for an answer, from its request to the last byte, in single waits.
_WAITS_PER_ANSWER = 2
# Heads of which nothing depends on who reads them: no blanks around a value, no line
# that goes on, printable characters of ASCII. The status is that of an answer.
_PLAIN_LINES = rb"((?:[A-Za-z0-9-]+: [!-~](?:[ -~]*[!-~])?\r\n)+)\r\n"
_PLAIN_HEAD = re.compile(rb"HTTP/1\.1 ([2-5]\d\d) [ -~]*\r\n" + _PLAIN_LINES)
_PLAIN_REQUEST = re.compile(rb"(?!CONNECT )[A-Z]+ /[!-~]* HTTP/1\.1\r\n" + _PLAIN_LINES)
_WITHOUT_BODY = (b"204", b"304")
# An answer whose end, and that of its connection, depend on its length alone has the
# first of these headers, once, and none of the others.
_OF_FRAMING = (b"content-length", b"transfer-encoding", b"connection", b"upgrade")


class UnreadableAnswer(httpx.RemoteProtocolError):
    """An answer that is not of HTTP/1.1; received: its bytes that are not read yet."""

    def __init__(self, reason: str, received: bytes) -> None:
        super().__init__(reason)
        self.received = received.decode("latin-1")


class EndlessAnswer(httpx.ReadError):
    """An answer that is too long, or not whole when its time is over."""


_KEPT = ("Connection", "keep-alive")
_OF_OTHER_REQUESTS = {"host", "content-length", "transfer-encoding", "upgrade"}


@dataclass(frozen=True, slots=True)
class HttpRequest:
    """A request as it is sent. timeout_s: of connecting, and of each read and write.

    An answer with an end has twice that time in all. headers: all but Host and those
    that describe the body, unless they differ from it.
    """

    method: str
    url: httpx.URL
    headers: dict[str, tuple[str, str]]  # by name in lower case
    content: bytes | Iterable[bytes] | None
    timeout_s: float

    @property
    def is_secure(self) -> bool:
        """Whether it goes to a server with TLS, and by a proxy through a tunnel."""
        return self.url.scheme == "https"

    @property
    def answer_timeout_s(self) -> float:
        """The time for connecting, the head and the body together."""
        return _WAITS_PER_ANSWER * self.timeout_s

    def late(self) -> EndlessAnswer:
        """Give the error of an answer that is not whole at the end of its time."""
        return EndlessAnswer(f"the answer had no end after {self.answer_timeout_s:g} s")

    def all_headers(self) -> list[tuple[str, str]]:
        """Give the headers with those that a client adds, where they are missing."""
        host = ("Host", self.url.netloc.decode("ascii"))
        headers = [self.headers.get("host", host)]
        headers += [pair for name, pair in self.headers.items() if name != "host"]
        if "content-length" in self.headers or "transfer-encoding" in self.headers:
            return headers
        if isinstance(self.content, bytes | None):
            size = len(self.content or b"")
            if size or self.method in ("POST", "PUT", "PATCH"):
                headers.append(("Content-Length", str(size)))
        else:
            headers.append(("Transfer-Encoding", "chunked"))
        return headers

    def plain_bytes(self) -> bytes | None:
        """Give the bytes of one that is written like nearly all; None if h11 has to."""
        content, names = self.content or b"", self.headers.keys()
        is_kept = self.headers.get("connection", _KEPT) == _KEPT
        if type(content) is not bytes or not is_kept or names & _OF_OTHER_REQUESTS:
            return None
        lines = "".join(f"{name}: {text}\r\n" for name, text in self.all_headers())
        target = self.url.raw_path.decode("ascii")
        head = f"{self.method} {target} HTTP/1.1\r\n{lines}\r\n".encode()
        return head + content if _PLAIN_REQUEST.fullmatch(head) else None


class BodyInTwoParts(bytes):
    """A body whose second part is sent some milliseconds after the first.

    cut: where the second part begins. Servers read together what arrives together.
    """

    cut = 0

    @classmethod
    def cut_at(cls, cut: int, content: bytes) -> "BodyInTwoParts":
        body = cls(content)
        body.cut = cut
        return body


@dataclass(frozen=True, slots=True)
class WholeAnswer:
    """An answer that arrived in one piece; the source of its own body."""

    status: int
    headers: list[tuple[bytes, bytes]]
    body: bytes

    @classmethod
    def split(cls, method: str, received: bytes) -> "WholeAnswer | None":
        """Split the bytes of an answer; None if h11 has to read them."""
        head = _PLAIN_HEAD.match(received)
        if head is None or head[1] in _WITHOUT_BODY or method == "HEAD":
            return None
        lines = (line.partition(b": ") for line in head[2].splitlines())
        headers = [(name, value) for name, _, value in lines]
        body = received[head.end() :]
        framing = [value for name, value in headers if name.lower() in _OF_FRAMING]
        if framing != [b"%d" % len(body)]:
            return None
        return cls(int(head[1]), headers, body)

    def read_parts(self, *, is_endless: bool) -> Iterator[bytes]:
        """As of BodySource."""
        yield self.body

    def close_unless_idle(self) -> None:
        """As of BodySource: its connection is idle."""


class BodySource(Protocol):
    """The connection on which a body arrives."""

    def read_parts(self, *, is_endless: bool) -> Iterator[bytes]:
        """Give its parts, for the time of an answer; raises httpx.TransportError.

        is_endless: the body is a stream, which may go on for longer.
        """

    def close_unless_idle(self) -> None:
        """Keep the connection if the body was read to its end."""


class HttpResponse:
    """The head of a response, and its body as it arrives."""

    def __init__(
        self,
        connection: BodySource,
        sock: socket.socket,
        status: int,
        headers: httpx.Headers,
    ) -> None:
        self.status, self.headers = status, headers
        self.body: bytes | None = None
        self._connection, self._sock = connection, sock

    def read(self) -> bytes:
        """Read all of the body; decodes it if it is compressed.

        Raises EndlessAnswer if it is too long or its time is over.
        """
        received = _limit_size(self._connection.read_parts(is_endless=False))
        self.body = body = b"".join(_limit_size(self._decode(received)))
        return body

    def parts(self) -> Iterator[bytes]:
        """Give the parts of the body as they arrive, decoded."""
        return self._decode(self._connection.read_parts(is_endless=True))

    def _decode(self, received: Iterator[bytes]) -> Iterator[bytes]:
        codings = self.headers.get("content-encoding", "")
        if "," in codings:  # each of them may multiply a small part by a thousand
            raise httpx.DecodingError(f"more than one Content-Encoding: {codings}")
        if not codings:
            yield from received
            return
        stream = _PartStream(received)
        yield from httpx.Response(200, headers=self.headers, stream=stream).iter_bytes()

    def close(self) -> None:
        """Close the connection unless the body was read to its end."""
        self._connection.close_unless_idle()

    def shut_down(self) -> None:
        """End it from another thread than the one that reads it.

        Harmless when it has ended: the connection may carry other requests since then,
        but over another socket.
        """
        with contextlib.suppress(OSError):
            self._sock.shutdown(socket.SHUT_RDWR)


def _limit_size(parts: Iterator[bytes]) -> Iterator[bytes]:
    size = 0
    for part in parts:
        size += len(part)
        if size > BODY_BYTES_MAX:
            mebibytes = BODY_BYTES_MAX >> 20
            raise EndlessAnswer(f"the body had no end after {mebibytes} MiB")
        yield part


def can_be_stale(error: BaseException) -> bool:
    """Say whether the other side may have closed a connection that was kept."""
    return isinstance(
        error, httpx.RemoteProtocolError | httpx.ReadError | httpx.WriteError
    )


class _PartStream(httpx.SyncByteStream):
    def __init__(self, parts: Iterator[bytes]) -> None:
        self._parts = parts

    def __iter__(self) -> Iterator[bytes]:
        return self._parts


class KeptConnection:
    """A connection to the host of a URL, opened when needed; for one thread.

    Raises the exceptions of httpx: TransportError without a valid response, and
    LocalProtocolError for a request that HTTP cannot carry, of which nothing is sent.
    """

    def __init__(self, certificates: Callable[[], ssl.SSLContext]) -> None:
        self._certificates = certificates
        self._sock: socket.socket | None = None
        self._selector: selectors.BaseSelector  # has the socket, while it is open
        self._h11 = h11.Connection(h11.CLIENT, _HEAD_BYTES_MAX)
        self._idle_since = 0.0
        self._request: HttpRequest | None = None
        self._is_plain = False  # h11 has not seen the request
        self._ends_at = math.inf  # the time of the answer is over
        self._is_new = self._has_answer = self._has_bytes = False

    def send(self, request: HttpRequest) -> HttpResponse:
        """Send a request and receive the head of its response."""
        if self._sock is not None and self._is_stale():
            self.close()
        self._is_new, self._has_answer = self._sock is None, False
        self._has_bytes = False  # of this request's answer
        self._request = request
        self._ends_at = time.monotonic() + request.answer_timeout_s
        try:
            sock = self._sock or self._open(request)
            sock.settimeout(request.timeout_s)
            self._write(sock, request)
            answer = self._read_answer(sock, request)
        except BaseException:
            self.close()
            raise
        self._has_answer = True
        return answer

    def _read_answer(self, sock: socket.socket, request: HttpRequest) -> HttpResponse:
        received = self._receive()
        if whole := self._is_plain and WholeAnswer.split(request.method, received):
            self._idle_since = time.monotonic()
            headers = httpx.Headers(whole.headers)
            return HttpResponse(whole, sock, whole.status, headers)
        if self._is_plain:
            for _ in self._written(request):
                pass
        self._feed(received)
        event = self._read_head()
        headers = httpx.Headers(event.headers.raw_items())
        return HttpResponse(self, sock, event.status_code, headers)

    def was_closed_before_use(self, error: BaseException) -> bool:
        """Say whether the other side closed a kept connection as it was used again.

        Every HTTP server may close one that is idle, at any moment.
        """
        return not (self._is_new or self._has_answer) and can_be_stale(error)

    def read_parts(self, *, is_endless: bool) -> Iterator[bytes]:
        """As of BodySource; after the last part it can be used again."""
        if is_endless:
            self._ends_at = math.inf
        try:
            while type(event := self._next_event()) is h11.Data:
                yield bytes(event.data)
        finally:
            self.close_unless_idle()

    def close_unless_idle(self) -> None:
        """Keep it if the last response has been read."""
        if self._h11.our_state is h11.DONE and self._h11.their_state is h11.DONE:
            self._h11.start_next_cycle()
            self._idle_since = time.monotonic()
        elif self._h11.our_state is not h11.IDLE:
            self.close()

    def close(self) -> None:
        """Close it; the next request opens another one."""
        sock, self._sock = self._sock, None
        if sock is not None:
            self._selector.close()
            sock.close()
        self._h11 = h11.Connection(h11.CLIENT, _HEAD_BYTES_MAX)

    def _is_stale(self) -> bool:
        """Whether it was idle for long, or the other side has closed it."""
        is_old = time.monotonic() - self._idle_since > _KEPT_IDLE_S
        return is_old or bool(self._selector.select(0))

    def _open(self, request: HttpRequest) -> socket.socket:
        self._sock = sock = self._connect(request)
        self._selector = _Selector()
        self._selector.register(sock, selectors.EVENT_READ)
        return sock

    def _connect(self, request: HttpRequest) -> socket.socket:
        url = request.url
        is_secure = url.scheme == "https"
        host = url.raw_host.decode("ascii")
        address = host, url.port or (443 if is_secure else 80)
        try:
            sock = socket.create_connection(address, request.timeout_s)
            try:
                sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                if is_secure:
                    certificates = self._certificates()
                    sock = certificates.wrap_socket(sock, server_hostname=host)
            except BaseException:
                sock.close()
                raise
        except TimeoutError as error:
            raise httpx.ConnectTimeout(str(error)) from error
        except OSError as error:
            raise httpx.ConnectError(str(error)) from error
        return sock

    def _write(self, sock: socket.socket, request: HttpRequest) -> None:
        content, plain = request.content, request.plain_bytes()
        self._is_plain = plain is not None
        try:
            if plain is not None:
                sock.sendall(plain)
                return
            written = self._written(request)
            if not isinstance(content, bytes | None):
                for part in written:
                    sock.sendall(part)
                return
            data = b"".join(written)
            if isinstance(content, BodyInTwoParts):
                first = len(data) - len(content) + content.cut
                sock.sendall(data[:first])
                time.sleep(_BETWEEN_PARTS_S)
                data = data[first:]
            sock.sendall(data)
        except h11.LocalProtocolError as error:
            raise httpx.LocalProtocolError(str(error)) from error
        except TimeoutError as error:
            raise httpx.WriteTimeout(str(error)) from error
        except OSError as error:
            if is_own_error(error):
                raise httpx.WriteError(str(error)) from error
            # A server may answer and close before it has all: read what it said.

    def _written(self, request: HttpRequest) -> Iterator[bytes]:
        """Write a request with h11: its head, then its body in parts."""
        content = request.content
        head = h11.Request(
            method=request.method,
            target=request.url.raw_path,
            headers=request.all_headers(),
        )
        yield self._h11.send(head) or b""
        for part in [content or b""] if isinstance(content, bytes | None) else content:
            yield self._h11.send(h11.Data(data=part)) or b""
        yield self._h11.send(h11.EndOfMessage()) or b""

    def _read_head(self) -> h11.Response | h11.InformationalResponse:
        for _ in range(_INTERIM_MAX + 1):
            event = self._next_event()
            if isinstance(event, h11.Response):
                return event
            if isinstance(event, h11.InformationalResponse):
                if event.status_code == _UPGRADED:
                    return event
            else:
                raise httpx.RemoteProtocolError(f"no response, but {event!r}")
        raise httpx.RemoteProtocolError(f"more than {_INTERIM_MAX} interim responses")

    def _next_event(self) -> h11.Event | type[h11.NEED_DATA] | type[h11.PAUSED]:
        while True:
            try:
                event = self._h11.next_event()
            except h11.RemoteProtocolError as error:
                received, _ = self._h11.trailing_data
                raise UnreadableAnswer(str(error), received) from error
            if event is not h11.NEED_DATA:
                return event
            self._feed(self._receive())

    def _feed(self, data: bytes) -> None:
        if not data and self._h11.their_state is h11.SEND_RESPONSE:
            raise httpx.RemoteProtocolError(
                "Server disconnected without sending a response."
            )
        self._h11.receive_data(data)

    def _late(self, request: HttpRequest) -> httpx.ReadError | httpx.ReadTimeout:
        """Give the error at the end of the time, by whether an answer has begun."""
        if self._has_bytes:
            return request.late()
        return httpx.ReadTimeout("no byte of an answer came")

    def _receive(self) -> bytes:
        if (sock := self._sock) is None or (request := self._request) is None:
            raise httpx.ReadError("the connection is closed")
        left_s = self._ends_at - time.monotonic()
        if left_s <= 0:
            raise self._late(request)
        try:
            timeout_s = min(left_s, request.timeout_s)
            if sock.gettimeout() != timeout_s:
                sock.settimeout(timeout_s)
            data = sock.recv(_PIECE_BYTES)
        except TimeoutError as error:
            if time.monotonic() >= self._ends_at:
                raise self._late(request) from error
            raise httpx.ReadTimeout(str(error)) from error
        except OSError as error:
            raise httpx.ReadError(str(error)) from error
        self._has_bytes = True
        return data
