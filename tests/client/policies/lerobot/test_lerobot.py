"""The mapping of a LeRobot policy, from its config.json and a benchmark's spaces.

LeRobot is not installed here; lerobot_checks.py plays its policies.
"""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from reference_client import LerobotPolicies, Observation
from reference_client.policies import BadMapping, BadPolicy, PolicyMapping, load
from tests.support.client.command import Proctor
from tests.support.client.direct_client import DirectClient
from tests.support.client.sized_benchmark import benchmark_of
from tests.support.paths import ROOT
from tests.support.servers import ReferenceServer

ROBOT = {"joint_position": 7, "gripper": 1}
SEEN = Observation(
    state={"joint_position": np.arange(7.0), "gripper": np.array([9.0])}
    | {"ee_pose": np.zeros(7)},
    images={"front": np.full((4, 8, 3), 255, np.uint8)},
    tensors={},
    instruction="Lift.",
    episode_id="e0001",
    step=3,
)


def save_config(folder: Path, *, names: str = "", **members: Any) -> Path:
    """A policy's folder without weights. names: of inputs, with their shapes."""
    document: dict[str, Any] = {
        "type": "act",
        "n_obs_steps": 1,
        "chunk_size": 6,
        "n_action_steps": 5,
        "input_features": {
            name: {"type": "STATE", "shape": json.loads(shape)}
            for name, shape in (one.split("=") for one in names.split())
        },
        "output_features": {"action": {"type": "ACTION", "shape": [8]}},
    }
    (folder / "config.json").write_text(json.dumps(document | members))
    for name in ("preprocessor", "postprocessor"):
        (folder / f"policy_{name}.json").write_text("{}")
    return folder


def overrides(text: str, folder: Path) -> PolicyMapping:
    (folder / "m.toml").write_text(text)
    return PolicyMapping.read(folder / "m.toml", is_partial=True)


def test_the_mapping_follows_from_the_configuration(tmp_path: Path) -> None:
    """A state of 8 is what the action is named after; pictures become float32 of
    channels first. Expect a batch of one, and the order of the action space."""
    names = "observation.state=[8] observation.images.front=[3,2,4]"
    config = LerobotPolicies(save_config(tmp_path, names=names)).config
    benchmark = benchmark_of(ROBOT | {"ee_pose": 7}, {"front": 3, "wrist": 3}, ROBOT)
    mapping = config.mapping(benchmark)
    request = mapping.request(SEEN)
    assert request["observation.state"].tolist() == [[0, 1, 2, 3, 4, 5, 6, 9]]
    picture = request["observation.images.front"]
    assert (picture.dtype, picture.max()) == (np.float32, 1)
    assert picture.shape == (1, 3, 2, 4)
    assert request["task"] == ["Lift."]
    (action,) = mapping.chunk(np.arange(8.0), SEEN)
    assert {k: list(v) for k, v in action.items()} == {
        "joint_position": [0, 1, 2, 3, 4, 5, 6],
        "gripper": [7],
    }
    assert config.describe(mapping) == (
        "LeRobot act: observation.state = state.joint_position + state.gripper, "
        "observation.images.front = images.front; action: joint_position = 0:7, "
        "gripper = 7:8"
    )


@pytest.mark.parametrize(
    ("names", "said"),
    [
        ("observation.state=[7]", "more than one choice of the states"),
        ("observation.state=[9]", "no choice of the states"),
        ("observation.images.top=[3,2,4]", "is none of the images"),
        ("observation.images.front=[4,2,4]", "would have 3 channels"),
        ("observation.state=[8] observation.other=[8]", "would both be state.joint"),
    ],
)
def test_what_leaves_a_choice_is_refused(tmp_path: Path, names: str, said: str) -> None:
    config = LerobotPolicies(save_config(tmp_path, names=names)).config
    benchmark = benchmark_of(ROBOT | {"ee_pose": 7}, {"front": 3, "wrist": 3}, ROBOT)
    with pytest.raises(BadMapping, match=said):
        config.mapping(benchmark)


def test_the_only_camera_is_the_only_image(tmp_path: Path) -> None:
    names = "observation.image=[3,2,4] observation.ee_pose=[7]"
    config = LerobotPolicies(save_config(tmp_path, names=names)).config
    benchmark = benchmark_of(ROBOT | {"ee_pose": 7}, {"front": 3}, ROBOT)
    entries = config.mapping(benchmark).entries
    assert entries["observation.image"].source == ("images.front",)
    assert entries["observation.ee_pose"].source == ("state.ee_pose",)


def test_an_action_of_another_size_is_refused(tmp_path: Path) -> None:
    folder = save_config(tmp_path, names="observation.state=[8]")
    config = LerobotPolicies(folder).config
    benchmark = benchmark_of(ROBOT, {}, {"joint_position": 7})
    with pytest.raises(BadMapping, match=r"answers 8 numbers; .* has 7"):
        config.mapping(benchmark)


def test_a_mapping_file_decides(tmp_path: Path) -> None:
    """Only what differs stands in it. Expect the rest from the configuration."""
    names = "observation.state=[7] observation.images.top=[3,2,2]"
    folder = save_config(tmp_path, names=names)
    text = """
    [observation]
    "observation.state" = { from = "state.ee_pose" }
    "observation.images.top" = { from = "images.front", pad = false }
    task = { value = "Lift the cube." }
    [action]
    execute = 3
    [action.values]
    joint_position = { columns = "1:8" }
    gripper = { columns = "0:1", clip = [0, 1] }
    """
    config = LerobotPolicies(folder).config
    benchmark = benchmark_of(ROBOT | {"ee_pose": 7}, {"front": 3, "wrist": 3}, ROBOT)
    mapping = config.mapping(benchmark, overrides(text, folder))
    request = mapping.request(SEEN)
    assert request["observation.state"].shape == (1, 7)
    assert request["observation.images.top"].min() == 1  # stretched: no bars
    assert (mapping.execute, mapping.vectors["gripper"].clip) == (3, (0, 1))


def test_the_documented_mapping_file_fits_its_benchmark(
    direct: DirectClient, tmp_path: Path
) -> None:
    """The policy that the manual names: 7 numbers of state, other names of cameras."""
    page = (ROOT / "docs" / "evaluate" / "policies" / "policies.md").read_text()
    (text,) = re.findall(r"```toml\n(# lerobot\.toml\n.*?)```", page, re.DOTALL)
    names = "observation.state=[7] observation.images.top=[3,96,96]"
    folder = save_config(tmp_path, names=f"{names} observation.images.hand=[3,96,96]")
    config = LerobotPolicies(folder).config
    benchmark = direct.control.get_benchmark("tabletop")
    with pytest.raises(BadMapping, match="mapping file decides"):
        config.mapping(benchmark)
    assert set(config.mapping(benchmark, overrides(text, folder)).entries) == {
        "observation.state",
        "observation.images.top",
        "observation.images.hand",
        "task",
    }


def test_sizes_and_names_of_a_mapping_file_are_checked(tmp_path: Path) -> None:
    folder = save_config(tmp_path, names="observation.state=[7]")
    config = LerobotPolicies(folder).config
    benchmark = benchmark_of(ROBOT | {"ee_pose": 7}, {}, ROBOT)
    only_state = '[observation]\n"observation.state" = { from = "state.gripper" }\n'
    with pytest.raises(BadMapping, match="would have 1 numbers; the policy reads 7"):
        config.mapping(benchmark, overrides(only_state, folder))
    unknown = '[observation]\n"observation.stat" = { from = "state.gripper" }\n'
    with pytest.raises(BadMapping, match=r"does not read observation\.stat; it reads"):
        config.mapping(benchmark, overrides(unknown, folder))


@pytest.mark.parametrize(
    ("members", "actions"),
    [
        ({}, 5),
        ({"n_obs_steps": 2}, 1),
        ({"n_action_steps": 1, "temporal_ensemble_coeff": 0.01}, 1),
    ],
)
def test_how_often_the_policy_looks(
    tmp_path: Path, members: dict[str, Any], actions: int
) -> None:
    """Several observations, or blended chunks: each observation is read."""
    folder = save_config(tmp_path, names="observation.state=[8]", **members)
    assert LerobotPolicies(folder).config.actions_per_look == actions


def test_what_is_no_policy_is_refused(tmp_path: Path) -> None:
    """No folder, other JSON, no processors, an adapter. Expect the cure."""
    with pytest.raises(BadPolicy, match=r"there is no .*config\.json"):
        load(f"lerobot:{tmp_path}")
    (tmp_path / "config.json").write_text("[]")
    with pytest.raises(BadPolicy, match="no configuration of a LeRobot policy"):
        load(f"lerobot:{tmp_path}")
    save_config(tmp_path, use_peft=True)
    with pytest.raises(BadPolicy, match="merge it first"):
        load(f"lerobot:{tmp_path}")
    (tmp_path / "policy_preprocessor.json").unlink()
    with pytest.raises(BadPolicy, match="migrate_policy_normalization"):
        load(f"lerobot:{tmp_path}")


def test_the_command_refuses_before_there_is_a_run(
    server: ReferenceServer, policy_folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A policy of other sizes, one without LeRobot, and processes. Expect no run."""
    proctor = Proctor(server.url, capsys)
    before = proctor.json("status")
    save_config(policy_folder, names="observation.state=[99]")
    run = ["run", "--benchmark", "calibration", "--policy", "lerobot:."]
    assert "has 99 numbers" in proctor.json(*run)["error"]["detail"]
    assert "--processes" in proctor.json(*run, "--processes")["error"]["detail"]
    action = {"action": {"type": "ACTION", "shape": [15]}}
    save_config(policy_folder, names="observation.state=[8]", output_features=action)
    assert "make lerobot" in proctor.json(*run)["error"]["detail"]
    assert proctor.code == 2
    assert proctor.json("status") == before
