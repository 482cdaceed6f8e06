"""The answer of `stream_events`: events for as long as there is somebody to read them.

A stream keeps nothing of its run but a place in its events. It looks when there is news
and when all that it had is sent: who reads slowly is told later and of fewer changes,
and nothing piles up here. What is told, and in which order, is decided in `events.py`.
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
from reference_server.views.run_views import episode_view

log = logging.getLogger("proctor.events")

EVENT_STREAM = "text/event-stream"
# Looked at and sent at a time.
EPISODES_PER_BATCH = 100
# After how long a reader whose stream broke off comes back.
RETRY_MS = 1000
# A comment is due after 15 s (EVT-008): with time to spare for a busy machine.
KEEPALIVE_S = 10.0
# From one look to the next, so that many workers do not have many readers look for each
# of their episodes. What is rare is told at once, the rest within a second (EVT-004).
PAUSE_S = 0.2
# A proxy keeps nothing of it, and holds nothing back until it is worth a packet.
_HEADERS = {"Cache-Control": "no-store", "X-Accel-Buffering": "no"}


@dataclass(frozen=True, slots=True)
class EventStream:
    """Somebody who is told of a run; view: the run as get_run shows it to them."""

    registry: RunRegistry
    run_id: str
    account: str
    view: Callable[[RunHead], dict[str, Any]]

    async def answer(self, last_id: str | None) -> Response:
        """The events behind that one; 204 when there are none and never will be.

        Raises Refused and StoreFailed as the first look does. What goes wrong later
        ends the stream: its reader comes back and is refused then.
        """
        cursor = Cursor() if last_id is None else Cursor.parse(last_id, self.run_id)
        if cursor is None:
            raise _no_event()
        change = self.registry.change_event(self.run_id)  # before the look
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
            # A reader may come back by another name of this server.
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
        """What is sent, piece by piece; the next is made when the last has left."""
        last_sent_at = last_read_at = time.monotonic()
        yield b"retry: %d\n\n%b" % (RETRY_MS, batch.text)
        try:
            while not batch.is_last:
                has_more = batch.is_behind and bool(batch.text)
                batch = replace(batch, text=b"")  # who waits keeps nothing of it
                if has_more:
                    await asyncio.sleep(0)  # a long history lets others have a turn
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
            log.warning("a stream of %s ends, the store failed: %s", self.run_id, error)


def _left_s(since: float, seconds: float) -> float:
    return max(0.0, since + seconds - time.monotonic())


def _no_event() -> Refused:
    return Refused(
        "invalid_request",
        "No event of this run has that id.",
        errors=[("header:last-event-id", "is the id of an event of this run")],
        requirement="EVT-007",
    )
