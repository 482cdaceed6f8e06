"""Changes of a run for the pages that show it, made once for all of them.

One reader of the event stream feeds all pages of a run that have the same token. The
part of the page that changed is rendered once, at most every PAUSE_S, and sent to each.
An empty comment of the stream (EVT-008) is passed on: no page has a timer of its own.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import AsyncGenerator, Callable, Sequence
from contextlib import aclosing, suppress
from datetime import UTC, datetime
from typing import Any

import msgspec

from reference_record.generated import answers
from reference_record.pages.page_contents import summary_html
from reference_record.pages.page_templates import Links
from reference_record.pages.run_page import (
    Document,
    latest_results,
    left_episodes,
    pace_of,
    snapshot,
    status_of,
    task_table,
)
from reference_server.http.pages.api_documents import ApiDocuments, Problem

log = logging.getLogger("proctor.pages")

PAUSE_S = 1.0
COMMENT = b":\n\n"
# The most readers of one account.
READERS_MAX = 400
# Episodes of a run that are listed anew for each change: one answer of the API.
LISTED_MAX = 1000
ROWS_MAX = 200


class LiveRuns:
    """The runs that pages show now."""

    def __init__(self, links: Links) -> None:
        self._links = links
        self._runs: dict[tuple[str, str], _LiveRun] = {}

    async def updates(
        self,
        api: ApiDocuments,
        account: str,
        run_id: str,
        is_allowed: Callable[[], bool],
    ) -> AsyncGenerator[bytes, None]:
        """Server-sent events, until the run can change no more or may not be read.

        is_allowed: whether the reader is still signed in. Raises Problem at the start.
        """
        key = (api.token, run_id)
        run = self._runs.get(key)
        if run is None:
            run = self._runs[key] = _LiveRun(self._links, account, run_id)
        try:
            run.enter(api)
            yield b"retry: 2000\n\n"
            async for part in run.changes():
                if not is_allowed():
                    return
                yield part
        finally:
            run.leave()
            if not run.readers:
                self._runs.pop(key, None)

    def is_full(self, account: str) -> bool:
        """Whether this account has all the readers that it may have."""
        own = (run for run in self._runs.values() if run.account == account)
        return sum(run.readers for run in own) >= READERS_MAX


class _LiveRun:
    """readers: how many pages of the account wait for its changes."""

    def __init__(self, links: Links, account: str, run_id: str) -> None:
        self._links = links
        self.account = account
        self._run_id = run_id
        self._run: answers.Run | None = None
        # By index; those of a long run are listed once, and then changed by its events.
        self._episodes: dict[int, Document] = {}
        self._rows: dict[int, tuple[Any, ...]] = {}
        self._part = b""
        self._changed = asyncio.Event()
        self._task: asyncio.Task[None] | None = None
        self._is_over = False  # the run can change no more
        self.readers = 0

    def enter(self, api: ApiDocuments) -> None:
        self.readers += 1
        if self._task is None:
            self._task = asyncio.create_task(self._follow(api))

    def leave(self) -> None:
        self.readers -= 1
        if not self.readers and self._task is not None:
            self._task.cancel()

    async def changes(self) -> AsyncGenerator[bytes, None]:
        """Yield the list of runs, then each change of it; empty comments in between."""
        sent = b""
        assert self._task is not None
        while True:
            changed = self._changed
            if self._part is sent:
                yield COMMENT
            else:
                sent = self._part
                yield sent
            if self._task.done():
                if self._is_over:
                    yield b"event: end\ndata: \n\n"
                return
            await changed.wait()

    async def _follow(self, api: ApiDocuments) -> None:
        try:
            stream = api.stream("runs", self._run_id, "events")
            async with aclosing(_events(stream)) as events:
                await self._render_changes(api, events)
            # A stream ends early, too, when its token is revoked or its run deleted.
            await api.get("runs", self._run_id)
            self._is_over = True
        except Problem as problem:
            log.debug("pages of %s end: %s", self._run_id, problem)
        except Exception:
            log.exception("the pages of a run are not updated")
        finally:
            self._wake()

    async def _render_changes(
        self,
        api: ApiDocuments,
        events: AsyncGenerator[tuple[str, Any], None],
    ) -> None:
        """An event `run` ends each batch: then the page is made, and then a pause.

        A comment says that nothing changed: readers hear that the stream is alive, and
        since when a run stands still.
        """
        async for kind, body in events:
            if kind == "episode":
                self._add_result(body)
            elif kind == "run":
                self._run = body
                await self._render(api, body)
                await asyncio.sleep(PAUSE_S)
            elif self._run is not None:
                await self._render(api, self._run)
            else:
                self._wake()

    def _add_result(self, result: answers.EpisodeResult) -> None:
        episode = self._episodes.get(result["index"])
        if episode is not None:
            counted = {"attempt": result["attempt"], "faults": result["faults"]}
            self._episodes[result["index"]] = {
                **episode, **counted, "status": "scored", "result": result,
            }  # fmt: skip

    async def _render(self, api: ApiDocuments, run: answers.Run) -> None:
        """All of it from one list of the episodes."""
        if len(self._episodes) <= LISTED_MAX:
            path = ("runs", self._run_id, "episodes")
            async for page in api.pages(*path, limit=LISTED_MAX):
                self._episodes |= {one["index"]: one for one in page["episodes"]}
        episodes = [self._episodes[index] for index in sorted(self._episodes)]
        # Events have no judgements.
        judged = (await api.get("runs", self._run_id)).get("judged")
        seen, score = snapshot({**run, "judged": judged}, episodes)
        latest = latest_results(episodes)
        text = summary_html(
            self._links,
            seen,
            score,
            task_table(episodes),
            pace=pace_of(seen, episodes, datetime.now(UTC)),
            latest=latest,
            changed=self._changed_rows(episodes, latest),
            left=left_episodes(episodes),
        )
        lines = "".join(f"data: {line}\n" for line in text.splitlines() if line)
        part = f"event: summary\n{lines}\n".encode()
        if part != self._part:
            self._part = part
        self._wake()

    def _changed_rows(
        self, episodes: Sequence[Document], latest: Sequence[Document]
    ) -> list[Document]:
        """Episodes whose rows a page may have as they were before.

        A page that was loaded a moment ago has all but the last changes: the latest
        results and what is in progress are always among them.
        """
        fresh = {one["index"] for one in latest}
        before, self._rows = self._rows, {}
        changed = []
        for one in episodes:
            status = status_of(one)
            now = self._rows[one["index"]] = status, one["attempt"], one["faults"]
            is_known = before.get(one["index"], now) == now
            if status == "in_progress" or one["index"] in fresh or not is_known:
                changed.append(one)
        return changed[:ROWS_MAX]

    def _wake(self) -> None:
        """Every reader that waits goes on; later ones wait for the next change."""
        self._changed.set()
        self._changed = asyncio.Event()


async def _events(
    parts: AsyncGenerator[bytes, None],
) -> AsyncGenerator[tuple[str, Any], None]:
    """Kind and body of each event of a stream; an empty kind for a comment."""
    rest = b""
    async with aclosing(parts):
        async for part in parts:
            *blocks, rest = (rest + part).split(b"\n\n")
            for block in blocks:
                if block.startswith(b":"):
                    yield "", {}
                    continue
                fields = dict(
                    line.split(b": ", 1) for line in block.split(b"\n") if b": " in line
                )
                with suppress(KeyError, msgspec.DecodeError):
                    body = msgspec.json.decode(fields[b"data"])
                    yield fields[b"event"].decode(), body
