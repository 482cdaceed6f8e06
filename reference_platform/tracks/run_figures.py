"""Figures of runs: parts of their scores, which pages show beside a result.

They are stored when the result is made, so that no page waits for the server.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import msgspec

from reference_platform.storage.platform_database import Database

# Parts of the schema Score, beside the names of its splits.
_FIGURES = ("score", "success_rate", "success_interval", "counts")
_SPLITS_MAX = 100


def note_figures(database: Database, run_id: str, score: Mapping[str, Any]) -> None:
    """Store the score of a completed run and its figures. score: as `get_score`."""
    figures = {name: score.get(name) for name in _FIGURES}
    splits = score.get("by_split") or {}
    if len(splits) <= _SPLITS_MAX:
        figures["by_split"] = {name: {} for name in splits}
    with database.transaction():
        database.execute(
            "INSERT OR REPLACE INTO run_figures VALUES (?, ?)",
            *(run_id, msgspec.json.encode(figures).decode()),
        )
        for statement in (
            "UPDATE track_runs SET score = ? WHERE run_id = ?",
            "UPDATE submissions SET score = ? WHERE run_id = ?",
        ):
            database.execute(statement, figures["score"], run_id)
