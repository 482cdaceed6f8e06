"""Entries of runs, as the history of the leaderboard has them: flags, withdrawals.

A leaf is never changed, so each is read once. The entries are stored: a known flag
excludes a result while the server is away, and until another history was read to its
end (HST-044).
"""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

import msgspec

from reference_platform.storage.platform_database import Database

_NOTE_PUBLISHED = (
    "INSERT INTO board_entries VALUES (?1, ?2, ?3, 'shown', NULL) "
    "ON CONFLICT (entry_id) DO UPDATE SET state = 'shown'"
)
_NOTE_CHANGE = {
    "hide": "UPDATE board_entries SET state = 'hidden' WHERE entry_id = ?1",
    "withdraw": "UPDATE board_entries SET state = 'withdrawn' WHERE entry_id = ?1",
    "flag": "UPDATE board_entries SET flag = ?2 WHERE entry_id = ?1",
    "unflag": "UPDATE board_entries SET flag = NULL WHERE entry_id = ?1",
}


class HistoryLeaf(msgspec.Struct, frozen=True):
    """leaf: its text, as the tree has it."""

    index: int
    leaf: str


class HistoryReader(Protocol):
    """Reads the history of the leaderboard at the server."""

    async def read_leaves(self, start: int) -> Sequence[HistoryLeaf] | None:
        """Some of the leaves from an index on, in their order. Raises Refused.

        None if the server has no leaderboard.
        """


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


async def _read_to_the_end(
    reader: HistoryReader, known: Sequence[HistoryLeaf]
) -> Sequence[HistoryLeaf] | None:
    """The known leaf and those behind it; all, where the history has it no more.

    None if the server has no leaderboard.
    """
    leaves = [*known]
    while True:
        page = await reader.read_leaves(leaves[-1].index if leaves else 0)
        if page is None:
            return None
        if leaves and leaves[-1:] != [*page[:1]]:  # it was restored to an earlier state
            leaves = []
        elif len(page) > len(leaves[-1:]):
            leaves.extend(page[len(leaves[-1:]) :])
        else:
            return leaves


@dataclass(frozen=True, slots=True)
class HistoryEntries:
    """The runs that have, or had, a public entry."""

    database: Database
    _reading: asyncio.Lock = field(default_factory=asyncio.Lock, init=False)

    async def refresh(self, reader: HistoryReader) -> None:
        """Read the leaves that are new to the end, and note them together.

        Raises Refused if the server is away. Nothing has changed then, nor where the
        server has no leaderboard.
        """
        async with self._reading:
            last = self.database.row(HistoryLeaf, "SELECT * FROM last_leaf")
            known = [] if last is None else [last]
            leaves = await _read_to_the_end(reader, known)
            if leaves is not None and leaves != known:
                self._note(leaves, is_other=leaves[:1] != known)

    def _note(self, leaves: Sequence[HistoryLeaf], *, is_other: bool) -> None:
        """is_other: they are all leaves of a history of which none is noted yet."""
        with self.database.transaction():
            self.database.execute("DELETE FROM last_leaf")
            if is_other:
                self.database.execute("DELETE FROM board_entries")
            for leaf in leaves:
                self._note_one(msgspec.json.decode(leaf.leaf, type=_Members))
            for leaf in leaves[-1:]:
                statement = "INSERT INTO last_leaf VALUES (?, ?)"
                self.database.execute(statement, leaf.index, leaf.leaf)

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
            "SELECT manifest_sha256, count(*) AS entries FROM board_entries JOIN ("
            "SELECT run_id, track_id, phase_id FROM track_runs UNION ALL "
            "SELECT run_id, track_id, phase_id FROM submissions) USING (run_id) "
            "WHERE track_id = ? AND phase_id = ? AND board_entries.state = 'shown' "
            "GROUP BY manifest_sha256 ORDER BY entries DESC, manifest_sha256",
            *(track_id, phase_id),
        )
