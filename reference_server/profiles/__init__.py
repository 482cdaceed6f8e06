"""Wires of other houses, offered beside our own when the setting `profiles` asks.

An adapter turns their words into ours and back. It calls the same routes, book, stage
and rules, and has no state, no SQL and no decision on a lifecycle of its own.
"""

from __future__ import annotations

from collections.abc import Callable

from reference_server.http.dispatch import Operation
from reference_server.http.handlers import Routes
from reference_server.profiles.ebench.handlers import Ebench
from reference_server.profiles.flageval.handlers import Flageval


def tables(routes: Routes) -> dict[str, dict[str, Operation]]:
    """path → method → operation, of every profile that the settings ask for."""
    doors: dict[str, Callable[[Routes], Ebench | Flageval]]
    doors = {"ebench": Ebench, "flageval": Flageval}
    table: dict[str, dict[str, Operation]] = {}
    for name in routes.settings.more_profiles:
        table |= doors[name](routes).table()
    return table
