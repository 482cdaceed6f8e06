"""The operations of policy.yaml as an ASGI application: a policy served over HTTP.

Serves any policy that `proctor run` accepts: one instance per session, called in a
thread, one turn at a time. The outcome of the last call of a session is stored, an
error too, so that a repeated request is not executed twice: a policy that was called
again after it raised would answer from a state that no client expects. This module
knows HTTP and the messages, not how observations and actions are converted.
"""

from __future__ import annotations

import asyncio
import hmac
import logging
import math
import os
import time
from collections import OrderedDict
from collections.abc import Awaitable, Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeVar, cast

import msgspec
from proctor_client import Benchmark
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from reference_client.api.action_layout import ActionLayout
from reference_client.api.observation import observation_of
from reference_client.api.policy import Policy, chunk_of
from reference_client.errors import ProctorError
from reference_client.generated.messages import EpisodeView, Turn
from reference_client.policies.error_origin import describe_policy_error
from reference_client.policies.lerobot_policy import LerobotPolicy
from reference_client.policies.policy_thread import PolicyRaised, PolicyThread
from reference_client.printable_text import printable
from reference_record.generated.answers import (
    Assumptions,
    PolicyDescription,
    PolicyReset,
    Predict,
    Problem,
)
from reference_record.generated.protocol_version import PROTOCOL_VERSION
from reference_record.texts.shortened_text import shortened

log = logging.getLogger("proctor.policy")

# A turn may carry several raw images in Base64.
BODY_BYTES_MAX = 64 * 2**20
_DETAIL_CHARS_MAX = 2000  # callers read no problem of any length
# A session that was not called for so long has ended, or its simulator hangs: no
# operation says that a session is over.
IDLE_S = 30.0
_FULL_RETRY_S = 5
_FULL_LOG_PAUSE_S = 60.0
# Code → status, retryable, title; as in x-problems of openapi.yaml and policy.yaml.
PROBLEMS = {
    "malformed_body": (400, False, "The body cannot be parsed"),
    "unauthenticated": (401, False, "No valid bearer token"),
    "not_found": (404, False, "There is nothing here for this caller"),
    "method_not_allowed": (405, False, "Method not allowed"),
    "session_ended": (409, False, "The session is not live any more"),
    "body_too_large": (413, False, "The body is too large"),
    "invalid_request": (422, False, "The request breaks the schema"),
    "policy_failed": (500, False, "The policy failed"),
    "unavailable": (503, True, "The server cannot answer now"),
}


class ResetPolicy(msgspec.Struct):
    """Schema ResetPolicy of openapi.yaml."""

    session_id: str
    benchmark: dict[str, Any]
    episode: EpisodeView
    run_id: str = ""


Body = TypeVar("Body", ResetPolicy, Turn)
Answer = PolicyDescription | PolicyReset | Predict


class Refusal(Exception):
    """A request that is answered with a problem document."""

    def __init__(self, code: str, detail: str) -> None:
        super().__init__(detail)
        self.code = code


@dataclass(slots=True)
class _ServedSession:
    """A session: its policy, and the last call with its outcome.

    last_call: path and body. is_ready: the latest reset succeeded. run_id: empty where
    the caller sends none. is_superseded: another session of the run has its episode.
    answered_at: when the last call was answered.
    """

    policy: Policy
    thread: PolicyThread
    last_call: tuple[str, bytes] | None = None
    outcome: Answer | Refusal | None = None
    is_ready: bool = False
    layout: ActionLayout | None = None
    turn: asyncio.Lock = field(default_factory=asyncio.Lock)
    run_id: str = ""
    episode_id: str = ""
    is_superseded: bool = False
    answered_at: float = field(default_factory=time.monotonic)

    def is_over(self) -> bool:
        """Whether the session is not in use any more, as far as can be seen."""
        has_failed = isinstance(self.outcome, Refusal)  # that ended the attempt
        is_idle = time.monotonic() - self.answered_at > IDLE_S
        return self.is_superseded or has_failed or is_idle

    async def once(
        self, call: tuple[str, bytes], execute: Callable[[], Awaitable[Answer]]
    ) -> Answer:
        """POL-006: carry a call out, or repeat the outcome of this very call.

        The caller holds `turn`. Raises Refusal.
        """
        if call != self.last_call or self.outcome is None:
            self.last_call, self.outcome = call, None
            try:
                self.outcome = await execute()
            except Refusal as refusal:
                self.outcome = refusal
            except PolicyRaised as raised:
                self.outcome = _policy_failed(raised.error, call[0])
        self.answered_at = time.monotonic()
        if isinstance(self.outcome, Refusal):
            raise self.outcome
        return self.outcome


class PolicyApp:
    """The operations of policy.yaml; `app` is the ASGI application.

    make: makes a policy for one session at a time. name: reported by describe_policy.
    max_sessions: limit; beyond it, a new session replaces one that is not in use, or is
    refused until there is one (OPT-078). key: bearer token that requests must carry, if
    any. assumes: schema Assumptions.
    """

    def __init__(
        self,
        make: Callable[[], Policy],
        name: str,
        *,
        max_sessions: int = 16,
        key: str | None = None,
        assumes: Mapping[str, Any] | None = None,
    ) -> None:
        self._make = make
        self._name = name
        self._max_sessions = max_sessions
        self._key = key
        self._assumes = assumes
        self._sessions: OrderedDict[str, _ServedSession] = OrderedDict()
        self._threads: list[PolicyThread] = []
        self._sessions_lock = asyncio.Lock()
        self._full_logged_at = -math.inf
        self.app = Starlette(
            routes=[
                Route("/v1/policy", self._as_endpoint(self.describe_policy)),
                Route(
                    "/v1/policy/reset", self._as_endpoint(self.reset), methods=["POST"]
                ),
                Route(
                    "/v1/policy/predict",
                    self._as_endpoint(self.predict),
                    methods=["POST"],
                ),
            ],
            exception_handlers={404: _not_found, 405: _not_allowed},
        )

    def seconds_in_execution(self) -> list[float]:
        """For how long each call has been executed that the policy has not returned."""
        now = time.monotonic()
        began = [thread.began_at for thread in self._threads]
        return sorted(now - at for at in began if at is not None)

    async def describe_policy(self, _request: Request) -> PolicyDescription:
        body: PolicyDescription = {
            "name": self._name,
            "protocol": {"min": PROTOCOL_VERSION, "max": PROTOCOL_VERSION},
            "max_sessions": self._max_sessions,
        }
        if self._assumes is not None:
            body["assumes"] = cast("Assumptions", self._assumes)
        return body

    async def reset(self, request: Request) -> Answer:
        body = await _body(request)
        payload = _read(body, ResetPolicy)
        session = await self._open_session(payload)
        async with session.turn:
            return await session.once(
                (request.url.path, body), lambda: self._reset(session, payload)
            )

    async def _reset(
        self, session: _ServedSession, payload: ResetPolicy
    ) -> PolicyReset:
        session.is_ready = False
        session.layout = _layout_of(payload.benchmark)
        _bind(session.policy, payload.benchmark)
        instruction = payload.episode.instruction
        await session.thread.call(lambda: session.policy.reset(instruction))
        session.is_ready = True
        return {
            "session_id": payload.session_id,
            "episode_id": payload.episode.episode_id,
            "attempt": payload.episode.attempt,
        }

    async def predict(self, request: Request) -> Answer:
        body = await _body(request)
        turn = _read(body, Turn)
        session = self._sessions.get(turn.session_id)
        if session is None:
            text = (
                "Unknown session: call reset first. A session that was not called for "
                f"{IDLE_S:.0f} s gives way to another where --max-sessions "
                f"({self._max_sessions}) is reached."
            )
            raise Refusal("session_ended", text)
        self._sessions.move_to_end(turn.session_id)
        async with session.turn:
            return await session.once(
                (request.url.path, body), lambda: self._act(session, turn)
            )

    async def _act(self, session: _ServedSession, turn: Turn) -> Predict:
        if not session.is_ready:
            raise Refusal("session_ended", "The reset failed: call reset again.")
        try:
            observation = observation_of(turn)
        except ProctorError as error:
            raise Refusal("invalid_request", error.detail) from error
        policy, layout = session.policy, session.layout
        actions = await session.thread.call(
            lambda: chunk_of(policy.act(observation), layout)
        )
        return {
            "session_id": turn.session_id,
            "seq": turn.seq + 1,
            "actions": actions,
        }

    async def _open_session(self, reset: ResetPolicy) -> _ServedSession:
        """The session; at the limit, a new one takes the policy of an evicted one."""
        async with self._sessions_lock:
            self._mark_superseded(reset)
            session = self._sessions.pop(reset.session_id, None)
            if session is None and len(self._sessions) < self._max_sessions:
                thread = PolicyThread()
                self._threads.append(thread)
                session = _ServedSession(await thread.call(self._make), thread)
            elif session is None:
                old = self._sessions.pop(self._unused_session(reset.run_id))
                session = _ServedSession(old.policy, old.thread)
            session.run_id, session.episode_id = reset.run_id, reset.episode.episode_id
            session.is_superseded = False
            self._sessions[reset.session_id] = session
            return session

    def _mark_superseded(self, reset: ResetPolicy) -> None:
        """An episode that begins again has left the session in which it was played."""
        place = (reset.run_id, reset.episode.episode_id)
        for session in self._sessions.values():
            if reset.run_id and (session.run_id, session.episode_id) == place:
                session.is_superseded = True

    def _unused_session(self, run_id: str) -> str:
        """The id of the longest idle session that may be evicted.

        Raises Refusal `unavailable`, which the caller repeats: a session in use would
        lose its attempt.
        """
        sessions = self._sessions
        free = [name for name in sessions if not sessions[name].turn.locked()]
        over = [name for name in free if sessions[name].is_over()]
        # No run has more than max_sessions in use: one that has all has left one.
        run_ids = {session.run_id for session in sessions.values()}
        if not over and run_id and run_ids == {run_id}:
            over = free
        if over:
            return over[0]
        text = (
            f"All sessions of this policy server are in use (--max-sessions "
            f"{self._max_sessions}), so another one waits until a run ends. To play "
            "them side by side: serve-policy with a larger --max-sessions, or submit "
            "with a smaller --max-concurrent."
        )
        now = time.monotonic()
        if now - self._full_logged_at > _FULL_LOG_PAUSE_S:
            self._full_logged_at = now
            log.warning("proctor: %s", text)
        raise Refusal("unavailable", text)

    def _as_endpoint(
        self, operation: Callable[[Request], Awaitable[Answer]]
    ) -> Callable[[Request], Awaitable[Response]]:
        async def endpoint(request: Request) -> Response:
            try:
                self._authenticate(request)
                return JSONResponse(await operation(request))
            except Refusal as refusal:
                return _problem(refusal)
            except PolicyRaised as raised:
                failure = _policy_failed(raised.error, request.url.path)
                return _problem(failure)
            except Exception as error:  # noqa: BLE001 - so that every answer is one
                return _problem(_policy_failed(error, request.url.path))

        return endpoint

    def _authenticate(self, request: Request) -> None:
        sent = request.headers.get("authorization", "")
        if self._key is not None and not hmac.compare_digest(
            sent.encode(), f"Bearer {self._key}".encode()
        ):
            wrong = "The bearer token is not the key of this policy server."
            none = "There is no bearer token; this policy server has a key."
            raise Refusal("unauthenticated", wrong if sent else none)


def _policy_failed(error: BaseException, path: str) -> Refusal:
    """The refusal for what a policy raised; the log names it in one line."""
    text = shortened(describe_policy_error(error), _DETAIL_CHARS_MAX)
    shows_trace = bool(os.environ.get("PROCTOR_DEBUG"))
    log.error(
        "proctor: %s failed: %s",
        path.rpartition("/")[2],
        printable(text),
        exc_info=error if shows_trace else None,
    )
    return Refusal("policy_failed", text)


def _layout_of(benchmark: dict[str, Any]) -> ActionLayout | None:
    """The action space of a benchmark; None if the caller sends less than that."""
    try:
        return ActionLayout.of(benchmark["benchmark_id"], benchmark["action_space"])
    except (KeyError, TypeError, AttributeError, ValueError):
        return None


def _bind(policy: Policy, benchmark: dict[str, Any]) -> None:
    """Give a policy that needs it the benchmark."""
    if isinstance(policy, LerobotPolicy):
        try:
            policy.bind(Benchmark.model_validate(benchmark))
        except ValueError as error:
            raise Refusal("invalid_request", str(error)) from error


async def _body(request: Request) -> bytes:
    parts: list[bytes] = []
    size = 0
    try:
        async for part in request.stream():
            size += len(part)
            if size > BODY_BYTES_MAX:
                text = f"The body exceeds {BODY_BYTES_MAX} bytes."
                raise Refusal("body_too_large", text)
            parts.append(part)
    except ClientDisconnect as error:
        raise Refusal("malformed_body", "The body is truncated.") from error
    return b"".join(parts)


def _read(body: bytes, message: type[Body]) -> Body:
    """The message of a body; unknown members are ignored."""
    try:
        return msgspec.json.decode(body, type=message)
    except msgspec.ValidationError as error:
        text = f"The body violates the schema in policy.yaml: {error}."
        raise Refusal("invalid_request", text) from error
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise Refusal("malformed_body", f"The body is not JSON: {error}.") from error


def _problem(refusal: Refusal, **headers: str) -> Response:
    status, retryable, title = PROBLEMS[refusal.code]
    body: Problem = {
        "type": f"urn:proctor:problem:{refusal.code}",
        "title": title,
        "status": status,
        "detail": str(refusal),
        "code": refusal.code,
        "retryable": retryable,
        "side_effects": "possible" if status == 500 else "none",
    }
    if status == 503:
        headers["Retry-After"] = str(_FULL_RETRY_S)
    return JSONResponse(body, status, headers, "application/problem+json")


async def _not_found(_request: Request, _error: Exception) -> Response:
    return _problem(Refusal("not_found", "There is no such path."))


async def _not_allowed(_request: Request, error: Exception) -> Response:
    headers = error.headers if isinstance(error, HTTPException) else None
    text = "The path does not support this method."
    return _problem(Refusal("method_not_allowed", text), **dict(headers or {}))
