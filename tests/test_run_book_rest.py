"""Runs at rest: read for whoever looks, in nobody's memory, no older than told."""

import asyncio
import gc
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from reference_server.http import views
from reference_server.rules import effects
from reference_server.rules.lifecycle import Attach, Detach
from reference_server.rules.run import Episode, Run, RunHead
from reference_server.runs import registry
from reference_server.storage.store import StoreFailed
from tests.conftest import PATIENCE_S
from tests.parts import (
    Gate,
    Parts,
    begun,
    calibration,
    failing,
    predict,
    refusal,
    score,
    tell,
)

Told = tuple[str, int, list[str]]


def told(run: RunHead, episodes: Sequence[Episode]) -> Told:
    return run.state, run.scored, [e.episode_id for e in episodes if e.result]


async def stored(parts: Parts, *runs: Run) -> None:
    """Runs in the database and nowhere else."""
    for run in runs:
        changed, run.changed = run.changed, set()
        assert await parts.store.insert(run, None, "")
        run.changed = changed
        await parts.store.save(run)


def finished(run_id: str = "run_1", state: str = "completed") -> Run:
    run = calibration("score", "echo", "count", run_id=run_id, state=state)
    for index in range(len(run.episodes)):
        score(run, index)
    return run


def in_memory(parts: Parts) -> list[str]:
    gc.collect()
    return sorted(parts.registry._in_memory)


# --- a look ---


@pytest.mark.parametrize("state", registry.STABLE_STATES)
def test_a_look_at_a_run_at_rest_leaves_it_there(tmp_path: Path, state: str) -> None:
    async def story(parts: Parts) -> None:
        await stored(parts, finished(state=state))
        look = parts.registry.read_view
        assert await look("run_1", "alice", told) == (state, 3, [])
        page = await look("run_1", "alice", told, 1, 2)
        assert page == (state, 3, ["e0001"])
        assert await look("run_1", "alice", told, 2, 9) == (state, 3, ["e0002"])
        assert await look("run_1", "alice", told, 3, 9) == (state, 3, [])
        everything = await look("run_1", "alice", views.score_view, end=None)
        assert await parts.registry.page("alice", None, 9, lambda run: run.scored) == [
            3
        ]
        assert in_memory(parts) == []
        run = await parts.registry.get("run_1")
        assert views.score_view(run, run.episodes) == everything
        assert await look("run_1", "alice", told, 1, 2) == page

    tell(tmp_path, story)


def test_it_looks_the_same_from_memory_and_from_the_store(tmp_path: Path) -> None:
    def whole(run: RunHead, episodes: Sequence[Episode]) -> list[object]:
        shown = [views.episode_view(episode) for episode in episodes]
        return [views.run_view(run, "http://x", None), shown]

    async def story(parts: Parts) -> None:
        run = calibration("score", "echo", "count", state="stopped")
        run.episodes[0].attempt = run.episodes[0].faults = 2
        run.changed = {0}
        score(run, 1)
        await stored(parts, run)
        read = await parts.registry.read_view("run_1", "alice", whole, end=None)
        run = await parts.registry.get("run_1")
        assert await parts.registry.read_view("run_1", "alice", whole, end=None) == read

    tell(tmp_path, story)


def test_a_look_tells_strangers_nothing(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        await stored(parts, finished())
        said = []
        for run_id in ("run_1", "run_2"):
            with refusal("not_found") as refused:
                await parts.registry.read_view(run_id, "bob", told)
            said.append(refused.value.detail.replace(run_id, ""))
        assert said[0] == said[1]

    tell(tmp_path, story)


@pytest.mark.parametrize(("row", "shown"), [("running", "ready"), ("queued", "ready")])
def test_a_row_that_is_not_at_rest_is_no_answer(
    tmp_path: Path, row: str, shown: str
) -> None:
    """Its sessions were lost with a write, or it waits to be admitted."""

    async def story(parts: Parts) -> None:
        await stored(parts, calibration(state=row))
        found = await parts.registry.read_view("run_1", "alice", told)
        assert found == (shown, 0, [])

    tell(tmp_path, story)


def test_a_run_that_is_taken_up_meanwhile_is_shown_as_it_is_then(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        runs = [calibration("score", "score", run_id=f"run_{n}") for n in (1, 2)]
        for run in runs:
            run.state = "stopped"
        await stored(parts, *runs)
        read_window = Gate(monkeypatch, parts.store, "read_window", after=True)
        heads = Gate(monkeypatch, parts.store, "heads", after=True)
        looking = begun(parts.registry.read_view("run_1", "alice", told, end=None))
        paging = begun(parts.registry.page("alice", None, 9, lambda run: run.state))
        await read_window.reached()
        await heads.reached()
        run = await parts.registry.get("run_1")
        effects.resume(run, 0.0)
        await parts.registry.commit(run)
        score(run, 1)
        await parts.registry.commit(run)
        read_window.open()
        heads.open()
        assert await looking == ("ready", 1, ["e0001"])
        assert await paging == ["stopped", "ready"]

    tell(tmp_path, story)


def test_a_look_never_shows_what_could_not_be_stored(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration(state="ready"), None, "")
        await parts.registry.is_stored(run)
        failing(monkeypatch, parts, {run.run_id}, StoreFailed("full"))
        score(run, 0)
        parts.registry.commit_later(run)
        looked = await parts.registry.read_view("run_1", "alice", told, end=None)
        assert looked == ("ready", 0, [])
        shown = await parts.registry.page("alice", None, 9, lambda run: run.scored)
        assert shown == [0]

    tell(tmp_path, story)


# --- leaving memory ---


def test_whoever_holds_a_run_and_whoever_asks_again_have_one_object(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The run leaves the kept ones while its reader has not had its turn."""
    monkeypatch.setattr(registry, "CACHED_RUNS_MAX", 1)

    async def story(parts: Parts) -> None:
        await stored(parts, *(finished(f"run_{number}") for number in range(4)))
        gate = Gate(monkeypatch, parts.store, "load", after=True)
        asking = [begun(parts.registry.get(f"run_{number}")) for number in (0, 1, 2)]
        asking.append(begun(parts.registry.get("run_0")))
        await gate.reached()
        gate.open()
        first, *_, again = await asyncio.gather(*asking)
        assert first is again
        await parts.registry.get("run_3")
        assert await parts.registry.get("run_0") is first
        del first, again, asking, _
        await parts.registry.get("run_3")
        assert in_memory(parts) == ["run_3"]

    tell(tmp_path, story)


def test_a_waiter_hears_of_a_run_that_left_memory_meanwhile(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It waits for the id: the run is loaded again by whoever changes it."""
    monkeypatch.setattr(registry, "CACHED_RUNS_MAX", 1)

    async def story(parts: Parts) -> None:
        await stored(parts, calibration(state="stopped"), finished("run_2"))
        await parts.registry.get("run_1")
        waiting = begun(
            parts.registry.wait_for_change(
                parts.registry.change_event("run_1"), PATIENCE_S
            )
        )
        await asyncio.sleep(0)
        await parts.registry.get("run_2")
        assert in_memory(parts) == ["run_2"]
        assert not waiting.done()
        run = await parts.registry.get("run_1")
        effects.resume(run, 0.0)
        await parts.registry.commit(run)
        assert await waiting

    tell(tmp_path, story)


def test_a_waiter_keeps_no_run_in_memory(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        await stored(parts, calibration(state="ready"))
        news = parts.registry.change_event("run_1")
        await parts.registry.read_view("run_1", "alice", told)
        waiting = begun(parts.registry.wait_for_change(news, PATIENCE_S))
        await asyncio.sleep(0)
        assert in_memory(parts) == []
        run = await parts.registry.get("run_1")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        assert await waiting
        assert turn["seq"] == 0

    tell(tmp_path, story)


def test_a_lease_ends_although_nobody_asks_for_the_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is played stays in memory; after its lease it is stored, and may leave."""
    monkeypatch.setattr(registry, "CACHED_RUNS_MAX", 1)

    async def story(parts: Parts) -> None:
        await stored(parts, finished("run_2"))
        run = calibration("count", idle_timeout_s=0.2)
        run = await parts.registry.add(run, None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        await parts.executor.predict(run, predict(turn))
        del run
        await parts.registry.get("run_2")
        news = parts.registry.change_event("run_1")
        while (await parts.registry.read_view("run_1", "alice", told))[0] == "running":
            assert await parts.registry.wait_for_change(news, PATIENCE_S)
            news = parts.registry.change_event("run_1")
        await parts.registry.get("run_2")
        await parts.registry.close()
        assert in_memory(parts) == ["run_2"]

        def attempt(run: RunHead, episodes: Sequence[Episode]) -> tuple[str, int]:
            return run.state, episodes[0].attempt

        found = await parts.registry.read_view("run_1", "alice", attempt, end=1)
        assert found == ("ready", 2)

    tell(tmp_path, story)


def test_an_episode_is_scored_once_however_often_its_run_leaves_memory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(registry, "CACHED_RUNS_MAX", 1)

    async def story(parts: Parts) -> None:
        await stored(parts, calibration(*["score"] * 4, state="ready"))
        await stored(parts, finished("run_2"))
        for number in range(4):
            run = await parts.registry.get("run_1")
            assert (run.scored, run.pending[0]) == (number, number)
            turn = await parts.executor.attach(run, Attach("w", f"key-{number}"))
            value = (number + 1) / 8
            turn = await parts.executor.predict(run, predict(turn, score=value, end=1))
            session_id = turn["session_id"]
            await parts.executor.detach(run, Detach("w", session_id))
            del run
            await parts.registry.get("run_2")
            assert in_memory(parts) == ["run_2"]
            counted = await parts.registry.read_view("run_1", "alice", told, end=None)
            assert counted[1] == len(counted[2]) == number + 1
        body = await parts.registry.read_view(
            "run_1", "alice", views.score_view, end=None
        )
        assert (body["state"], body["score"]) == ("completed", 10 / 32)

    tell(tmp_path, story)


# --- the queue ---


def test_who_is_behind_moves_and_who_is_before_does_not(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        runs = [calibration(run_id=f"run_{n}", queue_until_wall=1e11) for n in range(4)]
        for run in runs:
            await parts.registry.add(run, None, "")
        positions = [parts.registry.queue_position(run) for run in runs]
        assert positions == [1, 2, 3, 4]
        news = [parts.registry.change_event(run.run_id) for run in runs]
        effects.stop(runs[1], "abort", 0.0)
        await parts.registry.commit(runs[1])
        assert [event.is_set() for event in news] == [False, True, True, True]
        positions = [parts.registry.queue_position(run) for run in runs]
        assert positions == [1, None, 2, 3]
        news = [parts.registry.change_event(run.run_id) for run in runs]
        effects.resume(runs[1], 1e11)  # an old number: it comes before newer runs
        await parts.registry.commit(runs[1])
        assert [event.is_set() for event in news] == [False, True, True, True]
        positions = [parts.registry.queue_position(run) for run in runs]
        assert positions == [1, 2, 3, 4]

    tell(tmp_path, story)


def test_nobody_pays_for_the_length_of_a_queue_that_cannot_move(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        first = await parts.registry.add(calibration(), None, "")
        second = await parts.registry.add(calibration(run_id="run_2"), None, "")
        asked, admit = [], effects.admit

        def counted(queued: Sequence[Run], *rest: Any) -> list[Run]:
            asked.append(len(queued))
            return admit(queued, *rest)

        monkeypatch.setattr(effects, "admit", counted)
        parts.registry.notify(first)
        assert asked == []
        effects.stop(first, "abort", 0.0)
        await parts.registry.commit(first)
        assert asked == [1]
        assert second.state == "ready"

    tell(tmp_path, story, active_max=1)
