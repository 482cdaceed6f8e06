"""The way of examples/trained_policy/README.md, in small: `make lerobot-check`.

Demonstrations of an expert, a few steps of training by our loop and by LeRobot's own
program, and both policies played by the command.
"""

import subprocess
import sys
from pathlib import Path

import pytest
from lerobot.datasets.lerobot_dataset import LeRobotDataset

from tests.support.client.command import Proctor
from tests.support.paths import ROOT
from tests.support.servers import TOKENS, ReferenceServer

EXAMPLE = ROOT / "examples" / "trained_policy"
LEROBOT_TRAIN = Path(sys.executable).with_name("lerobot-train")
TASKS = ("reach", "press_button")
EPISODES = 2


@pytest.fixture(scope="module")
def demonstrations(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("data") / "demonstrations"
    options = ["--tasks", ",".join(TASKS), "--episodes", str(EPISODES)]
    _run(sys.executable, EXAMPLE / "demonstrations.py", folder, *options)
    return folder


def _run(*command: object) -> None:
    subprocess.run([str(part) for part in command], check=True, cwd=ROOT)


def test_demonstrations_are_a_data_set(demonstrations: Path) -> None:
    """Expect the episodes, at the benchmark's rate, and instructions as tasks."""
    dataset = LeRobotDataset("proctor/demonstrations", root=demonstrations)
    assert (dataset.num_episodes, dataset.fps) == (len(TASKS) * EPISODES, 20)
    frame = dataset[0]
    assert frame["task"] == "Move the gripper to the green ball."
    assert len(frame["observation.state"]) == len(frame["action"]) == 8
    # The expert commands at most a stride from where the arm is.
    stride = frame["action"][:7] - frame["observation.state"][:7]
    assert 0 < stride.abs().max() < 0.3


def test_our_training_makes_a_policy_that_the_command_evaluates(
    demonstrations: Path,
    server: ReferenceServer,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    folder = tmp_path / "act"
    _run(sys.executable, EXAMPLE / "train.py", demonstrations, folder, "--steps", 20)
    _evaluate(folder, server, monkeypatch, capsys)


def test_lerobots_own_program_trains_from_them(
    demonstrations: Path,
    server: ReferenceServer,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    output = tmp_path / "lerobot-train"
    _run(
        LEROBOT_TRAIN,
        "--dataset.repo_id=proctor/demonstrations",
        f"--dataset.root={demonstrations}",
        "--policy.type=act",
        "--policy.device=cpu",
        "--policy.push_to_hub=false",
        "--policy.dim_model=32",
        "--policy.n_heads=2",
        "--policy.dim_feedforward=32",
        f"--output_dir={output}",
        "--steps=2",
        "--num_workers=0",
    )
    folder = output / "checkpoints" / "last" / "pretrained_model"
    _evaluate(folder, server, monkeypatch, capsys)


def _evaluate(
    folder: Path,
    server: ReferenceServer,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The first episode of the benchmark. Expect that all states were mapped."""
    monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["alice"])
    proctor = Proctor(server.url, capsys)
    run = ["run", "--policy", f"lerobot:{folder}", "--benchmark", "tabletop_state"]
    score = proctor.json(*run, "--episodes", "1")
    assert (proctor.code, score["counts"]["unscored"]) == (0, 63)
    assert "observation.environment_state = state.joint_position" in proctor.err
