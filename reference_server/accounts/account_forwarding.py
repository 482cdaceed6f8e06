"""Requests that the program of the accounts answers are passed on to it, as they are.

Its operations are below /v1/hosting and its pages below /hosting. Bodies are streamed
in both directions: an upload is never kept in memory. It knows the address of the
client from `x-forwarded-for`, which this server writes anew.
"""

from __future__ import annotations

from collections.abc import AsyncIterator, Sequence

import httpcore
from starlette.types import ASGIApp, Receive, Scope, Send

from reference_server.accounts.account_service import NOT_REACHED, AccountService
from reference_server.http.dispatch import OPERATION
from reference_server.http.problems import problem_response
from reference_server.rules.refusal import Refused
from reference_server.settings.allowed_hosts import AllowedHosts
from reference_server.telemetry.log_output import REQUEST_ID

PATHS = ("/v1/hosting/{rest:path}", "/hosting", "/hosting/{rest:path}")
_TIMEOUTS = {"connect": 2.0, "pool": 10.0}
# Headers of a single connection, and those that this server writes itself.
_NOT_PASSED_ON = {
    *(b"connection", b"keep-alive", b"proxy-connection", b"te", b"trailer"),
    *(b"transfer-encoding", b"upgrade", b"expect", b"x-request-id"),
    *(b"x-forwarded-for", b"x-forwarded-proto"),
}
_NOT_SENT_BACK = _NOT_PASSED_ON | {b"date", b"server", b"proctor-version"}


class _ClientLeft(Exception):
    """The client left before its request was complete."""


class AccountForwarding:
    """Answers a request with what the program of the accounts answers."""

    def __init__(self, service: AccountService, hosts: AllowedHosts) -> None:
        self._service, self._hosts = service, hosts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        scope[OPERATION] = "hosting"
        app: ASGIApp | None = None
        is_begun = False

        async def send_and_note(message: dict[str, object]) -> None:
            nonlocal is_begun
            is_begun = True
            await send(message)

        try:
            self._hosts.check(_header(scope, b"host").decode("latin-1"))
            await self._pass_on(scope, receive, send_and_note)  # type: ignore[arg-type]
        except _ClientLeft:
            return
        except Refused as refused:
            app = problem_response(refused)
        except NOT_REACHED:
            if is_begun:  # too late for a problem; the connection is closed
                raise
            text = "The accounts of this server cannot be reached now."
            app = problem_response(Refused("unavailable", text))
        if app is not None:
            await app(scope, receive, send)

    async def _pass_on(self, scope: Scope, receive: Receive, send: Send) -> None:
        target = scope.get("raw_path") or scope["path"].encode()
        if scope["query_string"]:
            target += b"?" + scope["query_string"]
        names = {name for name, _ in scope["headers"]}
        has_body = bool(names & {b"content-length", b"transfer-encoding"})
        async with self._service.connections.stream(
            scope["method"],
            httpcore.URL(scheme=b"http", host=b"accounts", port=None, target=target),
            headers=_request_headers(scope),
            content=_read_body(receive) if has_body else None,
            extensions={"timeout": _TIMEOUTS},
        ) as response:
            kept = [
                (name.lower(), value)
                for name, value in response.headers
                if name.lower() not in _NOT_SENT_BACK
            ]
            await send(
                {
                    "type": "http.response.start",
                    "status": response.status,
                    "headers": kept,
                }
            )
            left, is_complete = _length_of(response.headers), False
            async for part in response.aiter_stream():
                # A client that has the whole answer may send its next request at once:
                # the last part must be known as the last one.
                left = None if left is None else left - len(part)
                is_complete = left == 0
                await send(
                    {
                        "type": "http.response.body",
                        "body": part,
                        "more_body": not is_complete,
                    }
                )
        if not is_complete:
            await send({"type": "http.response.body", "body": b"", "more_body": False})


def _length_of(headers: Sequence[tuple[bytes, bytes]]) -> int | None:
    lengths = [value for name, value in headers if name.lower() == b"content-length"]
    return int(lengths[0]) if lengths else None


def _request_headers(scope: Scope) -> list[tuple[bytes, bytes]]:
    headers = [
        (name, value) for name, value in scope["headers"] if name not in _NOT_PASSED_ON
    ]
    if b"chunked" in _header(scope, b"transfer-encoding"):
        headers.append((b"transfer-encoding", b"chunked"))
    client = (scope.get("client") or ("-",))[0]
    return [
        *headers,
        (b"x-forwarded-for", str(client).encode("latin-1", "replace")),
        (b"x-forwarded-proto", str(scope["scheme"]).encode()),
        (b"x-request-id", (REQUEST_ID.get() or "").encode()),
    ]


def _header(scope: Scope, wanted: bytes) -> bytes:
    return next((value for name, value in scope["headers"] if name == wanted), b"")


async def _read_body(receive: Receive) -> AsyncIterator[bytes]:
    more = True
    while more:
        message = await receive()
        if message["type"] == "http.disconnect":
            raise _ClientLeft
        more = message.get("more_body", False)
        if part := message.get("body", b""):
            yield part
