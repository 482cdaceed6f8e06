"""A connection for bytes that no HTTP library sends: requests that never end.

Knows URLs, TLS and the status line of an answer, and nothing of the protocol.
"""

import contextlib
import http.client
import socket
import time
from collections.abc import Iterator
from dataclasses import dataclass
from urllib.parse import urlsplit

from conformance.client.connections.connection_pool import certificates
from conformance.client.connections.transport.proxy_route import ProxyRoute, find_route
from conformance.verdicts.expect import SetUpFailed

_CONNECT_TIMEOUT_S = 10.0
_STORED_BYTES = 2**16
_READ_TIMEOUT_S = 10.0


@dataclass(frozen=True)
class Ending:
    """The end of an exchange.

    status: None without an answer. is_closed: the server closed the connection.
    """

    status: int | None
    is_closed: bool
    after_s: float

    def __str__(self) -> str:
        answer = f"status {self.status}" if self.status else "no answer"
        end = "closed" if self.is_closed else "still open"
        return f"{answer}, connection {end} after {self.after_s:.1f} s"


class RawConnection:
    """One connection to the server of a URL; head lines name it."""

    def __init__(self, connection: socket.socket, host: str, prefix: str) -> None:
        self._connection = connection
        self._host = host
        self._prefix = prefix

    def head(self, method: str, path: str, *lines: str) -> bytes:
        """Give a request line and headers, without the empty line behind them."""
        first = f"{method} {self._prefix}{path} HTTP/1.1"
        return "".join(
            f"{line}\r\n" for line in (first, f"Host: {self._host}", *lines)
        ).encode()

    def send_until_end(
        self,
        data: bytes,
        timeout_s: float = _READ_TIMEOUT_S,
        *,
        more: bytes = b"",
        every_s: float = _READ_TIMEOUT_S,
    ) -> Ending:
        """Send bytes, and read until the server closes or the time is over.

        more: is sent again and again while nothing comes.
        """
        began_at = time.monotonic()
        self._connection.settimeout(timeout_s)
        with contextlib.suppress(OSError):  # it may hang up before all is sent
            self._connection.sendall(data)
        received, is_closed = b"", False
        while (left_s := began_at + timeout_s - time.monotonic()) > 0:
            self._connection.settimeout(min(left_s, every_s))
            try:
                part = self._connection.recv(2**16)
            except TimeoutError:
                with contextlib.suppress(OSError):
                    self._connection.sendall(more)
                continue
            except OSError:
                part = b""
            if not part:
                is_closed = True
                break
            received += part[: max(0, _STORED_BYTES - len(received))]
        words = received.split(b" ", 2)
        status = int(words[1]) if len(words) == 3 and words[1].isdigit() else None
        return Ending(status, is_closed, time.monotonic() - began_at)


@contextlib.contextmanager
def open_raw_connection(url: str) -> Iterator[RawConnection]:
    """Connect to the server at a base URL; raises OSError.

    Raises SetUpFailed where a proxy opens no tunnel: what it forwards are requests.
    """
    parts = urlsplit(url)
    assert parts.hostname is not None
    is_tls = parts.scheme == "https"
    address = (parts.hostname, parts.port or (443 if is_tls else 80))
    with contextlib.ExitStack() as stack:
        connection = stack.enter_context(_connect(address, find_route(url)))
        if is_tls:
            connection = stack.enter_context(
                certificates().wrap_socket(connection, server_hostname=parts.hostname)
            )
        host = parts.netloc.rpartition("@")[2]
        yield RawConnection(connection, host, parts.path.rstrip("/"))


def _connect(address: tuple[str, int], route: ProxyRoute) -> socket.socket:
    if not route.url:
        return socket.create_connection(address, _CONNECT_TIMEOUT_S)
    proxy = urlsplit(route.url)
    if proxy.scheme == "https":
        reason = f"the kit opens no tunnel {route.how}, which speaks TLS itself"
        raise SetUpFailed(reason, allowed=True)
    opener = http.client.HTTPConnection(
        proxy.hostname or "", proxy.port, timeout=_CONNECT_TIMEOUT_S
    )
    opener.set_tunnel(*address, headers=dict(route.headers))
    try:
        opener.connect()
    except OSError as error:
        opener.close()
        raise SetUpFailed(
            f"no connection of its own {route.how} ({error}): {route.advice}",
            allowed=True,
        ) from error
    tunnel = opener.sock
    opener.sock = None
    return tunnel
