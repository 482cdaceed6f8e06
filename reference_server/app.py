"""The ASGI application: routes, and what holds for every answer."""

from __future__ import annotations

import logging
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager

from starlette.applications import Starlette
from starlette.datastructures import MutableHeaders
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from reference_server.auth import Tokens
from reference_server.benchmarks import Benchmarks
from reference_server.operations import VERSION, Operation, perform
from reference_server.problems import Refused, problem_response
from reference_server.routes import Routes
from reference_server.run_book import RunBook
from reference_server.settings import Settings
from reference_server.stage import Stage
from reference_server.store import Store, StoreFailed
from reference_sim.runners.local import SimulatorPool

log = logging.getLogger("proctor.app")


def build(settings: Settings, tokens: Tokens) -> Versioned:
    """One server: its parts, put together. Nothing runs before the lifespan begins."""
    store = Store(settings.database_url)
    pool = SimulatorPool(
        settings.max_simulators, settings.spare_simulators, settings.turn_timeout_s
    )
    book = RunBook(store, settings.max_active_runs)
    stage = Stage(book, pool)
    routes = Routes(settings, Benchmarks(settings.max_chunk), book, stage)

    @asynccontextmanager
    async def lifespan(_app: Starlette) -> AsyncIterator[None]:
        await store.open()
        await book.open()
        await pool.start()
        try:
            yield
        finally:
            await stage.close()
            await book.close()
            await pool.close()
            await store.close()

    app = Starlette(
        routes=[
            _route(path, operations, tokens, settings.max_body_bytes)
            for path, operations in routes.table().items()
        ],
        exception_handlers={
            404: _not_found,
            405: _not_allowed,
            StoreFailed: _unavailable,
            Exception: _failed,
        },
        lifespan=lifespan,
    )
    app.router.redirect_slashes = False
    served = Versioned(app)
    served.end = book.end
    return served


def _route(
    path: str, operations: Mapping[str, Operation], tokens: Tokens, max_body: int
) -> Route:
    """One route per path, so that a 405 can name every method the path has."""

    async def endpoint(request: Request) -> Response:
        operation = operations.get(request.method)
        if operation is None:
            allowed = ", ".join(sorted(operations))
            raise HTTPException(405, headers={"Allow": allowed})
        return await perform(request, operation, tokens, max_body)

    route = Route(path, endpoint)
    route.methods = None  # every method arrives here
    return route


async def _not_found(_request: Request, _error: Exception) -> Response:
    return problem_response(Refused("not_found", "There is no such path."))


async def _not_allowed(request: Request, error: Exception) -> Response:
    headers = getattr(error, "headers", None) or {}
    detail = f"{request.method} is not a method of this path."
    return problem_response(Refused("method_not_allowed", detail, headers=headers))


async def _unavailable(_request: Request, error: Exception) -> Response:
    log.error("the store failed: %s", error)
    return problem_response(Refused("unavailable", "The store does not answer."))


async def _failed(_request: Request, error: Exception) -> Response:
    log.error("a request failed", exc_info=error)
    return problem_response(Refused("internal_error", "The server has a defect."))


class Versioned:
    """VER-001: every answer names the version it was made under.

    end: to be called when the server begins to end; answers those who wait.
    """

    end: Callable[[], None]

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        async def send_versioned(message: Message) -> None:
            if message["type"] == "http.response.start":
                MutableHeaders(scope=message)["Proctor-Version"] = VERSION
            await send(message)

        await self._app(scope, receive, send_versioned)
