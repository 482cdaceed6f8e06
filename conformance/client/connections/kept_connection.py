"""One HTTP/1.1 connection that is kept: sends a request, receives the response.

A kit run is thousands of small requests, and a library with pools, redirects, cookies
and events takes 0.4 ms of CPU for each; this takes 0.1 ms, with the same parser (h11),
and sends a request in one piece. It refuses what HTTP forbids on both sides as httpx
does, with its exceptions. It repeats nothing and judges nothing.
"""

import contextlib
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

_PIECE_BYTES = 2**16
_HEAD_BYTES_MAX = 100 * 1024
_KEPT_IDLE_S = 2.0
_INTERIM_MAX = 100
_UPGRADED = 101


@dataclass(frozen=True, slots=True)
class HttpRequest:
    """A request as it is sent. timeout_s: of connecting, and of each read and write.

    headers: all but Host and those that describe the body, unless they differ from it.
    """

    method: str
    url: httpx.URL
    headers: dict[str, tuple[str, str]]  # by name in lower case
    content: bytes | Iterable[bytes] | None
    timeout_s: float

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


class BodySource(Protocol):
    """The connection on which a body arrives."""

    def read_parts(self) -> Iterator[bytes]:
        """Give its parts; raises httpx.TransportError."""

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
        """Read all of the body; decodes it if it is compressed."""
        body = b"".join(self._connection.read_parts())
        if "content-encoding" in self.headers:
            body = httpx.Response(200, headers=self.headers, content=body).content
        self.body = body
        return body

    def parts(self) -> Iterator[bytes]:
        """Give the parts of the body as they arrive."""
        stream = _PartStream(self._connection)
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


def can_be_stale(error: BaseException) -> bool:
    """Say whether the other side may have closed a connection that was kept."""
    return isinstance(
        error, httpx.RemoteProtocolError | httpx.ReadError | httpx.WriteError
    )


class _PartStream(httpx.SyncByteStream):
    def __init__(self, connection: BodySource) -> None:
        self._connection = connection

    def __iter__(self) -> Iterator[bytes]:
        return self._connection.read_parts()


class KeptConnection:
    """A connection to the host of a URL, opened when needed; for one thread.

    Raises the exceptions of httpx: TransportError without a valid response, and
    LocalProtocolError for a request that HTTP cannot carry, of which nothing is sent.
    """

    def __init__(self, certificates: Callable[[], ssl.SSLContext]) -> None:
        self._certificates = certificates
        self._sock: socket.socket | None = None
        self._h11 = h11.Connection(h11.CLIENT, _HEAD_BYTES_MAX)
        self._idle_since = 0.0
        self._is_new = self._has_answer = False

    def send(self, request: HttpRequest) -> HttpResponse:
        """Send a request and receive the head of its response."""
        if self._sock is not None and self._is_stale(self._sock):
            self.close()
        self._is_new, self._has_answer = self._sock is None, False
        try:
            sock = self._sock = self._sock or self._connect(request)
            sock.settimeout(request.timeout_s)
            self._write(sock, request)
            event = self._read_head()
        except BaseException:
            self.close()
            raise
        self._has_answer = True
        headers = httpx.Headers(event.headers.raw_items())
        return HttpResponse(self, sock, event.status_code, headers)

    def was_closed_before_use(self, error: BaseException) -> bool:
        """Say whether the other side closed a kept connection as it was used again.

        Every HTTP server may close one that is idle, at any moment.
        """
        return not (self._is_new or self._has_answer) and can_be_stale(error)

    def read_parts(self) -> Iterator[bytes]:
        """Give the parts of a body; after the last one it can be used again."""
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
            sock.close()
        self._h11 = h11.Connection(h11.CLIENT, _HEAD_BYTES_MAX)

    def _is_stale(self, sock: socket.socket) -> bool:
        """Whether it was idle for long, or the other side has closed it."""
        if time.monotonic() - self._idle_since > _KEPT_IDLE_S:
            return True
        with selectors.DefaultSelector() as selector:
            selector.register(sock, selectors.EVENT_READ)
            return bool(selector.select(0))

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
        content = request.content
        parts = [content or b""] if isinstance(content, bytes | None) else content
        is_whole = isinstance(content, bytes | None)
        try:
            data = self._send_event(
                h11.Request(
                    method=request.method,
                    target=request.url.raw_path,
                    headers=request.all_headers(),
                )
            )
            for part in parts:
                if not is_whole:
                    sock.sendall(data)
                    data = b""
                data += self._send_event(h11.Data(data=part))
            sock.sendall(data + self._send_event(h11.EndOfMessage()))
        except h11.LocalProtocolError as error:
            raise httpx.LocalProtocolError(str(error)) from error
        except TimeoutError as error:
            raise httpx.WriteTimeout(str(error)) from error
        except OSError as error:
            if is_own_error(error):
                raise httpx.WriteError(str(error)) from error
            # A server may answer and close before it has all: read what it said.

    def _send_event(self, event: h11.Event) -> bytes:
        return self._h11.send(event) or b""

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
                if event is not h11.NEED_DATA:
                    return event
                data = self._receive()
                if not data and self._h11.their_state is h11.SEND_RESPONSE:
                    raise httpx.RemoteProtocolError(
                        "Server disconnected without sending a response."
                    )
                self._h11.receive_data(data)
            except h11.RemoteProtocolError as error:
                raise httpx.RemoteProtocolError(str(error)) from error

    def _receive(self) -> bytes:
        if (sock := self._sock) is None:
            raise httpx.ReadError("the connection is closed")
        try:
            return sock.recv(_PIECE_BYTES)
        except TimeoutError as error:
            raise httpx.ReadTimeout(str(error)) from error
        except OSError as error:
            raise httpx.ReadError(str(error)) from error
