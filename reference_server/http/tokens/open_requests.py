"""Requests that are open for long end soon after their caller may send them no more.

A stream of events, a long poll, a download and an upload can last for minutes. So the
token of each is looked at again once a second: one that was revoked ends its requests.
"""

from __future__ import annotations

import asyncio
import contextvars
import logging
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager, suppress

from starlette.requests import Request
from starlette.responses import Response
from starlette.types import Message, Send

from reference_server.rules.refusal import Refused
from reference_server.storage.runs.run_store import StoreFailed

log = logging.getLogger("proctor.tokens")

LOOK_S = 1.0


class RequestEnded(Exception):
    """The caller may send this request no more; its answer is not complete."""

    def __init__(self, refused: Refused) -> None:
        super().__init__(str(refused))
        self.refused = refused


class OpenRequest:
    """One request. check: raises Refused once it may not go on."""

    def __init__(self, check: Callable[[], object], limit: asyncio.Timeout) -> None:
        self._check, self._limit = check, limit
        # Whether what is sent may still be read, such as that of a deleted run.
        self.check_content: Callable[[], Awaitable[object]] | None = None
        self.refused: Refused | None = None  # why it has ended

    async def look(self) -> None:
        """End the request if it may not go on."""
        try:
            self._check()
            if self.check_content is not None:
                await self.check_content()
        except Refused as refused:
            log.info("an open request ends: %s", refused)
            self.refused = refused
            with suppress(RuntimeError):  # it has ended meanwhile
                self._limit.reschedule(asyncio.get_running_loop().time())
        except StoreFailed:
            pass  # nothing is known now; it is looked at again


class OpenRequests:
    """The open requests of one server."""

    def __init__(self) -> None:
        self._open: set[OpenRequest] = set()
        self._looking: asyncio.Task[None] | None = None

    @asynccontextmanager
    async def enter(self, check: Callable[[], object]) -> AsyncIterator[OpenRequest]:
        """Cancel what is done inside, and raise RequestEnded, when `check` refuses."""
        limit = asyncio.timeout(None)
        request = OpenRequest(check, limit)
        try:
            async with limit:
                self._open.add(request)
                if self._looking is None:
                    self._looking = asyncio.create_task(
                        self._look_at_all(), context=contextvars.Context()
                    )
                yield request
        except TimeoutError as error:
            if request.refused is not None:
                raise RequestEnded(request.refused) from error
            raise
        finally:
            self._open.discard(request)

    async def answer(
        self,
        request: Request,
        check: Callable[[], object],
        perform: Callable[[], Awaitable[Response]],
        refuse: Callable[[Refused], Response],
        send: Send,
    ) -> None:
        """Perform a request, and send its response, while `check` allows it.

        After that a wait ends with a refusal, and a stream ends where it is.
        """
        response: Response | None = None
        has_begun = False

        async def send_and_note(message: Message) -> None:
            nonlocal has_begun
            await send(message)  # a head may have to wait for an earlier response
            has_begun = True

        try:
            async with self.enter(check) as open_request:
                response = await perform()
                open_request.check_content = getattr(response, "check_content", None)
                await response(request.scope, request.receive, send_and_note)
        except RequestEnded as ended:
            if response is None or not has_begun:
                refusal = refuse(ended.refused)
                # Who still sends a body is to stop.
                refusal.headers["connection"] = "close"
                await refusal(request.scope, request.receive, send)
            # A body of a known length stays short, and so its reader sees that.
            elif "content-length" not in response.headers:
                await send({"type": "http.response.body", "body": b""})

    async def _look_at_all(self) -> None:
        try:
            while self._open:
                await asyncio.sleep(LOOK_S)
                for request in list(self._open):
                    if request in self._open:
                        await request.look()
        finally:
            self._looking = None
