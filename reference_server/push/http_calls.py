"""HTTP calls to a server that nobody here vouches for.

Every call ends: it has one deadline from the connection to the last byte, its answer
has a greatest size, redirects and compressed bodies are not taken, and only so many
calls are in flight. What was not answered is asked again with the same bytes, after a
pause. It knows JSON and no protocol.
"""

from __future__ import annotations

import asyncio
import random
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Self

import httpcore
import msgspec

from reference_server.http.codec import JSON, decode, pointer
from reference_server.http.problems import PROBLEM_JSON
from reference_server.push.egress import (
    AddressNotAllowed,
    CheckedBackend,
    EgressPolicy,
    HostNotResolved,
)
from reference_server.rules.refusal import Refused

PAUSE_S = 0.5
PAUSE_MOST_S = 30.0
_PROBLEM_TEXT_MAX = 200


class PolicyFault(Exception):
    """What a policy server did wrong, in words for the submitter of the run.

    again: it did not answer, or asked to come again: the same call may be repeated,
    not before `after_s` seconds.
    """

    def __init__(
        self, text: str, *, retryable: bool = False, after_s: float = 0.0
    ) -> None:
        super().__init__(text)
        self.retryable = retryable
        self.after_s = after_s


class Backoff:
    """Ever longer ones: many that were turned away together come back one by one."""

    def __init__(self, first_s: float, most_s: float) -> None:
        self._first_s = self._next_s = first_s
        self._most_s = most_s

    def next_s(self) -> float:
        pause_s = self._next_s * random.uniform(0.8, 1.2)
        self._next_s = min(2 * self._next_s, self._most_s)
        return pause_s

    def reset(self) -> None:
        """From the first one again."""
        self._next_s = self._first_s


@dataclass(frozen=True, slots=True)
class CallLimits:
    """What a call may cost; `max_bytes` is of an answer."""

    timeout_s: float
    max_concurrent: int
    max_retries: int
    max_bytes: int


class HttpCalls:
    """Calls to the server at `url`, over connections that are kept."""

    def __init__(
        self, url: str, egress: EgressPolicy, limits: CallLimits, key: str | None
    ) -> None:
        self._url = url
        self._limits = limits
        self._key = key
        self._slots = asyncio.Semaphore(limits.max_concurrent)
        self._pool = httpcore.AsyncConnectionPool(
            max_connections=limits.max_concurrent,
            network_backend=CheckedBackend(egress),
        )

    async def __aenter__(self) -> Self:
        return self

    async def __aexit__(self, *_: object) -> None:
        await self._pool.aclose()

    async def get(self, path: str) -> Any:
        """The JSON at a path. Raises PolicyFault."""
        return await self._call_with_retries("GET", path, None)

    async def post(self, path: str, body: Mapping[str, Any]) -> Any:
        """The JSON that answers a body. Raises PolicyFault."""
        return await self._call_with_retries("POST", path, msgspec.json.encode(body))

    def redact_key(self, text: str) -> str:
        """A text of the policy server's for its submitter, before anything is cut off.

        It may say the key (PUSH-005), also in a JSON pointer.
        """
        if self._key is None:
            return text
        for reported in (self._key, pointer([self._key]).removeprefix("/")):
            text = text.replace(reported, "(its API key)")
        return text

    async def _call_with_retries(
        self, method: str, path: str, content: bytes | None
    ) -> Any:
        left = self._limits.max_retries
        backoff = Backoff(PAUSE_S, PAUSE_MOST_S)
        while True:
            try:
                async with self._slots:
                    return await self._call_with_deadline(method, path, content)
            except PolicyFault as fault:
                if not fault.retryable or left == 0:
                    tries = self._limits.max_retries - left + 1
                    raise _with_context(self._url, path, fault, tries) from fault
                after_s = fault.after_s
            left -= 1
            await asyncio.sleep(max(after_s, backoff.next_s()))

    async def _call_with_deadline(
        self, method: str, path: str, content: bytes | None
    ) -> Any:
        timeout_s = self._limits.timeout_s
        try:
            async with asyncio.timeout(timeout_s):
                return await self._send_once(method, path, content)
        except TimeoutError as error:
            text = f"gave no whole answer within {timeout_s:g} s"
            raise PolicyFault(text, retryable=True) from error
        except AddressNotAllowed as error:
            raise PolicyFault(f"is not called: {error}") from error
        except HostNotResolved as error:
            raise PolicyFault(f"is not found: {error}", retryable=True) from error
        except (httpcore.NetworkError, httpcore.TimeoutException, OSError) as error:
            raise PolicyFault("is not reached", retryable=True) from error
        except httpcore.RemoteProtocolError as error:
            text = "broke off, or does not speak HTTP"
            raise PolicyFault(text, retryable=True) from error

    async def _send_once(self, method: str, path: str, content: bytes | None) -> Any:
        headers = [("Accept", JSON), ("Accept-Encoding", "identity")]
        if content is not None:
            headers.append(("Content-Type", JSON))
        if self._key is not None:  # PUSH-004
            headers.append(("Authorization", f"Bearer {self._key}"))
        async with self._pool.stream(
            method, self._url + path, headers=headers, content=content
        ) as answer:
            named = {name.lower().decode(): value for name, value in answer.headers}
            found = {name: value.decode("latin-1") for name, value in named.items()}
            if 300 <= answer.status < 400:  # PUSH-011
                raise PolicyFault(f"redirects (status {answer.status})")
            return self._read(answer.status, found, await self._body(answer))

    async def _body(self, answer: httpcore.Response) -> bytes:
        parts: list[bytes] = []
        size = 0
        async for part in answer.aiter_stream():
            size += len(part)
            if size > self._limits.max_bytes:
                raise PolicyFault(f"answered more than {self._limits.max_bytes} bytes")
            parts.append(part)
        return b"".join(parts)

    def _read(self, status: int, headers: Mapping[str, str], body: bytes) -> Any:
        if status == 429 or status >= 500:
            text = f"answered with status {status}{self._reason(headers, body)}"
            raise PolicyFault(text, retryable=True, after_s=_retry_after_s(headers))
        if status != 200:
            text = f"answered with status {status}{self._reason(headers, body)}"
            raise PolicyFault(text)
        if headers.get("content-encoding", "identity") != "identity":
            raise PolicyFault("compressed its answer, which was not asked for")
        if _media_type(headers) != JSON:
            reported = self.redact_key(headers.get("content-type", ""))
            printable = _printable(reported.partition(";")[0].strip()[:60])
            raise PolicyFault(f"answered with {printable or 'no media type'}")
        try:
            return decode(body, JSON)
        except Refused as error:
            raise PolicyFault(f"answered what is no JSON ({error.detail})") from error

    def _reason(self, headers: Mapping[str, str], body: bytes) -> str:
        """What a problem says, if the answer is one: its author wants to read it."""
        if _media_type(headers) != PROBLEM_JSON:
            return ""
        try:
            problem = decode(body, JSON)
        except Refused:
            return ""
        reported = (
            [problem.get(n) for n in ("code", "detail")] if _is_map(problem) else []
        )
        text = ": ".join(part for part in reported if isinstance(part, str))
        printable = _printable(self.redact_key(text)[:_PROBLEM_TEXT_MAX])
        return f" ({printable})" if printable else ""


def _media_type(headers: Mapping[str, str]) -> str:
    return headers.get("content-type", "").partition(";")[0].strip().lower()


def _printable(text: str) -> str:
    return "".join(c if c.isprintable() else " " for c in text)


def _is_map(value: object) -> bool:
    return isinstance(value, dict)


def _retry_after_s(headers: Mapping[str, str]) -> float:
    text = headers.get("retry-after", "")
    is_seconds = text.isascii() and text.isdigit() and len(text) < 6
    return min(float(text), PAUSE_MOST_S) if is_seconds else 0.0


def _with_context(url: str, path: str, fault: PolicyFault, tries: int) -> PolicyFault:
    often = f", {tries} times" if tries > 1 else ""
    return PolicyFault(
        f"The policy server at {url} {fault} ({path.rpartition('/')[2]}{often}).",
        retryable=fault.retryable,
    )
