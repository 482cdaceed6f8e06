"""Scores that are kept: never another run's, never an older one, never a lost one."""

import gc
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from reference_server.http import views
from reference_server.rules import effects
from reference_server.rules.run import Run
from reference_server.runs import scores
from reference_server.runs.scores import ScoreCache
from reference_server.storage.store import StoreFailed
from tests.parts import (
    RESULT,
    Gate,
    Parts,
    begun,
    calibration,
    failing,
    refusal,
    score,
    tell,
)


def counted(patch: pytest.MonkeyPatch) -> list[str]:
    """The ids of the runs whose score is computed from now on."""
    computed: list[str] = []
    right = views.score_view

    def note(run: Any, episodes: Any) -> dict[str, Any]:
        computed.append(run.run_id)
        return right(run, episodes)

    patch.setattr(views, "score_view", note)
    return computed


async def put_down(parts: Parts, run: Run) -> None:
    """The run is stored and leaves memory as soon as nobody holds it."""
    await parts.registry.commit(run)
    parts.registry._recent.clear()


async def at_rest(parts: Parts, run_id: str, count: int) -> None:
    """A stopped run with three episodes and `count` results, in nobody's memory."""
    run = calibration("score", "score", "score", run_id=run_id, state="stopped")
    await parts.registry.add(run, None, "")
    for index in range(count):
        score(run, index)
    await put_down(parts, run)


def test_the_score_of_a_run_at_rest_is_computed_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    computed = counted(monkeypatch)

    async def story(parts: Parts) -> None:
        await at_rest(parts, "run_1", 1)
        await at_rest(parts, "run_2", 2)
        gc.collect()
        told = ScoreCache()
        for _ in range(3):
            first = await told.get(parts.registry, "run_1", "alice")
            second = await told.get(parts.registry, "run_2", "alice")
        assert [s["counts"]["success"] for s in (first, second)] == [1, 2]
        assert [s["run_id"] for s in (first, second)] == computed == ["run_1", "run_2"]

    tell(tmp_path, story)


def test_it_is_computed_anew_when_the_run_has_changed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    computed = counted(monkeypatch)

    async def story(parts: Parts) -> None:
        await at_rest(parts, "run_1", 1)
        gc.collect()
        told = ScoreCache()
        before = await told.get(parts.registry, "run_1", "alice")
        assert (before["state"], before["counts"]["unscored"]) == ("stopped", 2)
        run = await parts.registry.get("run_1")
        effects.resume(run, 1e11)
        await parts.registry.commit(run)
        queued = await told.get(parts.registry, "run_1", "alice")
        assert queued == before | {"state": "queued"}
        score(run, 1)
        playing = await told.get(parts.registry, "run_1", "alice")
        assert playing["counts"]["unscored"] == 1
        effects.stop(run, "abort", 0.0)
        await put_down(parts, run)
        del run
        gc.collect()
        del computed[:]
        for _ in range(2):
            after = await told.get(parts.registry, "run_1", "alice")
            assert after == playing | {"state": "stopped"}
        assert computed == ["run_1"]

    tell(tmp_path, story)


def test_what_was_lost_is_not_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Who asked has left before it was known; then another result is stored."""
    computed = counted(monkeypatch)

    async def story(parts: Parts) -> None:
        told, broken = ScoreCache(), {"run_1"}
        run = await parts.registry.add(calibration("score", state="ready"), None, "")
        failing(monkeypatch, parts, broken, StoreFailed("full"))
        gate = Gate(monkeypatch, parts.store, "save")
        looked = Gate(monkeypatch, parts.registry, "is_stored")
        score(run, 0)
        parts.registry.commit_later(run)
        leaving = begun(told.get(parts.registry, "run_1", "alice"))
        await looked.reached()
        assert computed == ["run_1"]
        leaving.cancel()
        looked.open()
        gate.open()
        assert not await parts.registry.is_stored(run)
        broken.clear()
        run = await parts.registry.get("run_1")
        score(run, 0)
        run.episodes[0].result = replace(RESULT, score=0.25)
        await put_down(parts, run)
        del run
        gc.collect()
        for _ in range(2):
            assert (await told.get(parts.registry, "run_1", "alice"))["mean"] == 0.25

    tell(tmp_path, story)


def test_a_kept_score_is_no_strangers_business(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        await at_rest(parts, "run_1", 1)
        gc.collect()
        told = ScoreCache()
        for _ in range(2):
            await told.get(parts.registry, "run_1", "alice")
            with refusal("not_found"):
                await told.get(parts.registry, "run_1", "bob")

    tell(tmp_path, story)


def test_so_many_are_kept_and_no_more(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(scores, "CACHED_SCORES_MAX", 2)
    computed = counted(monkeypatch)

    async def story(parts: Parts) -> None:
        for number in range(3):
            await at_rest(parts, f"run_{number}", 1)
        gc.collect()
        told = ScoreCache()
        for number in (0, 1, 2, 2, 1, 0):
            await told.get(parts.registry, f"run_{number}", "alice")
        assert computed == ["run_0", "run_1", "run_2", "run_0"]

    tell(tmp_path, story)
