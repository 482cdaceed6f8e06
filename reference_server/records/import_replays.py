"""Simulates records that were handed in again, one after another, oldest first.

Each has a simulator beside those of runs, with low priority: no run waits for it. What
a restart cuts off begins again. It decides no level of trust.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import time
from collections.abc import Awaitable, Callable
from dataclasses import replace
from pathlib import Path
from typing import cast

import msgspec

from reference_record.broken import BrokenRecord, UnusableRecord
from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import MANIFEST, STATEMENT
from reference_record.replay_verdict import (
    Divergence,
    ReplaySummary,
    Result,
    replay_of,
)
from reference_record.statement import EpisodeLine
from reference_record.verification import read_statement
from reference_server.rules import imported_record
from reference_server.rules.imported_record import ImportReplay, RecordImport
from reference_server.storage.import_store import ImportStore
from reference_server.storage.store import StoreFailed
from reference_sim.engine import engine_fingerprint
from reference_sim.process.pool import (
    NoCapacity,
    SimulatorFault,
    SimulatorHandle,
    SimulatorPool,
    TaskUnplayable,
)
from reference_sim.replay.record_replay import (
    ReplayedBenchmark,
    replayable_lines,
    resolve,
)

log = logging.getLogger("proctor.imports")

RETRY_S = 5.0
Sign = Callable[[ReplaySummary, str], Awaitable[bytes]]


class NotReplayed(Exception):
    """Why an import has no replay, in a sentence."""


class ImportReplays:
    """The replays of one server.

    path_of: import id → its archive. sign: makes this server's verdict on a statement.
    replay_s_max: longest time for one record.
    """

    def __init__(
        self,
        store: ImportStore,
        pool: SimulatorPool,
        path_of: Callable[[str], Path],
        sign: Sign,
        replay_s_max: float,
    ) -> None:
        self._store, self._pool = store, pool
        self._path_of, self._sign = path_of, sign
        self._replay_s_max = replay_s_max
        self._wake = asyncio.Event()
        self._worker: asyncio.Task[None] | None = None
        self._current: tuple[str, asyncio.Task[None]] | None = None
        self._replayed = 0

    def open(self) -> None:
        """REC-123: go on with what is not finished."""
        self._worker = asyncio.create_task(self._work())
        self._wake.set()

    async def close(self) -> None:
        if self._worker is not None:
            self._worker.cancel()
            await asyncio.wait([self._worker])

    def wake(self) -> None:
        """There is another import."""
        self._wake.set()

    def episodes_replayed(self, one: RecordImport) -> int:
        """How many episodes of it were simulated so far."""
        if one.replay is not None:
            return one.replay.episodes
        is_current = self._current is not None and self._current[0] == one.import_id
        return self._replayed if is_current else 0

    async def stop(self, import_id: str) -> None:
        """End the replay of an import that is being deleted."""
        if self._current is not None and self._current[0] == import_id:
            task = self._current[1]
            task.cancel()
            await asyncio.wait([task])

    async def _work(self) -> None:
        while True:
            await self._wake.wait()
            self._wake.clear()
            try:
                while (one := await self._store.oldest_unfinished()) is not None:
                    await self._finish_task(one)
            except (StoreFailed, NoCapacity) as error:
                log.warning("records are not replayed at the moment: %s", error)
                await asyncio.sleep(RETRY_S)
                self._wake.set()

    async def _finish_task(self, one: RecordImport) -> None:
        """In a task of its own, which `stop` may cancel."""
        task = asyncio.create_task(self._finish(one))
        self._current, self._replayed = (one.import_id, task), 0
        try:
            await asyncio.wait([task])
        finally:
            task.cancel()
            self._current = None
        with contextlib.suppress(asyncio.CancelledError):
            task.result()

    async def _finish(self, one: RecordImport) -> None:
        await self._store.update(replace(one, state="replaying"))
        try:
            done = await self._outcome(one)
        except (StoreFailed, NoCapacity):  # later it may succeed
            raise
        except Exception as error:  # noqa: BLE001 - the next ones do not wait for it
            what = type(error).__name__
            log.warning("import %s: the replay failed: %s", one.import_id, what)
            done = replace(one, reason=f"The replay failed: {what}.")
        ended = replace(done, state="finished", finished_at_wall=time.time())
        await self._store.update(ended)

    async def _outcome(self, one: RecordImport) -> RecordImport:
        """The import with its replay, or with the reason why it has none."""
        try:
            async with asyncio.timeout(self._replay_s_max):
                summary = await self._replay(one)
        except NotReplayed as refused:
            return replace(one, reason=str(refused)[:1000])
        except TimeoutError:
            reason = f"The replay was not done within {self._replay_s_max:g} s."
            return replace(one, reason=reason)
        verdict = await self._sign(summary, one.statement_sha256)
        return replace(one, replay=_replay_shown(summary), verdict=verdict)

    async def _replay(self, one: RecordImport) -> ReplaySummary:
        path = self._path_of(one.import_id)
        try:
            benchmark, lines = await asyncio.to_thread(_prepare, path)
        except (UnusableRecord, BrokenRecord, OSError) as error:
            raise NotReplayed(f"It cannot be replayed here: {error}.") from error
        results: dict[int, tuple[Result, Divergence | None]] = {}
        handle: SimulatorHandle | None = None
        try:
            for line in lines:
                if handle is None:
                    handle = await self._start(benchmark)
                results[line.index] = await _replay_line(handle, path, benchmark, line)
                self._replayed = len(results)
        finally:
            if handle is not None:
                handle.discard()
        return replay_of(results, engine_fingerprint())

    async def _start(self, benchmark: ReplayedBenchmark) -> SimulatorHandle:
        try:
            return await self._pool.start_beside(benchmark.config)
        except (SimulatorFault, TaskUnplayable) as fault:
            raise NotReplayed(f"No simulator could be made for it: {fault}.") from fault


def _prepare(path: Path) -> tuple[ReplayedBenchmark, list[EpisodeLine]]:
    """What the manifest names, as this server has it, and what can be simulated."""
    bundle = open_bundle(path)
    statement, _ = read_statement(bundle.read(STATEMENT))
    benchmark = resolve(statement.predicate, bundle.read(MANIFEST))
    return benchmark, replayable_lines(path, benchmark)


async def _replay_line(
    handle: SimulatorHandle, path: Path, benchmark: ReplayedBenchmark, line: EpisodeLine
) -> tuple[Result, Divergence | None]:
    plan = msgspec.json.encode(benchmark.plan_of(line.index))
    try:
        found = await handle.replay(path, msgspec.json.encode(line), plan)
    except (SimulatorFault, TaskUnplayable) as fault:
        text = f"The simulator failed in episode {line.index}: {fault}."
        raise NotReplayed(text) from fault
    where = None if found.where is None else Divergence(line.index, *found.where)
    return cast("Result", found.result), where


def _replay_shown(summary: ReplaySummary) -> ImportReplay:
    where = None
    if first := summary.first_divergence:
        where = imported_record.FirstDivergence(
            first.episode_index, first.attempt, first.step
        )
    return ImportReplay(
        summary.result,
        summary.episodes,
        summary.exact,
        summary.outcome,
        summary.diverged,
        where,
    )
