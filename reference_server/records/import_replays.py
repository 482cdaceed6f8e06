"""Simulates records that were handed in again, one after another, accounts in turn.

Each has a simulator beside those of runs, with low priority: no run waits for it. A
replay that a restart cuts off begins again. This module decides no level of trust.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import time
from collections.abc import Awaitable, Callable, Iterator, Sequence
from dataclasses import replace
from itertools import chain
from pathlib import Path
from typing import cast

import msgspec
from pydantic import ValidationError

from reference_record.broken import BrokenRecord, UnusableRecord
from reference_record.contents.replay_verdict import (
    Divergence,
    ReplaySummary,
    Result,
    replay_of,
)
from reference_record.contents.statement import RecordedResult
from reference_record.formats.opened_seeds import OpenedBenchmark
from reference_server.generated import models
from reference_server.process.backoff import Backoff
from reference_server.records.record_verifier import ExaminationFailed, RecordVerifier
from reference_server.rules import imported_record
from reference_server.rules.imported_record import ImportReplay, RecordImport
from reference_server.rules.refusal import Refused
from reference_server.storage.import_store import ImportStore
from reference_server.storage.runs.run_store import StoreFailed
from reference_sim.engine import engine_fingerprint
from reference_sim.process.pool import (
    NoCapacity,
    SimulatorFault,
    SimulatorHandle,
    SimulatorPool,
    TaskUnplayable,
)
from reference_sim.replay.foreign_manifest import BenchmarkChoice
from reference_sim.replay.record_replay import (
    NONE_SIMULATED,
    ReplayedBenchmark,
    add_opened_seeds,
    resolve_choice,
)

log = logging.getLogger("proctor.imports")

NO_SEEDS = f"{NONE_SIMULATED}, and this server has no file in which it has opened them"
Sign = Callable[[ReplaySummary, str], Awaitable[bytes]]


class NotReplayed(Exception):
    """Why an import has no replay, in a sentence."""


class ImportReplays:
    """The replays of one server.

    find: import id → its archive. sign: makes this server's verdict on a statement.
    replay_s_max: longest time for one record. opened: seeds of sealed splits that
    their hosts have opened. may_work: whether this server is the one that replays what
    all of a cluster receive. look_every_s: None if nothing is received elsewhere.
    """

    def __init__(
        self,
        store: ImportStore,
        pool: SimulatorPool,
        verifier: RecordVerifier,
        *,
        find: Callable[[str], Awaitable[Path]],
        sign: Sign,
        replay_s_max: float,
        opened: Sequence[OpenedBenchmark] = (),
        may_work: Callable[[], bool] = lambda: True,
        look_every_s: float | None = None,
    ) -> None:
        self._may_work, self._look_every_s = may_work, look_every_s
        self._store, self._pool, self._verifier = store, pool, verifier
        self._find, self._sign = find, sign
        self._replay_s_max, self._opened = replay_s_max, opened
        self._wake = asyncio.Event()
        self._worker: asyncio.Task[None] | None = None
        self._current: tuple[str, asyncio.Task[None]] | None = None
        self._replayed = 0
        self._last_turns: dict[str, int] = {}

    def open(self) -> None:
        """REC-123: go on with what is not finished."""
        self._worker = asyncio.create_task(self._work())
        self._wake.set()

    async def close(self) -> None:
        if self._worker is not None:
            self._worker.cancel()
            await asyncio.wait([self._worker])

    def wake(self) -> None:
        """Look for work, because there is another import."""
        self._wake.set()

    def episodes_replayed(self, record_import: RecordImport) -> int:
        """How many episodes of it were simulated so far."""
        if record_import.replay is not None:
            return record_import.replay.episodes
        is_current = (
            self._current is not None and self._current[0] == record_import.import_id
        )
        return self._replayed if is_current else 0

    async def stop(self, import_id: str) -> None:
        """End the replay of an import that is being deleted."""
        if self._current is not None and self._current[0] == import_id:
            task = self._current[1]
            task.cancel()
            await asyncio.wait([task])

    async def _work(self) -> None:
        backoff = Backoff.between_sessions()
        while True:
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(self._wake.wait(), self._look_every_s)
            self._wake.clear()
            try:
                while self._may_work() and (record_import := await self._next()):
                    await self._finish_task(record_import)
                backoff.reset()
            except (StoreFailed, NoCapacity, Refused) as error:
                log.warning("records are not replayed at the moment: %s", error)
                await asyncio.sleep(backoff.next_s())
                self._wake.set()

    async def _next(self) -> RecordImport | None:
        waiting = await self._store.oldest_unfinished()
        record_import = imported_record.next_to_replay(waiting, self._last_turns)
        if record_import is not None:
            turn = 1 + max(self._last_turns.values(), default=0)
            self._last_turns[record_import.account] = turn
        return record_import

    async def _finish_task(self, record_import: RecordImport) -> None:
        """Finish an import in a task of its own, which `stop` may cancel."""
        task = asyncio.create_task(self._finish(record_import))
        self._current, self._replayed = (record_import.import_id, task), 0
        try:
            await asyncio.wait([task])
        finally:
            task.cancel()
            self._current = None
        with contextlib.suppress(asyncio.CancelledError):
            task.result()

    async def _finish(self, record_import: RecordImport) -> None:
        await self._store.update(replace(record_import, state="replaying"))
        try:
            done = await self._outcome(record_import)
        except (StoreFailed, NoCapacity, Refused):  # later it may succeed
            raise
        except Exception as error:  # noqa: BLE001 - the next ones do not wait for it
            what = type(error).__name__
            log.warning(
                "import %s: the replay failed: %s", record_import.import_id, what
            )
            done = replace(record_import, reason=f"The replay failed: {what}.")
        ended = replace(done, state="finished", finished_at_wall=time.time())
        await self._store.update(ended)

    async def _outcome(self, record_import: RecordImport) -> RecordImport:
        """The import with its replay, or with the reason why it has none."""
        try:
            async with asyncio.timeout(self._replay_s_max):
                summary = await self._replay(record_import)
        except NotReplayed as refused:
            return replace(record_import, reason=str(refused)[:1000])
        except TimeoutError:
            reason = f"The replay was not done within {self._replay_s_max:g} s."
            return replace(record_import, reason=reason)
        verdict = await self._sign(summary, record_import.statement_sha256)
        return replace(record_import, replay=_replay_shown(summary), verdict=verdict)

    async def _replay(self, record_import: RecordImport) -> ReplaySummary:
        try:
            path = await self._find(record_import.import_id)
            benchmark, recorded = await self._prepare(path)
        except (UnusableRecord, BrokenRecord, ExaminationFailed, OSError) as error:
            raise NotReplayed(f"It cannot be replayed here: {error}.") from error
        results: dict[int, tuple[Result, Divergence | None]] = {}
        handle: SimulatorHandle | None = None
        try:
            for result in recorded:
                if handle is None:
                    handle = await self._start(benchmark)
                replayed = await _replay_one(handle, path, benchmark, result)
                results[result.index] = replayed
                self._replayed = len(results)
        finally:
            if handle is not None:
                handle.discard()
        return replay_of(results, engine_fingerprint())

    async def _prepare(
        self, path: Path
    ) -> tuple[ReplayedBenchmark, Iterator[RecordedResult]]:
        """The benchmark as this server has it, and the results to be simulated."""
        recorded = await self._verifier.read_for_replay(path)
        check_choice(recorded.choice)
        benchmark = await asyncio.to_thread(self._resolve, recorded.choice)
        results = (
            result
            for result in recorded.results()
            if benchmark.knows_seed(result.index)
        )
        first = next(results, None)
        if first is None:
            raise UnusableRecord(NO_SEEDS)
        return benchmark, chain([first], results)

    def _resolve(self, choice: BenchmarkChoice) -> ReplayedBenchmark:
        return add_opened_seeds(resolve_choice(choice), choice, self._opened)

    async def _start(self, benchmark: ReplayedBenchmark) -> SimulatorHandle:
        try:
            return await self._pool.start_beside(benchmark.config)
        except (SimulatorFault, TaskUnplayable) as fault:
            raise NotReplayed(f"No simulator could be made for it: {fault}.") from fault


def check_choice(choice: BenchmarkChoice) -> None:
    """Check a record's choice like a submission; raises UnusableRecord."""
    said = {"benchmark_id": choice.benchmark_id, "policy": {"name": "a record"}}
    select = None if choice.select is None else msgspec.to_builtins(choice.select)
    chosen = {"options": choice.options, "images": choice.images, "select": select}
    said |= {name: value for name, value in chosen.items() if value is not None}
    try:
        models.SubmitRun.model_validate(said, strict=True)
    except ValidationError as error:
        at = ".".join(map(str, error.errors(include_input=False)[0]["loc"]))[:100]
        text = f"no run can be submitted with what it says in {at}"
        raise UnusableRecord(text) from error


async def _replay_one(
    handle: SimulatorHandle,
    path: Path,
    benchmark: ReplayedBenchmark,
    recorded: RecordedResult,
) -> tuple[Result, Divergence | None]:
    plan = msgspec.json.encode(benchmark.plan_of(recorded.index))
    try:
        replayed = await handle.replay(path, msgspec.json.encode(recorded), plan)
    except (SimulatorFault, TaskUnplayable) as fault:
        text = f"The simulator failed in episode {recorded.index}: {fault}."
        raise NotReplayed(text) from fault
    where = (
        None if replayed.where is None else Divergence(recorded.index, *replayed.where)
    )
    return cast("Result", replayed.result), where


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
