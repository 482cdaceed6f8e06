"""A gateway between a client and a server that loses answers on purpose.

It stands in front of one server, keeps a record of what passed, and can lose or damage
requests and answers of a kind, kill the server at one predict, or alter every answer.
It knows which operation a path is, and nothing of what the bodies mean, except that a
run's `endpoint` must lead back through it.
"""

import json
import re
import socket
import threading
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, Self
from urllib.parse import urlsplit

import httpx
import msgspec

WriteAnswer = Callable[[int, Iterable[tuple[str, str]], bytes], bytes]
MSGPACK = "application/msgpack"
KINDS = {
    "describe": re.compile(r"GET /v1"),
    "submit": re.compile(r"POST /v1/runs"),
    "attach": re.compile(r"PUT /v1/runs/[^/]+/workers/[^/]+"),
    "predict": re.compile(r"POST /v1/runs/[^/]+/workers/[^/]+/predict"),
    "heartbeat": re.compile(r"POST /v1/runs/[^/]+/workers/[^/]+/heartbeat"),
    "episodes": re.compile(r"GET /v1/runs/[^/]+/episodes"),
}
HTML = {"Content-Type": "text/html"}
SECRET = "hunter2"
# Answers of a gateway or a network in the place of a server: status, headers, body.
ANSWERS_OF_OTHERS: dict[str, tuple[int, dict[str, str], bytes]] = {
    "page": (200, HTML, b"<h1>Please sign in</h1>"),
    "gateway": (502, HTML, b"<h1>Bad Gateway</h1>"),
    "empty": (503, {}, b""),
    "problem": (
        504,
        {"Content-Type": "application/problem+json"},
        b'{"type": "about:blank", "title": "Gateway Timeout", "status": 504}',
    ),
    "sign_in": (302, {"Location": f"http://portal.invalid/?token={SECRET}"}, b""),
    "refused": (405, HTML, b"<h1>Method Not Allowed</h1>"),
}
# Answers that break off: in the head, in a body of known length, and in one whose end
# is that of the connection.
CUTS = {"cut_head", "cut_answer", "cut_open_answer"}
HOP_BY_HOP = {"connection", "content-length", "host", "keep-alive", "transfer-encoding"}


@dataclass(frozen=True)
class RecordedRequest:
    """One request as it arrived: its kind, its body, its Idempotency-Key."""

    kind: str
    body: bytes
    key: str | None

    @property
    def members(self) -> dict[str, Any]:
        """Those of its body, which is an object in JSON or in MessagePack."""
        codec = msgspec.json if self.body.startswith(b"{") else msgspec.msgpack
        return dict(codec.decode(self.body))


class Proxy:
    """A server on a free port of this machine: `url` leads to `upstream`.

    drop: kinds whose first answer is lost after the server gave it. lose: kinds of
    request that never reach the server. crash_at: the number of the predict (from 1)
    whose answer is lost in a crash. crash: called then; it returns when the server is
    back, with its URL. alter: makes another answer of each parsed one. write: makes the
    bytes of an answer from its status, headers and body. host: the address of this
    machine at which it listens. `faults` has, for each kind, the faults of its next
    requests in order: `pass`, `lose_request`; and after the server has answered
    `lose_answer`, a name of CUTS, or a name of ANSWERS_OF_OTHERS.
    """

    def __init__(
        self,
        upstream: str,
        *,
        drop: Iterable[str] = (),
        lose: Iterable[str] = (),
        crash_at: int = 0,
        crash: Callable[[], str] | None = None,
        alter: Callable[[object], object] | None = None,
        write: WriteAnswer | None = None,
        host: str = "127.0.0.1",
    ) -> None:
        self.upstream, self._alter, self._write = upstream, alter, write
        self.recorded: list[RecordedRequest] = []
        self.dropped_answers: list[str] = []
        self.faults = {kind: deque(["lose_answer"]) for kind in drop}
        self._crash_at, self._crash = crash_at, crash
        self._lost = frozenset(lose)
        self._lock = threading.Lock()
        # The environment may name a proxy; this machine is never behind it.
        self._client = httpx.Client(trust_env=False, timeout=60.0)
        proxy = self

        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def _forward(self) -> None:
                proxy.handle(self)

            do_GET = do_POST = do_PUT = do_DELETE = _forward  # noqa: N815

            def log_message(self, format: str, *arguments: object) -> None:  # noqa: A002
                """The record is `passed`."""

        class Gateway(ThreadingHTTPServer):
            address_family = socket.AF_INET6 if ":" in host else socket.AF_INET
            daemon_threads = True

        self._server = Gateway((host, 0), Handler)
        place = f"[{host}]" if ":" in host else host
        self.url = f"http://{place}:{self._server.server_address[1]}"
        serve = self._server.serve_forever
        self._thread = threading.Thread(target=serve, args=(0.02,), daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()
        self._client.close()

    def handle(self, request: BaseHTTPRequestHandler) -> None:
        body = request.rfile.read(int(request.headers.get("Content-Length") or 0))
        kind = self._kind(f"{request.command} {urlsplit(request.path).path}")
        with self._lock:
            key = request.headers["Idempotency-Key"]
            self.recorded.append(RecordedRequest(kind, body, key))
            predicts = sum(recorded.kind == "predict" for recorded in self.recorded)
            faults = self.faults.get(kind)
            fault = faults.popleft() if faults else "pass"
        if kind in self._lost or fault == "lose_request":
            return drop_connection(request)
        headers = without_hops(request.headers.items())
        try:
            path = self.upstream + request.path
            call = request.command, path
            asked = self._client.build_request(*call, headers=headers, content=body)
            answer = self._client.send(asked)
        except httpx.TransportError:
            return drop_connection(request)
        if kind == "predict" and predicts == self._crash_at and self._crash is not None:
            with self._lock:
                self.dropped_answers.append("crash")
                self.upstream = self._crash()
            return drop_connection(request)
        if fault in ANSWERS_OF_OTHERS:
            status, lines, page = ANSWERS_OF_OTHERS[fault]
            answer = httpx.Response(status, headers=lines, content=page)
        if fault == "lose_answer":
            with self._lock:
                self.dropped_answers.append(kind)
            return drop_connection(request)
        return self._answer(request, answer, fault=fault)

    def bodies(self, kind: str) -> list[dict[str, Any]]:
        """The members of all requests of a kind that arrived."""
        return [one.members for one in self.recorded if one.kind == kind]

    def repeats(self, kind: str) -> list[RecordedRequest]:
        """Requests of a kind that are the same as an earlier one."""
        matches: list[RecordedRequest] = []
        seen: set[RecordedRequest] = set()
        for recorded in self.recorded:
            if recorded.kind == kind and recorded in seen:
                matches.append(recorded)
            seen.add(recorded)
        return matches

    def _answer(
        self,
        request: BaseHTTPRequestHandler,
        answer: httpx.Response,
        *,
        fault: str = "pass",
    ) -> None:
        content = answer.content
        if request.path.startswith("/v1/runs") and b'"endpoint"' in content:
            content = json.dumps(self._with_our_endpoints(json.loads(content))).encode()
        if self._alter is not None and content:
            media_type = answer.headers.get("Content-Type", "").partition(";")[0]
            codec = msgspec.msgpack if media_type == MSGPACK else msgspec.json
            content = codec.encode(self._alter(codec.decode(content)))
        headers = without_hops(answer.headers.items(), "content-encoding")
        if self._write is not None:
            request.wfile.write(self._write(answer.status_code, headers, content))
            return None
        request.send_response_only(answer.status_code)
        for name, value in headers:
            request.send_header(name, value)
        if fault == "cut_head":
            request.flush_headers()
            return drop_connection(request)
        if answer.status_code != 204 and fault != "cut_open_answer":
            request.send_header("Content-Length", str(len(content)))
        request.end_headers()
        if fault in CUTS:
            request.wfile.write(content[: len(content) // 2])
            return drop_connection(request)
        request.wfile.write(content)
        return None

    def _with_our_endpoints(self, value: object) -> object:
        if isinstance(value, list):
            return [self._with_our_endpoints(item) for item in value]
        if isinstance(value, dict):
            members = {n: self._with_our_endpoints(item) for n, item in value.items()}
            return members | ({"endpoint": self.url} if "endpoint" in value else {})
        return value

    @staticmethod
    def _kind(line: str) -> str:
        matches = [kind for kind, pattern in KINDS.items() if pattern.fullmatch(line)]
        return matches[0] if matches else "other"


def without_hops(
    headers: Iterable[tuple[str, str]], *more: str
) -> list[tuple[str, str]]:
    return [(k, v) for k, v in headers if k.lower() not in HOP_BY_HOP | {*more}]


def drop_connection(request: BaseHTTPRequestHandler) -> None:
    """Close the connection without a word, as a gateway that dies."""
    request.close_connection = True
    request.connection.shutdown(socket.SHUT_RDWR)
