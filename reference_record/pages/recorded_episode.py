"""A recording as the page of its episode shows it: the last attempt, step by step.

Recordings come from elsewhere: they are read within the bounds of `McapReader`, and
what is kept of one is bounded here. State is not recorded, only digests of it.
"""

from __future__ import annotations

import base64
import binascii
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import BinaryIO, Final

import msgspec

from reference_record.broken import BrokenRecord
from reference_record.contents.score import STAGE_TOLERANCE
from reference_record.formats.strict_json import UNREADABLE
from reference_record.pages.run_page import PolicyTimes
from reference_record.recordings.mcap_reader import McapReader
from reference_record.recordings.recording import (
    CAMERA,
    AttemptEvent,
    EpisodeResult,
    Fault,
    RecordedJudgement,
    Turn,
)
from reference_record.texts.figures import figure

EVENTS_MAX: Final = 200
PICTURES_MAX: Final = 2000
PICTURE_BYTES_MAX: Final = 64 * 2**20
STAGES_MAX: Final = 64
TEXT_CHARS_MAX: Final = 4000
GOAL: Final = "goal"
_FORMATS: Final = {"jpeg": "jpg", "png": "png", "webp": "webp"}
_CAMERA_NAME: Final = re.compile(r"[A-Za-z0-9_.-]{1,64}")

_TURN = msgspec.json.Decoder(Turn)
_ATTEMPT = msgspec.json.Decoder(AttemptEvent)
_FAULT = msgspec.json.Decoder(Fault)
_JUDGEMENT = msgspec.json.Decoder(RecordedJudgement)
_RESULT = msgspec.json.Decoder(EpisodeResult)


class _CameraMessage(msgspec.Struct):
    """As JSON has it: the data is a text."""

    data: str
    format: str


_PICTURE = msgspec.json.Decoder(_CameraMessage)


@dataclass(frozen=True, slots=True)
class CameraPicture:
    """The picture of a camera after `step` steps; extension: as files of it have."""

    camera: str
    step: int
    data: bytes
    extension: str


@dataclass(slots=True)
class RecordedEpisode:
    """turns: of the last attempt. events: (attempt, what happened, why) of all.

    sha256: of the recording, where that is known; a video of the episode has it, too.
    instruction, stages: as its start says them; empty where it does not.
    """

    turns: list[Turn] = field(default_factory=list)
    events: list[tuple[int, str, str]] = field(default_factory=list)
    first_digest: str | None = None
    result: EpisodeResult | None = None
    judgement: RecordedJudgement | None = None
    pictures: list[CameraPicture] = field(default_factory=list)
    sha256: str = ""
    instruction: str = ""
    stages: Sequence[str] = ()

    @property
    def steps(self) -> int:
        return sum(turn.steps for turn in self.turns)

    @property
    def stages_reached(self) -> list[tuple[str, int | None]]:
        """Each stage, then the goal: the step at which it was reached, None if never.

        The score is k / (n + 1) after the first k of n stages (record.md). The goal is
        reached as the success of the last turn says, whatever the score is, so that it
        agrees with the outcome; of `last_step`, where it has held since. Stages among
        which the goal is do not count so: none are shown.
        """
        if not self.stages or GOAL in self.stages:
            return []
        count = len(self.stages)
        steps: list[int | None] = []
        step, goal = 0, None
        for turn in self.turns:
            step += turn.steps
            goal = (step if goal is None else goal) if turn.success else None
            while len(steps) < count and (
                turn.success
                or turn.score >= (len(steps) + 1) / (count + 1) - STAGE_TOLERANCE
            ):
                steps.append(step)
        missed = [None] * (count - len(steps))
        return list(zip([*self.stages, GOAL], [*steps, *missed, goal], strict=True))

    def times(self, control_rate_hz: float | None) -> PolicyTimes:
        """How long the policy took; `late` needs the control rate."""
        times = PolicyTimes([turn.think_ms for turn in self.turns])
        if not control_rate_hz or control_rate_hz <= 0:
            return times
        for before, turn in zip(self.turns, self.turns[1:], strict=False):
            times.followed += 1
            times.late += turn.think_ms > 1000 * before.steps / control_rate_hz
        return times


def read_recorded_episode(file: BinaryIO, size: int, name: str) -> RecordedEpisode:
    """Raises BrokenRecord, which calls the file `name`."""
    episode = RecordedEpisode()
    reader = _Reader(episode)
    try:
        for topic, data in McapReader(name, file, size).messages():
            reader.add(topic, data)
        reader.place_pictures(0)
    except UNREADABLE as error:
        detail = f"a message cannot be read: {error}"
        raise BrokenRecord(name, "REC-012", detail) from error
    return episode


class _Reader:
    def __init__(self, episode: RecordedEpisode) -> None:
        self._episode = episode
        self._steps = 0
        self._picture_bytes = 0
        # Written before the turn that they show the end of.
        self._unplaced: list[CameraPicture] = []

    def add(self, topic: str, data: memoryview) -> None:
        episode = self._episode
        if topic == "/turn":
            turn = _TURN.decode(data)
            self.place_pictures(turn.steps)
            self._steps += turn.steps
            episode.turns.append(turn)
        elif topic == "/attempt":
            self._add_attempt(_ATTEMPT.decode(data))
        elif topic == "/fault":
            fault = _FAULT.decode(data)
            self._note(fault.attempt, fault.code.replace("_", " "), fault.detail)
        elif topic == "/judgement":
            self._add_judgement(_JUDGEMENT.decode(data))
        elif topic == "/result":
            episode.result = _RESULT.decode(data)
        elif topic.startswith(CAMERA):
            self._add_picture(topic.removeprefix(CAMERA), _PICTURE.decode(data))

    def _add_attempt(self, event: AttemptEvent) -> None:
        self._note(event.attempt, event.event, event.reason or "")
        if event.event == "started":
            self._episode.turns.clear()
            self._episode.pictures.clear()
            self._unplaced.clear()
            self._steps = self._picture_bytes = 0
            self._episode.first_digest = event.state_digest
            self._episode.instruction = (event.instruction or "")[:TEXT_CHARS_MAX]
            stages = event.stages[:STAGES_MAX]
            self._episode.stages = [name[:TEXT_CHARS_MAX] for name in stages]

    def _add_judgement(self, given: RecordedJudgement) -> None:
        """The last one counts: an attempt may be void after its judgement."""
        self._episode.judgement = given
        outcome = (
            "success"
            if given.success
            else f"no success, score {figure(given.score, 3)}"
        )
        blind = "blind" if given.blind else "not blind"
        note = f": {given.note}" if given.note else ""
        self._note(
            given.attempt, "judged", f"{outcome}, by {given.judge}, {blind}{note}"
        )

    def _note(self, attempt: int, what: str, why: str) -> None:
        if len(self._episode.events) < EVENTS_MAX:
            self._episode.events.append((attempt, what, why[:1000]))

    def _add_picture(self, camera: str, message: _CameraMessage) -> None:
        extension = _FORMATS.get(message.format)
        can_be_shown = extension and _CAMERA_NAME.fullmatch(camera)
        self._picture_bytes += len(message.data)
        pictures = self._episode.pictures
        full = len(pictures) + len(self._unplaced) >= PICTURES_MAX
        if not can_be_shown or full or self._picture_bytes > PICTURE_BYTES_MAX:
            return
        try:
            data = base64.b64decode(message.data, validate=True)
        except (ValueError, binascii.Error):
            return
        picture = CameraPicture(camera, self._steps, data, str(extension))
        is_first = all(camera != earlier.camera for earlier in pictures)
        (pictures if is_first else self._unplaced).append(picture)

    def place_pictures(self, steps: int) -> None:
        """Pictures of a turn of so many steps show each step, or the last one."""
        numbers: Counter[str] = Counter()
        counts = Counter(picture.camera for picture in self._unplaced)
        for picture in self._unplaced:
            numbers[picture.camera] += 1
            is_each = counts[picture.camera] == steps
            after = numbers[picture.camera] if is_each else steps
            step = self._steps + after
            self._episode.pictures.append(replace(picture, step=step))
        self._unplaced.clear()


@dataclass(frozen=True, slots=True)
class FirstDifference:
    """step: the first one, from 1, that was not the same in both; 0: the start."""

    step: int
    what: str


def first_divergence(
    baseline: RecordedEpisode, run: RecordedEpisode
) -> FirstDifference | None:
    """Where two plays of an episode part; None while they are the same."""
    if baseline.first_digest != run.first_digest:
        return FirstDifference(0, "The simulator began in another state.")
    pairs = zip(_actions(baseline), _actions(run), strict=False)
    for step, (a, b) in enumerate(pairs, start=1):
        if a != b:
            return FirstDifference(step, "Another action was executed.")
    if baseline.steps != run.steps:
        return FirstDifference(
            min(baseline.steps, run.steps) + 1, "One ended, the other went on."
        )
    last = (baseline.turns[-1:], run.turns[-1:])
    digests = [turn.state_digest for turns in last for turn in turns]
    if len(set(digests)) > 1:
        return FirstDifference(baseline.steps, "The same actions led to another state.")
    return None


def _actions(episode: RecordedEpisode) -> list[Mapping[str, Sequence[float]]]:
    return [action for turn in episode.turns for action in turn.actions]
