"""The connections of one run of the kit, each used by one thread at a time.

To servers behind a proxy that the environment names, requests go through httpx, which
knows how to speak with proxies.
"""

import contextlib
import functools
import ipaddress
import ssl
import threading
import urllib.request
from collections.abc import Iterator
from urllib.parse import urlsplit

import httpx

from conformance.client.connections.kept_connection import (
    HttpRequest,
    HttpResponse,
    KeptConnection,
)
from conformance.client.connections.proxied_connection import ProxiedConnection

Connection = KeptConnection | ProxiedConnection
# Requests go to the service and to the endpoints of its runs.
_ORIGINS_MAX = 4


class Connections:
    """The connections of one thread: one to each host, opened when needed."""

    def __init__(self, *, is_behind_proxy: bool = False) -> None:
        self._is_behind_proxy = is_behind_proxy
        self._by_origin: dict[tuple[str, str, int | None], Connection] = {}

    def to(self, url: httpx.URL) -> Connection:
        """Give the connection to the host of a URL. Raises UnsupportedProtocol."""
        origin = url.scheme, url.host, url.port
        connection = self._by_origin.get(origin)
        if connection is None:
            if url.scheme not in ("http", "https") or not url.host:
                raise httpx.UnsupportedProtocol(f"{url} is no URL of HTTP with a host")
            if len(self._by_origin) >= _ORIGINS_MAX:
                self.close()
            kind = ProxiedConnection if self._is_behind_proxy else KeptConnection
            connection = self._by_origin[origin] = kind(_certificates)
        return connection

    def get(self, url: str, timeout_s: float) -> HttpResponse:
        """Read what a server answers to a GET. Raises httpx.TransportError."""
        request = HttpRequest("GET", httpx.URL(url), {}, None, timeout_s)
        response = self.to(request.url).send(request)
        response.read()
        return response

    def close(self) -> None:
        """Close all; the next requests open others."""
        for connection in self._by_origin.values():
            connection.close()
        self._by_origin.clear()


class ConnectionPool:
    """Connections that are kept, each used by one thread at a time."""

    def __init__(self, url: str) -> None:
        self._is_behind_proxy = _is_behind_proxy(url)
        self._idle: list[Connections] = []
        self._lock = threading.Lock()

    @contextlib.contextmanager
    def borrow(self) -> Iterator[Connections]:
        """Give connections that nothing else uses until the end of the block.

        After an error they are closed: nothing is known about them.
        """
        with self._lock:
            connections = self._idle.pop() if self._idle else None
        connections = connections or Connections(is_behind_proxy=self._is_behind_proxy)
        try:
            yield connections
        except BaseException:
            connections.close()
            raise
        with self._lock:
            self._idle.append(connections)

    def close(self) -> None:
        """Close all that are not in use."""
        with self._lock:
            idle, self._idle = self._idle, []
        for connections in idle:
            connections.close()


@functools.cache
def _certificates() -> ssl.SSLContext:
    """Load the certificate authorities once: it is slow."""
    return httpx.create_ssl_context()


def _is_behind_proxy(url: str) -> bool:
    """Whether the environment names proxies, which are for other machines only."""
    host = urlsplit(url).hostname or ""
    try:
        is_this_machine = ipaddress.ip_address(host).is_loopback
    except ValueError:
        is_this_machine = host == "localhost"
    return not is_this_machine and bool(urllib.request.getproxies())
