"""A policy server with scripted replies, which records the calls it receives.

It plays the benchmark `calibration`: every episode ends after one action, with the
score that the check chose. A check can replace the reply to any operation by a slow or
wrong one. Only the standard library: it runs in the kit's process, for one check.
"""

import json
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from conformance.oracle.calibration_benchmark import action
from conformance.policy.listening_server import QuietHandler, Scripted
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


class ScriptedPolicy(Scripted):
    """A policy server on a free port; a context manager."""

    def __init__(self, host: str = "127.0.0.1", score: float = 0.5) -> None:
        self.score = score
        self.max_sessions = 16
        self.calls: list[PolicyCall] = []
        self.max_in_flight = 0
        self._in_flight = 0
        self._answers: dict[str, ReplyFunction] = {
            "describe_policy": self.description,
            "reset": self.reset_reply,
            "predict": self.final_action_reply,
        }
        super().__init__(host, _handler_of(self))
        self.url = self._server.origin

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
        protocol = {"min": version, "max": version}
        policy = {"name": "policy server of the conformance kit", "protocol": protocol}
        return PolicyReply(policy | {"max_sessions": self.max_sessions})

    def reset_reply(self, call: PolicyCall) -> PolicyReply:
        session, episode = {"session_id": call.body["session_id"]}, call.body["episode"]
        return PolicyReply(session | {n: episode[n] for n in ("episode_id", "attempt")})

    def final_action_reply(self, call: PolicyCall) -> PolicyReply:
        """End the episode with the score."""
        return self.actions_reply(call, action(score=self.score, end=1))

    def actions_reply(
        self, call: PolicyCall, *actions: Mapping[str, Any]
    ) -> PolicyReply:
        """Answer a turn with these actions."""
        turn = {"session_id": call.body["session_id"], "seq": call.body["seq"] + 1}
        return PolicyReply(turn | {"actions": list(actions)})

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


def _handler_of(policy: ScriptedPolicy) -> type[QuietHandler]:
    class Handler(QuietHandler):
        def _serve(self) -> None:
            raw = self.read_body()
            operation = OPERATIONS.get((self.command, self.path))
            if operation is None:
                self._reply(PolicyReply(status=404))
                return
            body = json.loads(raw) if raw else None
            headers, now = self.lower_headers(), time.monotonic()
            self._reply(policy.answer(PolicyCall(operation, headers, body, raw, now)))

        do_GET = do_POST = _serve  # noqa: N815 - names of http.server

        def _reply(self, reply: PolicyReply) -> None:
            body = reply.encoded()
            size = _UNREACHED_LENGTH if reply.never_ends else len(body)
            named = {"Content-Type": JSON, "Content-Length": str(size)}
            self.send(reply.status, {**named, **reply.headers}, body)
            while reply.never_ends and not policy.is_closed:
                self.wfile.write(b" ")
                time.sleep(_BYTE_INTERVAL_S)

    return Handler
