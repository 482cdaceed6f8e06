"""Databases of earlier versions become those of today, in one transaction."""

from __future__ import annotations

import json
import sqlite3
from typing import Final

_OF_TRACKS: Final = frozenset(("track_id", "title", "rules", "entry", "accounts"))
_STATEMENTS: Final = (
    "ALTER TABLE track_runs ADD COLUMN phase_id TEXT NOT NULL DEFAULT 'main'",
    "ALTER TABLE track_runs ADD COLUMN policy_name TEXT NOT NULL DEFAULT ''",
    "ALTER TABLE submissions ADD COLUMN phase_id TEXT NOT NULL DEFAULT 'main'",
    "ALTER TABLE submissions ADD COLUMN score REAL",
    "ALTER TABLE submissions ADD COLUMN commit_index INTEGER",
    "ALTER TABLE keys ADD COLUMN organisation TEXT NOT NULL DEFAULT ''",
)


def upgrade_from_1(connection: sqlite3.Connection) -> None:
    """A track was one phase; now it has one that is called `main`."""
    for statement in _STATEMENTS:
        connection.execute(statement)
    for track_id, text in connection.execute("SELECT * FROM tracks").fetchall():
        old = json.loads(text)
        phase = {n: v for n, v in old.items() if n not in _OF_TRACKS}
        track = {n: v for n, v in old.items() if n in _OF_TRACKS}
        new = json.dumps(track | {"phases": [phase | {"phase_id": "main"}]})
        statement = "UPDATE tracks SET document = ? WHERE track_id = ?"
        connection.execute(statement, (new, track_id))
