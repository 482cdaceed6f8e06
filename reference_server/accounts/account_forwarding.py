"""Requests that the program of the accounts answers are passed on to it, as they are.

Its operations are below /v1/hosting and its pages below /hosting. Bodies are streamed
in both directions: an upload is never kept in memory. It knows the address of the
client from `x-forwarded-for`, which this server writes anew.
"""

from __future__ import annotations

import httpcore
from starlette.types import Receive, Scope, Send

from reference_server.accounts.account_service import (
    NOT_REACHED,
    ORIGIN,
    AccountService,
)
from reference_server.http.dispatch import OPERATION
from reference_server.http.problems import problem_response
from reference_server.outgoing.streamed_exchange import (
    HOP_BY_HOP,
    ClientLeft,
    Headers,
    StreamedExchange,
    headers_without,
)
from reference_server.rules.refusal import Refused
from reference_server.settings.allowed_hosts import AllowedHosts
from reference_server.telemetry.log_output import REQUEST_ID

PATHS = ("/v1/hosting/{rest:path}", "/hosting", "/hosting/{rest:path}")
# Headers of a single connection, and those that this server writes itself.
_NOT_PASSED_ON = HOP_BY_HOP | {
    *(b"x-request-id", b"x-forwarded-for", b"x-forwarded-proto"),
}
_NOT_SENT_BACK = _NOT_PASSED_ON | {b"date", b"server", b"proctor-version"}


class AccountForwarding:
    """Answers a request with what the program of the accounts answers."""

    def __init__(self, service: AccountService, hosts: AllowedHosts) -> None:
        self._service, self._hosts = service, hosts

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        scope[OPERATION] = "hosting"
        exchange = StreamedExchange(scope, receive, send)
        try:
            self._hosts.check(_header(scope, b"host").decode("latin-1"))
            await exchange.answer(
                self._service.stream,
                ORIGIN,
                _request_headers(scope),
                kept_back=_NOT_SENT_BACK,
            )
        except ClientLeft:
            return
        except Refused as refused:
            await problem_response(refused)(scope, receive, send)
        except NOT_REACHED as error:
            if exchange.is_begun:  # too late for a problem; the connection is closed
                raise
            text = "The accounts of this server cannot be reached now."
            if isinstance(error, httpcore.PoolTimeout):
                text = "This server passes on as many requests as it can at a time."
            away = Refused("unavailable", text)
            await problem_response(away)(scope, receive, send)


def _request_headers(scope: Scope) -> Headers:
    client = (scope.get("client") or ("-",))[0]
    return [
        *headers_without(scope, _NOT_PASSED_ON),
        (b"x-forwarded-for", str(client).encode("latin-1", "replace")),
        (b"x-forwarded-proto", str(scope["scheme"]).encode()),
        (b"x-request-id", (REQUEST_ID.get() or "").encode()),
    ]


def _header(scope: Scope, wanted: bytes) -> bytes:
    return next((value for name, value in scope["headers"] if name == wanted), b"")
