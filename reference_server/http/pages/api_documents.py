"""Calls of this server's own API, with the token of a reader, in this process.

The request passes the same checks as one from the network, so a page shows exactly what
the API would answer to that token, and a refusal is the API's own.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import re
from collections.abc import AsyncGenerator, AsyncIterator, Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import quote, urlencode

import msgspec
from starlette.requests import Request
from starlette.types import ASGIApp, Message, Scope

from reference_server.generated.problem_codes import PROBLEMS

# A recording that is longer is not shown, but may be downloaded.
ANSWER_BYTES_MAX = 64 * 2**20
_TOO_LARGE = "It is too large to be shown; it can be downloaded with the record."
# The advice of a problem names members and headers of the API by these.
_OF_MESSAGES = re.compile(r"`|Retry-After|\bdetail\b")
log = logging.getLogger("proctor.pages")


class Problem(Exception):
    """A refusal of the API: its status, code and text for people."""

    def __init__(self, status: int, code: str, detail: str) -> None:
        super().__init__(detail)
        self.status, self.code, self.detail = status, code, detail


@dataclass(frozen=True, slots=True)
class ApiDocuments:
    """The operations of the API, for one reader. token: the bearer token."""

    app: ASGIApp
    outer: Scope
    token: str

    @classmethod
    def of(cls, app: ASGIApp, request: Request, token: str) -> ApiDocuments:
        return cls(app, request.scope, token)

    async def get(self, *path: str, **query: object) -> Any:
        """The JSON of an answer. Raises Problem."""
        return msgspec.json.decode(await self.read(*path, **query))

    async def pages(self, *path: str, **query: object) -> AsyncIterator[Any]:
        """Each page of a list, from the cursor of the query on. Raises Problem."""
        page = await self.get(*path, **query)
        yield page
        while (cursor := page["next_cursor"]) is not None:
            await asyncio.sleep(0)  # turns are played between two pages
            page = await self.get(*path, **query | {"cursor": cursor})
            yield page

    async def read(self, *path: str, **query: object) -> bytes:
        """The bytes of an answer. Raises Problem."""
        body = bytearray()
        async with contextlib.aclosing(self.stream(*path, **query)) as parts:
            async for part in parts:
                body += part
                if len(body) > ANSWER_BYTES_MAX:
                    raise Problem(413, "too_large", _TOO_LARGE)
        return bytes(body)

    async def send(self, method: str, *path: str, body: object = None) -> Any:
        """The JSON of the answer to a request that changes what is there."""
        data = b"" if body is None else msgspec.json.encode(body)
        scope = self._scope(path, {})
        scope["method"] = method
        scope["headers"].append((b"content-type", b"application/json"))
        async with _call(self.app, scope, data) as messages:
            status = (await anext(messages, {"status": 500}))["status"]
            if status not in (200, 201):
                raise await _problem(status, messages)
            return msgspec.json.decode(await _rest(messages))

    async def stream(self, *path: str, **query: object) -> AsyncGenerator[bytes, None]:
        """The parts of an answer as they are sent. Raises Problem."""
        async with _call(self.app, self._scope(path, query)) as messages:
            status = (await anext(messages, {"status": 500}))["status"]
            if status != 200:
                raise await _problem(status, messages)
            async for message in messages:
                if part := message.get("body", b""):
                    yield part

    def _scope(self, path: tuple[str, ...], query: Mapping[str, object]) -> Scope:
        whole = "/v1" + "".join("/" + quote(part, safe="") for part in path)
        host = [(b"host", value) for name, value in self.outer["headers"]
                if name == b"host"]  # fmt: skip
        token = [(b"authorization", f"Bearer {self.token}".encode())]
        token = token if self.token else []  # a public leaderboard needs none
        return {
            "type": "http",
            "asgi": self.outer["asgi"],
            "http_version": "1.1",
            "method": "GET",
            "scheme": self.outer["scheme"],
            "path": whole,
            "raw_path": whole.encode(),
            "root_path": "",
            "query_string": urlencode(query).encode(),
            "headers": host + token,
            "client": self.outer.get("client"),
            "server": self.outer.get("server"),
        }


@contextlib.asynccontextmanager
async def _call(
    app: ASGIApp, scope: Scope, body: bytes = b""
) -> AsyncIterator[AsyncIterator[Message]]:
    """The messages of the answer; the call is ended with the context."""
    # One at a time: what is not read yet is not made.
    queue: asyncio.Queue[Message | None] = asyncio.Queue(maxsize=1)
    is_sent = False

    async def receive() -> Message:
        nonlocal is_sent
        if not is_sent:
            is_sent = True
            return {"type": "http.request", "body": body, "more_body": False}
        await asyncio.Event().wait()  # the reader stays until the call is cancelled
        raise AssertionError("an event that is never set")

    async def run() -> None:
        try:
            await app(scope, receive, queue.put)
        except Exception:
            log.exception("a page could not be filled")
        await queue.put(None)

    async def messages() -> AsyncIterator[Message]:
        while (message := await queue.get()) is not None:
            yield message

    task = asyncio.create_task(run())
    try:
        yield messages()
    finally:
        task.cancel()
        with contextlib.suppress(asyncio.CancelledError, Exception):
            await task


async def _rest(messages: AsyncIterator[Message]) -> bytes:
    return b"".join([message.get("body", b"") async for message in messages])


async def _problem(status: int, messages: AsyncIterator[Message]) -> Problem:
    try:
        said = msgspec.json.decode(await _rest(messages))
        code = str(said["code"])
        return Problem(status, code, _for_pages(code, str(said["detail"])))
    except (msgspec.DecodeError, KeyError, TypeError):
        return Problem(status, "internal_error", "The server could not answer.")


def _for_pages(code: str, detail: str) -> str:
    """The detail without an advice that speaks of messages, which no reader sees."""
    entry = PROBLEMS.get(code)
    if entry is None or not _OF_MESSAGES.search(entry["act"]):
        return detail
    instead = " Try it again in a moment." if entry["retryable"] else ""
    return f"{detail.removesuffix(entry['act']).rstrip()}{instead}"
