"""Mutants of limits: what one connection may send, and one account may hold."""

from __future__ import annotations

from dataclasses import replace
from typing import Any
from weakref import WeakSet

from starlette.requests import Request

from reference_server import __main__ as server_main
from reference_server import app
from reference_server.http import application
from reference_server.http.connections.bounded_connection import BoundedConnection
from reference_server.http.connections.connection_limits import ConnectionLimits
from reference_server.http.dispatch import Operation
from reference_server.rules.capacity import Quota
from reference_server.rules.runs import effects
from reference_server.rules.runs.run import Session
from reference_server.runs.admission import account_usage
from reference_server.settings import Settings
from tests.mutants import Json, Row, instead_of, mutant, mutants, put

LARGE = 2**30
DESCRIBED = WeakSet[BoundedConnection]()  # whose latest request was `GET /v1`


@mutant("SVC-006", through=instead_of(BoundedConnection, "data_received"))
def describes_the_service_to_one_connection_at_a_time(
    right: Any, connection: BoundedConnection, data: bytes
) -> None:
    """A server with one thread hangs until the first client has gone."""
    others = [other for other in DESCRIBED if other is not connection]
    DESCRIBED.discard(connection)
    if data.startswith(b"GET /v1 "):
        DESCRIBED.add(connection)
        if any(not other.transport.is_closing() for other in others):
            return
    right(connection, data)


@mutants(
    Row(
        "reads_headers_of_any_size",
        ("LIM-001",),
        "One request without a token can fill the memory.",
        {"header_bytes": LARGE, "request_line_bytes": LARGE, "header_count": LARGE},
    ),
    Row(
        "waits_for_requests_for_ever",
        ("LIM-002", "LIM-003"),
        "A client that breaks off its request holds a connection that others need.",
        {"header_timeout_s": 1e9, "body_grace_s": 1e9},
    ),
)
def change_limits(wrong_limits: Json) -> None:
    """Let each connection have other limits than the settings say."""
    right = server_main._connection_limits

    def wrong(settings: Settings) -> ConnectionLimits:
        return replace(right(settings), **wrong_limits)

    put(server_main, "_connection_limits", wrong)


@mutant("LIM-002", through=instead_of(BoundedConnection, "_feed_head"))
def waits_as_long_as_headers_come_byte_by_byte(
    right: Any, self: BoundedConnection, data: bytes, position: int
) -> Any:
    """A client that sends a byte now and then holds a connection that others need."""
    end = right(self, data, position)
    if self._head_size:
        self._deadline = self.loop.time() + self._limits.header_timeout_s
    return end


@mutant("LIM-008", through=instead_of(application, "perform"))
def reads_long_bodies_of_every_operation(
    right: Any, request: Request, operation: Operation, *rest: Any, **kept: Any
) -> Any:
    """A heartbeat can have the megabytes of a chunk of actions."""
    return right(request, replace(operation, max_body_bytes=LARGE), *rest, **kept)


def announce(**limits: Any) -> None:
    """Run the server with other settings; what it announces follows from them."""
    right = app.build

    def wrong(settings: Settings, *parts: Any) -> application.Application:
        return right(settings.model_copy(update=limits), *parts)

    put(server_main, "build", wrong)


@mutant("LIM-006")
def lets_a_session_live_on_heartbeats() -> None:
    """A policy that hangs holds a simulator that others need."""
    announce(heartbeat_s_max=5.0)

    def wrong(session: Session, now: float, _heartbeat_s_max: float) -> None:
        effects.extend_lease(session, now)

    put(effects, "extend_without_turn", wrong)


@mutant("LIM-007")
def opens_any_number_of_runs() -> None:
    """One account fills the database, and the others wait behind its runs."""
    announce(max_open_runs=20)
    put(account_usage, "below_quota", lambda _open_runs, _open_runs_max: None)


@mutant("LIM-009", "LIM-010")
def stores_any_number_of_keys_and_bytes() -> None:
    """One account fills the disk, and no result of another one can be stored."""
    announce(max_idempotency_keys=20, max_stored_bytes=20_000)

    def wrong(right: Any, has: Quota, most: Quota, *, has_key: bool) -> Any:
        return right(has._replace(keys=0, stored_bytes=0), most, has_key=has_key)

    instead_of(account_usage, "below_storage_quota")(wrong)
