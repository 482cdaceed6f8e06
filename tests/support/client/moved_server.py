"""Addresses at which a server was and is not any more."""

import socket
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler

from tests.support.network.tls_gateway import serve_plainly


@contextmanager
def closed_port() -> Iterator[int]:
    """A port of this machine that refuses every connection."""
    with socket.socket() as bound:
        bound.bind(("127.0.0.1", 0))
        yield int(bound.getsockname()[1])


def _handler(
    status: int, header: Callable[[str], tuple[str, str]]
) -> type[BaseHTTPRequestHandler]:
    """Answers each request without a body; header: path → name and value."""

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def do_GET(self) -> None:
            self.rfile.read(int(self.headers.get("Content-Length") or 0))
            self.send_response_only(status)
            self.send_header(*header(self.path))
            self.send_header("Content-Length", "0")
            self.end_headers()

        do_POST = do_PUT = do_DELETE = do_GET  # noqa: N815

        def log_message(self, format: str, *arguments: object) -> None:  # noqa: A002
            """No request is of interest."""

    return Handler


@contextmanager
def other_server() -> Iterator[str]:
    """The URL of a server of something else, which has no such page."""
    with serve_plainly(_handler(405, lambda _: ("Content-Type", "text/html"))) as url:
        yield url


@contextmanager
def moved_server(place: str) -> Iterator[str]:
    """The URL of a server that redirects every request to the base URL `place`."""
    with serve_plainly(_handler(308, lambda path: ("Location", place + path))) as url:
        yield url
