"""Mutants of events: content, order, start, delay and end of a stream."""

from __future__ import annotations

import asyncio
import copy
from dataclasses import replace
from typing import Any

from starlette.responses import Response

from reference_server.http import event_streams
from reference_server.http.event_streams import EventStream
from reference_server.rules import events
from reference_server.rules.events import Cursor, EventBatch
from reference_server.rules.run import Episode, Run, RunHead
from reference_server.runs.memory.run_changes import RunChange
from reference_server.runs.registry import RunRegistry
from reference_server.storage.store import Store
from reference_server.views import run_views
from tests.mutants import Patch, mutant, put


def with_short_keepalive(patch: Patch) -> Patch:
    """Let comments come soon, so that the kit need not wait for one."""

    def patch_with_short_keepalive() -> None:
        put(event_streams, "KEEPALIVE_S", 1.0)
        patch()

    patch_with_short_keepalive.__name__, patch_with_short_keepalive.__doc__ = (
        patch.__name__,
        patch.__doc__,
    )
    return patch_with_short_keepalive


@mutant("EVT-001")
@with_short_keepalive
def sends_only_the_ids_of_episodes() -> None:
    """A client that follows a run must request each result."""
    right = run_views.episode_view
    names = ("episode_id", "index", "task")

    def wrong(episode: Episode) -> dict[str, Any]:
        return {name: right(episode)[name] for name in names}

    put(event_streams, "episode_view", wrong)


@mutant("EVT-002", "EVT-009")
@with_short_keepalive
def sends_episodes_in_manifest_order() -> None:
    """With two workers, an episode is skipped whenever a later one is scored first."""

    def wrong(run: Run, start: int, end: int | None, scored: bool) -> list[Episode]:
        if not scored:
            return run.episodes[start:end]
        return [e for e in run.episodes if e.result is not None][start:end]

    put(Run, "window", wrong)


@mutant("EVT-003")
@with_short_keepalive
def sends_the_run_before_its_episodes() -> None:
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
@with_short_keepalive
def sends_a_stop_late() -> None:
    """A client that follows a run lets its policy compute for nothing."""
    right = EventStream._read_batch

    async def wrong(self: EventStream, cursor: Cursor) -> EventBatch:
        batch = await right(self, cursor)
        if b'"state":"stopped"' in batch.text:
            await asyncio.sleep(2.0)
        return batch

    put(EventStream, "_read_batch", wrong)


@mutant("EVT-004")
@with_short_keepalive
def resends_an_unchanged_run() -> None:
    """A page that follows a run is redrawn although nothing changed."""
    right, changed = events.next_batch, RunRegistry.wait_for_change

    async def wake_early(self: RunRegistry, event: RunChange, timeout_s: float) -> bool:
        return await changed(self, event, min(timeout_s, 0.2)) or True

    put(RunRegistry, "wait_for_change", wake_early)

    def wrong(cursor: Cursor, run: RunHead, *rest: Any) -> EventBatch:
        without_run_digest = (
            cursor if events.is_final(run) else Cursor(cursor.results_sent)
        )
        return right(without_run_digest, run, *rest)

    put(event_streams, "next_batch", wrong)


@mutant("EVT-004")
@with_short_keepalive
def hides_changes_that_leave_the_state() -> None:
    """A page that follows a run shows one worker where there are two."""
    right = events.next_batch

    def wrong(cursor: Cursor, run: RunHead, *rest: Any) -> EventBatch:
        run_body, scored, _ = rest
        return right(
            cursor, run, run_body, scored, f"{run.state} {run.scored}".encode()
        )

    put(event_streams, "next_batch", wrong)


@mutant("EVT-004", "EVT-005", "EVT-009")
@with_short_keepalive
def restarts_the_stream_on_reconnect() -> None:
    """Each lost connection counts the earlier results again."""
    right = EventStream.answer

    async def wrong(self: EventStream, last_id: str | None) -> Response:
        answer = await right(self, last_id)
        return answer if answer.status_code == 204 else await right(self, None)

    put(EventStream, "answer", wrong)


@mutant("EVT-006", "EVT-009")
@with_short_keepalive
def never_ends_a_stream() -> None:
    """A script that waits for the end of a stream never ends."""

    def wrong(_run: RunHead) -> bool:
        return False

    put(events, "is_final", wrong)


@mutant("EVT-007")
@with_short_keepalive
def accepts_event_ids_of_other_runs() -> None:
    """A reader that mixes up two runs misses the first results of the second."""

    def wrong(id_: str, _run_id: str) -> Cursor | None:
        parts = events._ID.fullmatch(id_)
        return Cursor(int(parts[1]), parts[2]) if parts else None

    put(Cursor, "parse", wrong)


@mutant("EVT-008")
def sends_no_keepalive_comments() -> None:
    """A broken connection looks like a run in which nothing happens."""
    put(event_streams, "KEEPALIVE_S", 1e6)


@mutant("EVT-008")
def sends_one_keepalive_comment() -> None:
    """A proxy closes every stream of a run that is quiet for a minute."""
    put(event_streams, "KEEPALIVE_S", 1.0)
    right = event_streams._left_s
    asked: dict[float, int] = {}

    def wrong(since: float, seconds: float) -> float:
        if seconds != event_streams.KEEPALIVE_S:
            return right(since, seconds)
        task = asyncio.current_task()
        asked[hash(task)] = asked.get(hash(task), 0) + 1
        return right(since, seconds) if asked[hash(task)] < 2 else 1e6

    put(event_streams, "_left_s", wrong)


@mutant("EVT-009")
@with_short_keepalive
def forgets_in_a_restart_in_which_order_episodes_were_scored() -> None:
    """A reader that goes on after a power cut gets one episode twice, and one never."""
    right = Run.__post_init__

    def wrong(self: Run) -> None:
        right(self)
        self.scored_order.sort()

    put(Run, "__post_init__", wrong)


@mutant("EVT-009")
@with_short_keepalive
def sends_results_before_they_are_stored() -> None:
    """After a power cut a result that was published does not exist."""
    right, save = RunRegistry.commit, Store.save

    async def commit_after_notify(self: RunRegistry, run: Run) -> None:
        self.notify(run)
        await right(self, run)

    async def save_slowly(self: Store, run: Run, *checks: Any) -> None:
        await asyncio.sleep(0.25)
        await save(self, run, *checks)

    async def always_stored(_self: RunRegistry, _run: Run) -> bool:
        return True

    put(RunRegistry, "commit", commit_after_notify)
    put(Store, "save", save_slowly)
    put(RunRegistry, "is_stored", always_stored)
