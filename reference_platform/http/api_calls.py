"""From HTTP to an operation of the hosting API and back: what all have in common.

A request is authenticated by a key; its body is decoded into one structure, and refused
by what is wrong in it. Every refusal is a problem of the standard.
"""

from __future__ import annotations

import contextlib
import logging
import re
import sqlite3
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from functools import partial
from typing import Any, Final, TypeVar

import msgspec
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from reference_platform.accounts.account_keys import NOTED_S, Key
from reference_platform.accounts.account_rules import Account
from reference_platform.accounts.organisations import Owner
from reference_platform.parts import Parts
from reference_record.texts.timestamps import timestamp
from reference_server.http.auth import unauthenticated
from reference_server.http.bodies.request_bodies import read_body
from reference_server.http.codec import pointer
from reference_server.http.problems import problem_response
from reference_server.http.tokens.open_requests import OpenRequests
from reference_server.rules.refusal import Refused, lacks_scope

log = logging.getLogger("proctor.hosting")

BODY_BYTES_MAX: Final = 2**16
_UNKNOWN_FIELD: Final = re.compile(r"Object contains unknown field `(.*)`", re.DOTALL)
Body = TypeVar("Body")


@dataclass(frozen=True, slots=True)
class ApiCall:
    """One request. key, account: of its caller; None where none is needed."""

    request: Request
    parts: Parts
    key: Key | None = None
    caller: Account | None = None

    @property
    def account(self) -> Account:
        assert self.caller is not None, "an operation without scope has no caller"
        return self.caller

    @property
    def owner(self) -> Owner:
        """Whom the key acts for: the account, or an organisation of it."""
        assert self.key is not None, "an operation without scope has no key"
        return Owner(self.key.owner, bool(self.key.organisation))

    @property
    def now(self) -> float:
        return self.parts.clock()

    @property
    def address(self) -> str:
        return (self.request.client or ("",))[0]

    def path(self, name: str) -> str:
        return str(self.request.path_params[name])

    async def body(self, kind: type[Body]) -> Body:
        """Raises Refused, which points at what is wrong."""
        media_type = self.request.headers.get("content-type", "").partition(";")[0]
        if media_type.strip().lower() != "application/json":
            raise Refused("unsupported_media_type", "The body is not JSON.")
        data = await read_body(self.request, BODY_BYTES_MAX)
        try:
            return msgspec.json.decode(data, type=kind)
        except msgspec.ValidationError as error:
            text, _, at = str(error).partition(" - at `$")
            place = at.rstrip("`").replace(".", "/").replace("[", "/")
            place = place.replace("]", "")
            if unknown := _UNKNOWN_FIELD.fullmatch(text):
                place += pointer([unknown[1]])  # ERR-003
            errors = [(place, text)]
            raise Refused("invalid_request", f"{text}.", errors=errors) from error
        except msgspec.DecodeError as error:
            raise Refused("malformed_body", "The body is not JSON.") from error


Handler = Callable[[ApiCall], Awaitable[Response]]


@dataclass(frozen=True, slots=True)
class LastingEndpoint:
    """An endpoint that ends an answer once its caller may not have it (HST-017).

    answer: handles every exception. check: raises Refused for a request that may not go
    on; it is made again while the request is open.
    """

    answer: Callable[[Request], Awaitable[Response]]
    check: Callable[[Request], object]
    open_requests: OpenRequests

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        request = Request(scope, receive)
        await self.open_requests.answer(
            request, partial(self._look, request), partial(self.answer, request),
            problem_response, send,
        )  # fmt: skip

    def _look(self, request: Request) -> None:
        """Another program that locks the database ends nothing."""
        with contextlib.suppress(sqlite3.OperationalError):
            self.check(request)


class EveryMethod:
    """An endpoint of every method: Starlette lets a plain function have GET alone."""

    def __init__(self, answer: Callable[[Request], Awaitable[Response]]) -> None:
        self._answer = answer

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        response = await self._answer(Request(scope, receive))
        await response(scope, receive, send)


def endpoint_of(
    parts: Parts,
    handlers: dict[str, tuple[Handler, str | None]],
    open_requests: OpenRequests,
) -> LastingEndpoint:
    """The endpoint of a path. handlers: method → handler, and the scope that it needs.

    HST-014: `host` is that of an administrator, whatever the scopes of its key.
    """

    handlers = handlers | ({"HEAD": handlers["GET"]} if "GET" in handlers else {})

    def check(request: Request) -> None:
        _, scope = handlers.get(request.method, (None, None))
        if scope is not None:
            _authenticate(parts, request, scope)

    async def answer(request: Request) -> Response:
        if request.method not in handlers:  # ERR-010, ERR-022
            text = f"{request.method} is not a method of this path."
            allowed = {"Allow": ", ".join(sorted(handlers))}
            return problem_response(Refused("method_not_allowed", text), allowed)
        try:
            handler, scope = handlers[request.method]
            if request.method not in ("GET", "HEAD"):
                await parts.database.until_free()
            key = account = None
            if scope is not None:
                key, account = _authenticate(parts, request, scope)
            return await handler(ApiCall(request, parts, key, account))
        except Refused as refused:
            return problem_response(refused)
        except sqlite3.OperationalError as error:
            log.warning("a request was not served: %s", error)
            return problem_response(database_refusal())
        except Exception:
            log.exception("a request failed")
            defect = Refused("internal_error", "The platform has a defect.")
            return problem_response(defect)

    return LastingEndpoint(answer, check, open_requests)


def database_refusal() -> Refused:
    """The database is locked by another program, or its disk is full."""
    text = "The database of the platform cannot be used now. Try it again."
    return Refused("unavailable", text)


# Such a token has no account, and so enters no track and hands nothing in.
_OF_THE_SERVER = (
    "a token of the server, such as its operator's, where a key of an account is needed"
)


def _authenticate(parts: Parts, request: Request, scope: str) -> tuple[Key, Account]:
    authorization = request.headers.get("authorization", "")
    scheme, _, secret = authorization.partition(" ")
    key = parts.keys.find(secret.strip(), parts.clock())
    if scheme.lower() != "bearer" or key is None:
        raise unauthenticated(authorization, _OF_THE_SERVER)
    now = parts.clock()
    if key.used_at is None or now - key.used_at > NOTED_S:
        parts.keys.note_used({key.hash: now})
    account = parts.accounts.get(key.account)
    if scope not in key.scopes.split():
        raise lacks_scope(scope, "key")
    if scope == "host" and not account.is_administrator:
        raise Refused("forbidden", "The account is no administrator.")
    return key, account


def json_response(content: Any, status: int = 200) -> Response:
    return Response(
        msgspec.json.encode(content),
        status_code=status,
        media_type="application/json",
        headers={"Cache-Control": "no-store"},
    )


def maybe_time(at: float | None) -> str | None:
    return None if at is None else timestamp(at)


def public_url(parts: Parts, request: Request) -> str:
    """Where people reach the server: as the host says, or as this request did."""
    if parts.public_url:
        return parts.public_url.rstrip("/")
    return f"{request.url.scheme}://{request.headers.get('host', '')}"
