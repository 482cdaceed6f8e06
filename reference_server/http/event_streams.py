"""The response of `stream_events`: server-sent events until the run or the reader ends.

A stream stores only its cursor. It reads the run when there is a change and all that it
had is sent: a slow reader receives later and fewer changes, and nothing is queued for
it. Which events are sent, and in which order, is decided in `rules/events.py`.
"""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import AsyncIterator, Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import msgspec
from starlette.responses import Response, StreamingResponse

from reference_server.rules.events import Cursor, EventBatch, next_batch
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Episode, RunHead
from reference_server.runs.registry import RunRegistry
from reference_server.storage.store import StoreFailed
from reference_server.system.repeated_failures import RepeatedFailures
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
# A proxy must neither store the stream nor buffer it.
_HEADERS = {"Cache-Control": "no-store", "X-Accel-Buffering": "no"}


@dataclass(frozen=True, slots=True)
class EventStream:
    """The stream of one reader; view: the run as get_run shows it to that reader."""

    registry: RunRegistry
    run_id: str
    account: str
    view: Callable[[RunHead], dict[str, Any]]

    async def answer(self, last_id: str | None) -> Response:
        """The events behind that one (EVT-005); 204 if none will ever follow (EVT-006).

        Raises Refused and StoreFailed as the first read does. A later failure ends the
        stream: its reader reconnects and is refused then.
        """
        cursor = Cursor() if last_id is None else Cursor.parse(last_id, self.run_id)
        if cursor is None:
            raise _no_event()
        change = self.registry.change_event(self.run_id)  # before it is read
        first = await self._read_batch(cursor)
        if first.is_last and not first.text:
            return Response(status_code=204)
        body = self._stream_events(first, change)
        return StreamingResponse(body, headers=_HEADERS, media_type=EVENT_STREAM)

    async def _read_batch(self, cursor: Cursor) -> EventBatch:
        def view(run: RunHead, scored: Sequence[Episode]) -> EventBatch:
            if cursor.results_sent > run.scored:
                raise _no_event()
            body = self.view(run)
            # A reader may reconnect under another host name of this server.
            run_body, common_body = map(
                msgspec.json.encode, (body, body | {"endpoint": None})
            )
            episodes = [msgspec.json.encode(episode_view(one)) for one in scored]
            return next_batch(cursor, run, run_body, episodes, common_body)

        window = (cursor.results_sent, cursor.results_sent + EPISODES_PER_BATCH)
        return await self.registry.read_view(
            self.run_id, self.account, view, *window, scored=True
        )

    async def _stream_events(
        self, batch: EventBatch, change: asyncio.Event
    ) -> AsyncIterator[bytes]:
        """What is sent, part by part; the next is made when the last was sent."""
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
                batch = await self._read_batch(batch.cursor)
                if batch.text:
                    yield batch.text
                    last_sent_at = time.monotonic()
        except Refused as refused:
            log.debug("a stream of %s ends: %s", self.run_id, refused)
        except StoreFailed as error:
            _failures.report("an event stream could not use the database", str(error))


def _left_s(since: float, seconds: float) -> float:
    return max(0.0, since + seconds - time.monotonic())


def _no_event() -> Refused:
    return Refused(
        "invalid_request",
        "No event of this run has that id.",
        errors=[("header:last-event-id", "must be the id of an event of this run")],
        requirement="EVT-007",
    )
