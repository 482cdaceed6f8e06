"""Connections to PostgreSQL on one host or on several, one of which can be written to.

A host that has lost its power, or its network, refuses nothing: packets to it vanish.
asyncpg tries one host after another and gives all of them one timeout, so such a host
would hide the others. Here all are tried at once. And a connection whose packets are
not acknowledged is lost after seconds, where TCP would repeat them for a quarter of an
hour. A PostgreSQL that is slow, or paused, acknowledges them. asyncpg is imported here.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Iterator, Sequence
from typing import Any

import asyncpg

# How long packets may stay without acknowledgement: a retry is in time for most leases.
UNACKNOWLEDGED_S = 2.0
# A statement may wait for long, with nothing on the way: a packet asks once a second
# whether the host is there. The names are those of Linux; others have not all of them.
_OPTIONS = {
    "TCP_USER_TIMEOUT": round(UNACKNOWLEDGED_S * 1000),
    "TCP_KEEPIDLE": 1,
    "TCP_KEEPINTVL": 1,
    "TCP_KEEPCNT": round(UNACKNOWLEDGED_S),
}


class WatchedConnection(asyncpg.Connection):  # type: ignore[misc]
    """A connection that ends when its host has vanished."""

    def __init__(
        self, protocol: Any, transport: asyncio.Transport, *rest: Any, **options: Any
    ) -> None:
        super().__init__(protocol, transport, *rest, **options)
        used = transport.get_extra_info("socket")
        if used is None or used.family == socket.AF_UNIX:
            return
        used.setsockopt(socket.SOL_SOCKET, socket.SO_KEEPALIVE, 1)
        for name, value in _OPTIONS.items():
            if (option := getattr(socket, name, None)) is not None:
                used.setsockopt(socket.IPPROTO_TCP, option, value)


async def connect(**options: Any) -> asyncpg.Connection:
    """A connection to the first host that answers, and can be written to.

    options: those of `asyncpg.connect`; host and port may be lists. Raises as it does,
    for a host that answers and cannot be written to, else for the first one.
    """
    options["connection_class"] = WatchedConnection
    hosts = list(_hosts_of(options))
    if len(hosts) == 1:
        return await asyncpg.connect(**options)
    options.setdefault("target_session_attrs", "read-write")
    tries = [
        asyncio.ensure_future(asyncpg.connect(**{**options, **host})) for host in hosts
    ]
    chosen: asyncio.Future[asyncpg.Connection] | None = None
    try:
        chosen = await _first_success(tries)
        return chosen.result()
    finally:
        for attempt in tries:
            if attempt is not chosen and not attempt.cancel():
                _end(attempt)


def _hosts_of(options: dict[str, Any]) -> Iterator[dict[str, Any]]:
    hosts, ports = options.get("host"), options.get("port")
    if not isinstance(hosts, (list, tuple)):
        yield {}
        return
    if not isinstance(ports, (list, tuple)):
        ports = [ports] * len(hosts)
    for host, port in zip(hosts, ports, strict=True):
        yield {"host": host, "port": port}


async def _first_success(
    tries: Sequence[asyncio.Future[asyncpg.Connection]],
) -> asyncio.Future[asyncpg.Connection]:
    waiting = set(tries)
    while True:
        done, waiting = await asyncio.wait(waiting, return_when=asyncio.FIRST_COMPLETED)
        for attempt in done:
            if attempt.exception() is None:
                return attempt
        if not waiting:
            return max(tries, key=_is_read_only)


def _is_read_only(failed: asyncio.Future[asyncpg.Connection]) -> bool:
    return isinstance(failed.exception(), asyncpg.TargetServerAttributeNotMatched)


def _end(attempt: asyncio.Future[asyncpg.Connection]) -> None:
    """Close what was connected beside the chosen one."""
    if not attempt.cancelled() and attempt.exception() is None:
        attempt.result().terminate()
