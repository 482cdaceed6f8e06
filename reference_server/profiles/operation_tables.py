"""The operations of the enabled profiles, for the dispatch."""

from __future__ import annotations

from collections.abc import Callable

from reference_server.http.dispatch import Operation
from reference_server.http.handlers import Handlers
from reference_server.profiles.ebench.task_handlers import EbenchHandlers
from reference_server.profiles.flageval.evaluation_handlers import FlagevalHandlers


def profile_tables(handlers: Handlers) -> dict[str, dict[str, Operation]]:
    """path → method → operation, of every enabled profile."""
    adapters: dict[str, Callable[[Handlers], EbenchHandlers | FlagevalHandlers]]
    adapters = {"ebench": EbenchHandlers, "flageval": FlagevalHandlers}
    table: dict[str, dict[str, Operation]] = {}
    for name in handlers.settings.enabled_profiles:
        table |= adapters[name](handlers).table()
    return table
