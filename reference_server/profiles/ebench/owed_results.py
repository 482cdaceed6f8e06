"""Remembers the results of ended episodes that no client of EBench has received.

EBench's client writes a file for each `episode_result` that it is given, and is given
each only once, by the answer that ends the episode. When that answer is lost, with its
client or with this server, the result is owed: the answer to a later step has it
(EBE-031).

This is kept in memory only. A run that is seen for the first time, as after a restart,
is owed all results: nothing shows which were received, and a client that receives one
again writes the same file again. This module must not know requests or encodings, and
does not change a run.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterable
from weakref import WeakKeyDictionary

from reference_server.rules.runs.run import Episode, Run


class OwedResults:
    """Keeps for each run the indices of the episodes whose results are owed."""

    def __init__(self) -> None:
        self._owed: WeakKeyDictionary[Run, list[int]] = WeakKeyDictionary()

    def notice(self, run: Run) -> None:
        """Call before anything of a request is carried out."""
        if run not in self._owed:
            self._owed[run] = sorted(run.scored_order)

    def take(self, run: Run) -> Episode | None:
        """An episode whose result goes into an answer now."""
        owed = self._owed.get(run)
        return run.episodes[heapq.heappop(owed)] if owed else None

    def add(self, run: Run, indices: Iterable[int]) -> None:
        """The answers with these results were lost."""
        owed = self._owed.setdefault(run, [])
        for index in indices:
            if index not in owed:
                heapq.heappush(owed, index)
