"""How a refusal becomes an HTTP response: an RFC 9457 problem.

The closed list of codes is `generated/problem_codes.py`, made from `x-problems`. It
does not know why something is refused.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import msgspec
from starlette.responses import Response

from reference_record.generated.answers import Problem
from reference_server.generated.problem_codes import PROBLEMS
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import OwnedElsewhere

# Between the nodes of a cluster: nothing was done, and another one has the run by now.
MOVED_HEADER = "Proctor-Run-Moved"
PROBLEM_JSON = "application/problem+json"
# How long a client waits before it repeats a request; short: slots free quickly.
RETRY_AFTER_S = 1


def problem_response(
    refused: Refused, headers: Mapping[str, str] | None = None
) -> Response:
    """The response for a refusal, in schema Problem (ERR-001, ERR-011)."""
    entry = PROBLEMS[refused.code]
    body: Problem = {
        "type": f"urn:proctor:problem:{refused.code}",
        "title": entry["title"],
        "status": entry["status"],
        "detail": refused.sentences,
        "code": refused.code,
        "retryable": entry["retryable"],
        "side_effects": entry["side_effects"],
    }
    if refused.errors:
        body["errors"] = [{"pointer": p, "detail": d} for p, d in refused.errors]
    if refused.requirement:
        body["requirement"] = refused.requirement
    headers = dict(headers or {})
    if entry["status"] in (429, 503):
        after_s = max(math.ceil(refused.retry_after_s or 0), RETRY_AFTER_S)
        headers.setdefault("Retry-After", str(after_s))
    if isinstance(refused, OwnedElsewhere):
        headers[MOVED_HEADER] = "1"
    if entry["status"] == 401:
        headers.setdefault("WWW-Authenticate", "Bearer")  # AUTH-002
    return Response(
        msgspec.json.encode({**body, **refused.members}),
        status_code=entry["status"],
        headers=headers,
        media_type=PROBLEM_JSON,
    )
