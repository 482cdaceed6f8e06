"""Scores of runs; that of a run at rest is computed once.

It caches only scores of stored results, and these never change: a run with the same
number of results has the same ones. It does not know how a score is computed.
"""

from __future__ import annotations

from collections.abc import Sequence

from reference_record.generated.answers import Score
from reference_server.rules.runs.run import Episode, Run, RunHead
from reference_server.runs.run_reader import RunReader
from reference_server.views import run_views

CACHED_SCORES_MAX = 256


class ScoreCache:
    """Schema Score of each run, by its id."""

    def __init__(self) -> None:
        # run_id → state, results, score
        self._cache: dict[str, tuple[str, int, Score]] = {}

    async def get(self, reader: RunReader, run_id: str, account: str | None) -> Score:
        """The score, in every state (SCORE-010). Refused like `RunReader.get`."""
        if run_id in self._cache:
            again = await reader.read_view(run_id, account, self._cached_score)
            if again is not None:
                return again
        return await reader.read_view(run_id, account, self._compute_score, end=None)

    def _cached_score(self, run: RunHead, _: object) -> Score | None:
        state, scored, score = self._cache.get(run.run_id, (None, 0, None))
        return score if (state, scored) == (run.state, run.scored) else None

    def _compute_score(self, run: RunHead, episodes: Sequence[Episode]) -> Score:
        score = run_views.score_view(run, episodes)
        if not isinstance(run, Run):  # a result that only memory has may be lost
            self._cache[run.run_id] = run.state, run.scored, score
            if len(self._cache) > CACHED_SCORES_MAX:
                del self._cache[next(iter(self._cache))]
        return score
