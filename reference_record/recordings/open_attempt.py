"""The attempt in play, as the parts of its recording have it: what a restart finds.

Every turn is written to the recording before it is answered. So who goes on with the
episode after the end of a server has all that was answered, and perhaps one more turn.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import msgspec

from reference_record.recordings.recording import CAMERA, Actions, AttemptEvent
from reference_record.recordings.recording_parts import (
    CAMERA_TOPIC,
    EXECUTED_TURN,
    SUFFIX,
    PartRecord,
    decode_turn,
    digest_after,
    parts_of,
    records_of,
)

# Replaces all parts of earlier owners; the numbers of the others begin at 1.
TAKEN_OVER = f"{0:06d}{SUFFIX}"
_ATTEMPT = msgspec.json.Decoder(AttemptEvent)


class AttemptTurn(msgspec.Struct, frozen=True):
    """A turn that was executed.

    actions: as the simulator was sent them; rewards: of those that it executed.
    requested: as the policy sent them. digest: of the state after them.
    """

    seq: int
    actions: Actions
    requested: Actions
    observe_all: bool
    rewards: Sequence[float]
    think_ms: float
    digest: str


@dataclass(slots=True)
class OpenAttempt:
    """The attempt that was begun last, unless it is over or broke.

    attempt: its number; None if none is in play. digest: of the state at step 0.
    """

    attempt: int | None = None
    digest: str = ""
    instruction: str = ""
    turns: list[AttemptTurn] = field(default_factory=list)

    def add(self, record: PartRecord) -> None:
        """Raises MsgspecError."""
        if record.kind == EXECUTED_TURN:
            self._add_turn(record.data)
        elif record.topic == "/attempt":
            event = _ATTEMPT.decode(record.data)
            is_begun = event.event == "started"
            self.attempt = event.attempt if is_begun else None
            self.digest, self.turns = event.state_digest or "", []
            self.instruction = event.instruction or ""
        elif record.topic == "/fault":  # the attempt begins again at step 0
            self.attempt, self.turns = None, []

    def _add_turn(self, data: bytes) -> None:
        executed = decode_turn(data)
        command = executed.command
        self.turns.append(
            AttemptTurn(
                command.seq,
                command.actions,
                command.requested or command.actions,
                command.observe_all,
                executed.rewards,
                command.think_ms,
                digest_after(executed),
            )
        )


def read_attempt(folders: Iterable[Path]) -> OpenAttempt:
    """The attempt in play. Raises OSError and MsgspecError."""
    attempt = OpenAttempt()
    for folder in folders:
        for part in parts_of(folder):
            for record in records_of(part):
                attempt.add(record)
    return attempt


def take_over(earlier: Sequence[Path], folder: Path) -> None:
    """Copy all that earlier owners wrote into one part of `folder`, before its own.

    An earlier owner that was only paused may write on: nothing of that is read then.
    Pictures behind the last turn are left out: they are drawn with it again. Raises
    OSError.
    """
    records: list[bytes] = []
    kept = 0
    for source in earlier:
        for part in parts_of(source):
            for record in records_of(part):
                records.append(record.written)
                is_picture = record.topic.startswith(CAMERA)
                if not (is_picture or record.kind == CAMERA_TOPIC):
                    kept = len(records)
    if not kept:
        return
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    draft = (folder / TAKEN_OVER).with_suffix(".draft")
    descriptor = os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    with os.fdopen(descriptor, "wb") as file:
        file.writelines(records[:kept])
    draft.replace(folder / TAKEN_OVER)


def has_taken_over(folder: Path) -> bool:
    """Whether it has all that earlier owners wrote."""
    return (folder / TAKEN_OVER).is_file()
