"""Connections to other nodes that one request after another uses.

httpcore's own pool looks at every connection whenever a request begins or ends: with
hundreds of requests at once that takes a node longer than all else. Here a request
takes the connection used last, however many there are, and what has no use any more is
closed in the background.
"""

from __future__ import annotations

import asyncio
import contextlib
import contextvars
from collections import deque
from collections.abc import AsyncIterator
from typing import Any

import httpcore

from reference_server.process.outgoing_streams import OutgoingBackend


class ReusedConnections:
    """A connection for each request; those without one are kept for a while.

    at_once_max: requests at the same time; one more waits until another has ended.
    expiry_s: how long a connection without a request is kept.
    """

    def __init__(self, at_once_max: int, expiry_s: float) -> None:
        self._places = asyncio.Semaphore(at_once_max)
        self._expiry_s = expiry_s
        # Connections without a request, by origin; the one used last is at the end.
        self._idle: dict[str, deque[httpcore.AsyncHTTPConnection]] = {}
        self._backend = OutgoingBackend()
        self._timer: asyncio.TimerHandle | None = None
        self._closing: asyncio.Task[None] | None = None
        self._is_closed = False

    @contextlib.asynccontextmanager
    async def stream(
        self, method: str, url: httpcore.URL, **request: Any
    ) -> AsyncIterator[httpcore.Response]:
        """Send a request as the pool of httpcore does, with the same errors."""
        async with self._places:
            connection = self._take(url.origin)
            try:
                async with connection.stream(method, url, **request) as response:
                    yield response
            finally:
                await self._give_back(str(url.origin), connection)

    def _take(self, origin: httpcore.Origin) -> httpcore.AsyncHTTPConnection:
        """The one used last; a new one if that has expired, as all others have then."""
        idle = self._idle.get(str(origin))
        if idle and not idle[-1].has_expired():
            return idle.pop()
        return httpcore.AsyncHTTPConnection(
            origin, keepalive_expiry=self._expiry_s, network_backend=self._backend
        )

    async def _give_back(
        self, origin: str, connection: httpcore.AsyncHTTPConnection
    ) -> None:
        """Keep it, unless its request failed or was given up."""
        # httpcore calls a connection idle, too, that could not be opened.
        is_usable = connection.is_idle() and not connection.is_closed()
        if is_usable and not self._is_closed:
            self._idle.setdefault(origin, deque()).append(connection)
            self._close_expired_later()
        else:
            await connection.aclose()

    def _close_expired_later(self) -> None:
        if self._timer is None:
            # An empty context, because the timer does not belong to a request.
            self._timer = asyncio.get_running_loop().call_later(
                self._expiry_s, self._begin_closing, context=contextvars.Context()
            )

    def _begin_closing(self) -> None:
        self._timer = None
        self._closing = asyncio.ensure_future(self._close_expired())

    async def _close_expired(self) -> None:
        """Close connections that were idle for long or that the other node closed."""
        for origin, idle in list(self._idle.items()):
            while idle and idle[0].has_expired():
                await idle.popleft().aclose()
            if not idle:
                self._idle.pop(origin, None)
        if self._idle and not self._is_closed:
            self._close_expired_later()

    async def close(self) -> None:
        """All that have no request; each of the others when its request has ended."""
        self._is_closed = True
        if self._timer is not None:
            self._timer.cancel()
        if self._closing is not None:
            await self._closing
        for idle in list(self._idle.values()):
            while idle:
                await idle.pop().aclose()
        self._idle.clear()
