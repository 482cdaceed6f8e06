"""Scores as they are asked for: that of a run at rest is computed once.

It keeps what was computed of stored results only, and these never change: as long as a
run has as many of them, it has the same. It must not know how a score is computed.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from reference_server.http import views
from reference_server.rules.run import Episode, Run, RunHead
from reference_server.runs.registry import RunBook

SCORES_KEPT = 256

Json = dict[str, Any]


class Scores:
    """Schema Score of each run, by its id."""

    def __init__(self) -> None:
        # run_id → state, results, score
        self._kept: dict[str, tuple[str, int, Json]] = {}

    async def of(self, book: RunBook, run_id: str, account: str) -> Json:
        """The score of the account's run. Raises Refused like `RunBook.get`."""
        if run_id in self._kept:
            again = await book.look(run_id, account, self._again)
            if again is not None:
                return again
        return await book.look(run_id, account, self._anew, end=None)

    def _again(self, run: RunHead, _: object) -> Json | None:
        state, scored, score = self._kept.get(run.run_id, (None, 0, {}))
        return score if (state, scored) == (run.state, run.scored) else None

    def _anew(self, run: RunHead, episodes: Sequence[Episode]) -> Json:
        score = views.score_view(run, episodes)
        if not isinstance(run, Run):  # what only memory has may yet be lost
            self._kept[run.run_id] = run.state, run.scored, score
            if len(self._kept) > SCORES_KEPT:
                del self._kept[next(iter(self._kept))]
        return score
