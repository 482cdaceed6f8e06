"""Databases of the growth benchmark hold valid runs; its page reports every figure."""

import asyncio
from collections.abc import Sequence
from pathlib import Path

import pytest

from benchmarks.filled_databases import READY_RUNS, DatabaseCase, fill
from benchmarks.storage_growth import DATABASE_CASES, report
from reference_server.rules.run import Episode, Run, RunHead
from reference_server.runs.registry import RunRegistry
from reference_server.storage.store import Store
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

    def ignore(_run: Run) -> None:
        pass

    store = Store(f"sqlite+aiosqlite:///{path}")
    await store.open()
    registry = RunRegistry(store, 1000, ignore, ignore)
    for number in range(3):
        run_id = f"completed_{number}"
        found = await registry.read_view(run_id, "bench", view, end=None)
        assert found == ("completed", 8, True)
    waiting = await registry.read_view("ready_0", "bench", view, end=None)
    assert waiting == ("ready", 0, False)
    newest = await registry.page("bench", 13, 9, lambda run: run.run_id)
    assert newest == ["completed_2", "completed_1", "completed_0"]
    await store.close()


def test_each_server_has_a_database_of_its_own() -> None:
    files = [database_case.file for database_case in DATABASE_CASES]
    assert len(set(files)) == len(files)


def test_the_page_contains_every_figure() -> None:
    case_names = [database_case.name for database_case in DATABASE_CASES]
    figures = iter(range(1000, 2000))
    cost = {
        "p50_ms": {name: float(next(figures)) for name in case_names},
        "ratio": {name: float(next(figures)) for name in case_names},
    }
    weighed = {
        name: {"few_mb": float(next(figures)), "many_mb": float(next(figures))}
        for name in ("looked_at", "played", "left_waiting")
    }
    body = {
        "requests": {"get_run": cost},
        "memory": {"at_start_mb": float(next(figures)), **weighed},
        **{
            waiting: {
                "waiting": next(figures),
                "cost_mb": float(next(figures)),
                "cpu_share": next(figures) / 100,
            }
            for waiting in ("long_polls", "event_streams")
        },
        "turns": {
            "turns": next(figures),
            "written_bytes": next(figures),
            "last_turn_bytes": next(figures),
        },
        "queue": {
            "runs": next(figures),
            "ratio": {
                n: float(next(figures)) for n in ("submit", "get_run", "predict")
            },
        },
    }
    text = report(body)
    missing = [n for n in range(1000, next(figures)) if str(n) not in text]
    assert missing == []
