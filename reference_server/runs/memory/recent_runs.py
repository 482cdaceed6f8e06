"""The runs that were used last: kept in memory, so that the next request finds them."""

from __future__ import annotations

from collections import OrderedDict

from reference_server.rules.runs.run import Run

# Runs kept in memory although no request uses them at the moment, and how many
# episodes they may have together: these are most of a run in memory.
CACHED_RUNS_MAX = 256
CACHED_EPISODES_MAX = 2**15


class RecentRuns:
    """Keeps at most so many runs; the one used longest ago is dropped first."""

    def __init__(self) -> None:
        self._runs: OrderedDict[str, Run] = OrderedDict()
        self._episodes = 0

    def is_last(self, run: Run) -> bool:
        """Whether no other run was kept since, and it is kept still."""
        return next(reversed(self._runs.values()), None) is run

    def keep(self, run: Run) -> None:
        """The run is used now; the last one is kept, however large it is."""
        if self._runs.get(run.run_id) is run:
            self._runs.move_to_end(run.run_id)
            return
        self.drop(run.run_id)
        self._runs[run.run_id] = run
        self._episodes += run.total
        while len(self._runs) > 1 and (
            len(self._runs) > CACHED_RUNS_MAX or self._episodes > CACHED_EPISODES_MAX
        ):
            self.drop(next(iter(self._runs)))

    def drop(self, run_id: str) -> None:
        """Keep the run no more, if it was kept."""
        run = self._runs.pop(run_id, None)
        if run is not None:
            self._episodes -= run.total
