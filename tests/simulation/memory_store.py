"""A database in memory in the place of Store; its writes fail, or are in doubt.

The rows are those of the real one (`storage/runs/rows.py`). The order of writes, what
is read inside the lock and what a failure leaves is as in `storage/runs/run_store.py`.
"""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import AsyncIterator, Mapping, Sequence
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from typing import Any

from reference_server.rules.capacity import WaitingRun
from reference_server.rules.runs.run import Episode, Run, RunHead, State
from reference_server.storage.runs import rows
from reference_server.storage.runs.run_store import StoreFailed
from tests.simulation.world import Life, World

READ_S, WRITE_S = 0.002, 0.1
# A write that fails is seldom the only one.
FULL_S = 4.0


@dataclass(slots=True)
class Database:
    """Tables; runs by their number, episodes by the run's number and their index."""

    runs: dict[int, dict[str, Any]] = field(default_factory=dict)
    manifests: dict[str, Any] = field(default_factory=dict)
    episodes: dict[int, dict[int, dict[str, Any]]] = field(default_factory=dict)
    keys: dict[tuple[str, str], tuple[str, str]] = field(default_factory=dict)
    is_full_until: float = 0.0

    def number_of(self, run_id: str) -> int | None:
        found = (n for n, row in self.runs.items() if row["run_id"] == run_id)
        return next(found, None)

    def stored_episodes(self, number: int) -> list[rows.EpisodeRow]:
        of_run = self.episodes.get(number, {})
        return [
            tuple(of_run[index][name] for name in rows.EPISODE_COLUMNS)
            for index in sorted(of_run)
        ]


class MemoryStore:
    """The store of one server process over a database that outlives it."""

    def __init__(self, world: World, life: Life, database: Database) -> None:
        self._world, self._life, self._database = world, life, database
        self._write_lock = asyncio.Lock()

    @asynccontextmanager
    async def _commit(self) -> AsyncIterator[None]:
        """Around what a transaction changes, which happens at one moment."""
        world = self._world
        await world.delay(WRITE_S)
        await self._life.check()
        now = asyncio.get_running_loop().time()
        if world.happens(world.chances.write_fails):
            self._database.is_full_until = now + world.chance.random() * FULL_S
        if now < self._database.is_full_until:
            raise StoreFailed("the disk is full")
        yield
        if world.happens(world.chances.killed_at_write):
            world.kill()
        await world.delay(WRITE_S)
        await self._life.check()
        if world.happens(world.chances.write_in_doubt):
            raise StoreFailed("the connection was lost before the answer came")

    async def _read(self) -> None:
        await self._world.delay(READ_S)
        await self._life.check()

    async def insert(
        self,
        run: Run,
        key: str | None,
        body_sha256: str,
        _check: object = None,  # of a cluster alone
    ) -> bool:
        data = self._database
        async with self._write_lock, self._commit():
            if key is not None and (run.account, key) in data.keys:
                return False
            run.attempts_by_submitter = 1 + len(data.runs)
            run.number = 1 + len(data.runs)
            data.manifests[run.manifest_sha256] = run.manifest
            row = rows.new_run_row(run) | {"number": run.number}
            data.runs[run.number] = row
            if key is not None:
                data.keys[run.account, key] = body_sha256, run.run_id
        return True

    async def save(self, run: Run) -> list[Episode]:
        async with self._write_lock:
            if run.lost:
                raise StoreFailed("an earlier write of the run failed")
            changed, run.changed = run.changed, set()
            stored_now = [run.episodes[index] for index in sorted(changed)]
            row, episodes = rows.run_row(run), rows.episode_rows(run, changed)
            try:
                async with self._commit():
                    if run.is_played and run.played_number is None:
                        row["played_number"] = 1 + self._played()
                    self._database.runs[run.number].update(row)
                    stored = self._database.episodes.setdefault(run.number, {})
                    stored.update((one["index"], one) for one in episodes)
            except StoreFailed:
                run.changed |= changed
                raise
            run.played_number = row["played_number"]
        return [one for one in stored_now if one.result is not None]

    def _played(self) -> int:
        numbers = (row["played_number"] for row in self._database.runs.values())
        return max((n for n in numbers if n is not None), default=0)

    async def find_key(self, account: str, key: str) -> tuple[str, str] | None:
        await self._read()
        return self._database.keys.get((account, key))

    async def load(self, run_id: str) -> Run | None:
        await self._read()
        found = self._find(run_id)
        if found is None:
            return None
        row, manifest = found
        stored = self._database.stored_episodes(row["number"])
        return rows.run_of(row, manifest, stored)

    async def read_window(
        self, run_id: str, start: int, end: int | None, scored: bool = False
    ) -> tuple[RunHead, list[Episode]] | None:
        await self._read()
        found = self._find(run_id)
        if found is None:
            return None
        run = rows.run_of(*found, self._database.stored_episodes(found[0]["number"]))
        return rows.head_of(*found), run.window(start, end, scored)

    async def heads(self, run_ids: Sequence[str]) -> dict[str, RunHead]:
        await self._read()
        found = {run_id: self._find(run_id) for run_id in run_ids}
        return {
            i: rows.listed_head_of(*one) for i, one in found.items() if one is not None
        }

    def _find(self, run_id: str) -> tuple[dict[str, Any], Any] | None:
        number = self._database.number_of(run_id)
        if number is None:
            return None
        row = dict(self._database.runs[number])
        return row, self._database.manifests[row["manifest_sha256"]]

    async def page(
        self, account: str | None, before: int | None, limit: int
    ) -> list[tuple[int, str]]:
        await self._read()
        found = [
            (number, str(row["run_id"]))
            for number, row in sorted(self._database.runs.items(), reverse=True)
            if account in (None, row["account"]) and (before is None or number < before)
        ]
        return found[:limit]

    async def replace_states(self, states: Mapping[State, State], reason: str) -> None:
        async with self._write_lock, self._commit():
            for row in self._database.runs.values():
                if row["state"] in states:
                    row |= {"state": states[row["state"]], "reason": reason}

    async def waiting_runs(self, *states: str) -> list[WaitingRun]:
        await self._read()
        names = WaitingRun.__dataclass_fields__
        return [WaitingRun(*(row[n] for n in names)) for row in self._in(states)]

    async def in_states(self, *states: str) -> list[str]:
        await self._read()
        return [row["run_id"] for row in self._in(states)]

    def _in(self, states: Sequence[str]) -> list[dict[str, Any]]:
        return [
            row
            for _, row in sorted(self._database.runs.items())
            if row["state"] in states
        ]

    async def sizes_of_accounts(self) -> tuple[dict[str, int], dict[str, int]]:
        await self._read()
        keys = Counter(account for account, _ in self._database.keys)
        runs = Counter(str(row["account"]) for row in self._database.runs.values())
        return dict(keys), dict(runs)
