"""Scores that are kept: never another run's, never an older one, never a lost one."""

import gc
from dataclasses import replace
from typing import Any

import pytest

from reference_server.rules.runs import effects
from reference_server.rules.runs.run import Run
from reference_server.runs.memory import score_cache
from reference_server.runs.memory.score_cache import ScoreCache
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.views import run_views
from tests.support.server.server_parts import (
    RESULT,
    BlockedCall,
    ServerParts,
    calibration_run,
    expect_refusal,
    fail_writes,
    record_score,
    start_task,
)
from tests.support.waiting import wait_in_loop


def record_computed_scores(patch: pytest.MonkeyPatch) -> list[str]:
    """The ids of the runs whose score is computed from now on."""
    computed: list[str] = []
    right = run_views.score_view

    def note(run: Any, episodes: Any) -> Any:
        computed.append(run.run_id)
        return right(run, episodes)

    patch.setattr(run_views, "score_view", note)
    return computed


async def evict_run(parts: ServerParts, run: Run) -> None:
    """The run is stored and leaves memory as soon as no caller holds it."""
    await parts.registry.writer.commit(run)
    parts.registry.cache._recent.drop(run.run_id)


async def wait_until_evicted(parts: ServerParts, run_id: str) -> None:
    """A task that stored the run may hold it for a moment."""

    def is_evicted() -> bool:
        gc.collect()
        return run_id not in parts.registry.cache

    await wait_in_loop(is_evicted)


async def add_stopped_run(parts: ServerParts, run_id: str, count: int) -> None:
    """A stopped run with three episodes and `count` results, not held in memory."""
    run = calibration_run("score", "score", "score", run_id=run_id, state="stopped")
    await parts.registry.add(run, None, "")
    for index in range(count):
        record_score(run, index)
    await evict_run(parts, run)


async def test_a_changed_run_is_scored_again(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    computed = record_computed_scores(monkeypatch)
    await add_stopped_run(parts, "run_1", 1)
    await wait_until_evicted(parts, "run_1")
    score_cache = ScoreCache()
    before = await score_cache.get(parts.registry.reader, "run_1", "alice")
    assert (before["state"], before["counts"]["unscored"]) == ("stopped", 2)
    run = await parts.registry.get("run_1")
    effects.resume(run, 1e11)
    await parts.registry.writer.commit(run)
    queued = await score_cache.get(parts.registry.reader, "run_1", "alice")
    assert queued == before | {"state": "queued"}
    record_score(run, 1)
    playing = await score_cache.get(parts.registry.reader, "run_1", "alice")
    assert playing["counts"]["unscored"] == 1
    effects.stop(run, "abort", 0.0)
    await evict_run(parts, run)
    del run
    await wait_until_evicted(parts, "run_1")
    del computed[:]
    for _ in range(2):
        after = await score_cache.get(parts.registry.reader, "run_1", "alice")
        assert after == playing | {"state": "stopped"}
    assert computed == ["run_1"]


async def test_lost_results_are_not_cached(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """Who asked has left before it was known; then another result is stored."""
    computed = record_computed_scores(monkeypatch)
    score_cache, broken = ScoreCache(), {"run_1"}
    run = await parts.registry.add(calibration_run("score", state="ready"), None, "")
    fail_writes(monkeypatch, parts, broken, StoreFailed("full"))
    blocked = BlockedCall(monkeypatch, parts.store, "save")
    blocked_is_stored = BlockedCall(monkeypatch, parts.registry.writer, "is_stored")
    record_score(run, 0)
    parts.registry.writer.commit_later(run)
    leaving = start_task(score_cache.get(parts.registry.reader, "run_1", "alice"))
    await blocked_is_stored.wait_until_reached()
    assert computed == ["run_1"]
    leaving.cancel()
    blocked_is_stored.open()
    blocked.open()
    assert not await parts.registry.writer.is_stored(run)
    broken.clear()
    run = await parts.registry.get("run_1")
    record_score(run, 0)
    run.episodes[0].result = replace(RESULT, score=0.25)
    await evict_run(parts, run)
    del run
    gc.collect()
    for _ in range(2):
        assert (await score_cache.get(parts.registry.reader, "run_1", "alice"))[
            "mean"
        ] == 0.25


async def test_a_cached_score_is_private_to_its_account(parts: ServerParts) -> None:
    await add_stopped_run(parts, "run_1", 1)
    gc.collect()
    score_cache = ScoreCache()
    for _ in range(2):
        await score_cache.get(parts.registry.reader, "run_1", "alice")
        with expect_refusal("not_found"):
            await score_cache.get(parts.registry.reader, "run_1", "bob")


async def test_the_score_cache_is_bounded(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    monkeypatch.setattr(score_cache, "CACHED_SCORES_MAX", 2)
    computed = record_computed_scores(monkeypatch)
    for number in range(3):
        await add_stopped_run(parts, f"run_{number}", 1)
        await wait_until_evicted(parts, f"run_{number}")
    cache = ScoreCache()
    for number in (0, 1, 2, 2, 1, 0):
        await cache.get(parts.registry.reader, f"run_{number}", "alice")
    assert computed == ["run_0", "run_1", "run_2", "run_0"]
