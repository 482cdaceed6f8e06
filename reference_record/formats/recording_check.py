"""Whether a recording has the episode that its line in episodes.jsonl has.

One pass over its messages, in memory that does not grow with them.
"""

from __future__ import annotations

from typing import BinaryIO, Final

import msgspec
from msgspec import Struct

from reference_record.broken import BrokenRecord
from reference_record.formats.mcap_reader import McapReader
from reference_record.formats.strict_json import UNREADABLE, describe_damage
from reference_record.generated.answers import Outcome
from reference_record.score import TOLERANCE
from reference_record.statement import EpisodeLine, RecordingFacts

MESSAGE_BYTES_MAX: Final = 2**24


class _Attempt(Struct):
    attempt: int
    event: str
    state_digest: str | None = None


class _Turn(Struct):
    attempt: int
    actions: list[msgspec.Raw]
    rewards: list[float]
    steps: int
    score: float
    success: bool
    ended: bool
    state_digest: str


class _Result(Struct):
    outcome: Outcome
    success: bool
    score: float
    steps: int
    attempts: int


_ATTEMPT = msgspec.json.Decoder(_Attempt)
_TURN = msgspec.json.Decoder(_Turn)
_RESULT = msgspec.json.Decoder(_Result)


def check_recording(file: BinaryIO, size: int, line: EpisodeLine) -> int:
    """The number of its turns; raises BrokenRecord unless it fits the line.

    REC-010: the line and the recording agree. REC-012: its messages come in an order in
    which an episode can have been played.
    """
    assert line.recording is not None
    name = line.recording.path
    played = _Played(name)
    try:
        for topic, data in McapReader(name, file, size).messages():
            if len(data) > MESSAGE_BYTES_MAX:
                detail = f"a message has more than {MESSAGE_BYTES_MAX} bytes"
                raise BrokenRecord(name, "REC-030", detail)
            played.add(topic, data)
    except UNREADABLE as error:
        detail = f"a message cannot be read: {describe_damage(error)}"
        raise BrokenRecord(name, "REC-012", detail) from error
    if size != line.recording.bytes:
        raise BrokenRecord(name, "REC-010", "its size is not that in episodes.jsonl")
    played.compare(line, line.recording)
    return played.turns


class _Played:
    """The state of the episode that follows from the messages read so far."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._attempt = 0
        self._steps = 0
        self._last_turn: _Turn | None = None
        self._first_digest: str | None = None
        self._last_digest: str | None = None
        self._result: _Result | None = None
        self.turns = 0

    def add(self, topic: str, data: memoryview) -> None:
        if self._result is not None:
            self._refuse("a message stands behind its result")
        if topic == "/turn":
            self._add_turn(_TURN.decode(data))
        elif topic == "/attempt":
            event = _ATTEMPT.decode(data)
            if event.event == "started":
                self._begin(event)
        elif topic == "/result":
            self._result = _RESULT.decode(data)

    def _begin(self, event: _Attempt) -> None:
        if event.attempt < max(self._attempt, 1):
            self._refuse(f"attempt {event.attempt} begins behind {self._attempt}")
        self._attempt, self._steps, self._last_turn = event.attempt, 0, None
        self._first_digest = self._first_digest or event.state_digest
        if self.turns == 0:
            self._last_digest = event.state_digest

    def _add_turn(self, turn: _Turn) -> None:
        if turn.attempt != self._attempt or turn.steps < 0:
            self._refuse(f"turn {self.turns + 1} belongs to no attempt that began")
        if not len(turn.actions) == len(turn.rewards) == turn.steps:
            self._refuse(f"turn {self.turns + 1} has other steps than actions, rewards")
        self.turns += 1
        self._steps += turn.steps
        self._last_turn, self._last_digest = turn, turn.state_digest

    def compare(self, line: EpisodeLine, facts: RecordingFacts) -> None:
        digests = (facts.first_digest, facts.last_digest)
        if digests != (self._first_digest, self._last_digest):
            self._refuse("its state digests are not those of episodes.jsonl", "REC-010")
        if line.outcome is None:
            if self._result is not None:
                self._refuse("it has a result, episodes.jsonl has none", "REC-010")
            return
        result = self._result
        if result is None:
            self._refuse("it has no result, episodes.jsonl has one", "REC-010")
            return
        said = (line.outcome, line.success, line.score, line.steps, line.attempts)
        recorded = (result.outcome, result.success, result.score)
        if said != (*recorded, result.steps, result.attempts):
            self._refuse("its result is not that of episodes.jsonl", "REC-010")
        if result.outcome != "abandoned":
            self._check_end(result)

    def _check_end(self, result: _Result) -> None:
        """REC-011: what was scored is what the last attempt came to."""
        turn = self._last_turn
        if turn is None or (result.steps, result.attempts) != (
            self._steps,
            self._attempt,
        ):
            self._refuse("its result is not that of its last attempt", "REC-011")
            return
        if turn.success != result.success or abs(turn.score - result.score) > TOLERANCE:
            self._refuse("its score does not follow from its turns", "REC-011")
        if not turn.ended:
            self._refuse("its last turn did not end the episode", "REC-011")

    def _refuse(self, detail: str, rule: str = "REC-012") -> None:
        raise BrokenRecord(self._name, rule, detail)
