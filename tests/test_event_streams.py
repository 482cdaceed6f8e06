"""Streams of events in the server: what they hold, what they wait for, how they end."""

from __future__ import annotations

import asyncio
import contextlib
import gc
import sqlite3
import time
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import pytest
from starlette.responses import StreamingResponse

from conformance.client.event_reader import Event, EventParser
from reference_server.http import event_streams, views
from reference_server.http.event_streams import EPISODES_PER_BATCH, EventStream
from reference_server.rules import effects as rules
from reference_server.rules.run import Run, RunHead
from reference_server.storage.store import StoreFailed
from tests.conftest import PATIENCE_S
from tests.parts import Gate, Parts, calibration, refusal, score, tell

ROOT = Path(__file__).resolve().parent.parent
MANY = 1000


def view(run: RunHead) -> dict[str, Any]:
    return views.run_view(run, "http://here", None)


def a_reader(
    parts: Parts, run_id: str = "run_1", account: str = "alice"
) -> EventStream:
    return EventStream(parts.registry, run_id, account, view)


class Stream:
    """The body of an answer as a server takes it: the next part when it has time."""

    def __init__(self, parts: AsyncIterator[Any]) -> None:
        self._parts, self._parser = parts, EventParser()

    @classmethod
    async def open(cls, reader: EventStream, last_id: str | None = None) -> Stream:
        answer = await reader.answer(last_id)
        assert isinstance(answer, StreamingResponse)
        return cls(aiter(answer.body_iterator))

    async def part(self) -> bytes:
        async with asyncio.timeout(PATIENCE_S):
            return bytes(await anext(self._parts))

    async def events(self) -> list[Event]:
        """Those of the next part; none of a comment."""
        return self._parser.feed(await self.part())

    async def rest(self) -> list[Event]:
        found: list[Event] = []
        with contextlib.suppress(StopAsyncIteration):
            while True:
                found += await self.events()
        return found


def kinds(events: list[Event]) -> list[str]:
    return [event.kind for event in events]


def indices(events: list[Event]) -> list[int]:
    return [event.body["index"] for event in events if event.kind == "episode"]


async def stored(parts: Parts, *tasks: str, **changes: Any) -> Run:
    run = await parts.registry.add(calibration(*tasks, **changes), None, "")
    await parts.registry.is_stored(run)
    return run


async def scored(parts: Parts, run: Run, *order: int) -> None:
    for index in order:
        score(run, index)
    await parts.registry.commit(run)


async def complete(parts: Parts, run: Run) -> None:
    rules.apply_event(run, "attach_worker")
    await scored(parts, run, *[e.index for e in run.episodes if e.result is None])
    rules.apply_event(run, "all_scored")
    await parts.registry.commit(run)


# --- news ---


def test_a_reader_is_told_of_each_change(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await stored(parts, *["score"] * 3)
        stream = await Stream.open(a_reader(parts))
        first = await stream.part()
        assert first.startswith(b"retry: 1000\n\nevent: run\n")
        await scored(parts, run, 2)
        events = await stream.events()
        assert (kinds(events), indices(events)) == (["episode", "run"], [2])
        assert events[0].body == views.episode_view(run.episodes[2])
        assert events[1].body == view(run)
        await complete(parts, run)
        last = await stream.rest()
        assert indices(last) == [0, 1]
        assert last[-1].body["state"] == "completed"
        answer = await a_reader(parts).answer(last[-1].id)
        assert (answer.status_code, answer.body) == (204, b"")

    tell(tmp_path, story)


def test_what_is_not_stored_is_not_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        run = await stored(parts, "score", "score")
        stream = await Stream.open(a_reader(parts))
        assert kinds(await stream.events()) == ["run"]
        gate = Gate(monkeypatch, parts.store, "save")
        score(run, 0)
        parts.registry.commit_later(run)
        await gate.reached()
        parts.registry.notify(run)  # whatever wakes the stream
        batch = asyncio.ensure_future(stream.events())
        done, _ = await asyncio.wait([batch], timeout=2 * event_streams.PAUSE_S)
        assert done == set()
        gate.open()
        assert indices(await batch) == [0]

    tell(tmp_path, story)


def test_a_run_that_is_always_busy_is_not_silent(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is looked at again and again, and nothing of it has changed."""
    monkeypatch.setattr(event_streams, "KEEPALIVE_S", 0.2)
    monkeypatch.setattr(event_streams, "PAUSE_S", 0.0)

    async def story(parts: Parts) -> None:
        run = await stored(parts)
        stream = await Stream.open(a_reader(parts))
        await stream.events()

        async def keep_busy() -> None:
            while True:
                parts.registry.notify(run)
                await asyncio.sleep(0.01)

        busy = asyncio.ensure_future(keep_busy())
        for _ in range(2):
            assert await stream.part() == b":\n\n"
        busy.cancel()

    tell(tmp_path, story)


def test_a_busy_run_is_looked_at_now_and_then(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Changes that follow one another closely are told together."""
    monkeypatch.setattr(event_streams, "PAUSE_S", 1.0)

    async def story(parts: Parts) -> None:
        run = await stored(parts, *["score"] * 9)
        stream = await Stream.open(a_reader(parts))
        await stream.part()
        told = asyncio.ensure_future(stream.events())
        for index in range(3):
            await scored(parts, run, index)
        assert indices(await told) == [0, 1, 2]

    tell(tmp_path, story)


def test_a_wrong_count_keeps_nobody_busy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run that says that more is scored than there is: the rest is waited for."""
    monkeypatch.setattr(event_streams, "KEEPALIVE_S", 0.1)

    async def story(parts: Parts) -> None:
        run = await stored(parts, *["score"] * 3)
        await scored(parts, run, 1)
        run.scored += 1
        stream = await Stream.open(a_reader(parts))
        assert indices(await stream.events()) == [1]
        assert await stream.part() == b":\n\n"

    tell(tmp_path, story)


def test_a_slow_reader_makes_nothing_pile_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing is looked at while it takes nothing; then it is told all at once."""
    looks = []
    right = EventStream._read_batch

    async def counted(self: EventStream, cursor: Any) -> Any:
        looks.append(cursor)
        return await right(self, cursor)

    monkeypatch.setattr(EventStream, "_read_batch", counted)

    async def story(parts: Parts) -> None:
        run = await stored(parts, *["score"] * 250)
        stream = await Stream.open(a_reader(parts))
        await stream.part()
        for index in reversed(range(200)):
            await scored(parts, run, index)
        assert len(looks) == 1
        events = await stream.events()
        assert indices(events) == [*reversed(range(100, 200))]
        assert len(looks) == 2
        events = await stream.events()
        assert indices(events) == [*reversed(range(100))]
        assert (events[-1].body, len(looks)) == (view(run), 3)

    tell(tmp_path, story)


# --- what it costs ---


def test_a_finished_run_is_told_in_parts_and_kept_nowhere(tmp_path: Path) -> None:
    order = [(7 * index) % MANY for index in range(MANY)]

    async def play(parts: Parts) -> None:
        run = await stored(parts, *["score"] * MANY)
        for first in range(0, MANY, 250):
            await scored(parts, run, *order[first : first + 250])
        run.state = "completed"
        await parts.registry.commit(run)

    async def read(parts: Parts) -> None:
        stream = await Stream.open(a_reader(parts))
        events = await stream.events()
        assert len(events) == EPISODES_PER_BATCH
        events += await stream.rest()
        assert (indices(events), kinds(events)[-1]) == (order, "run")
        middle = await Stream.open(a_reader(parts), events[499].id)
        assert indices(await middle.rest()) == order[500:]
        assert len(parts.registry._in_memory) == 0

    tell(tmp_path, play, read)


def test_who_waits_keeps_no_run_in_memory(tmp_path: Path) -> None:
    async def wait(parts: Parts) -> None:
        stream = await Stream.open(a_reader(parts))
        assert kinds(await stream.events()) == ["run"]
        batch = asyncio.ensure_future(stream.events())
        await asyncio.sleep(0)
        gc.collect()
        assert len(parts.registry._in_memory) == 0
        run = await parts.registry.get("run_1")
        rules.stop(run, "abort", time.time())
        await parts.registry.commit(run)
        (event,) = await batch
        assert event.body["state"] == "stopped"

    async def make(parts: Parts) -> None:
        await stored(parts, state="ready")

    tell(tmp_path, make, wait)


def test_who_hangs_up_leaves_nothing(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        await stored(parts)
        answer = await a_reader(parts).answer(None)
        heard, gone = asyncio.Event(), asyncio.Event()

        async def send(message: Any) -> None:
            if message.get("body"):
                heard.set()

        async def receive() -> Any:
            await gone.wait()
            return {"type": "http.disconnect"}

        scope = {"type": "http", "asgi": {"spec_version": "2.3"}}
        sending = asyncio.ensure_future(answer(scope, receive, send))
        await heard.wait()
        assert len(parts.registry._change_events) == 1
        gone.set()
        await sending
        del answer, sending
        gc.collect()
        assert len(parts.registry._change_events) == 0

    tell(tmp_path, story)


# --- refusals and failures ---


def test_an_id_that_is_ahead_of_the_run_is_refused(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await stored(parts)
        await scored(parts, run, 0)
        stream = await Stream.open(a_reader(parts))
        id_ = (await stream.events())[0].id
        run.scored, run.scored_order = 0, []
        with refusal("invalid_request"):
            await a_reader(parts).answer(id_)

    tell(tmp_path, story)


@pytest.mark.parametrize("account", ["bob", "nobody"])
def test_a_run_of_others_is_none(tmp_path: Path, account: str) -> None:
    async def story(parts: Parts) -> None:
        await stored(parts)
        with refusal("not_found"):
            await a_reader(parts, account=account).answer(None)
        with refusal("not_found"):
            await a_reader(parts, "run_2").answer(None)

    tell(tmp_path, story)


def test_a_stream_ends_when_the_store_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        run = await stored(parts, state="ready")
        stream = await Stream.open(a_reader(parts))
        await stream.events()

        async def fail(*_: object, **__: object) -> None:
            raise StoreFailed("gone")

        monkeypatch.setattr(parts.registry, "read_view", fail)
        parts.registry.notify(run)
        assert await stream.rest() == []

    tell(tmp_path, story)


# --- an older database ---


def test_results_of_before_there_were_places_come_first(tmp_path: Path) -> None:
    async def before(parts: Parts) -> None:
        run = await stored(parts, *["score"] * 5, state="ready")
        await scored(parts, run, 3, 1)
        with contextlib.closing(sqlite3.connect(parts.path)) as database:
            database.execute("ALTER TABLE episodes DROP COLUMN place")

    async def after(parts: Parts) -> None:
        found = await parts.store.read_window("run_1", 0, 9, scored=True)
        assert found is not None
        assert [episode.index for episode in found[1]] == [1, 3]
        run = await parts.registry.get("run_1")
        await scored(parts, run, 4, 0)

    async def read(parts: Parts) -> None:
        stream = await Stream.open(a_reader(parts))
        assert indices(await stream.events()) == [1, 3, 4, 0]
        run = await parts.registry.get("run_1")
        assert run.scored_order == [1, 3, 4, 0]

    tell(tmp_path, before, after, read)
