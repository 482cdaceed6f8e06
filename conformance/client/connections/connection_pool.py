"""The connections of one run of the kit, each used by one thread at a time.

To servers behind a proxy that the environment names, requests go through httpx, which
knows how to speak with proxies.
"""

import contextlib
import functools
import os
import ssl
import threading
from collections.abc import Iterator

import certifi
import httpx

from conformance.client.connections.kept_connection import (
    HttpRequest,
    HttpResponse,
    KeptConnection,
)
from conformance.client.connections.proxied_connection import ProxiedConnection
from conformance.client.connections.transport.proxy_route import find_route
from conformance.client.connections.transport.tls_trust import VARIABLES, client_context

Connection = KeptConnection | ProxiedConnection
# Requests go to the service and to the endpoints of its runs.
_ORIGINS_MAX = 4


class Connections:
    """The connections of one thread: one to each host, opened when needed."""

    def __init__(self) -> None:
        self._by_origin: dict[tuple[str, str, int | None], Connection] = {}

    def to(self, url: httpx.URL) -> Connection:
        """Give the connection to the host of a URL.

        Raises UnsupportedProtocol, and BadProxy for a proxy that cannot be used.
        """
        origin = url.scheme, url.host, url.port
        connection = self._by_origin.get(origin)
        if connection is None:
            if url.scheme not in ("http", "https") or not url.host:
                raise httpx.UnsupportedProtocol(f"{url} is no URL of HTTP with a host")
            if len(self._by_origin) >= _ORIGINS_MAX:
                self.close()
            route = find_route(str(url))
            connection = (
                ProxiedConnection(certificates, route)
                if route.url
                else KeptConnection(certificates)
            )
            self._by_origin[origin] = connection
        return connection

    def get(self, url: str, timeout_s: float) -> HttpResponse:
        """Read what a server answers to a GET. Raises httpx.RequestError."""
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

    def __init__(self) -> None:
        self._idle: list[Connections] = []
        self._lock = threading.Lock()

    @contextlib.contextmanager
    def borrow(self) -> Iterator[Connections]:
        """Give connections that nothing else uses until the end of the block.

        After an error they are closed: nothing is known about them.
        """
        with self._lock:
            connections = self._idle.pop() if self._idle else None
        connections = connections or Connections()
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


def certificates() -> ssl.SSLContext:
    """The certificates that are accepted; loaded once, because it is slow."""
    return _load_certificates(tuple(os.environ.get(name) for name in VARIABLES))


@functools.cache
def _load_certificates(named: tuple[str | None, ...]) -> ssl.SSLContext:
    """Without a name they are those of this machine and those of browsers."""
    context = client_context()
    if not any(named):
        context.load_verify_locations(certifi.where())
    return context
