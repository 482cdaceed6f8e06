"""Why sessions ended, for as long as their run may be asked: until a restart (DET-005).

A run leaves memory when others are used, and it is not stored why its sessions ended.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping

from reference_server.rules.runs.run import ENDED_SESSIONS_MAX, Run, Session, SessionEnd
from reference_server.runs.memory.run_events import Departure, RunFollower

# Ended sessions of all runs together, at some 500 bytes each.
SESSIONS_MAX = 2**16


class EndedSessions(RunFollower):
    """Keeps ended sessions by run.

    The run for which no session has ended for the longest time is forgotten first.
    """

    def __init__(self) -> None:
        self._of_runs: OrderedDict[str, dict[str, SessionEnd]] = OrderedDict()
        self._count = 0

    def __len__(self) -> int:
        return self._count

    def note(self, run_id: str, session: Session) -> None:
        """A session has ended."""
        ended = self._of_runs.setdefault(run_id, {})
        self._of_runs.move_to_end(run_id)
        self._count -= len(ended)
        ended[session.session_id] = session.ended_by or "unknown"
        if len(ended) > ENDED_SESSIONS_MAX:
            del ended[next(iter(ended))]
        self._count += len(ended)
        while self._count > SESSIONS_MAX:
            self.forget(next(iter(self._of_runs)))

    def left(self, run: Run, why: Departure) -> None:
        if why == "deleted":
            self.forget(run.run_id)

    def of(self, run_id: str) -> Mapping[str, SessionEnd]:
        """Why those of a run ended, by their ids, the last one last."""
        return self._of_runs.get(run_id, {})

    def forget(self, run_id: str) -> None:
        """The run was deleted, or others need the room."""
        self._count -= len(self._of_runs.pop(run_id, {}))
