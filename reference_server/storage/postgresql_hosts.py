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

# How long packets may stay without acknowledgement. Below the shortest lease that a
# busy cluster uses and the time of its renewal: a retry is in time.
UNACKNOWLEDGED_S = 2.0
_OPTION: int | None = getattr(socket, "TCP_USER_TIMEOUT", None)  # Linux


class WatchedConnection(asyncpg.Connection):  # type: ignore[misc]
    """A connection that ends when its host has vanished."""

    def __init__(
        self, protocol: Any, transport: asyncio.Transport, *rest: Any, **options: Any
    ) -> None:
        super().__init__(protocol, transport, *rest, **options)
        used = transport.get_extra_info("socket")
        if used is not None and used.family != socket.AF_UNIX and _OPTION is not None:
            used.setsockopt(socket.IPPROTO_TCP, _OPTION, round(UNACKNOWLEDGED_S * 1000))


async def connect(**options: Any) -> asyncpg.Connection:
    """A connection to the first host that answers, and can be written to.

    options: those of `asyncpg.connect`; host and port may be lists. Raises as it does,
    for the last host that failed.
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
            return done.pop()


def _end(attempt: asyncio.Future[asyncpg.Connection]) -> None:
    """Close what was connected beside the chosen one."""
    if not attempt.cancelled() and attempt.exception() is None:
        attempt.result().terminate()
