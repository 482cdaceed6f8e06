"""`/livez` and `/readyz`: for load balancers and supervisors, without a token.

They are not part of the protocol and have no version. A probe names the address of the
machine as its host, so no host is refused. The answer names the parts that are not
ready and nothing else, because every caller may read it; why is in the log.
"""

from __future__ import annotations

import msgspec
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from reference_server.http.problems import PROBLEM_JSON, RETRY_AFTER_S
from reference_server.monitoring.readiness import Readiness

LIVE_PATH, READY_PATH = HEALTH_PATHS = "/livez", "/readyz"
_HEADERS = {"Cache-Control": "no-store"}
_TITLE = "The server cannot do its work now"


def health_routes(readiness: Readiness) -> list[BaseRoute]:
    """GET and HEAD of both paths."""

    async def show_live(_: Request) -> Response:
        return _json({"status": "live"}, 200)

    async def show_ready(_: Request) -> Response:
        missing = await readiness.missing()
        if not missing:
            return _json({"status": "ready"}, 200)
        named = ", ".join(missing)
        problem = {
            "type": "about:blank",
            "title": _TITLE,
            "status": 503,
            "detail": f"Not ready: {named}. Ask again, and look at the server's log.",
            "not_ready": missing,
        }
        return _json(problem, 503)

    return [Route(LIVE_PATH, show_live), Route(READY_PATH, show_ready)]


def _json(content: object, status: int) -> Response:
    headers = dict(_HEADERS)
    if status == 503:
        headers["Retry-After"] = str(RETRY_AFTER_S)
    media_type = "application/json" if status == 200 else PROBLEM_JSON
    return Response(msgspec.json.encode(content), status, headers, media_type)
