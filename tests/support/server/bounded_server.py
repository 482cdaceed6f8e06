"""A server of `BoundedConnection` in this process, with a small application behind it.

The application answers `/body` with the size of its body, `/large` with as many bytes
as its query says, `/parts` with five parts of that size, `/wait` when it is released,
and anything else at once. It is reached through ASGI, or as turns are answered.
"""

from __future__ import annotations

import asyncio
import contextlib
import socket
import threading
from collections.abc import Iterator, Mapping
from typing import Any

import uvicorn
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from reference_server.http.codec import MSGPACK, SegmentedResponse
from reference_server.http.connections.bounded_connection import (
    BoundedConnection,
    connection_factory,
)
from reference_server.http.connections.connection_limits import (
    ConnectionLimiter,
    ConnectionLimits,
)
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until

# Whether the servers that start from now on answer as turns are answered.
is_direct = False


class BoundedServer:
    """limiter: counts its connections. paths: of the requests that it was given."""

    def __init__(self, limits: ConnectionLimits, *, is_direct: bool) -> None:
        self.limiter = ConnectionLimiter(limits)
        self.paths: list[str] = []
        self._released = asyncio.Event()
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.address: tuple[str, int] = self._listener.getsockname()
        config = uvicorn.Config(
            self._app,
            http=connection_factory(self.limiter, self if is_direct else None),
            ws="none",
            interface="asgi3",
            lifespan="off",
            log_level="error",
            timeout_graceful_shutdown=1,
        )
        self._server = uvicorn.Server(config)
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()
        wait_until(lambda: self._server.started, "the server listens")

    def _run(self) -> None:
        self._server.run(sockets=[self._listener])

    @property
    def connections(self) -> list[BoundedConnection]:
        """Those that are open, also while they close."""
        return [
            one
            for one in list(self._server.server_state.connections)
            if isinstance(one, BoundedConnection)
        ]

    def connect(self, **options: Any) -> socket.socket:
        """A new connection; closed by the caller."""
        return socket.create_connection(self.address, TIMEOUT_S, **options)

    def release(self) -> None:
        """Answer what waits."""
        loop = self.connections[0].loop
        loop.call_soon_threadsafe(self._released.set)

    def end(self) -> None:
        self._server.force_exit = self._server.should_exit = True
        self._thread.join(TIMEOUT_S)

    async def _app(self, scope: Scope, receive: Receive, send: Send) -> None:
        self.paths.append(path := scope["path"])
        size = await _read_size(receive) if path == "/body" else 0
        response = await self._respond(path, scope["query_string"], size)
        await response(scope, receive, send)

    def path_of(self, method: bytes, url: bytes) -> Mapping[str, str] | None:
        """See DirectAnswers; a turn is answered after its body was read."""
        return {} if method == b"GET" or url == b"/body" else None

    async def answer(self, scope: Scope, body: bytes) -> Response:
        """See DirectAnswers."""
        path, _, query = scope["path"].partition("?")
        self.paths.append(path)
        return await self._respond(path, query, len(body))

    async def _respond(self, path: str, query: str | bytes, size: int) -> Response:
        body = b"ok"
        match path:
            case "/body":
                body = b"%d" % size
            case "/large":
                body = b"x" * int(query)
            case "/parts":
                return SegmentedResponse(parts_of(int(query)), 200, MSGPACK)
            case "/wait":
                await self._released.wait()
        return Response(body)


def parts_of(size: int) -> list[bytes | memoryview]:
    """The parts of the answer of `/parts`, each of another byte."""
    return [memoryview(bytes([65 + number]) * size) for number in range(5)]


async def _read_size(receive: Receive) -> int:
    size, more = 0, True
    while more:
        message = await receive()
        if message["type"] == "http.disconnect":
            return size
        size += len(message.get("body", b""))
        more = message.get("more_body", False)
    return size


@contextlib.contextmanager
def bounded_server(**limits: Any) -> Iterator[BoundedServer]:
    """A server with some limits other than the defaults; checks are 20 per second."""
    with _running(is_direct, limits) as server:
        yield server


@contextlib.contextmanager
def server_of_turns(**limits: Any) -> Iterator[BoundedServer]:
    """The same, which answers as turns are answered."""
    with _running(True, limits) as server:
        yield server


@contextlib.contextmanager
def _running(directly: bool, limits: Mapping[str, Any]) -> Iterator[BoundedServer]:
    bounds = ConnectionLimits(**{"check_interval_s": 0.05, **limits})
    server = BoundedServer(bounds, is_direct=directly)
    yield server
    server.end()
