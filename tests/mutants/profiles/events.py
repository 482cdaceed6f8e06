"""Mutants of events: content, order, start, delay and end of a stream."""

from __future__ import annotations

import asyncio
import copy
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from starlette.responses import Response

from reference_server.http import event_streams
from reference_server.http.event_streams import EventStream
from reference_server.rules.runs import events
from reference_server.rules.runs.events import Cursor
from reference_server.rules.runs.run import Episode, Run, RunHead
from reference_server.runs.run_writer import RunWriter
from reference_server.storage.runs.run_store import Store
from tests.mutants import instead_of, mutant, put


def with_short_keepalive(patch: Callable[[Any], None]) -> Callable[[Any], None]:
    """Let comments come soon, too, so that the kit need not wait for one."""

    def patch_both(wrong: Any) -> None:
        put(event_streams, "KEEPALIVE_S", 1.0)
        patch(wrong)

    return patch_both


@mutant(
    "EVT-001", through=with_short_keepalive(instead_of(event_streams, "episode_view"))
)
def sends_only_the_ids_of_episodes(right: Any, episode: Episode) -> Any:
    """A client that follows a run must request each result."""
    view = right(episode)
    return {name: view[name] for name in ("episode_id", "index", "task")}


@mutant("EVT-002", "EVT-009", through=with_short_keepalive(instead_of(Run, "window")))
def sends_episodes_in_manifest_order(
    _right: Any, run: Run, start: int, end: int | None, scored: bool
) -> Any:
    """With two workers, an episode is skipped whenever a later one is scored first."""
    episodes = [e for e in run.episodes if e.result is not None or not scored]
    return episodes[start:end]


@mutant(
    "EVT-003", through=with_short_keepalive(instead_of(event_streams, "next_batch"))
)
def sends_the_run_before_its_episodes(
    right: Any, cursor: Cursor, run: RunHead, *rest: Any
) -> Any:
    """A page counts ten episodes as scored and has the results of nine."""
    if events.is_final(run):
        return right(cursor, run, *rest)
    shown, scored, common_body = rest
    head = copy.copy(run)
    head.scored = cursor.results_sent
    first = right(cursor, head, shown, [], common_body)
    second = right(first.cursor, run, shown, scored, common_body)
    return replace(second, text=first.text + second.text)


@mutant("EVT-004", through=with_short_keepalive(instead_of(EventStream, "_read_batch")))
async def sends_a_stop_late(right: Any, self: EventStream, cursor: Cursor) -> Any:
    """A client that follows a run lets its policy compute for nothing."""
    batch = await right(self, cursor)
    if b'"state":"stopped"' in batch.text:
        await asyncio.sleep(2.0)
    return batch


@mutant(
    *("EVT-004", "EVT-005", "EVT-009"),
    through=with_short_keepalive(instead_of(EventStream, "answer")),
)
async def restarts_the_stream_on_reconnect(
    right: Any, self: EventStream, last_id: str | None
) -> Any:
    """Each lost connection counts the earlier results again."""
    answer = await right(self, last_id)
    return answer if answer.status_code == 204 else await right(self, None)


@mutant(
    "EVT-009",
    "EVT-010",
    through=with_short_keepalive(instead_of(EventStream, "answer")),
)
async def sends_an_empty_stream_after_the_last_event(
    right: Any, self: EventStream, last_id: str | None
) -> Any:
    """A browser connects again, without end, to a stream in which nothing follows."""
    answer = await right(self, last_id)
    if answer.status_code != 204:
        return answer
    return Response(b"retry: 1000\n\n", media_type="text/event-stream")


@mutant(
    *("EVT-006", "EVT-009", "EVT-010"),
    through=with_short_keepalive(instead_of(events, "is_final")),
)
def never_ends_a_stream(_right: Any, _run: RunHead) -> Any:
    """A script that waits for the end of a stream never ends."""
    return False


@mutant("EVT-007", through=with_short_keepalive(instead_of(Cursor, "parse")))
def accepts_event_ids_of_other_runs(_right: Any, id_: str, _run_id: str) -> Any:
    """A reader that mixes up two runs misses the first results of the second."""
    parts = events._ID.fullmatch(id_)
    return Cursor(int(parts[1]), parts[2]) if parts else None


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


@mutant("EVT-009", through=with_short_keepalive(instead_of(Run, "__post_init__")))
def forgets_in_a_restart_in_which_order_episodes_were_scored(
    right: Any, self: Run
) -> None:
    """A reader that goes on after a power cut gets one episode twice, and one never."""
    right(self)
    self.scored_order.sort()


@mutant("EVT-009")
def sends_results_before_they_are_stored() -> None:
    """A result that was published does not exist after a power cut."""
    put(event_streams, "KEEPALIVE_S", 1.0)
    right, save = RunWriter.commit, Store.save

    async def commit_after_notify(self: RunWriter, run: Run, *checks: Any) -> None:
        self._events.changed(run)
        await right(self, run, *checks)

    async def save_slowly(self: Store, run: Run, *checks: Any) -> list[Episode]:
        await asyncio.sleep(0.25)
        return await save(self, run, *checks)

    async def always_stored(_self: RunWriter, _run: Run) -> bool:
        return True

    put(RunWriter, "commit", commit_after_notify)
    put(Store, "save", save_slowly)
    put(RunWriter, "is_stored", always_stored)
