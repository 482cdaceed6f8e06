"""Plays a list of steps that is longer than a turn of the run may be.

EBench limits no list of steps; a run has its `max_chunk`. A longer list is played in
several turns, one after another, until it is finished or its episode has ended
(EBE-028). To the client it is one step: it has one answer, and a repetition of it
waits for that answer (EBE-013). When a turn of it fails, a repetition goes on with that
turn: what was executed before is not executed again.

Keeps, for each session, the last such list whose answer was not confirmed, in memory
only. Must not know requests or encodings; each turn is decided by the rules.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias
from weakref import WeakKeyDictionary

from reference_server.process.background_work import shielded
from reference_server.rules.runs.lifecycle import Predict
from reference_server.rules.runs.run import Session

Turn: TypeAlias = Mapping[str, Any]
Play: TypeAlias = Callable[[Predict], Awaitable[Turn]]


@dataclass(frozen=True, slots=True, eq=False)
class LongChunk:
    """A list of steps in execution, executed and not confirmed, or failed.

    executed: how many actions each turn has executed that was answered.
    """

    digest: str
    turns: Sequence[Predict]
    executed: list[int]
    task: asyncio.Task[Turn]

    @property
    def failed_turn(self) -> Predict | None:
        """The turn to go on with; None if it is played, or was played to its end."""
        if not self.task.done() or self.seq is not None:
            return None
        return self.turns[len(self.executed)]

    async def result(self) -> Turn:
        """The answer of the whole list; who waits may leave."""
        return await shielded(self.task)

    @property
    def seq(self) -> int | None:
        """The `seq` of its last turn; None while it is played, or when it failed."""
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

    def find_failed(self, session: Session, digest: str) -> LongChunk | None:
        """The list that this request repeats, if a turn of it failed."""
        chunk = self._chunks.get(session)
        if chunk is None or chunk.digest != digest or chunk.failed_turn is None:
            return None
        # Nothing else was played in the session since; the turn may have been begun.
        seq = chunk.failed_turn.seq
        return chunk if session.seq in (seq - 1, seq) else None

    def start(
        self,
        session: Session,
        digest: str,
        turns: Sequence[Predict],
        play: Play,
        executed: Sequence[int] = (),
    ) -> LongChunk:
        """Play the turns in a task of their own, which no client's leaving ends.

        executed: by the first of them, which are not played again.
        """
        so_far = [*executed]
        task = asyncio.create_task(_play_all(turns, so_far, play))
        # Its exception is retrieved also when its client has disconnected.
        task.add_done_callback(lambda task: task.cancelled() or task.exception())
        chunk = self._chunks[session] = LongChunk(digest, turns, so_far, task)
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


async def _play_all(turns: Sequence[Predict], executed: list[int], play: Play) -> Turn:
    """The last turn, with the actions that all have executed; counts each answer."""
    for command in turns[len(executed) :]:
        turn = await play(command)
        executed.append(turn["executed_steps"])
        ended = "episode_result" in turn or turn["done"]
        if ended or turn["executed_steps"] < len(command.actions):
            break
    steps = sum(executed)
    left = steps < sum(len(command.actions) for command in turns)
    return {**turn, "executed_steps": steps, "stopped_early": left}
