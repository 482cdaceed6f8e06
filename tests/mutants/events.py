"""Mutants of events: what is told, in which order, from where, when, until when."""

from __future__ import annotations

import asyncio
import copy
from dataclasses import replace
from typing import Any

from starlette.responses import Response

from reference_server.http import event_streams, views
from reference_server.http.event_streams import EventStream
from reference_server.rules import events
from reference_server.rules.events import Cursor, EventBatch
from reference_server.rules.run import Episode, Run, RunHead
from reference_server.runs.registry import RunRegistry
from reference_server.storage.store import Store
from tests.mutants import Patch, mutant, put


def prompt(patch: Patch) -> Patch:
    """Let comments come soon, so that the kit need not wait for one."""

    def hurried() -> None:
        put(event_streams, "KEEPALIVE_S", 1.0)
        patch()

    hurried.__name__, hurried.__doc__ = patch.__name__, patch.__doc__
    return hurried


@mutant("EVT-001")
@prompt
def tells_an_episode_by_its_id_alone() -> None:
    """Who follows a run has to ask for each result after all."""
    right = views.episode_view
    names = ("episode_id", "index", "task")

    def wrong(episode: Episode) -> dict[str, Any]:
        return {name: right(episode)[name] for name in names}

    put(event_streams, "episode_view", wrong)


@mutant("EVT-002")
@prompt
def tells_episodes_in_manifest_order() -> None:
    """With two workers, an episode is skipped whenever a later one is scored first."""

    def wrong(run: Run, start: int, end: int | None, scored: bool) -> list[Episode]:
        if not scored:
            return run.episodes[start:end]
        return [e for e in run.episodes if e.result is not None][start:end]

    put(Run, "window", wrong)


@mutant("EVT-003")
@prompt
def tells_the_run_first() -> None:
    """A page counts ten episodes as scored and has the results of nine."""

    right = events.next_batch

    def wrong(cursor: Cursor, run: RunHead, *rest: Any) -> EventBatch:
        if events.is_final(run):
            return right(cursor, run, *rest)
        shown, scored, common_body = rest
        head = copy.copy(run)
        head.scored = cursor.results_sent
        first = right(cursor, head, shown, [], common_body)
        second = right(first.cursor, run, shown, scored, common_body)
        return replace(second, text=first.text + second.text)

    put(event_streams, "next_batch", wrong)


@mutant("EVT-004")
@prompt
def tells_late_of_a_stop() -> None:
    """Who follows a run lets its policy compute for nothing."""
    right = EventStream._read_batch

    async def wrong(self: EventStream, cursor: Cursor) -> EventBatch:
        batch = await right(self, cursor)
        if b'"state":"stopped"' in batch.text:
            await asyncio.sleep(2.0)
        return batch

    put(EventStream, "_read_batch", wrong)


@mutant("EVT-004")
@prompt
def tells_the_run_again_and_again() -> None:
    """A page that follows a run is drawn anew while nothing happens."""
    right, changed = events.next_batch, RunRegistry.wait_for_change

    async def restless(
        self: RunRegistry, event: asyncio.Event, timeout_s: float
    ) -> bool:
        return await changed(self, event, min(timeout_s, 0.2)) or True

    put(RunRegistry, "wait_for_change", restless)

    def wrong(cursor: Cursor, run: RunHead, *rest: Any) -> EventBatch:
        forgotten = cursor if events.is_final(run) else Cursor(cursor.results_sent)
        return right(forgotten, run, *rest)

    put(event_streams, "next_batch", wrong)


@mutant("EVT-005")
@prompt
def begins_anew_for_who_comes_back() -> None:
    """Each lost connection counts the results so far once more."""
    right = EventStream.answer

    async def wrong(self: EventStream, last_id: str | None) -> Response:
        answer = await right(self, last_id)
        return answer if answer.status_code == 204 else await right(self, None)

    put(EventStream, "answer", wrong)


@mutant("EVT-006")
@prompt
def follows_a_run_for_ever() -> None:
    """A script that waits for the end of a stream never comes back."""

    def wrong(_run: RunHead) -> bool:
        return False

    put(events, "is_final", wrong)


@mutant("EVT-007")
@prompt
def takes_ids_of_other_runs() -> None:
    """A reader that mixes up two runs misses the first results of the second."""

    def wrong(id_: str, _run_id: str) -> Cursor | None:
        parts = events._ID.fullmatch(id_)
        return Cursor(int(parts[1]), parts[2]) if parts else None

    put(Cursor, "parse", wrong)


@mutant("EVT-008")
def says_nothing_without_news() -> None:
    """A connection that broke hours ago looks like a run in which nothing happens."""
    put(event_streams, "KEEPALIVE_S", 1e6)


@mutant("EVT-009")
@prompt
def tells_what_is_not_yet_stored() -> None:
    """After a power cut a result that was published does not exist."""
    right, save = RunRegistry.commit, Store.save

    async def hasty(self: RunRegistry, run: Run) -> None:
        self.notify(run)
        await right(self, run)

    async def slow(self: Store, run: Run) -> None:
        await asyncio.sleep(0.25)
        await save(self, run)

    async def trusting(_self: RunRegistry, _run: Run) -> bool:
        return True

    put(RunRegistry, "commit", hasty)
    put(Store, "save", slow)
    put(RunRegistry, "is_stored", trusting)
