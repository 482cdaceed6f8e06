"""Mutants of the HTTP layer: what one connection may send, and for how long."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from reference_server import __main__ as server_main
from reference_server.http.connection_limits import ConnectionLimits
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


@mutant("LIM-003")
def waits_for_bodies_for_ever() -> None:
    """A client that breaks off its request holds a connection and its memory."""
    change_limits(body_grace_s=1e9)
