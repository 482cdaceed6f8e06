"""A record of calibration with pictures, for what is simulated again: long episodes."""

from collections.abc import Iterator
from pathlib import Path

import msgspec

from reference_record.recordings.recording import Turn
from reference_sim import benchmark_registry
from reference_sim.episode import Episode
from reference_sim.interface import Simulator
from tests.support.record.played_records import Change, Chunk, keep, save_played_record
from tests.support.sim.calibration_action import calibration_action

# The last episode has no camera.
ECHO = {"tasks": ["echo", "echo", "score"], "max_steps": 45}


def play_45_steps(_episode: Episode, _simulator: Simulator) -> Iterator[Chunk]:
    """An episode that fails, with chunks of 5 steps."""
    for _ in range(9):
        yield [calibration_action()] * 5


def save_echo(folder: Path, change: Change = keep, faults: int = 0) -> Path:
    """10 Hz, pictures of 16 x 12; folder: has an empty folder `recordings`."""
    found = benchmark_registry.resolve("calibration", ECHO)
    return save_played_record(
        folder / "run-1.proctor",
        folder / "recordings",
        found,
        play_45_steps,
        change=change,
        options=ECHO,
        faults=faults,
    )


def other_digest(index: int, number: int, turn: Turn) -> Turn:
    """The third turn of episode 1 has another state."""
    if (index, number) != (1, 3):
        return turn
    return msgspec.structs.replace(turn, state_digest="0" * 32)


def other_action(index: int, number: int, turn: Turn) -> Turn:
    """The third turn of episode 1 is recorded with another end."""
    if (index, number) != (1, 3):
        return turn
    ending = [calibration_action(success=1, end=1)] * 5
    return msgspec.structs.replace(turn, actions=ending)
