"""Databases of earlier versions become those of today, in one transaction."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Mapping
from typing import Any, Final

_OF_PHASES: Final = ("benchmark_id", "opens_at", "closes_at", "splits")
_LIMITS: Final = ("per_day", "total", "at_once")
_STATEMENTS: Final = (
    "ALTER TABLE track_runs ADD COLUMN phase_id TEXT NOT NULL DEFAULT 'main'",
    "ALTER TABLE submissions ADD COLUMN phase_id TEXT NOT NULL DEFAULT 'main'",
    "ALTER TABLE track_runs ADD COLUMN policy_name TEXT NOT NULL DEFAULT ''",
    "ALTER TABLE submissions ADD COLUMN score REAL",
    "ALTER TABLE submissions ADD COLUMN commit_index INTEGER",
    "ALTER TABLE keys ADD COLUMN organisation TEXT NOT NULL DEFAULT ''",
)


def upgrade_from_1(connection: sqlite3.Connection) -> None:
    """A track was one phase; now it has one that is called `main`."""
    for statement in _STATEMENTS:
        connection.execute(statement)
    for track_id, document in connection.execute("SELECT * FROM tracks").fetchall():
        connection.execute(
            "UPDATE tracks SET document = ? WHERE track_id = ?",
            (json.dumps(_with_phases(json.loads(document))), track_id),
        )


def _with_phases(track: Mapping[str, Any]) -> Mapping[str, Any]:
    moved = (*_OF_PHASES, *_LIMITS)
    phase = {"phase_id": "main", **{n: track[n] for n in moved if n in track}}
    rest = {name: value for name, value in track.items() if name not in moved}
    return {**rest, "phases": [phase]}
