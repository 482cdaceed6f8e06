"""The platform as one ASGI application; it listens on a Unix socket."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from reference_platform.http.api_calls import EveryMethod
from reference_platform.http.api_handlers import BASE, api_routes
from reference_platform.http.server_calls import ServerHandlers, ServerRuns
from reference_platform.http.submission_handlers import SubmissionHandlers
from reference_platform.http.track_handlers import TrackHandlers
from reference_platform.pages.hosting_pages import page_routes
from reference_platform.pages.status_pages import OperationPages
from reference_platform.pages.submission_pages import SubmissionPages
from reference_platform.parts import Parts
from reference_platform.submissions.hosted_parts import HostedParts
from reference_server.http.problems import problem_response
from reference_server.http.tokens.open_requests import OpenRequests
from reference_server.rules.refusal import Refused


def make_application(
    parts: Parts, runs: ServerRuns, hosted: HostedParts | None = None
) -> Starlette:
    """runs: reads runs at the server. hosted: runs submissions; None: not here."""
    submissions = pages = None
    if hosted is not None:
        pages = SubmissionPages(hosted.reviews, hosted.logs)
        submissions = SubmissionHandlers(
            hosted.uploads, hosted.reviews, hosted.presets, hosted.logs, hosted.roots
        )
    server, open_requests = ServerHandlers(parts, runs), OpenRequests()

    async def not_found(_request: Request) -> Response:
        act = "Check the path." if hosted else "It runs no submissions."
        refused = Refused("not_found", "The platform has no such path.", act=act)
        return problem_response(refused)

    @contextlib.asynccontextmanager
    async def lifespan(_app: Starlette) -> AsyncIterator[None]:
        work = [asyncio.create_task(parts.outbox.send_all())]
        if hosted is not None:
            work.append(asyncio.create_task(hosted.supervisor.run()))
        try:
            yield
        finally:
            for task in work:
                task.cancel()
            await asyncio.gather(*work, return_exceptions=True)
            await runs.close()

    app = Starlette(
        routes=[
            Route("/keys", server.send_keys, methods=["POST"]),
            Route("/page_tokens", server.send_page_token, methods=["POST"]),
            Route("/runs", server.admit_run, methods=["POST"]),
            Route("/runs/{run_id}", server.withdraw_run, methods=["DELETE"]),
            Route("/draws", server.send_drawn, methods=["POST"]),
            Route("/publications", server.check_publication, methods=["POST"]),
            *api_routes(parts, open_requests, TrackHandlers(runs), submissions),
            Route(BASE + "/{rest:path}", EveryMethod(not_found)),  # ERR-009
            *page_routes(parts, open_requests, runs, pages, OperationPages(hosted)),
        ],
        lifespan=lifespan,
    )
    app.state.runs_submissions = hosted is not None  # pages link to them
    return app
