"""A policy server with scripted replies, which records the calls it receives.

It plays the benchmark `calibration`: every episode ends after one action, with the
score that the check chose. A check can replace the reply to any operation by a slow or
wrong one. Only the standard library: it runs in the kit's process, for one check.
"""

import json
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler
from typing import Any, Self

from conformance.client.calibration_actions import action
from conformance.policy.listening_server import ListeningServer
from conformance.policy.request_body import read_body
from conformance.specification.document import JSON, PROBLEM_JSON, load_spec

OPERATIONS = {
    ("GET", "/v1/policy"): "describe_policy",
    ("POST", "/v1/policy/reset"): "reset",
    ("POST", "/v1/policy/predict"): "predict",
}
_POLL_S = 0.005
_BYTE_INTERVAL_S = 0.05
_UNREACHED_LENGTH = 60_000


@dataclass(frozen=True)
class PolicyCall:
    """One request as it came; `body` is None where there is none."""

    operation: str
    headers: Mapping[str, str]
    body: Any
    raw: bytes
    started_at: float


@dataclass(frozen=True)
class PolicyReply:
    """An answer; `body` is written as JSON unless it is bytes already.

    `never_ends`: instead of the body one byte now and then, and never an end.
    """

    body: Any = b""
    status: int = 200
    headers: Mapping[str, str] = field(default_factory=dict)
    never_ends: bool = False

    def encoded(self) -> bytes:
        """Give the bytes of the body."""
        if isinstance(self.body, bytes):
            return self.body
        return json.dumps(self.body).encode()


ReplyFunction = Callable[[PolicyCall], PolicyReply]


class ScriptedPolicy:
    """A policy server on a free port; a context manager."""

    def __init__(self, host: str = "127.0.0.1", score: float = 0.5) -> None:
        self.score = score
        self.max_sessions = 16
        self.calls: list[PolicyCall] = []
        self.max_in_flight = 0
        self.is_closed = False
        self._in_flight = 0
        self._lock = threading.Lock()
        self._answers: dict[str, ReplyFunction] = {
            "describe_policy": self.description,
            "reset": self.reset_reply,
            "predict": self.final_action_reply,
        }
        self._server = ListeningServer(host, _handler_of(self))
        self.url = self._server.origin

    def __enter__(self) -> Self:
        """Serve, in a thread."""
        threading.Thread(
            target=self._server.serve_forever, args=(0.02,), daemon=True
        ).start()
        return self

    def __exit__(self, *_: object) -> None:
        """Stop serving."""
        self.is_closed = True
        self._server.shutdown()
        self._server.server_close()

    def on(self, operation: str, answer: ReplyFunction) -> None:
        """Answer an operation like this from now on."""
        self._answers[operation] = answer

    def calls_of(self, operation: str) -> list[PolicyCall]:
        """Give the calls of an operation so far, in the order of arrival."""
        with self._lock:
            return [call for call in self.calls if call.operation == operation]

    def wait_for(self, operation: str, count: int = 1, timeout_s: float = 5.0) -> bool:
        """Wait until an operation was called `count` times; False if not in time."""
        deadline = time.monotonic() + timeout_s
        while len(self.calls_of(operation)) < count:
            if time.monotonic() > deadline:
                return False
            time.sleep(_POLL_S)
        return True

    def description(self, _call: PolicyCall) -> PolicyReply:
        """Describe a policy without assumptions."""
        version = load_spec().version.rpartition(".")[0]
        return PolicyReply(
            {
                "name": "policy server of the conformance kit",
                "protocol": {"min": version, "max": version},
                "max_sessions": self.max_sessions,
            }
        )

    def reset_reply(self, call: PolicyCall) -> PolicyReply:
        episode = call.body["episode"]
        return PolicyReply(
            {
                "session_id": call.body["session_id"],
                "episode_id": episode["episode_id"],
                "attempt": episode["attempt"],
            }
        )

    def final_action_reply(self, call: PolicyCall) -> PolicyReply:
        """End the episode with the score."""
        return self.actions_reply(call, action(score=self.score, end=1))

    def actions_reply(
        self, call: PolicyCall, *actions: Mapping[str, Any]
    ) -> PolicyReply:
        """Answer a turn with these actions."""
        turn = call.body
        return PolicyReply(
            {
                "session_id": turn["session_id"],
                "seq": turn["seq"] + 1,
                "actions": list(actions),
            }
        )

    def answer(self, call: PolicyCall) -> PolicyReply:
        """Note a call and answer it."""
        with self._lock:
            self.calls.append(call)
            self._in_flight += 1
            self.max_in_flight = max(self.max_in_flight, self._in_flight)
        try:
            return self._answers[call.operation](call)
        finally:
            with self._lock:
                self._in_flight -= 1


def busy_reply() -> PolicyReply:
    """Give the problem `unavailable`, which the caller repeats."""
    entry = load_spec().problems["unavailable"]
    problem = {
        "type": "urn:proctor:problem:unavailable",
        "title": entry["title"],
        "status": entry["status"],
        "detail": "Temporarily unavailable; repeat the call.",
        "code": "unavailable",
        "retryable": entry["retryable"],
        "side_effects": entry["side_effects"],
    }
    headers = {"Content-Type": PROBLEM_JSON, "Retry-After": "0"}
    return PolicyReply(problem, entry["status"], headers)


def _handler_of(policy: ScriptedPolicy) -> type[BaseHTTPRequestHandler]:
    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"
        disable_nagle_algorithm = True

        def _serve(self) -> None:
            raw = read_body(self)
            operation = OPERATIONS.get((self.command, self.path))
            if operation is None:
                self._send(PolicyReply(status=404))
                return
            headers = {name.lower(): value for name, value in self.headers.items()}
            body = json.loads(raw) if raw else None
            call = PolicyCall(operation, headers, body, raw, time.monotonic())
            self._send(policy.answer(call))

        do_GET = do_POST = _serve  # noqa: N815 - names of http.server

        def _send(self, reply: PolicyReply) -> None:
            body = reply.encoded()
            size = _UNREACHED_LENGTH if reply.never_ends else len(body)
            self.send_response(reply.status)
            named = {"Content-Type": JSON, "Content-Length": str(size)}
            for name, value in {**named, **reply.headers}.items():
                self.send_header(name, value)
            self.end_headers()
            self.wfile.write(body)
            while reply.never_ends and not policy.is_closed:
                self.wfile.write(b" ")
                time.sleep(_BYTE_INTERVAL_S)

        def handle(self) -> None:
            try:
                super().handle()
            except OSError:
                self.close_connection = True  # the caller may close the connection

        def log_message(self, *_: object) -> None:
            """Say nothing."""

    return Handler
