"""Refusals: an exception inside the server, an RFC 9457 problem outside.

The closed list of codes is `catalogue.py`, generated from `x-problems`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import msgspec
from starlette.responses import Response

from reference_server.generated.problem_codes import PROBLEMS
from reference_server.rules.lifecycle import Refuse

PROBLEM_JSON = "application/problem+json"
# How long a client waits before it asks again; short, because slots free quickly.
RETRY_AFTER_S = 1


class Refused(Exception):
    """A request that is answered with a problem.

    code: one of x-problems. detail: what happened, for people; what to do is added
    from the catalogue. errors: (JSON pointer, text) pairs. members: further members
    of schema Problem.
    """

    def __init__(
        self,
        code: str,
        detail: str,
        *,
        errors: Iterable[tuple[str, str]] = (),
        requirement: str | None = None,
        members: Mapping[str, Any] | None = None,
        headers: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(detail)
        self.code = code
        self.detail = detail
        self.errors = tuple(errors)
        self.requirement = requirement
        self.members = dict(members or {})
        self.headers = dict(headers or {})

    @classmethod
    def from_verdict(cls, verdict: Refuse) -> Refused:
        """The refusal that the protocol decided."""
        return cls(
            verdict.code,
            verdict.detail,
            errors=verdict.errors,
            requirement=verdict.requirement,
            members=verdict.members,
        )


def problem_response(refused: Refused) -> Response:
    """The answer for a refusal, in schema Problem (ERR-001, ERR-011)."""
    entry = PROBLEMS[refused.code]
    body: dict[str, Any] = {
        "type": f"urn:proctor:problem:{refused.code}",
        "title": entry["title"],
        "status": entry["status"],
        "detail": f"{refused.detail} {entry['act']}",
        "code": refused.code,
        "retryable": entry["retryable"],
        "side_effects": entry["side_effects"],
    }
    if refused.errors:
        body["errors"] = [{"pointer": p, "detail": d} for p, d in refused.errors]
    if refused.requirement:
        body["requirement"] = refused.requirement
    body |= refused.members
    headers = dict(refused.headers)
    if entry["status"] in (429, 503):
        headers.setdefault("Retry-After", str(RETRY_AFTER_S))
    if entry["status"] == 401:
        headers.setdefault("WWW-Authenticate", "Bearer")
    return Response(
        msgspec.json.encode(body),
        status_code=entry["status"],
        headers=headers,
        media_type=PROBLEM_JSON,
    )
