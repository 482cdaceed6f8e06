"""Databases of the growth benchmark hold valid runs, and each server has its own."""

import asyncio
from collections.abc import Sequence
from pathlib import Path

import pytest

from benchmarks.growth.filled_databases import READY_RUNS, DatabaseCase, fill
from reference_server.rules.run import Episode, RunHead
from reference_server.runs.registry import RunRegistry
from reference_server.storage.run_store import Store
from reference_server.views import run_views
from tests.support.server.server_parts import count_rows

pytestmark = pytest.mark.slow("measures databases")


async def test_a_filled_database_contains_valid_runs(tmp_path: Path) -> None:
    path = tmp_path / "runs.sqlite"
    await asyncio.to_thread(fill, path, DatabaseCase("small", runs=3, episodes=8))
    assert count_rows(path, "runs") == 3 + READY_RUNS
    assert count_rows(path, "episodes") == 3 * 8
    assert count_rows(path, "manifests") == 1

    def view(run: RunHead, episodes: Sequence[Episode]) -> tuple[str, int, bool]:
        score = run_views.score_view(run, episodes)
        return run.state, run.scored, bool(score["complete"])

    store = Store(f"sqlite+aiosqlite:///{path}")
    await store.open()
    registry = RunRegistry(store, 1000)
    for number in range(3):
        run_id = f"completed_{number}"
        found = await registry.reader.read_view(run_id, "bench", view, end=None)
        assert found == ("completed", 8, True)
    waiting = await registry.reader.read_view("ready_0", "bench", view, end=None)
    assert waiting == ("ready", 0, False)
    newest = await registry.reader.page("bench", 13, 9, lambda run: run.run_id)
    assert newest == ["completed_2", "completed_1", "completed_0"]
    await store.close()
