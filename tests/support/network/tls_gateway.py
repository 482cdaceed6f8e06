"""Servers that speak TLS: one with fixed answers, and one before another server."""

import contextlib
import ssl
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import httpx

from tests.support.kit.null_servers import Request, canned_answers
from tests.support.server.certificates import create_certificate


class CannedHandler(BaseHTTPRequestHandler):
    def do_GET(self) -> None:
        reply = canned_answers(Request("GET", self.path, b""))
        assert reply is not None
        status, headers, body = reply
        self.send_response(status)
        for name, value in (headers | {"Content-Length": str(len(body))}).items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_: object) -> None:
        """Write no log."""


class Gateway(CannedHandler):
    """Passes requests on to a server that does not know of it."""

    upstream = ""

    def do_GET(self) -> None:
        body = self.rfile.read(int(self.headers["Content-Length"] or 0))
        url, headers = f"{self.upstream}{self.path}", dict(self.headers)
        sent = httpx.request(
            self.command, url, headers=headers, content=body, trust_env=False
        )
        self.send_response(sent.status_code)
        for name in ("Content-Type", "Proctor-Version"):
            self.send_header(name, sent.headers[name])
        self.send_header("Content-Length", str(len(sent.content)))
        self.end_headers()
        self.wfile.write(sent.content)

    do_POST = do_GET  # noqa: N815 - as the library calls it


@contextlib.contextmanager
def serve_tls(
    folder: Path, handler: type[BaseHTTPRequestHandler], name: str = "localhost"
) -> Iterator[tuple[str, Path]]:
    """A server for a name that no authority knows: its URL and certificate."""
    pem, context = create_certificate(folder, name)
    with serve_plainly(handler, context) as url:
        yield url.replace("http://127.0.0.1", f"https://{name}"), pem


@contextlib.contextmanager
def serve_plainly(
    handler: type[BaseHTTPRequestHandler], tls: ssl.SSLContext | None = None
) -> Iterator[str]:
    """A server with these answers: its URL without TLS."""
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        server.daemon_threads = True
        if tls is not None:
            server.socket = tls.wrap_socket(server.socket, server_side=True)
        serve = threading.Thread(target=server.serve_forever, args=(0.02,), daemon=True)
        serve.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}"
        finally:
            server.shutdown()
