"""A run as a LeRobotDataset, loaded by LeRobot itself: `make lerobot-check`."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
import torch
from lerobot.datasets.lerobot_dataset import LeRobotDataset

from reference_sim import benchmark_registry
from reference_sim.episode import Episode
from reference_sim.exports.__main__ import main
from reference_sim.interface import Simulator
from tests.support.record.played_records import Chunk, save_played_record
from tests.support.sim.echo_records import save_echo
from tools import experts

# LeRobot warns of the reader of videos that it takes where torchcodec is missing.
pytestmark = pytest.mark.filterwarnings("ignore")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("HF_HUB_OFFLINE", "1")
    (tmp_path / "recordings").mkdir()
    return tmp_path


def export(record: Path, **more: object) -> Path:
    target = record.parent / "set"
    job = {"kind": "lerobot", "record": str(record), "output": str(target)}
    assert main([json.dumps(job | more)]) == 0
    return target


def test_every_frame_is_read(folder: Path) -> None:
    """States, actions, pictures, times and the instruction, also in batches."""
    loaded = LeRobotDataset("a/run", root=export(save_echo(folder), episodes=[0, 1]))
    assert (loaded.num_episodes, len(loaded), loaded.fps) == (2, 90, 10)
    counts = loaded.features["observation.state"]["names"].index("count")
    for number in range(len(loaded)):
        frame = loaded[number]
        assert frame["observation.state"][counts] == number % 45
        assert frame["observation.images.pattern"].shape == (3, 12, 16)
        assert frame["task"] == "Calibration task echo."
    batch = next(iter(torch.utils.data.DataLoader(loaded, batch_size=8)))
    assert batch["action"].shape[0] == 8


def test_an_expert_s_episodes_are_read(folder: Path) -> None:
    """Two episodes of tabletop in two cameras; neighbours of a frame by their times."""
    found = benchmark_registry.resolve("tabletop")

    def play(episode: Episode, simulator: Simulator) -> Iterator[Chunk]:
        policy = experts.expert("tabletop")
        policy.reset(episode.instruction)
        while not episode.ended and not episode.success:
            state = simulator.observe().state
            action = policy.act({name: v.tolist() for name, v in state.items()})
            yield [{name: [*map(float, values)] for name, values in action.items()}]

    record = folder / "run-1.proctor"
    save_played_record(record, folder / "recordings", found, play, only={0, 1})
    target = export(record)
    times = {"action": [0.0, 0.05], "observation.images.wrist": [-0.05, 0.0]}
    loaded = LeRobotDataset("a/run", root=target, episodes=[1], delta_timestamps=times)
    frame = loaded[5]
    assert frame["episode_index"] == 1
    assert frame["action"].shape == (2, 8)
    assert frame["observation.images.wrist"].shape == (2, 3, 128, 128)
    assert bool(loaded[len(loaded) - 1]["next.success"])
    simulator = benchmark_registry.make(found.world)
    plan = found.episodes[1]
    simulator.reset(plan.task, plan.seed, plan.split)
    seen = simulator.observe().images["front"].transpose(2, 0, 1) / 255
    shown = loaded[0]["observation.images.front"].numpy()
    assert abs(shown - seen).mean() < 0.03
