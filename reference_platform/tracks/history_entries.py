"""Entries and flags of runs, as the history of the leaderboard has them.

A leaf is never changed, so each is read once. The entries are stored: a known flag
excludes a result while the server is away, too (HST-044).
"""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

import msgspec

from reference_platform.storage.platform_database import Database

_NOTE_PUBLISHED = (
    "INSERT INTO history_entries VALUES (?1, ?2, ?3, 1, NULL) "
    "ON CONFLICT (entry_id) DO UPDATE SET is_shown = 1"
)
_NOTE_CHANGE = {
    "hide": "UPDATE history_entries SET is_shown = 0 WHERE entry_id = ?1",
    "withdraw": "UPDATE history_entries SET is_shown = 0 WHERE entry_id = ?1",
    "flag": "UPDATE history_entries SET flag = ?2 WHERE entry_id = ?1",
    "unflag": "UPDATE history_entries SET flag = NULL WHERE entry_id = ?1",
}


class HistoryLeaf(msgspec.Struct, frozen=True):
    """leaf: its text, as the tree has it."""

    index: int
    leaf: str


class HistoryReader(Protocol):
    """Reads the history of the leaderboard at the server."""

    async def read_leaves(self, start: int) -> Sequence[HistoryLeaf]:
        """Some of the leaves from an index on, in their order. Raises Refused."""


class _Members(msgspec.Struct, frozen=True):
    """The members of a leaf that are needed; the leaf of a draw has the kind alone."""

    kind: str = ""
    entry_id: str = ""
    run_id: str = ""
    manifest_sha256: str = ""
    reason: str = ""


class PhaseBoard(msgspec.Struct, frozen=True):
    """entries: of one phase on the leaderboard of a manifest."""

    manifest_sha256: str
    entries: int


@dataclass(frozen=True, slots=True)
class HistoryEntries:
    """The runs that have, or had, a public entry."""

    database: Database
    _reading: asyncio.Lock = field(default_factory=asyncio.Lock, init=False)

    async def refresh(self, reader: HistoryReader) -> None:
        """Read the leaves that are new. Raises Refused if the server is away."""
        async with self._reading:
            while await self._read_more(reader):
                pass

    async def _read_more(self, reader: HistoryReader) -> bool:
        """Whether there may be more leaves."""
        last = self.database.row(HistoryLeaf, "SELECT * FROM last_read_leaf")
        leaves = await reader.read_leaves(0 if last is None else last.index)
        if last is None:
            self._note(leaves)
            return bool(leaves)
        if [last] != [*leaves[:1]]:  # the server was restored to an earlier state
            with self.database.transaction():
                self.database.execute("DELETE FROM history_entries")
                self.database.execute("DELETE FROM last_read_leaf")
            return True
        self._note(leaves[1:])
        return len(leaves) > 1

    def _note(self, leaves: Sequence[HistoryLeaf]) -> None:
        with self.database.transaction():
            for leaf in leaves:
                self._note_one(msgspec.json.decode(leaf.leaf, type=_Members))
            if leaves:
                self.database.execute("DELETE FROM last_read_leaf")
                last = leaves[-1]
                statement = "INSERT INTO last_read_leaf VALUES (?, ?)"
                self.database.execute(statement, last.index, last.leaf)

    def _note_one(self, leaf: _Members) -> None:
        if leaf.kind == "publish":
            values = (leaf.entry_id, leaf.run_id, leaf.manifest_sha256)
            self.database.execute(_NOTE_PUBLISHED, *values)
        elif leaf.kind == "flag":
            self.database.execute(_NOTE_CHANGE["flag"], leaf.entry_id, leaf.reason)
        elif leaf.kind in _NOTE_CHANGE:
            self.database.execute(_NOTE_CHANGE[leaf.kind], leaf.entry_id)

    def boards_of(self, track_id: str, phase_id: str) -> Sequence[PhaseBoard]:
        """The leaderboards with entries of a phase; the one with most of them first."""
        return self.database.rows(
            PhaseBoard,
            "SELECT manifest_sha256, count(*) AS entries FROM history_entries JOIN ("
            "SELECT run_id, track_id, phase_id FROM track_runs UNION ALL "
            "SELECT run_id, track_id, phase_id FROM submissions) USING (run_id) "
            "WHERE track_id = ? AND phase_id = ? AND is_shown "
            "GROUP BY manifest_sha256 ORDER BY entries DESC, manifest_sha256",
            *(track_id, phase_id),
        )
