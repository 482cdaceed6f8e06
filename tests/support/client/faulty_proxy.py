"""A proxy that loses and damages requests and answers, as a network does."""

import contextlib
import http.client
import re
import threading
from collections import deque
from collections.abc import Iterator, Mapping
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, TypeVar
from urllib.parse import urlsplit

import msgspec

from tests.support.servers import TIMEOUT_S

ServerT = TypeVar("ServerT", bound=ThreadingHTTPServer)


class FaultyProxy(ThreadingHTTPServer):
    """Forwards requests to a server; loses or damages some of them or their answers.
    faults: operation → the faults of its next requests, in order: `pass`,
    `lose_request`, `gateway` (a 502 with HTML), `lose_answer`, `cut_answer`. Requests
    without one pass. received_requests: (operation, body) of every request that
    arrived."""

    daemon_threads = True

    def __init__(self, upstream_url: str) -> None:
        super().__init__(("127.0.0.1", 0), _FaultyProxyHandler)
        self.upstream = urlsplit(upstream_url).netloc
        self.url = f"http://127.0.0.1:{self.server_address[1]}"
        self.faults: dict[str, deque[str]] = {}
        self.received_requests: list[tuple[str, dict[str, Any]]] = []

    def bodies(self, operation: str) -> list[dict[str, Any]]:
        return [body for name, body in self.received_requests if name == operation]


class _FaultyProxyHandler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server: FaultyProxy

    def _forward_with_fault(self) -> None:
        body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        operation = operation_of(self.command, self.path)
        packed = self.headers.get("Content-Type") == "application/msgpack"
        decode = msgspec.msgpack.decode if packed else msgspec.json.decode
        self.server.received_requests.append((operation, decode(body) if body else {}))
        faults = self.server.faults.get(operation)
        fault = faults.popleft() if faults else "pass"
        if fault == "lose_request":
            self.close_connection = True
        elif fault == "gateway":
            html = {"Content-Type": "text/html", "Content-Length": "20"}
            self._answer(502, html, b"<h1>Bad Gateway</h1>")
        else:
            self._forward(body, fault)

    def _forward(self, body: bytes, fault: str) -> None:
        upstream = http.client.HTTPConnection(self.server.upstream, timeout=TIMEOUT_S)
        with contextlib.closing(upstream):
            upstream.request(self.command, self.path, body, dict(self.headers.items()))
            answer = upstream.getresponse()
            content = answer.read()
        if fault == "lose_answer":
            self.close_connection = True
            return
        headers = dict(answer.getheaders())
        if fault == "cut_answer":
            self.close_connection = True
            content = content[: len(content) // 2]
        self._answer(answer.status, headers, content)

    def _answer(self, status: int, headers: Mapping[str, str], content: bytes) -> None:
        self.send_response_only(status)
        lengths = {"Content-Length": str(len(content))} if status != 304 else {}
        lengths |= {key.title(): text for key, text in headers.items()}
        for name, value in lengths.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)

    do_GET = do_PUT = do_POST = do_DELETE = _forward_with_fault  # noqa: N815 - http.server's names


@contextlib.contextmanager
def serve_in_thread(listener: ServerT) -> Iterator[ServerT]:
    """Serves in a thread, until the context ends."""
    with listener:
        serve = listener.serve_forever
        threading.Thread(target=serve, args=[0.01], daemon=True).start()
        yield listener
        listener.shutdown()


def operation_of(method: str, path: str) -> str:
    path = urlsplit(path).path
    for suffix in ("predict", "heartbeat"):
        if path.endswith(f"/{suffix}"):
            return suffix
    if re.search(r"/workers/[^/]+$", path):
        return {"PUT": "attach_worker", "DELETE": "detach_worker"}[method]
    return {"/v1/runs": "submit_run"}.get(path, path) if method == "POST" else path
