"""A port of its own for what operators read: metrics and health.

It has few connections, with the same bounds as those of clients, and lives in the same
event loop: a server whose loop stands does not answer here. It still answers while the
server drains.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Sequence

import uvicorn
from starlette.routing import BaseRoute, Router
from uvicorn.server import ServerState

from reference_server.http.connections.bounded_connection import connection_factory
from reference_server.http.connections.connection_limits import (
    ConnectionLimiter,
    ConnectionLimits,
)

CONNECTIONS_MAX = 64


class MetricsListener:
    """listener: bound, and not yet listening; None for no such port."""

    def __init__(
        self, listener: socket.socket | None, routes: Sequence[BaseRoute]
    ) -> None:
        self._listener = listener
        self._routes = routes
        self._server: asyncio.Server | None = None

    async def open(self) -> None:
        if self._listener is None:
            return
        limits = ConnectionLimits(
            connections=CONNECTIONS_MAX, per_address=CONNECTIONS_MAX
        )
        config = uvicorn.Config(
            Router(self._routes),
            http=connection_factory(ConnectionLimiter(limits)),
            ws="none",
            lifespan="off",
            log_config=None,
            access_log=False,
            server_header=False,
        )
        config.load()
        state = ServerState()

        def connect() -> asyncio.Protocol:
            protocol: asyncio.Protocol = config.http_protocol_class(  # type: ignore[call-arg]
                config=config, server_state=state, app_state={}
            )
            return protocol

        loop = asyncio.get_running_loop()
        self._server = await loop.create_server(connect, sock=self._listener)

    async def close(self) -> None:
        if self._server is not None:
            self._server.close()
