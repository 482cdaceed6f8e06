"""The server without HTTP, over a database in a file: for stories about its parts."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator, Awaitable, Callable, Coroutine, Iterator
from contextlib import asynccontextmanager, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from reference_record.contents.benchmark_manifest import manifest_sha256
from reference_record.generated.answers import Turn
from reference_server.files.seed_secret import SeedSecret
from reference_server.push.policy_server_validator import PolicyServerValidator
from reference_server.records.recordings import Recordings
from reference_server.rules.refusal import Refused
from reference_server.rules.runs import effects
from reference_server.rules.runs.lifecycle import Predict
from reference_server.rules.runs.run import Episode, Result, Run
from reference_server.rules.submission import SubmissionLimits
from reference_server.runs.admission.disk_bound import DiskBound
from reference_server.runs.benchmarks import Benchmarks
from reference_server.runs.registry import RunRegistry
from reference_server.runs.service import RunService
from reference_server.runs.sessions.session_executor import SessionExecutor
from reference_server.storage.runs.run_store import Store
from reference_sim import benchmark_registry
from reference_sim.process.pool import SimulatorPool
from tests.support.server.databases import UsedDatabase
from tests.support.server.runs import make_run
from tests.support.servers import TIMEOUT_S
from tests.support.sim.calibration_action import calibration_action
from tests.support.sim.shared_processes import shared_pool


class BlockedCall:
    """Holds up the calls of an async method of `owner` until `open` is called.

    after: lets the method do its work first and holds up its answer.
    """

    def __init__(
        self,
        patch: pytest.MonkeyPatch,
        owner: object,
        name: str,
        *,
        after: bool = False,
    ) -> None:
        right = getattr(owner, name)
        self._reached, self._opened = asyncio.Event(), asyncio.Event()

        async def blocked_call(*arguments: Any, **named: Any) -> Any:
            answer = await right(*arguments, **named) if after else None
            self._reached.set()
            await self._opened.wait()
            return answer if after else await right(*arguments, **named)

        patch.setattr(owner, name, blocked_call)

    async def wait_until_reached(self) -> None:
        """Returns when a call stands before the gate."""
        await self._reached.wait()

    def open(self) -> None:
        self._opened.set()


Scenario = Callable[["ServerParts"], Awaitable[None]]


@dataclass
class ServerParts:
    """Store, runs, simulators and executor, put together as `app` does."""

    database: UsedDatabase
    store: Store
    registry: RunRegistry
    pool: SimulatorPool
    executor: SessionExecutor
    service: RunService


def make_service(
    registry: RunRegistry, executor: SessionExecutor, seed_secret: SeedSecret
) -> RunService:
    """The use cases over these parts, without records."""
    validator = PolicyServerValidator()
    return RunService(
        SubmissionLimits(16, 600.0),
        Benchmarks(64, seed_secret),
        registry,
        executor,
        validator.validate_and_encrypt,
        validator.digest_key,
    )


@asynccontextmanager
async def open_server_parts(
    where: Path | UsedDatabase,
    active_max: int = 10,
    recordings: Recordings | None = None,
    pool: SimulatorPool | None = None,
    disk_bound: DiskBound | None = None,
) -> AsyncIterator[ServerParts]:
    """pool: started; it is closed with the rest. A local one without it."""
    database = where if isinstance(where, UsedDatabase) else UsedDatabase.of_file(where)
    url = database.url
    if recordings is None:
        store = Store(url)
    else:
        store = Store(url, recordings.finish_unplayed, recordings.remove_parts)

    registry = RunRegistry(store, active_max, disk_bound=disk_bound)
    pool = pool or shared_pool(4, 0, TIMEOUT_S)
    seed_secret = SeedSecret()
    executor = SessionExecutor(
        registry, pool, seed_secret, recordings=recordings, disk_bound=disk_bound
    )
    service = make_service(registry, executor, seed_secret)
    parts = ServerParts(database, store, registry, pool, executor, service)
    await store.open()
    await registry.open()
    try:
        yield parts
    finally:
        async with asyncio.timeout(TIMEOUT_S):
            await parts.executor.close()
            await registry.close()
            if recordings is not None:
                await recordings.close()
            await pool.close()
            await store.close()


@pytest.fixture
async def parts(tmp_path: Path) -> AsyncIterator[ServerParts]:
    """A server over an SQLite database, closed while patches of its test hold."""
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        yield parts


def run_scenario(where: Path | UsedDatabase, scenario: Scenario) -> None:
    """With a server of its own, for tests that go on without a loop.

    where: a folder for an SQLite file, or a database.
    """
    used = where / "proctor.sqlite" if isinstance(where, Path) else where

    async def run() -> None:
        async with asyncio.timeout(TIMEOUT_S), open_server_parts(used) as parts:
            await scenario(parts)

    asyncio.run(run())


def calibration_run(*tasks: str, run_id: str = "run_1", **changes: Any) -> Run:
    options = {"tasks": list(tasks) or ["score", "count"]}
    found = benchmark_registry.resolve("calibration", options)
    submission = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    plans = found.manifest["episodes"]
    fields: dict[str, Any] = {
        "run_id": run_id,
        "state": "queued",
        "manifest": found.manifest,
        "manifest_sha256": manifest_sha256(found.manifest),
        "submission": submission | {"options": options},
        "images": found.images,
        "episodes": [Episode(i, **plan) for i, plan in enumerate(plans)],
        # The first action of a run is stored: most tests are about what follows it.
        "played_number": 1,
    }
    return make_run(**fields | changes)


def predict_command(turn: Turn, worker_id: str = "w", **values: float) -> Predict:
    action = calibration_action(**values)
    return Predict(worker_id, turn["session_id"], turn["seq"] + 1, [action])


RESULT = Result("success", 1.0, 1, 1, True, False, 0.0, 1e9)


def record_score(run: Run, index: int) -> None:
    run.record_result(run.episodes[index], RESULT)


def fail_writes(
    patch: pytest.MonkeyPatch, parts: ServerParts, broken: set[str], error: Exception
) -> Callable[[str], Awaitable[str]]:
    """Lets no write of a run in `broken` succeed.

    Returns what waits for the next good write of a run and returns the state in it.
    """
    save = parts.store.save
    written: dict[str, asyncio.Future[str]] = {}

    async def fail(run: Run) -> list[Episode]:
        if run.run_id in broken:
            raise error
        scored = await save(run)
        if run.run_id in written:
            written.pop(run.run_id).set_result(run.state)
        return scored

    def next_write(run_id: str) -> Awaitable[str]:
        return written.setdefault(run_id, asyncio.get_running_loop().create_future())

    patch.setattr(parts.store, "save", fail)
    return next_write


@contextmanager
def expect_refusal(
    code: str, **members: Any
) -> Iterator[pytest.ExceptionInfo[Refused]]:
    with pytest.raises(Refused) as caught:
        yield caught
    assert caught.value.code == code, caught.value.detail
    assert caught.value.members == members


def stop_run(parts: ServerParts, run: Run, mode: str = "abort") -> None:
    """As the control plane does it, but for the store."""
    parts.executor.release_sessions(effects.stop(run, mode, time.time()))


def start_task(work: Coroutine[Any, Any, Any]) -> asyncio.Task[Any]:
    return asyncio.create_task(work)


async def assert_no_simulator_lent(parts: ServerParts) -> None:
    """No simulator is lent and no session is kept that has ended."""
    await parts.registry.close()
    assert parts.pool.busy == 0
    assert len(parts.executor._resources) == 0


def assert_no_error_logged(caplog: pytest.LogCaptureFixture) -> None:
    assert [r.getMessage() for r in caplog.records if r.levelname == "ERROR"] == []
