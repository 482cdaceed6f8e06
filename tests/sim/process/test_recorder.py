"""A simulator process records what it executes, before it reports it."""

import hashlib
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import msgspec
import pytest

from reference_record.pages.recorded_episode import read_recorded_episode
from reference_record.recordings.recording import Fault
from reference_record.recordings.recording_file import join_parts
from reference_record.recordings.recording_parts import (
    TurnCommand,
    append_part,
    json_of,
    parts_of,
    read_part,
)
from reference_sim.benchmark_registry import resolve
from reference_sim.benchmarks.calibration import Calibration
from reference_sim.episode import Episode
from reference_sim.process import recorder as recorder_module
from reference_sim.process.pool import (
    Begin,
    RecordingPlan,
    SimulatorFault,
    SimulatorHandle,
)
from reference_sim.process.recorder import EpisodeRecorder, UnwritableRecording
from tests.support.sim.calibration_action import calibration_action as action
from tests.support.sim.shared_processes import opened_pool


class StateOf(Calibration):
    """Has always this state."""

    stages: tuple[str, ...] = ()

    def __init__(self, state: bytes) -> None:
        super().__init__(16, 12)
        self._state = state

    def state_bytes(self) -> bytes:
        return self._state


@asynccontextmanager
async def simulator(*, records_here: bool = False) -> AsyncIterator[SimulatorHandle]:
    """One of `calibration`, in a process of its own."""
    async with opened_pool(size_max=1) as pool:
        pool.records_here = records_here
        yield await pool.acquire(resolve("calibration").world)


async def begin(handle: SimulatorHandle, plan: RecordingPlan, task: str) -> None:
    await handle.begin(Begin(task, 7, 3, "any_step", recording=plan))


def read(folder: Path) -> list[tuple[str, dict[str, object]]]:
    return [
        (topic, msgspec.json.decode(json_of(message)))
        for part in parts_of(folder)
        for topic, _, message in read_part(part)
    ]


@pytest.mark.parametrize("records_here", [False, True])
async def test_a_turn_is_recorded_as_it_was_executed(
    tmp_path: Path, *, records_here: bool
) -> None:
    """records_here: by the server, as for simulators of other machines."""
    async with simulator(records_here=records_here) as handle:
        plan = RecordingPlan(str(tmp_path), 2)
        await begin(handle, plan, "score")
        chunk = [action(score=score) for score in (0.25, 0.5)]
        await handle.play(chunk, observe_all=False, seq=1, think_ms=1.5)
        (_, started), (_, first) = read(tmp_path)
        assert started["event"] == "started"
        assert started["attempt"] == first["attempt"] == 2
        assert first["actions"] == chunk
        assert first["rewards"] == [0.25, 0.5]
        assert (first["seq"], first["steps"], first["score"]) == (1, 2, 0.5)
        assert (first["think_ms"], first["ended"]) == (1.5, False)
        await handle.play(chunk, observe_all=True, seq=2)
        _, last = read(tmp_path)[-1]
        assert last["actions"] == chunk[:1]
        assert (last["steps"], last["ended"]) == (1, True)
        digests = {started["state_digest"], first["state_digest"]}
        assert len(digests | {last["state_digest"]}) == 3


@pytest.mark.parametrize(
    ("stages", "score_is_success", "said"),
    [
        pytest.param(("near", "held"), False, ["near", "held"], id="stages"),
        pytest.param(("near", "held"), True, None, id="success-is-the-score"),
        pytest.param((), False, None, id="none"),
    ],
)
def test_a_start_says_what_was_asked_and_what_is_counted(
    tmp_path: Path,
    stages: tuple[str, ...],
    score_is_success: bool,
    said: list[str] | None,
) -> None:
    """A score that is the success counts no stage."""
    simulator = StateOf(b"")
    simulator.stages = stages
    episode = Episode(
        simulator, "score", 7, max_steps=3, success_rule="any_step",
        score_is_success=score_is_success,
    )  # fmt: skip
    EpisodeRecorder(RecordingPlan(str(tmp_path), 1), simulator, episode).close()
    ((_, started),) = read(tmp_path)
    assert started["instruction"] == episode.instruction
    assert started.get("stages") == said


async def test_equal_actions_give_equal_digests_in_another_part(tmp_path: Path) -> None:
    async with simulator() as handle:
        for _ in range(2):
            await begin(handle, RecordingPlan(str(tmp_path), 1), "score")
            await handle.play([action(score=0.5)], observe_all=False, seq=1)
        assert len(parts_of(tmp_path)) == 2
        digests = [message["state_digest"] for _, message in read(tmp_path)]
        assert digests[:2] == digests[2:]
        await handle.begin(Begin("score", 7, max_steps=3, success_rule="any_step"))
        await handle.play([action(score=0.5)], observe_all=False)
        assert len(read(tmp_path)) == 4


async def test_pictures_are_recorded_when_they_are_wanted(tmp_path: Path) -> None:
    async with simulator() as handle:
        await begin(handle, RecordingPlan(str(tmp_path), 1, pictures=True), "echo")
        await handle.play([action()] * 2, observe_all=True, seq=1)
        topics = [topic for topic, _ in read(tmp_path)]
        assert topics == ["/attempt", *["/camera/pattern"] * 3, "/turn"]
        await handle.observe()  # by a takeover: shown before
        assert len(read(tmp_path)) == len(topics)


@pytest.mark.parametrize("pictures", [False, True])
@pytest.mark.parametrize("observe_all", [False, True])
async def test_a_picture_stands_at_the_step_that_it_shows(
    tmp_path: Path, pictures: bool, observe_all: bool
) -> None:
    """A turn of two steps, and the end of an attempt, which is always recorded."""
    async with simulator() as handle:
        await begin(handle, RecordingPlan(str(tmp_path), 1, pictures=pictures), "echo")
        await handle.play([action()] * 2, observe_all=observe_all, seq=1)
        await handle.record_end()
    target = tmp_path / "whole.mcap"
    join_parts(tmp_path, target, [], [], steps=None)
    with target.open("rb") as file:
        recorded = read_recorded_episode(file, target.stat().st_size, "whole")
    during = [1, 2] if observe_all else [2]
    expected = [0, *during, 2] if pictures else [2]
    assert [picture.step for picture in recorded.pictures] == expected


async def test_a_recording_that_cannot_be_written_is_a_fault(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    async with simulator() as handle:
        plan = RecordingPlan(str(tmp_path / "file" / "parts"), 1)
        with pytest.raises(SimulatorFault, match="recording could not be written: Not"):
            await begin(handle, plan, "score")


@pytest.mark.parametrize("size", [0, 512, 513, 1 << 20])
def test_states_of_any_size_have_their_digest(tmp_path: Path, size: int) -> None:
    """And take little room until the episode ends."""
    simulator = StateOf(bytes(size))
    episode = Episode(simulator, "score", 7, max_steps=3, success_rule="any_step")
    recorder = EpisodeRecorder(RecordingPlan(str(tmp_path), 1), simulator, episode)
    command = msgspec.msgpack.encode(TurnCommand([action()], 1, think_ms=0.0))
    recorder.add_turn(command, list(episode.play([action()])), episode, 0.0)
    recorder.close()
    assert parts_of(tmp_path)[0].stat().st_size < 2_000
    digests = [message["state_digest"] for _, message in read(tmp_path)]
    assert digests == [hashlib.sha256(bytes(size)).hexdigest()[:32]] * 2


def test_an_episode_has_a_bound_of_parts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It may not begin again then; what broke is written all the same."""
    monkeypatch.setattr(recorder_module, "PARTS_MAX", 2)
    plan, simulator = RecordingPlan(str(tmp_path), 1), StateOf(b"")
    episode = Episode(simulator, "score", 7, max_steps=3, success_rule="any_step")
    EpisodeRecorder(plan, simulator, episode).close()
    EpisodeRecorder(plan, simulator, episode).close()
    with pytest.raises(UnwritableRecording, match="begun or broke 2 times"):
        EpisodeRecorder(plan, simulator, episode)
    append_part(tmp_path, "/fault", Fault(1, 0, "simulator_fault", "it broke", "t"))
    assert len(parts_of(tmp_path)) == 3
