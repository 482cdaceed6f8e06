"""Third-party API profiles, enabled by the setting `profiles`.

A profile offers the HTTP API of another evaluation system over the runs of this server.
Its handlers translate requests into calls of `runs/service.py`, like those of
`http/handlers.py`, and the results into that system's responses. It has no SQL and no
decision on the lifecycle of its own: whether a run or a session allows something is
decided by the rules. State of its own is only in `ebench/lost_answers.py` and
`ebench/long_chunks.py`.
"""

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
