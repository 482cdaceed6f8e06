"""A forward proxy: it carries requests to hosts that it alone may know.

It forwards requests for http:// and opens tunnels for https://, as squid does, with a
user and a password if it is given them. A program may be started in an environment that
names it.
"""

import base64
import contextlib
import selectors
import socket
import ssl
import threading
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any
from urllib.parse import urlsplit

TIMEOUT_S = 30.0
_HOP = ("connection", "proxy-connection", "proxy-authorization")


@dataclass
class ForwardProxy:
    """A running proxy. hosts: the addresses of names that no one else knows. password:
    `user:password` that it wants. refuses: the status with which it refuses everything.
    requests: all that arrived, as `METHOD target`."""

    hosts: Mapping[str, tuple[str, int]]
    password: str | None = None
    refuses: int | None = None
    requests: list[str] = field(default_factory=list)
    url: str = ""

    def address(self, host: str, port: int) -> tuple[str, int]:
        return self.hosts.get(host, (host, port))

    def admits(self, authorization: str | None) -> bool:
        if self.password is None:
            return True
        pair = base64.b64encode(self.password.encode()).decode()
        return authorization == f"Basic {pair}"


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    proxy: ForwardProxy

    rbufsize = 0  # what follows the head of a request stays in the socket

    def _forward(self) -> None:
        self.proxy.requests.append(f"{self.command} {self.path}")
        parts = urlsplit(self.path)
        target = parts.path + (f"?{parts.query}" if parts.query else "")
        headers = {n: v for n, v in self.headers.items() if n.lower() not in _HOP}
        lines = [f"{name}: {value}" for name, value in headers.items()]
        head = [f"{self.command} {target} HTTP/1.1", *lines, "Connection: close"]
        address = (parts.hostname or "", parts.port or 80)
        self._carry(address, "\r\n".join([*head, "", ""]).encode("latin-1"))

    do_GET = do_PUT = do_POST = do_DELETE = _forward  # noqa: N815 - http.server's names

    def do_CONNECT(self) -> None:
        self.proxy.requests.append(f"{self.command} {self.path}")
        host, _, port = self.path.rpartition(":")
        self._carry((host.strip("[]"), int(port)), None)

    def _carry(self, address: tuple[str, int], head: bytes | None) -> None:
        """Carry what follows in both directions. head: of a request, else a tunnel."""
        self.close_connection = True
        if not self._is_admitted():
            return
        try:
            place = self.proxy.address(*address)
            upstream = socket.create_connection(place, TIMEOUT_S)
        except OSError as error:
            self._refuse(502, str(error))
            return
        with upstream:
            if head is None:
                self.send_response_only(200, "Connection established")
                self.end_headers()
            else:
                upstream.sendall(head)
            _pump(self.connection, upstream)

    def _is_admitted(self) -> bool:
        if self.proxy.refuses is not None:
            self._refuse(self.proxy.refuses, "by the policy of this network")
        elif not self.proxy.admits(self.headers.get("Proxy-Authorization")):
            self._refuse(407, "a password is wanted")
        else:
            return True
        return False

    def _refuse(self, status: int, text: str) -> None:
        page = f"<html>{text}</html>".encode()
        self.send_response(status)
        self.send_header("Content-Type", "text/html")
        self.send_header("Content-Length", str(len(page)))
        self.end_headers()
        self.wfile.write(page)

    def log_message(self, *_: object) -> None:
        """Write no log."""


def _pump(one: socket.socket, two: socket.socket) -> None:
    """Carry bytes between both until either ends."""
    with selectors.DefaultSelector() as selector:
        selector.register(one, selectors.EVENT_READ, two)
        selector.register(two, selectors.EVENT_READ, one)
        with contextlib.suppress(OSError):
            while True:
                for key, _ in selector.select(TIMEOUT_S):
                    source: Any = key.fileobj
                    # A socket with TLS may hold more than the selector sees.
                    data = source.recv(2**16)
                    while isinstance(source, ssl.SSLSocket) and source.pending():
                        data += source.recv(2**16)
                    if not data:
                        return
                    key.data.sendall(data)


@contextlib.contextmanager
def run_forward_proxy(
    hosts: Mapping[str, tuple[str, int]] | None = None,
    *,
    tls: ssl.SSLContext | None = None,
    **how: Any,
) -> Iterator[ForwardProxy]:
    """Run a proxy until the end of the block; with TLS it is at `localhost`."""
    proxy = ForwardProxy(hosts or {}, **how)
    handler = type("Handler", (_Handler,), {"proxy": proxy})
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        server.daemon_threads = True
        if tls is not None:
            server.socket = tls.wrap_socket(server.socket, server_side=True)
        host = "127.0.0.1" if tls is None else "localhost"
        scheme = "http" if tls is None else "https"
        proxy.url = f"{scheme}://{host}:{server.server_port}"
        threading.Thread(target=server.serve_forever, args=(0.01,), daemon=True).start()
        yield proxy
        server.shutdown()
