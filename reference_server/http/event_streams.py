"""The response of `stream_events`: server-sent events until the run or the reader ends.

A stream stores only its cursor. It reads the run when there is a change and all that it
had is sent: a slow reader receives later and fewer changes, and nothing is queued for
it. Which events are sent, and in which order, is decided in `rules/runs/events.py`.
"""

from __future__ import annotations

import asyncio
import logging
import time
from collections import Counter
from collections.abc import AsyncIterator, Callable, Coroutine, Hashable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any, TypeAlias
from weakref import WeakKeyDictionary

import msgspec
from starlette.responses import Response, StreamingResponse
from starlette.types import Receive, Scope, Send

from reference_record.generated import answers
from reference_server.process.background_work import shielded
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.events import Cursor, EventBatch, next_batch
from reference_server.rules.runs.run import Episode, RunHead
from reference_server.runs.memory.run_changes import RunChange
from reference_server.runs.registry import RunRegistry
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.telemetry.repeated_failures import RepeatedFailures
from reference_server.views.run_views import episode_view

log = logging.getLogger("proctor.events")
_failures = RepeatedFailures(log)

EVENT_STREAM = "text/event-stream"
# Read and sent at a time.
EPISODES_PER_BATCH = 100
# After how long a reader reconnects when its stream broke.
RETRY_MS = 1000
# A comment is due after 15 s (EVT-008): with time to spare for a busy machine.
KEEPALIVE_S = 10.0
# From one read to the next, so that many workers do not make many readers read for each
# episode. A rare change is sent at once, the others within a second (EVT-004).
PAUSE_S = 0.2
# How long a batch is kept for other readers of the same change.
SHARED_S = 0.5
# An account may have as many times more streams than one run.
STREAMS_PER_ACCOUNT = 4
# A proxy must neither store the stream nor buffer it.
_HEADERS = {"Cache-Control": "no-store", "X-Accel-Buffering": "no"}


Batches: TypeAlias = dict[Hashable, asyncio.Task[EventBatch]]


class SharedStreams:
    """State that all event streams of a server share: their number, and batches.

    Readers of a run who know the same of it receive the same bytes: the run is read and
    encoded once for all of them, however many they are.
    """

    def __init__(self, per_run: int = 100) -> None:
        self._per_run = per_run
        self._open: Counter[tuple[str, str]] = Counter()
        # RunChange that ends it → what was asked → the batch.
        self._batches: WeakKeyDictionary[RunChange, Batches] = WeakKeyDictionary()

    def enter(self, account: str, run_id: str) -> Callable[[], None]:
        """Count a stream; returns what to call at its end. Raises Refused."""
        per_account = self._per_run * STREAMS_PER_ACCOUNT
        places = {("run", run_id): self._per_run, ("account", account): per_account}
        for place, most in places.items():
            if self._open[place] >= most:
                raise Refused(
                    "unavailable", f"The {place[0]} has {most} open streams of events."
                )
        self._open.update(list(places))
        return partial(self._leave, list(places))

    @property
    def count(self) -> int:
        return sum(n for (kind, _), n in self._open.items() if kind == "run")

    async def batch(
        self,
        change: RunChange,
        key: Hashable,
        read: Callable[[], Coroutine[Any, Any, EventBatch]],
    ) -> EventBatch:
        """The result of `read`, or its earlier result for the same key.

        change: the next change of the run, taken before; a batch is not shared beyond.
        """
        batches = self._batches.setdefault(change, {})
        task = batches.get(key)
        if task is None:
            task = batches[key] = asyncio.ensure_future(read())
            task.add_done_callback(partial(_forget_later, batches, key))
        return await shielded(task)

    def _leave(self, places: list[tuple[str, str]]) -> None:
        for place in places:
            self._open[place] -= 1
            if not self._open[place]:
                del self._open[place]


@dataclass(frozen=True, slots=True)
class EventStream:
    """The stream of one reader; view: the run as get_run shows it to that reader.

    account: whose stream it is. sees_all: it may show the runs of others (AUTH-008).
    view_id: equal for readers to whom the run is shown alike.
    """

    registry: RunRegistry
    run_id: str
    account: str
    view: Callable[[RunHead], answers.Run]
    view_id: str = ""
    shared: SharedStreams = field(default_factory=SharedStreams)
    sees_all: bool = False

    @property
    def _reader(self) -> str | None:
        return None if self.sees_all else self.account

    async def answer(self, last_id: str | None) -> Response:
        """The events behind that one (EVT-005); 204 if none will ever follow (EVT-010).

        Raises Refused and StoreFailed as the first read does. A later failure ends the
        stream: its reader reconnects and is refused then.
        """
        cursor = Cursor() if last_id is None else Cursor.parse(last_id, self.run_id)
        if cursor is None:
            raise _no_event()
        change = self.registry.change_event(self.run_id)  # before it is read
        first = await self._next_batch(cursor, change)
        if first.is_last and not first.text:
            return Response(status_code=204)
        leave = self.shared.enter(self.account, self.run_id)
        body = self._stream_events(first, change)
        return _CountedResponse(body, leave)

    async def _next_batch(self, cursor: Cursor, change: RunChange) -> EventBatch:
        # A token that sees more shares nothing with another one of its account.
        key = (cursor, self._reader, self.view_id)
        return await self.shared.batch(change, key, partial(self._read_batch, cursor))

    async def _read_batch(self, cursor: Cursor) -> EventBatch:
        def view(run: RunHead, scored: Sequence[Episode]) -> EventBatch:
            if cursor.results_sent > run.scored:
                raise _no_event()
            body = self.view(run)
            # A reader may reconnect under another host name of this server.
            run_body, common_body = map(
                msgspec.json.encode, (body, body | {"endpoint": None})
            )
            episodes = [
                msgspec.json.encode(episode_view(episode)) for episode in scored
            ]
            return next_batch(cursor, run, run_body, episodes, common_body)

        window = (cursor.results_sent, cursor.results_sent + EPISODES_PER_BATCH)
        return await self.registry.reader.read_view(
            self.run_id, self._reader, view, *window, scored=True
        )

    async def _stream_events(
        self, batch: EventBatch, change: RunChange
    ) -> AsyncIterator[bytes]:
        """Yield the parts of the stream; each is made after the one before was sent."""
        last_sent_at = last_read_at = time.monotonic()
        yield b"retry: %d\n\n%b" % (RETRY_MS, batch.text)
        try:
            while not batch.is_last:
                has_more = batch.is_behind and bool(batch.text)
                batch = replace(batch, text=b"")  # a waiting stream keeps no text
                if has_more:
                    await asyncio.sleep(0)  # other requests run between two batches
                else:
                    while not await self.registry.wait_for_change(
                        change, _left_s(last_sent_at, KEEPALIVE_S)
                    ):
                        yield b":\n\n"
                        last_sent_at = time.monotonic()
                    await asyncio.sleep(_left_s(last_read_at, PAUSE_S))
                change, last_read_at = (
                    self.registry.change_event(self.run_id),
                    time.monotonic(),
                )
                batch = await self._next_batch(batch.cursor, change)
                if batch.text:
                    yield batch.text
                    last_sent_at = time.monotonic()
        except Refused as refused:
            log.debug("a stream of %s ends: %s", self.run_id, refused)
        except StoreFailed as error:
            _failures.report("an event stream could not use the database", str(error))


def _forget_later(
    batches: Batches, key: Hashable, task: asyncio.Task[EventBatch]
) -> None:
    if task.cancelled() or task.exception() is not None:
        batches.pop(key, None)
    else:
        asyncio.get_running_loop().call_later(SHARED_S, batches.pop, key, None)


class _CountedResponse(StreamingResponse):
    """A stream, and what to call when it has ended, however it ended."""

    def __init__(self, body: AsyncIterator[bytes], leave: Callable[[], None]) -> None:
        super().__init__(body, headers=_HEADERS, media_type=EVENT_STREAM)
        self._leave = leave

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        try:
            await super().__call__(scope, receive, send)
        finally:
            self._leave()


def _left_s(since: float, seconds: float) -> float:
    return max(0.0, since + seconds - time.monotonic())


def _no_event() -> Refused:
    return Refused(
        "invalid_request",
        "No event of this run has that id.",
        errors=[("header:last-event-id", "must be the id of an event of this run")],
        requirement="EVT-007",
    )
