"""Streams of events in the server: what they hold, what they wait for, how they end."""

from __future__ import annotations

import asyncio
import contextlib
import gc
import time
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import pytest
from starlette.responses import StreamingResponse

from conformance.client.event_reader import Event, EventParser
from reference_record.generated import answers
from reference_server.http import event_streams
from reference_server.http.event_streams import (
    EPISODES_PER_BATCH,
    EventStream,
    SharedStreams,
)
from reference_server.rules.refusal import Refused
from reference_server.rules.runs import effects as rules
from reference_server.rules.runs.run import Run, RunHead
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.views import run_views
from tests.support.server.event_lists import indices, kinds
from tests.support.server.server_parts import (
    BlockedCall,
    ServerParts,
    calibration_run,
    expect_refusal,
    open_server_parts,
    record_score,
)
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_in_loop

MANY = 1000


def view(run: RunHead) -> answers.Run:
    return run_views.run_view(run, "http://here", None)


def make_event_stream(parts: ServerParts) -> EventStream:
    return EventStream(parts.registry, "run_1", "alice", view)


class StreamClient:
    """The body of an answer as a server takes it: the next part when it has time."""

    def __init__(self, parts: AsyncIterator[Any]) -> None:
        self._parts, self._parser = parts, EventParser()

    @classmethod
    async def open(
        cls, reader: EventStream, last_id: str | None = None
    ) -> StreamClient:
        answer = await reader.answer(last_id)
        assert isinstance(answer, StreamingResponse)
        return cls(aiter(answer.body_iterator))

    async def part(self) -> bytes:
        async with asyncio.timeout(TIMEOUT_S):
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


async def add_stored_run(parts: ServerParts, *tasks: str, **changes: Any) -> Run:
    run = await parts.registry.add(calibration_run(*tasks, **changes), None, "")
    await parts.registry.writer.is_stored(run)
    return run


async def score_episodes(parts: ServerParts, run: Run, *order: int) -> None:
    for index in order:
        record_score(run, index)
    await parts.registry.writer.commit(run)


# --- changes of a run ---


async def test_unstored_results_are_not_sent(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    run = await add_stored_run(parts, "score", "score")
    stream = await StreamClient.open(make_event_stream(parts))
    assert kinds(await stream.events()) == ["run"]
    blocked = BlockedCall(monkeypatch, parts.store, "save")
    record_score(run, 0)
    parts.registry.writer.commit_later(run)
    await blocked.wait_until_reached()
    parts.registry.notify(run)  # whatever wakes the stream
    batch = asyncio.ensure_future(stream.events())
    done, _ = await asyncio.wait([batch], timeout=2 * event_streams.PAUSE_S)
    assert done == set()
    blocked.open()
    assert indices(await batch) == [0]


async def test_frequent_changes_are_sent_in_one_batch(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """Changes that follow one another closely are sent together."""
    monkeypatch.setattr(event_streams, "PAUSE_S", 4.0)
    run = await add_stored_run(parts, *["score"] * 9)
    stream = await StreamClient.open(make_event_stream(parts))
    await stream.part()
    next_events = asyncio.ensure_future(stream.events())
    for index in range(3):
        await score_episodes(parts, run, index)
    assert indices(await next_events) == [0, 1, 2]


async def test_nothing_is_queued_for_a_slow_client(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    """No event is read while it takes nothing; then all are sent at once."""
    cursors_read = []
    right = EventStream._read_batch

    async def counted(self: EventStream, cursor: Any) -> Any:
        cursors_read.append(cursor)
        return await right(self, cursor)

    monkeypatch.setattr(EventStream, "_read_batch", counted)
    run = await add_stored_run(parts, *["score"] * 250)
    stream = await StreamClient.open(make_event_stream(parts))
    await stream.part()
    for index in reversed(range(200)):
        await score_episodes(parts, run, index)
    assert len(cursors_read) == 1
    events = await stream.events()
    assert indices(events) == [*reversed(range(100, 200))]
    assert len(cursors_read) == 2
    events = await stream.events()
    assert indices(events) == [*reversed(range(100))]
    assert (events[-1].body, len(cursors_read)) == (view(run), 3)


# --- what it costs ---


async def test_a_finished_run_is_sent_in_batches_and_not_cached(tmp_path: Path) -> None:
    order = [(7 * index) % MANY for index in range(MANY)]
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        run = await add_stored_run(parts, *["score"] * MANY)
        for first in range(0, MANY, 250):
            await score_episodes(parts, run, *order[first : first + 250])
        run.state = "completed"
        await parts.registry.writer.commit(run)
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        stream = await StreamClient.open(make_event_stream(parts))
        events = await stream.events()
        assert len(events) == EPISODES_PER_BATCH
        events += await stream.rest()
        assert (indices(events), kinds(events)[-1]) == (order, "run")
        middle = await StreamClient.open(make_event_stream(parts), events[499].id)
        assert indices(await middle.rest()) == order[500:]
        assert len(parts.registry.cache._in_memory) == 0


async def test_an_idle_stream_keeps_no_run_in_memory(tmp_path: Path) -> None:
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        await add_stored_run(parts, state="ready")
    async with open_server_parts(tmp_path / "proctor.sqlite") as parts:
        stream = await StreamClient.open(make_event_stream(parts))
        assert kinds(await stream.events()) == ["run"]
        batch = asyncio.ensure_future(stream.events())
        await asyncio.sleep(0)
        gc.collect()
        assert len(parts.registry.cache._in_memory) == 0
        run = await parts.registry.get("run_1")
        rules.stop(run, "abort", time.time())
        await parts.registry.writer.commit(run)
        (event,) = await batch
        assert event.body["state"] == "stopped"


async def test_a_disconnect_releases_the_stream(parts: ServerParts) -> None:
    await add_stored_run(parts)
    answer = await make_event_stream(parts).answer(None)
    sent, gone = asyncio.Event(), asyncio.Event()

    async def send(message: Any) -> None:
        if message.get("body"):
            sent.set()

    async def receive() -> Any:
        await gone.wait()
        return {"type": "http.disconnect"}

    scope = {"type": "http", "asgi": {"spec_version": "2.3"}}
    sending = asyncio.ensure_future(answer(scope, receive, send))
    await sent.wait()
    assert len(parts.registry._changes) == 1
    gone.set()
    await sending
    del answer, sending
    gc.collect()
    assert len(parts.registry._changes) == 0


async def test_an_id_that_is_ahead_of_the_run_is_refused(parts: ServerParts) -> None:
    run = await add_stored_run(parts)
    await score_episodes(parts, run, 0)
    stream = await StreamClient.open(make_event_stream(parts))
    id_ = (await stream.events())[0].id
    run.scored, run.scored_order = 0, []
    with expect_refusal("invalid_request"):
        await make_event_stream(parts).answer(id_)


# --- refusals and failures ---


async def test_a_stream_ends_when_the_store_fails(
    monkeypatch: pytest.MonkeyPatch, parts: ServerParts
) -> None:
    run = await add_stored_run(parts, state="ready")
    stream = await StreamClient.open(make_event_stream(parts))
    await stream.events()

    async def fail(*_: object, **__: object) -> None:
        raise StoreFailed("gone")

    monkeypatch.setattr(parts.registry.reader, "read_view", fail)
    parts.registry.notify(run)
    assert await stream.rest() == []


# --- an older database ---


# --- many readers ---


async def test_one_change_is_read_and_encoded_once_for_all_readers(
    parts: ServerParts,
) -> None:
    run = await add_stored_run(parts, *["score"] * 3)
    shown: list[RunHead] = []

    def counted(head: RunHead) -> answers.Run:
        shown.append(head)
        return view(head)

    shared = SharedStreams()
    readers = [
        EventStream(parts.registry, run.run_id, "alice", counted, "", shared)
        for _ in range(50)
    ]
    clients = [await StreamClient.open(reader) for reader in readers]
    assert len({await client.part() for client in clients}) == 1
    assert len(shown) == 1
    await score_episodes(parts, run, 2)
    batches = await asyncio.gather(*(client.events() for client in clients))
    assert len({tuple(one.id for one in batch) for batch in batches}) == 1
    # One more for each write that ended while the readers were pausing.
    assert len(shown) <= 4
    other = EventStream(parts.registry, run.run_id, "alice", counted, "x", shared)
    await (await StreamClient.open(other)).part()
    assert len(shown) <= 5
    await wait_in_loop(lambda: not any(shared._batches.values()))


async def test_streams_of_a_run_and_of_an_account_are_counted(
    parts: ServerParts,
) -> None:
    shared = SharedStreams(1)
    leave = [
        shared.enter("alice", f"run_{number}")
        for number in range(event_streams.STREAMS_PER_ACCOUNT)
    ]
    for account, run_id in (("bob", "run_0"), ("alice", "run_9")):
        with pytest.raises(Refused) as caught:
            shared.enter(account, run_id)
        assert caught.value.code == "unavailable"
    leave.pop()()
    shared.enter("alice", "run_9")()
    for one in leave:
        one()
    assert not shared._open
    await add_stored_run(parts)
    stream = EventStream(parts.registry, "run_1", "alice", view, "", shared)
    answer = await stream.answer(None)
    with pytest.raises(Refused):
        await stream.answer(None)

    async def disconnected() -> dict[str, str]:
        return {"type": "http.disconnect"}

    async def gone(_: Any) -> None:
        raise OSError

    with contextlib.suppress(Exception):
        await answer({"type": "http"}, disconnected, gone)
    assert not shared._open
