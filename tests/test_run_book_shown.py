"""What memory shows of a run: never more than the disk has, and every change."""

import asyncio
import gc
from pathlib import Path

import pytest
from starlette.requests import Request

from reference_server.http.auth import Caller
from reference_server.http.dispatch import OperationCall
from reference_server.http.handlers import Handlers
from reference_server.rules.lifecycle import Attach, Resume
from reference_server.rules.run import RunHead
from reference_server.runs.benchmarks import Benchmarks
from reference_server.settings import Settings
from reference_server.storage.store import StoreFailed
from tests.conftest import PATIENCE_S
from tests.parts import Gate, Parts, calibration, failing, predict, refusal, score, tell


def a_call(run_id: str) -> OperationCall:
    request = Request({"type": "http", "headers": []})
    caller = Caller("alice", frozenset({"read", "run"}))
    return OperationCall(
        request, {"run_id": run_id}, {}, {}, "application/json", caller
    )


# --- what is shown is stored ---


def shown_score(run: RunHead) -> int:
    return run.scored


def test_what_is_shown_is_stored(tmp_path: Path) -> None:
    """A write that was only just begun counts as well; nobody waits for it here."""

    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration(), None, "")
        score(run, 0)
        parts.registry.commit_later(run)
        assert await parts.registry.render_when_stored(run, shown_score) == 1
        stored = await parts.store.load(run.run_id)
        assert stored is not None
        assert stored.scored == 1

    tell(tmp_path, story)


def test_what_could_not_be_stored_is_not_shown(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration(), None, "")
        await parts.registry.is_stored(run)
        failing(monkeypatch, parts, {run.run_id}, StoreFailed("full"))
        score(run, 0)
        parts.registry.commit_later(run)
        assert await parts.registry.render_when_stored(run, shown_score) == 0

    tell(tmp_path, story)


def test_a_look_waits_for_no_later_write(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run whose workers never pause can be looked at, and shows no more than then."""

    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration(), None, "")
        await parts.registry.is_stored(run)
        score(run, 0)
        parts.registry.commit_later(run)
        looking = asyncio.create_task(
            parts.registry.render_when_stored(run, shown_score)
        )
        await asyncio.sleep(0)
        gate = Gate(monkeypatch, parts.store, "save")
        score(run, 1)
        parts.registry.commit_later(run)
        await gate.reached()
        assert await looking == 1
        gate.open()
        assert await parts.registry.render_when_stored(run, shown_score) == 2

    tell(tmp_path, story)


def test_a_page_shows_each_run_as_it_was_stored(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """While the second run of the page is waited for, the first one plays on."""

    async def story(parts: Parts) -> None:
        runs = [
            await parts.registry.add(calibration(run_id=f"run_{number}"), None, "")
            for number in (1, 2)
        ]
        for run in runs:
            await parts.registry.is_stored(run)
        gate = Gate(monkeypatch, parts.store, "save")
        parts.registry.commit_later(runs[0])
        looking = asyncio.create_task(
            parts.registry.page("alice", None, 9, shown_score)
        )
        seen = Gate(monkeypatch, parts.registry, "is_stored")
        await seen.reached()  # the newest, run_2, has been looked at
        score(runs[1], 0)
        parts.registry.commit_later(runs[1])
        seen.open()
        gate.open()
        assert await looking == [0, 0]

    tell(tmp_path, story)


@pytest.mark.parametrize("is_lost", [False, True])
def test_a_refusal_tells_no_state_that_may_be_lost(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_lost: bool
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("score", state="ready"), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        broken = {run.run_id} if is_lost else set[str]()
        failing(monkeypatch, parts, broken, StoreFailed("full"))
        gate = Gate(monkeypatch, parts.store, "save")
        last = asyncio.create_task(
            parts.executor.predict(run, predict(turn, score=1, end=1))
        )
        await gate.reached()
        assert run.state == "completed"
        routes = Handlers(Settings(), Benchmarks(64), parts.registry, parts.executor)
        resuming = asyncio.create_task(
            routes._run_accepting(a_call(run.run_id), Resume())
        )
        gate.open()
        await asyncio.wait([last])
        if is_lost:
            found = await resuming
            assert (found is run, found.state) == (False, "ready")
        else:
            with refusal("illegal_transition", state="completed"):
                await resuming

    tell(tmp_path, story)


# --- news ---


def test_no_change_is_missed_between_a_look_and_the_wait(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration(), None, "")
        await parts.registry.is_stored(run)
        news = parts.registry.change_event(run.run_id)
        parts.registry.notify(run)
        assert await parts.registry.wait_for_change(news, PATIENCE_S)
        assert not await parts.registry.wait_for_change(
            parts.registry.change_event(run.run_id), 0.001
        )
        del news
        gc.collect()
        assert len(parts.registry._change_events) == 0, (
            "what nobody waits for is not kept"
        )

    tell(tmp_path, story)


def test_nobody_begins_to_wait_when_the_server_ends(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration(), None, "")
        await parts.registry.is_stored(run)
        waiting = asyncio.create_task(
            parts.registry.wait_for_change(
                parts.registry.change_event(run.run_id), PATIENCE_S
            )
        )
        await asyncio.sleep(0)
        parts.registry.release_waiters()
        for _ in range(2):
            with refusal("unavailable"):
                await waiting
            waiting = asyncio.create_task(
                parts.registry.wait_for_change(
                    parts.registry.change_event(run.run_id), PATIENCE_S
                )
            )
        with refusal("unavailable"):
            await waiting

    tell(tmp_path, story)
