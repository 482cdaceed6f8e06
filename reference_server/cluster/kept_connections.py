"""Connections to other nodes that are used again, each by one request at a time.

httpcore's own pool looks at every connection whenever a request begins or ends: with
hundreds of requests at once that takes a node longer than all else. Here it is the one
used last that is taken, however many there are.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections import defaultdict, deque
from collections.abc import AsyncIterator
from typing import Any

import httpcore


class KeptConnections:
    """At most so many requests at once; more wait. expiry_s: of an unused one."""

    def __init__(self, at_once_max: int, expiry_s: float) -> None:
        self._places = asyncio.Semaphore(at_once_max)
        self._expiry_s = expiry_s
        # Of each origin, those without a request, the one used last at the end.
        self._idle: dict[str, deque[httpcore.AsyncHTTPConnection]]
        self._idle = defaultdict(deque)
        self._backend = httpcore.AnyIOBackend()

    @contextlib.asynccontextmanager
    async def stream(
        self, method: str, url: httpcore.URL, **request: Any
    ) -> AsyncIterator[httpcore.Response]:
        """As the method of httpcore's pool. Raises its errors."""
        async with self._places:
            idle = self._idle[str(url.origin)]
            connection = self._take(idle, url.origin)
            try:
                async with connection.stream(method, url, **request) as response:
                    yield response
            finally:
                # What a request has left in the middle httpcore has closed.
                if connection.is_idle():
                    idle.append(connection)
                await self._close_unused(idle)

    def _take(
        self, idle: deque[httpcore.AsyncHTTPConnection], origin: httpcore.Origin
    ) -> httpcore.AsyncHTTPConnection:
        """The one used last, unless that is expired: then all are, or soon."""
        if idle and not idle[-1].has_expired():
            return idle.pop()
        return httpcore.AsyncHTTPConnection(
            origin, keepalive_expiry=self._expiry_s, network_backend=self._backend
        )

    async def _close_unused(self, idle: deque[httpcore.AsyncHTTPConnection]) -> None:
        while idle and idle[0].has_expired():
            await idle.popleft().aclose()

    async def close(self) -> None:
        """Of all that have no request."""
        for idle in self._idle.values():
            while idle:
                await idle.pop().aclose()
