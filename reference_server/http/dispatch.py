"""From HTTP to an operation and back: what every operation has in common.

An operation is a function from an OperationCall to a Response. Its route, method,
scope, body and media types are declared once, in `handlers.py` (SVC-003); the order of
checks is here. It knows no run and no rule of the lifecycle.
"""

from __future__ import annotations

import asyncio
import logging
import re
import sys
from collections.abc import Awaitable, Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

from pydantic import BaseModel
from starlette.requests import Request
from starlette.responses import Response

from reference_record.generated.protocol_version import PROTOCOL_VERSION
from reference_record.texts.pattern_words import in_words
from reference_server.generated.parameters import (
    HEADER_PATTERNS,
    QUERY_PATTERNS,
    QUERY_RANGES,
)
from reference_server.generated.parameters import PATH_PATTERNS as DESCRIBED_PATHS
from reference_server.http import codec
from reference_server.http.auth import (
    NO_ACCOUNT,
    SCOPES,
    Caller,
    Tokens,
    hash_of_bearer,
    is_local,
)
from reference_server.http.bodies import bounded_parsing, request_bodies
from reference_server.http.problems import problem_response
from reference_server.rules.refusal import Refused
from reference_server.settings.allowed_hosts import ANY_HOST, AllowedHosts
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.telemetry.repeated_failures import RepeatedFailures

_failures = RepeatedFailures(logging.getLogger("proctor.http"))


# This server speaks one version.
VERSION_MIN = VERSION_MAX = PROTOCOL_VERSION
VERSION_CHARS_MAX = 9
# No operation has as many; the rest is not even split.
QUERY_PARAMETERS_MAX = 32

# A worker id is the choice of the client, so a wrong one is its own mistake
# (ATT-013); any other path parameter of a wrong form names nothing (ERR-018).
_PATH_CODES = {"worker_id": "invalid_request"}
# name → (pattern, code of the refusal)
PATH_PATTERNS: dict[str, tuple[str, str]] = {
    name: (pattern, _PATH_CODES.get(name, "not_found"))
    for name, pattern in DESCRIBED_PATHS.items()
}
# Where a request's scope has the account of its caller, for the log.
ACCOUNT = "proctor.account"
# And the name of its operation, for the metrics.
OPERATION = "proctor.operation"


@dataclass(frozen=True, slots=True)
class Operation:
    """One operation of the spec.

    scope: what the token needs; None for a request without credentials (SVC-001).
    body: the model of the body. reads, writes: media types, best first; empty without a
    body. query, headers: names that it takes. refusal_response: makes the response of a
    refusal; a problem by default. local_account: that of requests of this machine
    without a token; they are refused if it is empty. max_body_bytes: its own limit, if
    that is lower than the one of every operation. without_token: those of any machine
    are answered, too, as of no account. has_streamed_body: the handler reads
    it, part by part.
    """

    handler: Callable[[OperationCall], Awaitable[Response]]
    scope: str | None = "read"
    body: type[BaseModel] | None = None
    reads: tuple[str, ...] = (codec.JSON,)
    writes: tuple[str, ...] = (codec.JSON,)
    query: tuple[str, ...] = ()
    required_query: tuple[str, ...] = ()
    headers: tuple[str, ...] = ()
    refusal_response: Callable[[Refused], Response] | None = None
    local_account: str = ""
    max_body_bytes: int = sys.maxsize
    without_token: bool = False
    has_streamed_body: bool = False

    def may_last(self, method: str) -> bool:
        """Whether a caller can keep it open: a wait, a download or an upload.

        A turn is never cancelled.
        """
        return method == "GET" or self.has_streamed_body


def operation_name(operation: Operation) -> str:
    """The name of its handler, after that of the profile where it has another API."""
    handler = operation.handler
    name = getattr(handler, "__name__", "unnamed")
    _, _, profile = handler.__module__.partition(".profiles.")
    return f"{profile.partition('.')[0]}_{name}" if profile else name


@dataclass(slots=True)
class OperationCall:
    """One request, checked: every member fits the spec."""

    request: Request
    path: Mapping[str, str]
    query: Mapping[str, str]
    headers: Mapping[str, str]
    media_type: str
    caller: Caller | None = None
    body: Any = None
    raw: bytes = field(default=b"", repr=False)
    body_type: str = ""  # the media type of the body

    @property
    def account(self) -> str:
        assert self.caller is not None, "an operation without scope has no caller"
        return self.caller.account

    @property
    def reader(self) -> str | None:
        """The account whose runs are shown; None for those of all (AUTH-008)."""
        assert self.caller is not None, "an operation without scope has no caller"
        return self.caller.reader

    @property
    def stopper(self) -> str | None:
        """The account whose runs may be stopped; None for all (AUTH-008)."""
        assert self.caller is not None, "an operation without scope has no caller"
        return self.caller.stopper

    def answer(self, content: Any, status: int = 200) -> Response:
        return codec.encode_response(content, self.media_type, status)


@dataclass(slots=True)
class WholeRequests:
    """Requests of one connection with the same head, one at a time.

    body: of the request in work, complete. checked: the call of the first of them that
    passed every check of its head. The checks of the others would find the same, but
    for the token, which may have been revoked meanwhile: token_hash is its hash.
    """

    request: Request
    body: bytes = b""
    checked: OperationCall | None = None
    token_hash: str = ""

    def note(self, checked: OperationCall) -> None:
        """The head has passed every check."""
        self.checked = checked
        authorization = self.request.headers.get("authorization")
        if authorization is not None:
            self.token_hash = hash_of_bearer(authorization)


async def perform(
    request: Request,
    operation: Operation,
    tokens: Tokens,
    max_body_bytes: int,
    hosts: AllowedHosts = ANY_HOST,
    *,
    whole: WholeRequests | None = None,
) -> Response:
    """Check a request in the fixed order and carry it out; refusals become problems.

    ERR-020: nothing is carried out before everything is checked. No variable keeps what
    was raised: in a cycle of references its frames would keep the body for long. whole:
    of the request, if its body is complete; otherwise the body is received.
    """
    refuse = operation.refusal_response or problem_response
    try:
        if whole is not None and whole.checked is not None:
            call = await _check_again(whole, whole.checked, operation, tokens)
        else:
            if hosts:
                hosts.check(request.headers.get("host", ""))
            call = await _check_head(request, operation, tokens)
            if whole is not None:
                whole.note(call)
                call = replace(call)
        if operation.body is not None:
            await _read_body(call, operation.body, operation, max_body_bytes, whole)
        return await operation.handler(call)
    except Refused as error:
        return refuse(error)
    except StoreFailed as error:
        _failures.report("a request could not use the database", str(error))
        return refuse(Refused("unavailable", "The database is not available."))
    except asyncio.CancelledError:
        # Only the server cancels it: when the token was revoked, or when the server
        # shuts down and has waited long enough.
        refused = Refused("unavailable", "The server is shutting down.")
        try:
            check_caller(request, operation, tokens)
        except Refused as error:
            refused = error
        return refuse(refused)


def check_caller(request: Request, operation: Operation, tokens: Tokens) -> None:
    """Raise Refused unless the caller may still send this request."""
    if operation.scope is not None:
        _caller(request, operation, operation.scope, tokens)


async def _check_head(
    request: Request, operation: Operation, tokens: Tokens
) -> OperationCall:
    check_version(request)
    caller = None
    if operation.scope is not None:
        caller = await _admit(request, operation, operation.scope, tokens)
        request.scope[ACCOUNT] = caller.account
    call = OperationCall(
        request,
        _path(request),
        _query(request, operation),
        _headers(request, operation),
        codec.negotiate_media_type(request, operation.writes)
        if operation.writes
        else "",
        caller,
    )
    if operation.has_streamed_body or operation.body is not None:
        call.body_type = codec.media_type_of(request, operation.reads)
    return call


async def _check_again(
    whole: WholeRequests, checked: OperationCall, operation: Operation, tokens: Tokens
) -> OperationCall:
    """The call of a request whose head equals one that was checked."""
    request, scope, caller = checked.request, operation.scope, None
    if scope is not None:
        caller = tokens.find_again(whole.token_hash, scope)
        if caller is None:
            caller = await _admit(request, operation, scope, tokens)
        request.scope[ACCOUNT] = caller.account
    return OperationCall(
        request,
        checked.path,
        checked.query,
        checked.headers,
        checked.media_type,
        caller,
        body_type=checked.body_type,
    )


async def _read_body(
    call: OperationCall,
    model: type[BaseModel],
    operation: Operation,
    max_body_bytes: int,
    whole: WholeRequests | None,
) -> None:
    # LIM-008: what is longer is not parsed.
    allowed = min(max_body_bytes, operation.max_body_bytes)
    is_control = allowed < max_body_bytes
    if whole is None:
        call.raw = await request_bodies.read_body(
            call.request, allowed, is_control=is_control
        )
    else:
        call.raw = whole.body
        request_bodies.check_size(len(call.raw), allowed, is_control=is_control)
    call.body = await bounded_parsing.read_message(model, call.raw, call.body_type)


async def _admit(
    request: Request, operation: Operation, scope: str, tokens: Tokens
) -> Caller:
    """As `_caller`; a token that is not known may have been added a moment ago."""
    try:
        return _caller(request, operation, scope, tokens)
    except Refused as refused:
        authorization = request.headers.get("authorization")
        if refused.code != "unauthenticated" or authorization is None:
            raise
    return await tokens.authenticate_again(authorization, scope)


def _caller(
    request: Request, operation: Operation, scope: str, tokens: Tokens
) -> Caller:
    """Whom the token names; without one, FLE-024 and BRD-018."""
    authorization = request.headers.get("authorization")
    if authorization is None:
        if operation.without_token:
            return NO_ACCOUNT
        if operation.local_account and is_local(request):
            return Caller(operation.local_account, SCOPES)
    return tokens.authenticate(authorization, scope)


def check_version(request: Request) -> None:
    """VER-002."""
    wanted = request.headers.get("proctor-version")
    if wanted is not None and not _is_supported(wanted):
        raise Refused(
            "unsupported_version",
            f"Version {wanted[:20]} is not supported; supported versions: "
            f"{VERSION_MIN} to {VERSION_MAX}.",
            requirement="VER-002",
        )


def _is_supported(version: str) -> bool:
    """Only what may be a version is remembered: a header can have many kilobytes."""
    return len(version) <= VERSION_CHARS_MAX and _is_in_range(version)


@lru_cache(maxsize=64)
def _is_in_range(version: str) -> bool:
    if not re.fullmatch(r"[0-9]{1,4}\.[0-9]{1,4}", version):
        return False
    return _pair(VERSION_MIN) <= _pair(version) <= _pair(VERSION_MAX)


def _pair(version: str) -> tuple[int, int]:
    major, _, minor = version.partition(".")
    return int(major), int(minor)


def _path(request: Request) -> Mapping[str, str]:
    for name, value in request.path_params.items():
        pattern, code = PATH_PATTERNS[name]
        if not re.fullmatch(pattern, value):
            raise Refused(
                code,
                f"The {name} of the path {in_words(pattern)}.",
                errors=[(f"path:{name}", in_words(pattern, value))],
            )
    return request.path_params


def _query(request: Request, operation: Operation) -> Mapping[str, str]:
    """ERR-014: the values obey their schemas; unknown names are refused, too."""
    values: dict[str, str] = {}
    if not request.scope["query_string"] and not operation.required_query:
        return values
    if request.scope["query_string"].count(b"&") > QUERY_PARAMETERS_MAX:
        raise Refused(
            "invalid_request",
            f"The query has more than {QUERY_PARAMETERS_MAX} parameters.",
            errors=[("query:", f"must not have more than {QUERY_PARAMETERS_MAX}")],
        )
    errors = []
    for name, value in request.query_params.multi_items():
        if name not in operation.query:
            errors.append((f"query:{name}", "this operation has no such parameter"))
        elif name in values:
            errors.append((f"query:{name}", "must not be repeated"))
        elif not re.fullmatch(QUERY_PATTERNS[name], value):
            errors.append((f"query:{name}", in_words(QUERY_PATTERNS[name], value)))
        elif name in QUERY_RANGES and not _in_range(name, value):
            least, most = QUERY_RANGES[name]
            errors.append((f"query:{name}", f"must be from {least} to {most}"))
        values[name] = value
    errors += [
        (f"query:{name}", "is required")
        for name in operation.required_query
        if name not in values
    ]
    if errors:
        raise Refused("invalid_request", "A query parameter is wrong.", errors=errors)
    return values


def _in_range(name: str, value: str) -> bool:
    least, most = QUERY_RANGES[name]
    return least <= float(value) <= most


def _headers(request: Request, operation: Operation) -> Mapping[str, str]:
    """ERR-014: the headers of the operation. ERR-017: no others are looked at."""
    values = {}
    for name in operation.headers:
        value = request.headers.get(name)
        if value is None:
            continue
        pattern = HEADER_PATTERNS.get(name)
        if pattern is not None and not re.fullmatch(pattern, value):
            raise Refused(
                "invalid_request",
                f"The header {name} {in_words(pattern, value)}.",
                errors=[(f"header:{name}", in_words(pattern, value))],
            )
        values[name] = value
    return values
