"""The runs of a server, as the platform reads them there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from reference_platform.tracks.history_entries import HistoryLeaf


class ShownRuns:
    """It implements `tracks.RunReader`."""

    def __init__(self) -> None:
        self.runs: dict[str, dict[str, Any]] = {}
        self.figures: dict[str, dict[str, Any]] = {}
        self.figures_read: list[str] = []
        self.leaves: list[str] = []
        self.has_leaderboard = True

    async def read_run(self, run_id: str) -> Mapping[str, Any] | None:
        return self.runs.get(run_id)

    async def read_figures(self, run_id: str) -> Mapping[str, Any] | None:
        self.figures_read.append(run_id)
        return self.figures.get(run_id)

    async def read_leaves(self, start: int) -> Sequence[HistoryLeaf] | None:
        if not self.has_leaderboard:
            return None
        leaves = [HistoryLeaf(index, leaf) for index, leaf in enumerate(self.leaves)]
        return leaves[start : start + 2]
