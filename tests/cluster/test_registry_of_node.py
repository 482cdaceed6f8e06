"""The runs in memory of one node: what it claims is loaded, what it lost is not."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path

import pytest
import sqlalchemy as sa

from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run
from reference_server.runs import registry as registry_module
from reference_server.runs.registry import RunRegistry
from reference_server.storage.store import Store, StoreFailed
from reference_server.system.counters import COUNTERS
from tests.support.server.databases import UsedDatabase
from tests.support.server.server_parts import BlockedCall, calibration_run


class Ownership:
    """A node that claims every run that it is asked for."""

    node_id = "first"

    async def claim(self, _run_id: str) -> bool:
        return True


@dataclass
class NodeRuns:
    """Store and registry of one node."""

    store: Store
    registry: RunRegistry
    ownership: Ownership
    changed: asyncio.Queue[Run] = field(default_factory=asyncio.Queue)


@asynccontextmanager
async def opened(folder: Path) -> AsyncIterator[NodeRuns]:
    store = Store(UsedDatabase.of_file(folder / "d.sqlite").url, is_shared=True)
    ownership = Ownership()

    def on_change(run: Run) -> None:
        runs.changed.put_nowait(run)

    registry = RunRegistry(store, 4, lambda _: None, on_change, ownership=ownership)
    runs = NodeRuns(store, registry, ownership)
    await store.open()
    await registry.open()
    try:
        yield runs
    finally:
        await registry.close()
        await store.close()


def test_what_was_claimed_is_loaded_though_the_database_fails_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def scenario() -> None:
        async with opened(tmp_path) as runs:
            run = calibration_run()
            run.owner, run.fence = runs.ownership.node_id, 1
            assert await runs.store.insert(run, None, "")
            right, calls = runs.store.load, 0

            async def load(run_id: str) -> Run | None:
                nonlocal calls
                calls += 1
                if calls == 1:
                    raise StoreFailed("not now")
                return await right(run_id)

            monkeypatch.setattr(runs.store, "load", load)
            monkeypatch.setattr(registry_module, "RELOAD_S", 0.01)
            runs.registry.load_in_background(run.run_id)
            async with asyncio.timeout(10):  # a push run is driven from then on
                assert (await runs.changed.get()).run_id == run.run_id
            assert calls == 2

    asyncio.run(scenario())


def test_a_run_that_the_node_loses_while_it_is_stored_is_not_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The submit is refused; who asks again gets the run as it is stored."""

    async def scenario() -> None:
        async with opened(tmp_path) as runs:
            blocked = BlockedCall(monkeypatch, runs.store, "insert")
            run = calibration_run()
            adding = asyncio.ensure_future(runs.registry.add(run, "key", "sha"))
            await blocked.wait_until_reached()
            runs.ownership.node_id = "again"
            runs.registry.drop_all()
            blocked.open()
            with pytest.raises(Refused) as refused:
                await adding
            assert refused.value.code == "unavailable"
            assert not runs.registry.has(run.run_id)
            assert runs.registry.count_open()["ready"] == 0
            change = "UPDATE runs SET owner = 'again', fence = 2"
            async with runs.store.write() as connection:
                await connection.execute(sa.text(change))
            loaded = await runs.registry.get(run.run_id)
            assert (loaded.owner, loaded.lost) == ("again", False)

    asyncio.run(scenario())


def test_a_lost_run_is_loaded_again(tmp_path: Path) -> None:
    async def scenario() -> None:
        async with opened(tmp_path) as runs:
            run = calibration_run()
            await runs.registry.add(run, None, "")
            run.lost = True
            assert not (await runs.registry.get(run.run_id)).lost

    asyncio.run(scenario())


@pytest.mark.parametrize("write", ["commit", "delete"])
def test_a_write_after_another_node_has_claimed_the_run_is_counted(
    tmp_path: Path, write: str
) -> None:
    async def scenario() -> None:
        async with opened(tmp_path) as runs:
            run = calibration_run()
            await runs.registry.add(run, None, "")
            await runs.registry.commit(run)
            before = COUNTERS.fenced_writes
            async with runs.store.write() as connection:
                await connection.execute(sa.text("UPDATE runs SET fence = 7"))
            with pytest.raises((Refused, StoreFailed)):
                await getattr(runs.registry, write)(run)
            assert COUNTERS.fenced_writes == before + 1
            assert not runs.registry.has(run.run_id)

    asyncio.run(scenario())
