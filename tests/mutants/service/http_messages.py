"""Mutants of HTTP: versions, paths, queries, headers, and the limits of a message."""

from __future__ import annotations

import re
from typing import Any

from starlette.requests import Request
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from reference_server.assembly.nearest_path import UnknownPath
from reference_server.http import application, codec, dispatch, problems
from reference_server.http.application import Application
from reference_server.http.bodies import request_bodies
from reference_server.http.problems import problem_response
from reference_server.rules.refusal import Refused
from tests.mutants import Row, instead_of, mutant, mutants, put


@mutant("ERR-014", "VER-002")
def compares_only_the_major_version() -> None:
    """A client of a later version learns nothing of members that are unknown here."""
    put(dispatch, "_is_supported", lambda version: version.partition(".")[0] == "1")


@mutant("VER-002")
def compares_versions_as_text() -> None:
    """A client that writes 1.0 as 01.0 is refused, as if it were of another version."""
    lowest, highest = dispatch.VERSION_MIN, dispatch.VERSION_MAX
    put(dispatch, "_is_supported", lambda version: lowest <= version <= highest)


@mutant("ERR-020", "RUN-027", "VER-002")
def checks_the_version_after_the_work() -> None:
    """A client of another version is refused, and its run starts all the same."""
    right, right_perform = dispatch.check_version, dispatch.perform

    put(dispatch, "check_version", lambda _request: None)

    async def wrong(request: Request, *more: Any, **others: Any) -> Response:
        response = await right_perform(request, *more, **others)
        try:
            right(request)
        except Refused as refused:
            return problem_response(refused)
        return response

    put(application, "perform", wrong)


@mutant("ERR-009", through=instead_of(UnknownPath, "__call__"))
async def calls_an_unknown_path_a_bad_request(
    _right: Any, _self: UnknownPath, scope: Scope, receive: Receive, send: Send
) -> None:
    """A wrong address looks like a wrong body."""
    refused = Refused("invalid_request", "No such path.")
    await problems.problem_response(refused)(scope, receive, send)


@mutants(
    Row(
        "does_not_say_which_methods_are_allowed",
        ("ERR-022",),
        "A client cannot find the right method.",
        "method_not_allowed",
    ),
    Row(
        "calls_a_wrong_method_a_wrong_path",
        ("ERR-010",),
        "A client looks for a mistake in the address.",
        "not_found",
    ),
)
def answer_other_methods(code: str) -> None:
    """Refuse every method that a path lacks with this code, without a header."""

    def wrong(_right: Any, _self: object, _method: str) -> Any:
        return problems.problem_response(Refused(code, "No."))

    instead_of(application.Endpoint, "_not_allowed")(wrong)


@mutant("ERR-018")
def calls_a_wrong_run_id_a_wrong_body() -> None:
    """A user looks for a mistake in a body that was never sent."""
    pattern, _ = dispatch.PATH_PATTERNS["run_id"]
    patterns = dispatch.PATH_PATTERNS | {"run_id": (pattern, "malformed_body")}
    put(dispatch, "PATH_PATTERNS", patterns)


@mutant("ATT-013")
def accepts_any_worker_id() -> None:
    """Ids that do not fit into a path or a log are accepted."""
    put(
        dispatch,
        "PATH_PATTERNS",
        dispatch.PATH_PATTERNS | {"worker_id": (".+", "")},
    )


@mutant("ERR-012", through=instead_of(dispatch, "_path"))
def fails_on_broken_percent_encodings(right: Any, request: Request) -> Any:
    """A typing error in a path looks like a defect of the server."""
    for part in request.scope["raw_path"].split(b"%")[1:]:
        bytes.fromhex(part[:2].decode())
    return right(request)


@mutant("ERR-014", through=instead_of(dispatch, "_query"))
def ignores_invalid_query_parameters(
    right: Any, request: Request, operation: dispatch.Operation
) -> Any:
    """A misspelt limit is replaced by another, without an error."""
    try:
        return right(request, operation)
    except Refused:
        if operation.required_query:
            raise
        return {}


@mutant("ERR-014", through=instead_of(dispatch, "_query"))
def ignores_invalid_parameters_of_the_leaderboard(
    right: Any, request: Request, operation: dispatch.Operation
) -> Any:
    """A reader of entries gets a page of another size than was asked for."""
    try:
        return right(request, operation)
    except Refused:
        if request.url.path != "/v1/entries":
            raise
        return {}


@mutant("ERR-012", through=instead_of(dispatch, "_query"))
def fails_on_a_large_tree(
    right: Any, request: Request, operation: dispatch.Operation
) -> Any:
    """A proof about a tree that is not there looks like a defect of the server."""
    values = right(request, operation)
    if int(values.get("tree_size", 0)) > 999:
        raise OverflowError
    return values


@mutant("ERR-017", through=instead_of(dispatch, "_headers"))
def reads_the_headers_of_other_operations(
    right: Any, request: Request, operation: dispatch.Operation
) -> Any:
    """A proxy that adds a header to every request makes all of them fail."""
    values = right(request, operation)
    if not re.fullmatch(r"wait=\d+", request.headers.get("prefer", "wait=0")):
        raise Refused("invalid_request", "Prefer is wait=N.")
    return values


@mutant("ERR-019", through=instead_of(codec, "media_type_of"))
def compares_media_types_letter_by_letter(
    right: Any, request: Request, readable: Any
) -> Any:
    """A client whose library writes `Application/JSON` cannot send anything."""
    if request.headers.get("content-type", "").startswith("A"):
        raise Refused("unsupported_media_type", "Unknown media type.")
    return right(request, readable)


@mutant("ERR-007", through=instead_of(codec, "media_type_of"))
def refuses_a_charset_in_quotes(right: Any, request: Request, readable: Any) -> Any:
    """A client whose library writes parameters in quotes cannot send anything."""
    if '"' in request.headers.get("content-type", ""):
        raise Refused("unsupported_media_type", "Unknown media type.")
    return right(request, readable)


@mutant("ERR-007", through=instead_of(codec, "media_type_of"))
def reads_any_media_type_as_json(right: Any, request: Request, readable: Any) -> Any:
    """A form sent by a browser on behalf of another site is executed."""
    try:
        return right(request, readable)
    except Refused:
        return codec.JSON


@mutant("SVC-005", through=instead_of(request_bodies, "read_body"))
async def reads_no_body_without_a_length(
    right: Any, request: Request, max_bytes: int, **kind: bool
) -> Any:
    """A client that streams its body is refused as if it had sent none."""
    body = await right(request, max_bytes, **kind)
    return body if "content-length" in request.headers else b""


@mutant("SVC-004")
def answers_the_body_of_a_refused_request() -> None:
    """An attacker who chooses a body chooses the answer that another client gets."""
    right = Application.__call__
    poisoned: set[Any] = set()

    async def wrong(self: Application, scope: Any, receive: Any, send: Any) -> None:
        client = scope.get("client")
        if scope["type"] == "http" and client in poisoned:
            poisoned.discard(client)
            scope = scope | {"path": "/v1/no-such-path"}

        async def receive_and_look() -> Any:
            message = await receive()
            if message.get("body", b"").startswith(b"GET "):
                poisoned.add(client)
            return message

        await right(self, scope, receive_and_look, send)

    put(Application, "__call__", wrong)
