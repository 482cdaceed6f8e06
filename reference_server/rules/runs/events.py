"""Which events of a run a stream sends next, and the cursor behind them.

A reader's place follows from the `id` of its last event alone: the server stores
nothing about readers, and the same ids go on after a restart (EVT-005, EVT-009). Pure:
it gets the current views of the run as bytes and returns those that the reader does not
have yet. It knows neither requests nor the database nor time.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from reference_server.rules.runs.run import RunHead, State

_ID = re.compile(r"([0-9]{1,9})-(none|[0-9a-f]{16})-[0-9a-f]{8}")


@dataclass(frozen=True, slots=True)
class Cursor:
    """A place in the events of a run, the same after a restart (EVT-009).

    results_sent: how many results, in the order in which they were scored (EVT-002).
    run_digest: a digest of the run as it was sent last.
    """

    results_sent: int = 0
    run_digest: str = "none"

    def event_id(self, run_id: str) -> str:
        """The place as text, with a sum that makes it useless in another run."""
        place = f"{self.results_sent}-{self.run_digest}"
        return f"{place}-{_digest(f'{run_id}/{place}'.encode(), 8)}"

    @classmethod
    def parse(cls, id_: str, run_id: str) -> Cursor | None:
        """The place that an id of this run stands for; None of anything else."""
        parts = _ID.fullmatch(id_)
        if parts is None:
            return None
        cursor = cls(int(parts[1]), parts[2])
        return cursor if cursor.event_id(run_id) == id_ else None


@dataclass(frozen=True, slots=True)
class EventBatch:
    """The events to send next.

    text: the events, as they are sent; maybe none. cursor: the place behind them.
    is_behind: there are more at once. is_last: nothing will ever follow.
    """

    text: bytes
    cursor: Cursor
    is_behind: bool
    is_last: bool


def next_batch(
    cursor: Cursor,
    run: RunHead,
    run_body: bytes,
    scored: Sequence[bytes],
    common_body: bytes,
) -> EventBatch:
    """The events that a reader at the cursor has not received yet (EVT-001, EVT-002).

    run_body: the run as get_run shows it. common_body: the part that is the same for
    every reader. scored: the next episodes behind the cursor in the order in which they
    were scored, as list_episodes shows them; as many as are sent at a time. The run is
    sent when all episodes that it counts are (EVT-003).
    """
    events = []
    for episode in scored:
        cursor = Cursor(cursor.results_sent + 1, cursor.run_digest)
        events.append(_event(b"episode", cursor, run, episode))
    is_behind = cursor.results_sent < run.scored
    run_digest = _digest(common_body, 16)
    if not is_behind and run_digest != cursor.run_digest:
        cursor = Cursor(cursor.results_sent, run_digest)
        events.append(_event(b"run", cursor, run, run_body))
    is_last = not is_behind and is_final(run)
    return EventBatch(b"".join(events), cursor, is_behind, is_last)


class HasState(Protocol):
    """The members of a shown run that decide whether its stream ends."""

    @property
    def state(self) -> State: ...
    @property
    def retryable(self) -> bool | None: ...


def is_final(run: HasState) -> bool:
    """EVT-006: nothing that is legal is left, as a test proves of the lifecycle."""
    return run.state == "completed" or (run.state == "failed" and not run.retryable)


def _event(kind: bytes, cursor: Cursor, run: RunHead, data: bytes) -> bytes:
    id_ = cursor.event_id(run.run_id).encode()
    return b"event: %b\nid: %b\ndata: %b\n\n" % (kind, id_, data)


def _digest(data: bytes, length: int) -> str:
    return hashlib.sha256(data).hexdigest()[:length]
