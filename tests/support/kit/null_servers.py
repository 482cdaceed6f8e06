"""Servers with scripted answers, and such as implement nothing, for tests of the kit.

What they score is the floor of the kit: it must be nothing, or nearly so.
"""

import contextlib
import json
import ssl
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from email.message import Message
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from conformance.specification.ledger import SERVICE as PROFILES_OF_SERVICE

Reply = tuple[int, dict[str, str], bytes]


@dataclass(frozen=True)
class Request:
    """As much of a request as a null server looks at."""

    method: str
    path: str
    body: bytes = b""
    headers: Message = field(default_factory=Message)


Behaviour = Callable[[Request], Reply | None]

_JSON = {"Content-Type": "application/json", "Proctor-Version": "1.0"}
_SHA256 = "0" * 64
_TIME = "2026-01-01T00:00:00Z"
SERVICE = {
    "name": "canned_answers",
    "version": "0",
    "protocol": {"min": "1.0", "max": "1.0"},
    "profiles": [*PROFILES_OF_SERVICE, "msgpack"],
    "limits": {
        "max_body_bytes": 4_000_000,
        "max_workers": 4,
        "max_chunk": 8,
        "idle_timeout_s_min": 1,
        "idle_timeout_s_max": 600,
        "wait_s_max": 5,
    },
    "encodings": ["application/json"],
    "image_codecs": ["raw", "png", "jpeg"],
    "server_time": _TIME,
}
RUN = {
    "run_id": "run-1",
    "state": "ready",
    "reason": None,
    "retryable": None,
    "benchmark_id": "calibration",
    "benchmark_version": "1",
    "manifest_sha256": _SHA256,
    "policy": {"name": "canned_answers"},
    "max_workers": 4,
    "idle_timeout_s": 600,
    "images": {"codec": "raw", "width": 16, "height": 12},
    "endpoint": "",
    "queue_position": None,
    "live_workers": 0,
    "progress": {
        "episodes_total": 1,
        "episodes_scored": 0,
        "episodes_in_progress": 0,
        "episodes_pending": 1,
    },
    "created_at": _TIME,
    "updated_at": _TIME,
}
BENCHMARK: dict[str, Any] = {
    "benchmark_id": "calibration",
    "version": "1",
    "title": "",
    "description": "",
    "manifest_sha256": _SHA256,
    "episodes_total": 1,
    "tasks": ["score"],
    "splits": ["even"],
    "control_rate_hz": 10,
    "max_steps": 10,
    "max_chunk": 8,
    "max_attempts": 3,
    "max_faults": 3,
    "success_rule": "any_step",
    "action_space": {},
    "observation_space": {"state": {}, "images": {}, "tensors": {}},
    "image_sizes": [{"width": 16, "height": 12}],
    "image_codecs": ["raw"],
    "simulator": {"name": "none", "version": "0"},
    "unavailable_reason": None,
}
_LEASE = {"expires_at": _TIME, "idle_timeout_s": 600}
TURN: dict[str, Any] = {
    "session_id": "session-1",
    "seq": 0,
    "episode": {
        "episode_id": "e0",
        "index": 0,
        "task": "score",
        "instruction": "",
        "attempt": 1,
        "step": 0,
        "max_steps": 10,
    },
    "observation": {"state": {"count": [0]}, "images": {}, "tensors": {}},
    "executed_steps": 0,
    "stopped_early": False,
    "rewards": [],
    "terminated": False,
    "truncated": False,
    "done": False,
    "lease": _LEASE,
    "timing": dict.fromkeys(
        ("total_s", "queue_s", "simulate_s", "render_s", "encode_s"), 0
    ),
}
_COUNTS = {"total": 1, "success": 0, "failure": 0, "abandoned": 0, "unscored": 1}
_SCORE = {
    "run_id": "run-1",
    "benchmark_id": "calibration",
    "manifest_sha256": _SHA256,
    "state": "ready",
    "complete": False,
    "score": None,
    "score_low": 0,
    "score_high": 1,
    "counts": _COUNTS,
    "success_rate": None,
    "success_interval": {"low": 0, "high": 1},
    "mean": None,
    "mean_interval": {"low": 0, "high": 1},
    "by_task": {},
    "by_split": {},
}


def always(status: int, body: bytes = b"{}") -> Behaviour:
    """Answer everything alike."""
    return lambda _request: (status, _JSON, body)


def echo(request: Request) -> Reply:
    """Send back what came."""
    return 200, _JSON, request.body or b"{}"


def close(_request: Request) -> None:
    """Say nothing and hang up."""


def canned_answers(request: Request) -> Reply:
    """Give the same valid answer to every request of an operation."""
    path = request.path.partition("?")[0]
    last = path.rpartition("/")[2]
    if request.method == "DELETE":
        return 204, _JSON, b""
    if (request.method, last) == ("POST", "runs"):
        return 201, _JSON | {"Location": "/v1/runs/run-1"}, _dump(RUN)
    named: dict[str, Any] = {
        "v1": SERVICE,
        "benchmarks": {"benchmarks": [BENCHMARK]},
        "calibration": BENCHMARK,
        "runs": {"runs": [RUN], "next_cursor": None},
        "episodes": {"episodes": [], "next_cursor": None},
        "score": _SCORE,
        "predict": TURN | {"seq": 1},
        "heartbeat": _LEASE,
    }
    body = named.get(last, TURN if "/workers/" in path else RUN)
    return 200, _JSON | {"ETag": '"1"'}, _dump(body)


def nginx_that_keeps_streams(request: Request) -> Reply:
    """Answer as nginx passes answers on, but for event streams, which have no end."""
    if request.path.endswith("/events"):
        threading.Event().wait()
    status, headers, body = canned_answers(request)
    if request.path == "/v1":
        body = _dump(SERVICE | {"profiles": ["events"]})
    return status, headers | {"Server": "nginx"}, body


def refuse_everyone(request: Request) -> Reply:
    """Describe the service and refuse every token."""
    if request.path == "/v1":
        return 200, _JSON, _dump(SERVICE)
    return 401, _JSON, b'{"code": "unauthenticated"}'


def other_protocol_version(_request: Request) -> Reply:
    """Speak a version that this kit does not know."""
    return 200, _JSON, _dump(SERVICE | {"protocol": {"min": "7.0", "max": "7.2"}})


def stop_answering_after(requests: int, behaviour: Behaviour) -> Behaviour:
    """Behave for a while, then hang up for ever."""
    left = iter(range(requests))
    return lambda request: None if next(left, None) is None else behaviour(request)


def _dump(body: Any) -> bytes:
    return json.dumps(body).encode()


@contextlib.contextmanager
def run_server(
    behaviour: Behaviour, tls: ssl.SSLContext | None = None
) -> Iterator[str]:
    """Serve a behaviour on a free port; the URL, as it is without TLS."""

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"
        wbufsize = -1  # head and body leave together

        def handle_one_request(self) -> None:
            self.raw_requestline = self.rfile.readline(65537)
            if not self.raw_requestline or not self.parse_request():
                self.close_connection = True
                return
            size = self.headers.get("Content-Length")
            sent = self.rfile.read(int(size)) if size else b""
            reply = behaviour(Request(self.command, self.path, sent, self.headers))
            if reply is None or "Transfer-Encoding" in self.headers:
                self.close_connection = True
                return
            status, headers, body = reply
            self.send_response(status)
            for name, value in headers.items():
                self.send_header(name, value)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)
            self.wfile.flush()

        def log_message(self, format: str, *values: object) -> None:  # noqa: A002
            """Keep quiet."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    server.handle_error = lambda *_: None  # type: ignore[method-assign]
    if tls is not None:
        server.socket = tls.wrap_socket(server.socket, server_side=True)
    # The default interval would make each test wait for half a second at its end.
    threading.Thread(target=server.serve_forever, args=(0.02,), daemon=True).start()
    url = f"http://127.0.0.1:{server.server_port}"
    RUN["endpoint"] = url
    try:
        yield url
    finally:
        server.shutdown()
        server.server_close()
