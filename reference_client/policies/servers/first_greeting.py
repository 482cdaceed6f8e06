"""Compares the greetings of a policy server: each connection of a run has the same.

A server may be started again with another model, or stand for several behind one
address. Whatever its protocol says of the model at the first contact is compared at
each new connection, so that no score is made of two policies.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from reference_client.policies.servers.server_faults import failed
from reference_client.policies.servers.wire_settings import as_json

_MISSING = object()
_ADVICE = (
    ". If each connection has a value of its own, `varying` in [server] of the mapping "
    "file lists the name"
)


class FirstGreeting:
    """The first greeting of a run; the connections of all its workers share it.

    varying: members that may differ on each connection, by dotted name; None where no
    mapping file can list them.
    """

    def __init__(self, varying: Sequence[str] | None = None) -> None:
        self._varying = varying
        self._lock = threading.Lock()
        self._first: dict[str, Any] | None = None

    def check(self, place: str, greeting: Any) -> None:
        """Raises ProctorError `policy_failed` if it is not the first one again."""
        members = dict(_members(greeting, ""))
        with self._lock:
            if self._first is None:
                self._first = members
        for name in self._first | members:
            before, now = (m.get(name, _MISSING) for m in (self._first, members))
            if not _says_the_same(before, now) and not self._may_vary(name):
                advice = "" if self._varying is None else _ADVICE
                raise failed(
                    place,
                    f"says {_said(name, now)} on a new connection, and said "
                    f"{_said(name, before)} on the first one of this run: another "
                    "policy may answer there now, and no score is made of two. Start "
                    f"the first one again, then continue the run{advice}",
                )

    def _may_vary(self, name: str) -> bool:
        return any(f"{name}.".startswith(f"{one}.") for one in self._varying or ())


def _members(value: Any, name: str) -> Iterator[tuple[str, Any]]:
    """The values in it by dotted name, without the tables around them."""
    if not isinstance(value, Mapping):
        yield name or "its greeting", as_json(value)
        return
    for key, inner in value.items():
        yield from _members(inner, f"{name}.{key}" if name else f"{key}")


def _says_the_same(before: Any, now: Any) -> bool:
    """In whatever order the members of a table come, and whether 1 is sent as 1.0."""
    match before, now:
        case Mapping(), Mapping():
            same_names = before.keys() == now.keys()
            return same_names and all(_says_the_same(before[k], now[k]) for k in now)
        case list(), list():
            return len(before) == len(now) and all(map(_says_the_same, before, now))
    if isinstance(before, bool) != isinstance(now, bool):
        return False
    return bool(before == now) or repr(before) == repr(now)  # nan, which equals nothing


def _said(name: str, value: Any) -> str:
    return f"no {name}" if value is _MISSING else f"{name} = {value!r:.200}"
