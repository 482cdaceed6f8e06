"""HTTP servers of the kit at an address of this machine, of IPv4 or IPv6."""

import socket
import threading
from collections.abc import Mapping
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Self

from conformance.client.connections.loopback import in_url


class QuietHandler(BaseHTTPRequestHandler):
    """Reads whole bodies, keeps its connection, and writes no log."""

    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True

    def read_body(self) -> bytes:
        """Read the body.

        Raises ConnectionAbortedError when the caller leaves before its end, as a
        stopped run does.
        """
        length = int(self.headers.get("content-length", 0))
        body = self.rfile.read(length)
        if len(body) < length:
            raise ConnectionAbortedError("the caller left in the middle of a body")
        return body

    def lower_headers(self) -> dict[str, str]:
        """Give the headers by their names in small letters."""
        return {name.lower(): value for name, value in self.headers.items()}

    def send(self, status: int, headers: Mapping[str, str], body: bytes) -> None:
        """Send a response, or a part of it."""
        self.send_response(status)
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(body)

    def handle(self) -> None:
        """Let the caller close the connection at any time."""
        try:
            super().handle()
        except OSError:
            self.close_connection = True

    def log_message(self, *_: object) -> None:
        """Write nothing."""


class ListeningServer(ThreadingHTTPServer):
    """Listens at a free port of a host; `origin` is the URL without a path."""

    daemon_threads = True

    def __init__(self, host: str, handler: type[BaseHTTPRequestHandler]) -> None:
        is_ipv6 = ":" in host
        self.address_family = socket.AF_INET6 if is_ipv6 else socket.AF_INET
        super().__init__((host, 0), handler)
        self.origin = f"http://{in_url(host)}:{self.server_port}"


class Scripted:
    """A server of one check, which listens while it is entered."""

    def __init__(self, host: str, handler: type[BaseHTTPRequestHandler]) -> None:
        self.is_closed = False
        self._lock = threading.Lock()
        self._server = ListeningServer(host, handler)

    def __enter__(self) -> Self:
        """Serve, in a thread."""
        serve = self._server.serve_forever
        threading.Thread(target=serve, args=(0.02,), daemon=True).start()
        return self

    def __exit__(self, *_: object) -> None:
        """Stop serving."""
        self.is_closed = True
        self._server.shutdown()
        self._server.server_close()
