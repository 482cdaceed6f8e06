"""Pages that follow a run: what each of them is sent, and when."""

from __future__ import annotations

import asyncio
import contextlib
import re
from collections.abc import AsyncGenerator
from datetime import UTC, datetime, timedelta
from typing import Any

import msgspec
import pytest
from starlette.requests import Request
from starlette.types import Message, Receive, Scope, Send

from reference_server.http.pages import live_runs
from reference_server.http.pages.api_documents import ApiDocuments
from reference_server.http.pages.live_runs import COMMENT, LiveRuns
from reference_server.http.pages.page_links import ServerLinks
from reference_server.views.run_views import run_view
from tests.support.pages.page_api import RESULT, PageApi
from tests.support.servers import TIMEOUT_S

SUMMARY = b"event: summary\n"


class StreamingApi(PageApi):
    """Sends the parts of `stream` as the events of any run; None ends them."""

    def __init__(self) -> None:
        super().__init__()
        self.stream: asyncio.Queue[bytes | None] = asyncio.Queue()
        self.run = self.add("played", RESULT, None)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if not scope["path"].endswith("/events"):
            return await super().__call__(scope, receive, send)
        self.asked["events"] += 1
        start: Message = {"type": "http.response.start", "status": 200, "headers": []}
        await send(start)
        while (part := await self.stream.get()) is not None:
            await send({"type": "http.response.body", "body": part, "more_body": True})
        await send({"type": "http.response.body", "body": b"", "more_body": False})
        return None

    def change(self) -> None:
        """An event `run`, with the run as it is."""
        body = msgspec.json.encode(run_view(self.run, "http://server", None))
        self.stream.put_nowait(b"event: run\ndata: " + body + b"\n\n")

    def documents(self) -> ApiDocuments:
        scope: dict[str, Any] = {
            "type": "http",
            "headers": [],
            "asgi": {"version": "3.0"},
            "scheme": "http",
        }
        return ApiDocuments.of(self, Request(scope), "alice")


async def next_of(pages: list[AsyncGenerator[bytes, None]]) -> list[bytes]:
    """The next part of each."""
    async with asyncio.timeout(TIMEOUT_S):
        return await asyncio.gather(*map(anext, pages))


@contextlib.asynccontextmanager
async def opened(
    live: LiveRuns, api: StreamingApi, count: int
) -> AsyncGenerator[list[AsyncGenerator[bytes, None]], None]:
    """Pages that were sent how to begin: when to come back, nothing new."""
    pages = [
        live.updates(api.documents(), "alice", "played", lambda: True)
        for _ in range(count)
    ]
    assert await next_of(pages) == [b"retry: 2000\n\n"] * count
    assert await next_of(pages) == [COMMENT] * count
    yield pages
    for page in pages:
        await page.aclose()


async def test_a_comment_of_the_stream_reaches_every_page() -> None:
    """Nothing changes for long: each page hears that the server is there."""
    api, live = StreamingApi(), LiveRuns(ServerLinks())
    async with opened(live, api, 3) as pages:
        for _ in range(2):
            api.stream.put_nowait(b":\n\n")
            assert await next_of(pages) == [COMMENT] * 3
    assert api.asked["events"] == 1, "one reader for all pages"


async def test_a_change_is_rendered_once_for_all_pages(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A late page is sent what is there; the end is sent to each."""
    monkeypatch.setattr(live_runs, "PAUSE_S", 0.0)
    api, live = StreamingApi(), LiveRuns(ServerLinks())
    async with opened(live, api, 2) as pages:
        api.change()
        first, second = await next_of(pages)
        assert first is second
        assert first.startswith(SUMMARY)
        assert b"1/2" in first
        late = live.updates(api.documents(), "alice", "played", lambda: True)
        await anext(late)
        assert await anext(late) is first
        assert api.asked["runs/played/episodes"] == 1
        api.stream.put_nowait(None)
        for page in (*pages, late):
            rest = [part async for part in page]
            assert rest[-1] == b"event: end\ndata: \n\n"


async def test_each_part_is_of_one_moment(monkeypatch: pytest.MonkeyPatch) -> None:
    """An event of the run is older than the results. Expect the newest in all numbers.

    The row of the episode that ended is sent with them, and no column is left out.
    """
    monkeypatch.setattr(live_runs, "PAUSE_S", 0.0)
    api, live = StreamingApi(), LiveRuns(ServerLinks())
    async with opened(live, api, 1) as pages:
        api.run.episodes[1].in_progress = True
        api.change()
        (shown,) = await next_of(pages)
        rows = re.findall(rb'<tr data-outcome="(\w+)"[^>]* id="row-(\w+)"', shown)
        assert rows == [(b"success", b"e0000"), (b"in_progress", b"e0001")]
        api.change()
        api.run.record_result(api.run.episodes[1], RESULT)
        (shown,) = await next_of(pages)
        assert b"2 of 2 episodes" in shown
        assert b"<b>2/2</b>" in shown
        assert b"in_progress" not in shown
        heads = re.findall(rb'<th scope="col" class="number">([^<]*)', shown)
        of_splits = [b"Success", b"Rate", b"Mean score"]
        assert heads == [*of_splits, b"Splits mixed", b"even", b"odd"]


async def test_a_run_that_stands_still_says_since_when(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Nothing but comments come. Expect a new part for the pages all the same."""
    monkeypatch.setattr(live_runs, "PAUSE_S", 0.0)
    api, live = StreamingApi(), LiveRuns(ServerLinks())
    finished = datetime.fromtimestamp(RESULT.finished_at_wall, UTC)
    clock = [finished]
    monkeypatch.setattr(live_runs, "datetime", FixedClock(clock))
    async with opened(live, api, 1) as pages:
        api.change()
        (shown,) = await next_of(pages)
        assert b"without a result" not in shown
        clock[0] = finished + timedelta(minutes=2)
        api.stream.put_nowait(b":\n\n")
        (shown,) = await next_of(pages)
        assert b"<b>2 min 0 s</b>without a result" in shown


class FixedClock:
    def __init__(self, times: list[datetime]) -> None:
        self._times = times

    def now(self, _zone: object) -> datetime:
        return self._times[0]


async def test_a_reader_who_signed_out_is_sent_nothing_more() -> None:
    api, live = StreamingApi(), LiveRuns(ServerLinks())
    signed_in = [True]
    page = live.updates(api.documents(), "alice", "played", lambda: signed_in[0])
    await anext(page)
    await anext(page)
    signed_in[0] = False
    api.change()
    async with asyncio.timeout(TIMEOUT_S):
        assert [part async for part in page] == []
