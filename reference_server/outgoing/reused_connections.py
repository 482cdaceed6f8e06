"""Connections to other programs that one request after another uses.

A request takes the connection used last, however many there are, and what has no use
any more is closed in the background.
"""

from __future__ import annotations

import asyncio
import contextlib
import contextvars
from collections import deque
from collections.abc import AsyncIterator

import httpcore

from reference_server.outgoing.outgoing_connection import OutgoingConnection
from reference_server.outgoing.streamed_exchange import Headers, StreamedBody

PLACE_TIMEOUT_S = 10.0
Origin = tuple[bytes, int | None]


class ReusedConnections:
    """A connection for each request; those without one are kept for a while.

    at_once_max: requests at the same time; one more waits until another has ended.
    expiry_s: how long a connection without a request is kept; far less than the time
    after which the other program closes it. path: of the Unix socket that all requests
    go to, whatever their URL.
    """

    def __init__(
        self, at_once_max: int, expiry_s: float, path: str | None = None
    ) -> None:
        self._path = path
        self._places = asyncio.Semaphore(at_once_max)
        self._expiry_s = expiry_s
        # Connections without a request, by origin; the one used last is at the end.
        self._idle: dict[Origin, deque[OutgoingConnection]] = {}
        self._timer: asyncio.TimerHandle | None = None
        self._is_closed = False

    @contextlib.asynccontextmanager
    async def stream(
        self,
        method: str,
        url: httpcore.URL,
        *,
        headers: Headers,
        content: bytes | StreamedBody = b"",
        connect_timeout_s: float | None = None,
    ) -> AsyncIterator[OutgoingConnection]:
        """Send a request; gives the connection, which has its answer.

        Raises as OutgoingConnection does, and httpcore.PoolTimeout where no other
        request ends for PLACE_TIMEOUT_S.
        """
        await self._wait_for_place()
        try:
            origin = url.host, url.port
            connection = self._take(origin)
            if connection is None:
                connection = await OutgoingConnection.open(
                    url, connect_timeout_s, self._path
                )
            try:
                await connection.send(method, url.target, headers, content)
                yield connection
            finally:
                self._give_back(origin, connection)
        finally:
            self._places.release()

    async def _wait_for_place(self) -> None:
        if not self._places.locked():  # most requests need no timer
            await self._places.acquire()
            return
        try:
            async with asyncio.timeout(PLACE_TIMEOUT_S):
                await self._places.acquire()
        except TimeoutError as error:
            text = f"all connections were in use for {PLACE_TIMEOUT_S:g} s"
            raise httpcore.PoolTimeout(text) from error

    def _take(self, origin: Origin) -> OutgoingConnection | None:
        """The one used last; None if that has expired, as all others have then."""
        idle = self._idle.get(origin)
        if idle and not idle[-1].has_expired(self._expiry_s):
            return idle.pop()
        return None

    def _give_back(self, origin: Origin, connection: OutgoingConnection) -> None:
        """Keep it, unless its request failed or was given up."""
        if not connection.is_idle or self._is_closed:
            connection.close()
            return
        connection.rest()
        self._idle.setdefault(origin, deque()).append(connection)
        self._close_expired_later()

    def _close_expired_later(self) -> None:
        if self._timer is None:
            # An empty context, because the timer does not belong to a request.
            self._timer = asyncio.get_running_loop().call_later(
                self._expiry_s, self._close_expired, context=contextvars.Context()
            )

    def _close_expired(self) -> None:
        """Close those that were idle for long, or that the other program closed."""
        self._timer = None
        for origin, idle in list(self._idle.items()):
            while idle and idle[0].has_expired(self._expiry_s):
                idle.popleft().close()
            if not idle:
                del self._idle[origin]
        if self._idle and not self._is_closed:
            self._close_expired_later()

    def close(self) -> None:
        """All that have no request; each of the others when its request has ended."""
        self._is_closed = True
        if self._timer is not None:
            self._timer.cancel()
        for idle in self._idle.values():
            while idle:
                idle.pop().close()
        self._idle.clear()
