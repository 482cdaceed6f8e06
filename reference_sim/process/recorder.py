"""Appends the actions that a simulator executes to the recording of its episode.

In the simulator's own process: a turn is recorded before it is reported, and recording
costs nothing in the event loop of the server. A recording that cannot be written is an
error of the simulator, unless the disk is full.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import NDArray

from reference_record.recordings.recording import (
    CAMERA,
    AttemptEvent,
    Message,
    Picture,
    digest_state,
)
from reference_record.recordings.recording_parts import (
    NO_ROOM,
    CollectedPart,
    ExecutedTurn,
    PartWriter,
)
from reference_record.texts.timestamps import timestamp
from reference_sim.episode import Episode
from reference_sim.interface import Simulator
from reference_sim.process.observation_encoding import encode_image

# A state up to this size is written as it is, and hashed when the turns are read, which
# costs a turn less time. A larger state is written as its digest alone.
STATE_BYTES_MAX = 512
# Parts of an episode, with which it may begin again: each is read at its end.
PARTS_MAX = 10_000


class RecordingPlan(msgspec.Struct, frozen=True):
    """The folder that an attempt is recorded in, and whether with its pictures.

    folder: empty where the server writes what the replies have of it. is_continued: its
    beginning is recorded already, with turns of it.
    """

    folder: str
    attempt: int
    pictures: bool = False
    is_continued: bool = False


class UnwritableRecording(Exception):
    """The recording could not be written. no_room: the disk is full."""

    def __init__(self, error: OSError) -> None:
        detail = error.strerror or error
        super().__init__(f"the recording could not be written: {detail}")
        self.no_room = error.errno in NO_ROOM


def state_digest(simulator: Simulator) -> str:
    return digest_state(simulator.state_bytes())


class EpisodeRecorder:
    """Records one attempt from its reset on. All methods raise UnwritableRecording."""

    def __init__(
        self, plan: RecordingPlan, simulator: Simulator, episode: Episode
    ) -> None:
        self._plan, self._simulator = plan, simulator
        self._part: PartWriter | CollectedPart = CollectedPart()
        if plan.folder:
            try:
                self._part = PartWriter(Path(plan.folder), PARTS_MAX)
            except OSError as error:
                raise UnwritableRecording(error) from error
        if plan.is_continued:
            return
        now = time.time_ns()
        started = AttemptEvent(
            plan.attempt,
            "started",
            timestamp(now / 10**9),
            state_digest=state_digest(simulator),
            instruction=episode.instruction,
            stages=episode.stages,
        )
        self._write("/attempt", started, now)

    def add_turn(
        self,
        command: bytes,
        rewards: Sequence[float],
        episode: Episode,
        simulate_s: float,
    ) -> None:
        """REC-104: once, as it was executed; each reward is of an executed action.

        command: MessagePack that has the members of TurnCommand.
        """
        state = self._simulator.state_bytes()
        digest = None
        if len(state) > STATE_BYTES_MAX:
            state, digest = b"", digest_state(state)
        turn = ExecutedTurn(
            self._plan.attempt,
            rewards,
            episode.score,
            episode.success,
            episode.ended,
            state,
            digest,
            simulate_s,
            msgspec.Raw(command),
        )
        try:
            self._part.write_turn(turn)
        except OSError as error:
            raise UnwritableRecording(error) from error

    def add_pictures(
        self, images: Mapping[str, NDArray[np.uint8]], *, always: bool = False
    ) -> None:
        """Record the pictures of the cameras, if the plan asks for them, or always."""
        if not (always or self._plan.pictures):
            return
        now = time.time_ns()
        stamp = dict(zip(("sec", "nsec"), divmod(now, 10**9), strict=True))
        for name, pixels in images.items():
            codec = "jpeg" if pixels.shape[2] in (1, 3) else "png"
            coded = bytes(encode_image(pixels, codec)["data"])
            self._write(CAMERA + name, Picture(stamp, name, coded, codec), now)

    def take(self) -> bytes:
        """Give what the server has to write; nothing if it is written here."""
        return self._part.take() if isinstance(self._part, CollectedPart) else b""

    def close(self) -> None:
        self._part.close()

    def _write(self, topic: str, message: Message, at_ns: int) -> None:
        try:
            self._part.write(topic, message, at_ns)
        except OSError as error:
            raise UnwritableRecording(error) from error
