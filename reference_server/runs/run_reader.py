"""Runs as they are shown: from memory once that is stored, or as the store has them.

A run that is not in memory stays out of it, and no more of it is read than is shown.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from functools import partial
from typing import TypeVar

from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import RESTING_STATES
from reference_server.rules.runs.run import Episode, Run, RunHead
from reference_server.rules.submission import may_see_run
from reference_server.runs.admission.run_admission import RunAdmission
from reference_server.runs.memory.run_cache import RunCache
from reference_server.runs.run_writer import RunWriter
from reference_server.storage.runs.run_store import Store

# Views made of a page of runs before other requests are served.
VIEWS_AT_ONCE = 20

Rendered = TypeVar("Rendered")


class RunReader:
    """Reads runs for whom they may be shown to."""

    def __init__(
        self,
        store: Store,
        cache: RunCache,
        writer: RunWriter,
        admission: RunAdmission,
    ) -> None:
        self._store, self._cache = store, cache
        self._writer, self._admission = writer, admission

    async def get(self, run_id: str, account: str | None = None) -> Run:
        """The run in memory, if the account may see it (AUTH-003, RUN-010)."""
        run = self._cache.find_settled(run_id) or await self._cache.get(run_id)
        if run is None or not may_see_run(account, run.account):
            raise no_run(run_id)
        self._cache.keep(run)
        return run

    async def read_stored(self, run_id: str) -> Run:
        """The run as it is stored, wherever it is played; it is only to be shown."""
        run = await self._store.load(run_id)
        if run is None:
            raise no_run(run_id)
        return run

    async def read_view(
        self,
        run_id: str,
        account: str | None,
        view: Callable[[RunHead, Sequence[Episode]], Rendered],
        start: int = 0,
        end: int | None = 0,
        *,
        scored: bool = False,
    ) -> Rendered:
        """Apply `view` to the run with its episodes from start to end.

        scored: counts only episodes that have a result, in the order of their scoring.
        The cost depends neither on the size of the run nor on the number of runs.
        """
        await self._admission.refresh_before(run_id)
        if run_id not in self._cache:
            window = await self._store.read_window(run_id, start, end, scored)
            if window is not None and self._is_current(window[0]):
                if not may_see_run(account, window[0].account):
                    raise no_run(run_id)
                return view(*window)
        run = await self.get(run_id, account)
        episodes = partial(Run.window, start=start, end=end, scored=scored)
        return await self.render_when_stored(run, lambda run: view(run, episodes(run)))

    async def page(
        self,
        account: str | None,
        before: int | None,
        limit: int,
        view: Callable[[RunHead], Rendered],
    ) -> list[Rendered]:
        """Up to `limit` views of the account, newest first (RUN-009, AUTH-004).

        Without an account those of all (AUTH-008).
        """
        await self._admission.refresh()
        ids = [run_id for _, run_id in await self._store.page(account, before, limit)]
        heads = await self._store.heads([i for i in ids if i not in self._cache])
        views = []
        for place, run_id in enumerate(ids):
            if place % VIEWS_AT_ONCE == 0:
                await asyncio.sleep(0)  # a page may have a thousand
            head = heads.get(run_id)
            if head is not None and self._is_current(head):
                views.append(view(head))
                continue
            try:
                run = await self.get(run_id)
                views.append(await self.render_when_stored(run, view))
            except Refused:  # deleted meanwhile: a page is not short of it
                return await self.page(account, before, limit, view)
        return views

    async def render_when_stored(
        self, run: Run, view: Callable[[Run], Rendered]
    ) -> Rendered:
        """Apply `view` to the run, and return that once all of it is stored."""
        while True:
            await self._admission.refresh_before(run.run_id)
            rendered, played_number = view(run), run.played_number
            # DEL-006: the first write of what was played gives its number.
            is_stored = await self._writer.is_stored(run)
            if is_stored and run.played_number == played_number:
                return rendered
            run = await self.get(run.run_id)

    def _is_current(self, head: RunHead) -> bool:
        """Whether the run is as it was just read: it was not loaded meanwhile."""
        if self._cache.is_elsewhere(head):
            return True  # all that this node can know
        # A run that is known to be in the queue leaves it only in memory.
        is_queued = self._admission.has_queued(head.run_id)
        is_stable = head.state in RESTING_STATES or is_queued
        return is_stable and head.run_id not in self._cache


def no_run(run_id: str) -> Refused:
    return Refused("not_found", f"There is no run {run_id}.")
