"""HTTP calls to a policy server, which is not trusted: every call is bounded.

One deadline covers a call from the connection to the last byte of the response
(PUSH-009), a response has a maximum size, redirects (PUSH-011) and compressed bodies
are refused, and the number of calls in flight is limited (PUSH-007). A call without a
complete response is repeated with the same bytes after a pause (PUSH-008; the pauses
are `backoff`'s); one that a policy with a state failed to answer is not (PUSH-021). It
must not know a policy protocol: it sends and returns JSON.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Self, TypeAlias

import httpcore
import msgspec
from pydantic import BaseModel

from reference_record.texts.shortened_text import shortened
from reference_server.http.bodies.bounded_parsing import (
    INLINE_BYTES_MAX,
    WHOLE_BYTES_MAX,
    read_structure,
)
from reference_server.http.codec import JSON, decode, pointer
from reference_server.http.problems import PROBLEM_JSON
from reference_server.process.backoff import CALL_PAUSE_MAX_S, Backoff
from reference_server.push.egress import (
    AddressNotAllowed,
    CheckedBackend,
    EgressPolicy,
    HostNotResolved,
    is_hosted,
)
from reference_server.rules.refusal import Refused
from reference_server.telemetry.counters import COUNTERS, timed
from reference_server.telemetry.spans import span, traceparent

_REASON_CHARS_MAX = 700
# The members of a problem, and with them those of errors of frameworks for HTTP.
_PROBLEM_TEXTS = ("code", "detail")
_ERROR_TEXTS = (*_PROBLEM_TEXTS, "message", "error")
BUSY_WAIT_MAX_S = 3600.0  # for a policy server that other runs use
# The longest answer that is read; by policy.yaml a server reads at least this much.
# Only actions may be longer.
ANSWER_BYTES_MAX = 2**20
# The structure in a body; raises Refused. Large bodies are read in another thread.
ReadAnswer: TypeAlias = Callable[[bytes], Any]


class PolicyFault(Exception):
    """A fault of the policy server; the message is for the submitter of the run.

    retryable: it did not answer, or asked to come again: the same call may be repeated,
    not before `after_s` seconds. is_busy: it answered with the problem `unavailable`.
    """

    def __init__(
        self,
        text: str,
        *,
        retryable: bool = False,
        after_s: float = 0.0,
        is_busy: bool = False,
    ) -> None:
        super().__init__(text)
        self.is_busy = is_busy
        self.retryable = retryable
        self.after_s = after_s


def read_json(body: bytes) -> Any:
    """Any JSON; for small answers. Raises Refused."""
    return decode(body, JSON)


def read_members(
    model: type[BaseModel], mismatch: Callable[[Refused], PolicyFault]
) -> ReadAnswer:
    """Read what the model has, and nothing else of a large answer.

    mismatch: the fault of an answer that is JSON and has not the form of the model.
    """

    def read(body: bytes) -> Any:
        try:
            return read_structure(model, body, JSON, closed=False)
        except Refused as refused:
            if refused.code == "malformed_body":
                raise
            raise mismatch(refused) from refused

    return read


@dataclass(frozen=True, slots=True)
class Call:
    """One request; `content` is encoded once, and sent as it is in every attempt.

    has_state: carrying it out changes the policy, so a 500 is final (PUSH-021).
    waits_for_room: a policy server that is busy is waited for.
    """

    method: str
    path: str
    content: bytes | None
    max_bytes: int
    has_state: bool = False
    waits_for_room: bool = False


@dataclass(frozen=True, slots=True)
class CallLimits:
    """The bounds of a call; `max_bytes` is the maximum size of any response."""

    timeout_s: float
    max_concurrent: int
    max_retries: int
    max_bytes: int


class HttpCalls:
    """Calls to the server at `url`, over connections that are reused."""

    def __init__(
        self,
        url: str,
        egress: EgressPolicy,
        limits: CallLimits,
        key: str | None,
        account: str = "",
    ) -> None:
        self._url = url
        self._limits = limits
        self._key = key
        self._slots = asyncio.Semaphore(limits.max_concurrent)  # PUSH-007
        self._pool = httpcore.AsyncConnectionPool(
            max_connections=limits.max_concurrent,
            network_backend=CheckedBackend(egress, account),
        )

    async def __aenter__(self) -> Self:
        return self

    async def __aexit__(self, *_: object) -> None:
        await self._pool.aclose()

    async def get(self, path: str, read: ReadAnswer = read_json) -> Any:
        """GET a path; the JSON of the response. Raises PolicyFault, and as `read`."""
        call = Call("GET", path, None, ANSWER_BYTES_MAX)
        return await self._read(path, await self._call_with_retries(call), read)

    async def post(
        self,
        path: str,
        body: Mapping[str, Any],
        read: ReadAnswer = read_json,
        *,
        max_bytes: int = ANSWER_BYTES_MAX,
        has_state: bool = False,
        waits_for_room: bool = False,
    ) -> Any:
        """POST a body; the JSON of the response. Raises PolicyFault, and as `read`."""
        content = msgspec.json.encode(body)
        call = Call("POST", path, content, max_bytes, has_state, waits_for_room)
        return await self._read(path, await self._call_with_retries(call), read)

    def redact_key(self, text: str) -> str:
        """PUSH-005, FLE-006: a text from the policy server without the API key in it.

        Apply it before the text is cut. The key may also appear in a JSON pointer.
        """
        if self._key is None:
            return text
        for reported in (self._key, pointer([self._key]).removeprefix("/")):
            text = text.replace(reported, "[API key removed]")
        return text

    async def _call_with_retries(self, call: Call) -> bytes:
        """PUSH-008: each attempt sends the same bytes; PUSH-020: one answers."""
        left = self._limits.max_retries
        first: PolicyFault | None = None
        backoff = Backoff.between_calls()
        calls = 0
        busy_until = time.monotonic() + (BUSY_WAIT_MAX_S if call.waits_for_room else 0)
        while True:
            calls += 1
            try:
                async with self._slots:
                    with (
                        timed(COUNTERS.policy_calls),
                        span("policy server", is_call=True) as called,
                    ):
                        called.set("proctor.path", call.path)
                        return await self._call_with_deadline(call)
            except PolicyFault as fault:
                first = first or fault
                waits = fault.is_busy and time.monotonic() < busy_until
                if not fault.retryable or (left == 0 and not waits):
                    whole = _of_repeats(first, fault)
                    raise _with_context(self._url, call.path, whole, calls) from fault
                after_s = fault.after_s
            if not waits:
                left -= 1
            elif after_s:
                backoff.reset()
            await asyncio.sleep(max(after_s, backoff.next_s()))

    async def _call_with_deadline(self, call: Call) -> bytes:
        timeout_s = self._limits.timeout_s
        try:
            async with asyncio.timeout(timeout_s):  # PUSH-009
                return await self._send_once(call)
        except TimeoutError as error:
            text = f"did not answer completely within {timeout_s:g} s"
            raise PolicyFault(text, retryable=True) from error
        except AddressNotAllowed as error:
            raise PolicyFault(f"is not allowed: {error}") from error
        except HostNotResolved as error:
            raise PolicyFault(f"is not found: {error}", retryable=True) from error
        except (httpcore.NetworkError, httpcore.TimeoutException, OSError) as error:
            raise PolicyFault("is unreachable", retryable=True) from error
        except httpcore.RemoteProtocolError as error:
            text = "closed the connection or did not answer with HTTP"
            raise PolicyFault(text, retryable=True) from error

    async def _send_once(self, call: Call) -> bytes:
        headers = [("Accept", JSON), ("Accept-Encoding", "identity")]
        if call.content is not None:
            headers.append(("Content-Type", JSON))
        if self._key is not None:  # PUSH-004
            headers.append(("Authorization", f"Bearer {self._key}"))
        # Random numbers, and only of what is recorded: harmless to whom they reach.
        if trace := traceparent(only_recorded=True):
            headers.append(("traceparent", trace))
        async with self._pool.stream(
            call.method, self._url + call.path, headers=headers, content=call.content
        ) as answer:
            named = {name.lower().decode(): value for name, value in answer.headers}
            answer_headers = {
                name: value.decode("latin-1") for name, value in named.items()
            }
            if 300 <= answer.status < 400:  # PUSH-011
                raise PolicyFault(f"redirects (status {answer.status})")
            body = await self._body(answer, call.max_bytes)
            self._check(call, answer.status, answer_headers, body)
            return body

    async def _body(self, answer: httpcore.Response, max_bytes: int) -> bytes:
        most = min(max_bytes, self._limits.max_bytes)
        parts: list[bytes] = []
        size = 0
        async for part in answer.aiter_stream():
            size += len(part)
            if size > most:
                raise PolicyFault(f"answered more than {most} bytes")
            parts.append(part)
        return b"".join(parts)

    def _check(
        self, call: Call, status: int, headers: Mapping[str, str], body: bytes
    ) -> None:
        is_final = status == 500 and call.has_state  # PUSH-021
        if (status == 429 or status >= 500) and not is_final:
            reason = self._reason(headers, body)
            raise PolicyFault(
                f"answered with status {status}{reason}",
                retryable=True,
                after_s=_retry_after_s(headers),
                is_busy=reason.startswith(" (unavailable"),
            )
        if status != 200:
            text = f"answered with status {status}{self._reason(headers, body)}"
            raise PolicyFault(text)
        if headers.get("content-encoding", "identity") != "identity":
            raise PolicyFault("sent a compressed answer")
        if _media_type(headers) != JSON:
            reported = self.redact_key(headers.get("content-type", ""))
            printable = _printable(reported.partition(";")[0].strip()[:60])
            raise PolicyFault(f"answered with {printable or 'no media type'}")

    async def _read(self, path: str, body: bytes, read: ReadAnswer) -> Any:
        try:
            if len(body) > INLINE_BYTES_MAX:
                return await asyncio.to_thread(read, body)
            return read(body)
        except Refused as error:
            if error.code != "malformed_body":
                raise
            fault = PolicyFault(f"answered with invalid JSON ({error.detail})")
            raise _with_context(self._url, path, fault, 1) from error

    def _reason(self, headers: Mapping[str, str], body: bytes) -> str:
        """The words of an answer: the code and detail of an RFC 9457 problem."""
        media_type = _media_type(headers)
        is_problem = media_type == PROBLEM_JSON
        if len(body) > WHOLE_BYTES_MAX:
            what = f"a problem of {len(body)} bytes, too long to be read"
            return f" (with {what})" if is_problem else ""
        if media_type == "text/plain":
            text = " ".join(self.redact_key(body.decode(errors="replace")).split())
        else:
            text = self.redact_key(_words_of(body, media_type))
        printable = _printable(shortened(text, _REASON_CHARS_MAX))
        if is_problem:
            return f" ({printable})" if printable else ""
        return f' (it says "{printable}")' if printable else ""


def _words_of(body: bytes, media_type: str) -> str:
    """The texts of an error in JSON: of a problem, or as frameworks have it."""
    if media_type not in (JSON, PROBLEM_JSON):
        return ""
    try:
        error = read_json(body)
    except Refused:
        return ""
    names = _PROBLEM_TEXTS if media_type == PROBLEM_JSON else _ERROR_TEXTS
    reported = [error.get(name) for name in names] if _is_map(error) else []
    return ": ".join(part for part in reported if isinstance(part, str))


def _media_type(headers: Mapping[str, str]) -> str:
    return headers.get("content-type", "").partition(";")[0].strip().lower()


def _printable(text: str) -> str:
    return "".join(c if c.isprintable() else " " for c in text)


def _is_map(value: object) -> bool:
    return isinstance(value, dict)


def _retry_after_s(headers: Mapping[str, str]) -> float:
    text = headers.get("retry-after", "")
    is_seconds = text.isascii() and text.isdigit() and len(text) < 6
    return min(float(text), CALL_PAUSE_MAX_S) if is_seconds else 0.0


def _of_repeats(first: PolicyFault, last: PolicyFault) -> PolicyFault:
    """The fault of a call and its repeats: the cause, and how the last repeat ended."""
    if str(first) == str(last):
        return last
    return PolicyFault(
        f"{first}, and when called again {last}", retryable=last.retryable
    )


def _with_context(url: str, path: str, fault: PolicyFault, tries: int) -> PolicyFault:
    often = f", {tries} times" if tries > 1 else ""
    # With the address of a policy in a sandbox, others could call it.
    who = "The policy" if is_hosted(url) else f"The policy server at {url}"
    return PolicyFault(
        f"{who} {fault} ({path.rpartition('/')[2]}{often}).",
        retryable=fault.retryable,
    )
