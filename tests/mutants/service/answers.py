"""Mutants of answers: media types, headers, and what a refusal says."""

from __future__ import annotations

from typing import Any

from starlette.requests import Request
from starlette.responses import Response

from reference_server.generated.problem_codes import PROBLEMS
from reference_server.http import (
    codec,
    dispatch,
    problems,
)
from reference_server.http.application import Application
from reference_server.http.handlers import Handlers
from reference_server.rules.refusal import Refused
from reference_server.runs.benchmarks import Benchmarks
from reference_server.views import run_views
from tests.mutants import Json, Row, instead_of, mutant, mutants, put


@mutant("ENC-001", through=instead_of(codec, "negotiate_media_type"))
def prefers_messagepack(right: Any, request: Any, writable: Any) -> Any:
    """Generated clients receive a format that they cannot read."""
    return right(request, tuple(reversed(writable)))


@mutant("ENC-001")
def repeats_a_turn_in_its_first_encoding() -> None:
    """A client that accepts both is sent a format that it does not expect."""
    right = Handlers.predict
    first: dict[tuple[str, int], str] = {}

    async def wrong(self: Handlers, call: Any) -> Response:
        place = call.body.session_id, call.body.seq
        call.media_type = first.setdefault(place, call.media_type)
        return await right(self, call)

    put(Handlers, "predict", wrong)


@mutant("ERR-008", through=instead_of(codec, "negotiate_media_type"))
def answers_in_json_whatever_is_accepted(
    right: Any, request: Request, writable: Any
) -> Any:
    """A client receives a format that it cannot read."""
    try:
        return right(request, writable)
    except Refused:
        return codec.JSON


@mutant("SVC-003", through=instead_of(Benchmarks, "summaries"))
def writes_a_whole_number_with_a_fraction(right: Any, self: Any) -> list[Json]:
    """Clients in Go, Rust and Kotlin cannot read the answer."""
    return [
        summary | {"episodes_total": float(summary["episodes_total"])}
        for summary in right(self)
    ]


@mutant("SVC-003", through=instead_of(run_views, "timestamp"))
def writes_times_in_lower_case(right: Any, at_wall: float) -> str:
    """Clients in Go and Python cannot read the answer."""
    return str(right(at_wall)).lower()


@mutant("ERR-001")
def calls_problems_plain_json() -> None:
    """Clients that expect problem details do not recognise them."""
    put(problems, "PROBLEM_JSON", "application/json")


@mutant("ERR-001")
def says_that_a_conflict_is_retryable() -> None:
    """Clients repeat a request that can never succeed."""
    PROBLEMS["illegal_transition"]["retryable"] = True


@mutants(
    Row(
        "does_not_say_how_to_authenticate",
        ("AUTH-002",),
        "A generic HTTP client does not know what to send.",
        "www-authenticate",
    ),
    Row(
        "does_not_say_when_to_retry",
        ("ERR-011",),
        "Clients that must wait retry immediately.",
        "retry-after",
    ),
)
def omit_header(name: str) -> None:
    """Let no refusal carry this header."""

    def wrong(right: Any, refused: Refused, *headers: Any) -> Any:
        response = right(refused, *headers)
        if name in response.headers:
            del response.headers[name]
        return response

    instead_of(dispatch, "problem_response")(wrong)


@mutant("SVC-002", "VER-001")
def does_not_name_its_version() -> None:
    """A client cannot know which protocol version an answer follows."""
    right = Application.__call__

    # uvicorn calls it without arguments, and expects a TypeError.
    async def wrong(self: Application, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "http":
            await self._app(scope, receive, send)
        else:
            await right(self, scope, receive, send)

    put(Application, "__call__", wrong)
