"""Limits of all connections of the server together, and which connection gives way.

A `ConnectionLimiter` counts connections by address, chooses the one to close when a
limit is reached, and lets each connection check its deadlines once a second. It knows
no HTTP: what a connection reads and answers is in `bounded_connection.py`.
"""

from __future__ import annotations

import asyncio
from collections.abc import Iterable
from dataclasses import dataclass
from ipaddress import IPv6Address, ip_address
from typing import Protocol

from reference_server.process.freed_memory import FreedMemory

# The most that a request line and headers may have (LIM-001); browsers and proxies send
# a quarter of it.
HEADER_BYTES = 2**15
# Refused connections that may wait for their 503 at once; others are closed unanswered.
REFUSED_MAX = 64
# After a search for an idle connection found none, as long none is searched for.
SEARCH_PAUSE_S = 0.05


@dataclass(frozen=True, slots=True)
class ConnectionLimits:
    """Bounds of one connection, and of all of them. Bytes and seconds.

    header_bytes: of a request line and headers; request_line_bytes, header_count: of
    these. header_timeout_s: from the first byte of a request, or from the connection,
    to the end of its headers. body_grace_s, rate_min: a body, and an answer that is not
    read, may take that long and in addition 1 s per `rate_min` bytes.
    passed_over_bytes, passed_over_rate_min: the same for the rest of a body that was
    answered before its end. close_s: for a client to read a refusal and to hang up.
    held_bytes: read ahead of a request that has no answer yet. body_bytes: of a body
    that operations read.

    connections, per_address: how many at once. bodies_bytes, answers_bytes: held at
    once in bodies larger than `small_body_bytes`, and in answers that are not read.
    """

    connections: int = 2000
    per_address: int = 1500
    header_bytes: int = HEADER_BYTES
    request_line_bytes: int = 2**14
    header_count: int = 100
    header_timeout_s: float = 10.0
    keep_alive_s: float = 75.0
    body_grace_s: float = 10.0
    rate_min: int = 2**14
    passed_over_bytes: int = 2**28
    passed_over_rate_min: int = 2**18
    close_s: float = 2.0
    held_bytes: int = 2**15
    body_bytes: int = 2**23
    small_body_bytes: int = 2**15
    bodies_bytes: int = 2**26
    answers_bytes: int = 2**26
    check_interval_s: float = 1.0


class Connection(Protocol):
    """The part of a connection that the limiter uses."""

    loop: asyncio.AbstractEventLoop
    address: str

    @property
    def is_receiving(self) -> bool:
        """Whether the body of its request is not yet complete."""

    def abort(self) -> None:
        """Close it at once."""

    def refuse_unavailable(self) -> None:
        """Answer the request that it receives with `unavailable`, and close it."""

    def close_if_idle(self) -> bool:
        """Close it unless a request is in work; whether it was closed."""

    def check_deadlines(self, now: float) -> None:
        """Close it if it is too slow."""


class SharedMemory:
    """Bytes held by connections, up to a limit for all of them."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._total = 0
        self._freed = FreedMemory()
        self._by_connection: dict[Connection, int] = {}  # longest holder first

    def hold(self, connection: Connection, size: int) -> None:
        """Set how much a connection holds; 0 for nothing."""
        self._total += size - self._by_connection.pop(connection, 0)
        if size:
            self._by_connection[connection] = size
            self._freed.note(self._total)

    def give_back_freed(self) -> None:
        """Call it now and then."""
        self._freed.look(self._total)

    @property
    def is_exceeded(self) -> bool:
        return self._total > self._limit

    def holders(self) -> list[Connection]:
        """The connections of the address that holds most, the longest holder first."""
        by_address: dict[str, int] = {}
        for connection, size in self._by_connection.items():
            address = connection.address
            by_address[address] = by_address.get(address, 0) + size
        most = max(by_address, key=by_address.__getitem__, default="")
        return [holder for holder in self._by_connection if holder.address == most]


class ConnectionLimiter:
    """The connections of one server. Used in its event loop only."""

    def __init__(self, limits: ConnectionLimits) -> None:
        self.limits = limits
        self.bodies = SharedMemory(limits.bodies_bytes)
        self.answers = SharedMemory(limits.answers_bytes)
        self._by_address: dict[str, dict[Connection, None]] = {}  # oldest first
        self._leaving: set[Connection] = set()  # not counted, not yet closed
        self._count = 0
        self._search_again_at = 0.0
        self._timer: asyncio.TimerHandle | None = None

    def __len__(self) -> int:
        return self._count

    def admit(self, connection: Connection) -> bool:
        """Count a new connection. If there is no room, the oldest idle one is closed.

        It is one of the same address when that has its share, else one of the address
        with most. False if none is idle: the new connection is to be refused.
        """
        if self._timer is None:
            self._schedule_check(connection.loop)
        same = self._by_address.get(connection.address, {})
        now = connection.loop.time()
        if len(same) >= self.limits.per_address:
            if not self._make_room([same], now):
                return False
        elif self._count >= self.limits.connections:
            by_size = sorted(self._by_address.values(), key=len, reverse=True)
            if not self._make_room(by_size, now):
                return False
        self._by_address.setdefault(connection.address, {})[connection] = None
        self._count += 1
        return True

    @property
    def count(self) -> int:
        """Connections that are open, without those that are being refused."""
        return self._count

    def may_wait_refused(self, connection: Connection) -> bool:
        """Whether a refused connection may stay until it has its answer."""
        if len(self._leaving) >= REFUSED_MAX:
            return False
        self._leaving.add(connection)
        return True

    def remove(self, connection: Connection) -> None:
        """Forget a connection that is closed; harmless if it is unknown."""
        self.bodies.hold(connection, 0)
        self.answers.hold(connection, 0)
        self._leaving.discard(connection)
        same = self._by_address.get(connection.address, {})
        if connection in same:
            del same[connection]
            self._count -= 1
            if not same:
                del self._by_address[connection.address]

    def _make_room(self, groups: Iterable[dict[Connection, None]], now: float) -> bool:
        if now < self._search_again_at:
            return False
        for group in groups:
            for connection in group:
                if connection.close_if_idle():
                    # Now, and not when the transport has closed: other connections
                    # arrive before that.
                    self.remove(connection)
                    self._leaving.add(connection)
                    return True
        self._search_again_at = now + SEARCH_PAUSE_S
        return False

    def _schedule_check(self, loop: asyncio.AbstractEventLoop) -> None:
        interval_s = self.limits.check_interval_s
        self._timer = loop.call_later(interval_s, self._check_all, loop)

    def _check_all(self, loop: asyncio.AbstractEventLoop) -> None:
        """Check all connections by one timer, so that no request has to set one."""
        now = loop.time()
        groups = [*self._by_address.values(), self._leaving]
        for connection in [member for group in groups for member in group]:
            connection.check_deadlines(now)
        self.bodies.give_back_freed()
        self.answers.give_back_freed()
        self._timer = None
        if self._count or self._leaving:
            self._schedule_check(loop)


def shared_address(host: str) -> str:
    """The address by which a client is counted: for IPv6 its /64 network.

    One client can use all addresses of such a network.
    """
    if ":" not in host:
        return host
    address = ip_address(host.partition("%")[0])
    assert isinstance(address, IPv6Address)
    if address.ipv4_mapped is not None:
        return str(address.ipv4_mapped)
    return address.exploded[:19]
