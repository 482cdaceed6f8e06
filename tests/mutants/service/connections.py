"""Mutants of limits: what one connection may send, and one account may hold."""

from __future__ import annotations

from collections.abc import Awaitable
from dataclasses import replace
from typing import Any

from starlette.requests import Request
from starlette.responses import Response

from reference_server import __main__ as server_main
from reference_server import app
from reference_server.app import Application
from reference_server.http import dispatch
from reference_server.http.connections.bounded_connection import BoundedConnection
from reference_server.http.connections.connection_limits import ConnectionLimits
from reference_server.http.dispatch import Operation
from reference_server.rules import capacity, effects
from reference_server.rules.capacity import Quota
from reference_server.rules.lifecycle import Refuse
from reference_server.rules.run import Session
from reference_server.runs import account_usage
from reference_server.settings import Settings
from tests.mutants import mutant, put

LARGE = 2**30


def change_limits(**wrong_limits: Any) -> None:
    right = server_main._connection_limits

    def wrong(settings: Settings) -> ConnectionLimits:
        return replace(right(settings), **wrong_limits)

    put(server_main, "_connection_limits", wrong)


@mutant("LIM-001")
def reads_headers_of_any_size() -> None:
    """One request without a token can fill the memory."""
    change_limits(header_bytes=LARGE, request_line_bytes=LARGE, header_count=LARGE)


@mutant("LIM-002")
def waits_for_headers_for_ever() -> None:
    """A client that sends nothing holds a connection that others need."""
    change_limits(header_timeout_s=1e9)


@mutant("LIM-002")
def waits_as_long_as_headers_come_byte_by_byte() -> None:
    """A client that sends a byte now and then holds a connection that others need."""
    right = BoundedConnection._feed_head

    def wrong(self: BoundedConnection, data: bytes, position: int) -> int:
        end = right(self, data, position)
        if self._head_size:
            self._deadline = self.loop.time() + self._limits.header_timeout_s
        return end

    put(BoundedConnection, "_feed_head", wrong)


@mutant("LIM-003")
def waits_for_bodies_for_ever() -> None:
    """A client that breaks off its request holds a connection and its memory."""
    change_limits(body_grace_s=1e9)


def announce(**limits: Any) -> None:
    """Run the server with other settings; what it announces follows from them."""
    right = app.build

    def wrong(settings: Settings, *parts: Any) -> Application:
        return right(settings.model_copy(update=limits), *parts)

    put(server_main, "build", wrong)


@mutant("LIM-006")
def lets_a_session_live_on_heartbeats() -> None:
    """A policy that hangs holds a simulator that others need."""
    announce(heartbeat_s_max=5.0)

    def wrong(session: Session, now: float, _heartbeat_s_max: float) -> None:
        effects.extend_lease(session, now)

    put(effects, "extend_without_turn", wrong)


@mutant("LIM-008")
def reads_long_bodies_of_every_operation() -> None:
    """A heartbeat can have the megabytes of a chunk of actions."""
    right = dispatch.perform

    def wrong(
        request: Request, operation: Operation, *others: Any
    ) -> Awaitable[Response]:
        return right(request, replace(operation, max_body_bytes=LARGE), *others)

    put(app, "perform", wrong)


@mutant("LIM-008")
def reads_long_bodies_without_a_declared_length() -> None:
    """A heartbeat can have the megabytes of a chunk if it does not say so before."""
    right = dispatch.perform

    def wrong(
        request: Request, operation: Operation, *others: Any
    ) -> Awaitable[Response]:
        if "content-length" not in request.headers:
            operation = replace(operation, max_body_bytes=LARGE)
        return right(request, operation, *others)

    put(app, "perform", wrong)


@mutant("LIM-007")
def opens_any_number_of_runs() -> None:
    """One account fills the database, and the others wait behind its runs."""
    announce(max_open_runs=20)
    put(account_usage, "below_quota", lambda _open_runs, _open_runs_max: None)


@mutant("LIM-009")
def keeps_any_number_of_keys() -> None:
    """One account fills the database with keys that are never repeated."""
    announce(max_idempotency_keys=20)
    right = capacity.below_storage_quota

    def wrong(has: Quota, most: Quota, *, has_key: bool) -> Refuse | None:
        del has_key
        return right(has, most, has_key=False)

    put(account_usage, "below_storage_quota", wrong)


@mutant("LIM-010")
def stores_any_number_of_bytes() -> None:
    """One account fills the disk, and no result of another one can be stored."""
    announce(max_stored_bytes=20_000)
    right = capacity.below_storage_quota

    def wrong(has: Quota, most: Quota, *, has_key: bool) -> Refuse | None:
        return right(has._replace(stored_bytes=0), most, has_key=has_key)

    put(account_usage, "below_storage_quota", wrong)
