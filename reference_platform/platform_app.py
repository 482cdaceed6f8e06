"""The platform as one ASGI application; it listens on a Unix socket."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from reference_platform.http.api_handlers import BASE, api_routes
from reference_platform.http.server_calls import ServerHandlers, ServerRuns
from reference_platform.pages.hosting_pages import page_routes
from reference_platform.parts import Parts
from reference_server.http.problems import problem_response
from reference_server.rules.refusal import Refused


def make_application(parts: Parts, runs: ServerRuns) -> Starlette:
    """runs: reads runs at the server."""
    server = ServerHandlers(parts, runs)

    async def not_found(_request: Request) -> Response:
        refused = Refused("not_found", "The platform has no such path.")
        return problem_response(refused)

    @contextlib.asynccontextmanager
    async def lifespan(_app: Starlette) -> AsyncIterator[None]:
        sending = asyncio.create_task(parts.outbox.send_all())
        try:
            yield
        finally:
            sending.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await sending
            await runs.close()

    return Starlette(
        routes=[
            Route("/keys", server.send_keys, methods=["POST"]),
            Route("/runs", server.admit_run, methods=["POST"]),
            Route("/runs/{run_id}", server.withdraw_run, methods=["DELETE"]),
            *api_routes(parts),
            Route(BASE + "/{rest:path}", not_found),
            *page_routes(parts, runs),
        ],
        lifespan=lifespan,
    )
