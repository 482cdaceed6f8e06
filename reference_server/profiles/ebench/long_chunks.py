"""Plays a list of steps that is longer than a turn of the run may be.

EBench limits no list of steps; a run has its `max_chunk`. A longer list is played in
several turns, one after another, until it is finished or its episode has ended
(EBE-028). To the client it is one step: it has one answer, and a repetition of it
waits for that answer (EBE-013).

Keeps, for each session, the last such list whose answer was not confirmed, in memory
only. Must not know requests or encodings; each turn is decided by the rules.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias
from weakref import WeakKeyDictionary

from reference_server.rules.lifecycle import Predict
from reference_server.rules.run import Session

Turn: TypeAlias = Mapping[str, Any]
Play: TypeAlias = Callable[[Predict], Awaitable[Turn]]


@dataclass(frozen=True, slots=True, eq=False)
class LongChunk:
    """A list of steps in execution, or executed and not confirmed."""

    digest: str
    task: asyncio.Task[Turn]

    async def result(self) -> Turn:
        """The answer of the whole list; who waits may leave."""
        return await asyncio.shield(self.task)

    @property
    def seq(self) -> int | None:
        """That of its last turn; None while it is played, or when it failed."""
        if not self.task.done() or self.task.cancelled() or self.task.exception():
            return None
        seq: int = self.task.result()["seq"]
        return seq


class LongChunks:
    """The last long list of each session."""

    def __init__(self) -> None:
        self._chunks: WeakKeyDictionary[Session, LongChunk] = WeakKeyDictionary()

    def find_repeated(self, session: Session, digest: str) -> LongChunk | None:
        """EBE-013: the list that this request repeats, if it does."""
        chunk = self._chunks.get(session)
        if chunk is None or chunk.digest != digest:
            return None
        return chunk if self.is_played(session) or chunk.seq == session.seq else None

    def is_played(self, session: Session) -> bool:
        """Whether a list of the session has turns yet to come."""
        chunk = self._chunks.get(session)
        return chunk is not None and not chunk.task.done()

    def start(
        self, session: Session, digest: str, turns: Sequence[Predict], play: Play
    ) -> LongChunk:
        """Play the turns in a task of their own, which no client's leaving ends."""
        task = asyncio.create_task(_play_all(turns, play))
        # Its exception is retrieved also when its client has disconnected.
        task.add_done_callback(lambda task: task.cancelled() or task.exception())
        chunk = self._chunks[session] = LongChunk(digest, task)
        return chunk

    def confirm_delivery(self, session: Session, seq: int) -> None:
        """EBE-014: the answer was sent while its client was connected."""
        chunk = self._chunks.get(session)
        if chunk is not None and chunk.seq == seq:
            del self._chunks[session]


def split(command: Predict, max_chunk: int) -> list[Predict]:
    """The turns of at most `max_chunk` actions that a predict is played in."""
    actions = command.actions
    return [
        Predict(
            command.worker_id,
            command.session_id,
            command.seq + number,
            actions[start : start + max_chunk],
        )
        for number, start in enumerate(range(0, len(actions), max_chunk))
    ]


async def _play_all(turns: Sequence[Predict], play: Play) -> Turn:
    """The last turn, with the actions that all have executed."""
    executed = 0
    for command in turns:
        turn = await play(command)
        executed += turn["executed_steps"]
        ended = "episode_result" in turn or turn["done"]
        if ended or turn["executed_steps"] < len(command.actions):
            break
    left = executed < sum(len(command.actions) for command in turns)
    return {**turn, "executed_steps": executed, "stopped_early": left}
