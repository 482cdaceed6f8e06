"""EBench's actions and observations, converted: order, units, relative actions."""

from __future__ import annotations

import math
from base64 import b64decode, b64encode
from collections.abc import Mapping, Sequence
from copy import deepcopy
from typing import Any

import numpy as np
import pytest

from reference_server.profiles.ebench.message_conversion import (
    observation_view,
    read_actions,
)
from reference_server.profiles.ebench.task_requests import Chunk
from reference_server.rules.refusal import Refused
from reference_sim import benchmark_registry
from reference_sim.benchmarks.mobile_bimanual.benchmark import BENCHMARKS

Json = dict[str, Any]
JOINTS = benchmark_registry.resolve("mobile_bimanual", None, None, max_chunk=8).manifest
POSES = benchmark_registry.resolve(
    "mobile_bimanual_ee", None, None, max_chunk=8
).manifest
SIXTEEN = [float(n) for n in range(16)]
HALF_TURN = [0.0, 0.0, 0.0, 1.0]  # about z


def convert_actions(
    *chunk: Json,
    manifest: Json = JOINTS,
    last: Mapping[str, Sequence[float]] | None = None,
) -> list[dict[str, list[float]]]:
    def before() -> Mapping[str, Sequence[float]]:
        assert last is not None, "nothing here is relative"
        return last

    at = [f"/{number}/0" for number in range(len(chunk))]
    return read_actions(chunk, manifest, before, at)


def refused_pointer(*chunk: Any, manifest: Json = JOINTS) -> str:
    """Where a chunk is wrong."""
    with pytest.raises(Refused) as caught:
        convert_actions(*chunk, manifest=manifest)
    assert caught.value.code == "invalid_request"
    [(pointer, detail)] = caught.value.errors
    assert detail
    return pointer


def hand(pose: Sequence[float], fingers: Sequence[float]) -> list[Any]:
    return [list(pose[:3]), np.array(pose[3:]), list(fingers)]


@pytest.mark.parametrize(
    "numbers",
    [
        SIXTEEN,
        np.array(SIXTEEN),
        np.array(SIXTEEN, dtype=np.float32),
        np.arange(16),
        np.arange(16.0).reshape(2, 8),
        [SIXTEEN[:8], np.array(SIXTEEN[8:])],
    ],
)
def test_sixteen_numbers_are_two_arms(numbers: Any) -> None:
    [action] = convert_actions({"action": numbers})
    assert action == {
        "joint_position": [0, 1, 2, 3, 4, 5, 8, 9, 10, 11, 12, 13],
        "gripper": [6, 7, 14, 15],
        "base_motion": [0, 0, 0],
    }


def test_the_base_turns_in_degrees() -> None:
    [action] = convert_actions(
        {"action": SIXTEEN, "base_motion": np.array([0.1, -0.2, 90.0])}
    )
    assert action["base_motion"] == [0.1, -0.2, math.pi / 2]


def test_relative_arms_add_to_what_was_commanded_last() -> None:
    step = {"action": [0.5] * 16, "is_rel": True}
    absolute = {"action": SIXTEEN, "is_rel": False}
    chunk = convert_actions(
        step, step, absolute, step, last={"joint_position": [1.0] * 12}
    )
    joints = [action["joint_position"] for action in chunk]
    assert joints[:2] == [[1.5] * 12, [2.0] * 12]
    assert joints[3] == [joint + 0.5 for joint in joints[2]]
    # Grippers have no relative form.
    assert chunk[1]["gripper"] == [0.5] * 4


def test_poses_are_given_hand_by_hand() -> None:
    left, right = [1.0, 2.0, 3.0, *HALF_TURN], [4.0, 5.0, 6.0, 1.0, 0.0, 0.0, 0.0]
    body = {
        "action": [hand(left, (0.01, 0.02)), hand(right, (0.03, 0.04))],
        "control_type": "ee_pose",
    }
    [action] = convert_actions(body, manifest=POSES)
    assert action == {
        "left_ee_pose": left,
        "right_ee_pose": right,
        "gripper": [0.01, 0.02, 0.03, 0.04],
        "base_motion": [0, 0, 0],
    }


def test_relative_poses_move_the_pose_before() -> None:
    """Turned about the origin of the frame, then shifted."""
    delta = [0.0, 0.0, 0.5, *HALF_TURN]
    body = {"action": [hand(delta, (0, 0))] * 2, "is_rel": True}
    pose = [1.0, 2.0, 3.0, 1.0, 0.0, 0.0, 0.0]
    last = {"left_ee_pose": pose, "right_ee_pose": pose}
    first, second = convert_actions(body, body, manifest=POSES, last=last)
    assert first["left_ee_pose"] == pytest.approx([-1, -2, 3.5, *HALF_TURN])
    assert second["right_ee_pose"] == pytest.approx([1, 2, 4, -1, 0, 0, 0])


def test_an_invalid_rotation_becomes_nan() -> None:
    body = {"action": [hand([0.0] * 7, (0, 0))] * 2, "is_rel": True}
    pose = [0.0] * 7
    last = {"left_ee_pose": pose, "right_ee_pose": pose}
    [action] = convert_actions(body, manifest=POSES, last=last)
    assert all(map(math.isnan, action["left_ee_pose"]))


@pytest.mark.parametrize(
    ("body", "at"),
    [
        (SIXTEEN, ""),
        ({}, ""),
        ({"action": SIXTEEN[:9]}, "/action"),
        ({"action": np.zeros(17)}, "/action"),
        ({"action": np.zeros(5000)}, "/action"),
        ({"action": [None] * 16}, "/action"),
        ({"action": "0" * 16}, "/action"),
        ({"action": np.zeros(16, dtype=bool)}, "/action"),
        ({"action": SIXTEEN, "base_motion": [0, 0]}, "/base_motion"),
        ({"action": SIXTEEN, "base_motion": None}, "/base_motion"),
        ({"action": SIXTEEN, "control_type": "ee_pose"}, "/control_type"),
        ({"action": SIXTEEN, "control_type": np.zeros(3)}, "/control_type"),
        ({"action": SIXTEEN, "control_type": {}}, "/control_type"),
        ({"action": SIXTEEN, "base_is_rel": False}, "/base_is_rel"),
        ({"action": SIXTEEN, "base_is_rel": np.ones(3)}, "/base_is_rel"),
        ({"action": SIXTEEN, "base_is_rel": "yes"}, "/base_is_rel"),
        ({"action": SIXTEEN, "is_rel": np.zeros(3, dtype=bool)}, "/is_rel"),
        ({"action": SIXTEEN, "is_rel": np.zeros(0)}, "/is_rel"),
        ({"action": SIXTEEN, "is_rel": "no"}, "/is_rel"),
        ({"action": SIXTEEN, "is_rel": None}, "/is_rel"),
    ],
)
def test_an_invalid_action_is_refused_with_its_pointer(body: Any, at: str) -> None:
    good = {"action": SIXTEEN}
    assert refused_pointer(good, body) == f"/1/0{at}"


@pytest.mark.parametrize(
    ("value", "at"),
    [(SIXTEEN, ""), ([[0.0] * 9], ""), ([[0.0] * 9, [0.0] * 8], "/1"), (None, "")],
)
def test_an_invalid_pose_is_refused_with_its_pointer(value: Any, at: str) -> None:
    assert refused_pointer({"action": value}, manifest=POSES) == f"/0/0/action{at}"


# Whatever can be unpickled, in every place; no warning of numpy's either.
NUMBERS: list[Any] = [0, 1, -1, 2**64 - 1, 0.5, math.nan, -math.inf, 1e308, 5e-324]
PLAIN: list[Any] = [*NUMBERS, None, True, False, "", "ee_pose", "joint_position"]
PLAIN += [np.array(one) for one in (*NUMBERS, True, [], [[]], [True, False])]
PLAIN += [np.full(shape, 0.1) for shape in ((3,), (16,), (2, 9), (5000,))]
PLAIN += [
    [],
    [[]],
    [None],
    [{}],
    {},
    {"action": 1},
    {0: None},
    [[1.0], "x"],
    [[[]]] * 2,
]
PLAIN += [[one] * size for one in NUMBERS for size in (3, 16)]
PLAIN += [[[one] * 9] * 2 for one in NUMBERS]
MEMBERS = ["action", "base_motion", "control_type", "base_is_rel", "is_rel", "other", 7]
GOOD: dict[str, tuple[Json, Json]] = {
    "joints": (JOINTS, {"action": SIXTEEN}),
    "poses": (POSES, {"action": [hand([0.1] * 7, (0, 0))] * 2}),
}


@pytest.mark.parametrize("member", MEMBERS)
@pytest.mark.parametrize("robot", sorted(GOOD))
def test_every_value_is_converted_or_refused(robot: str, member: Any) -> None:
    manifest, good = GOOD[robot]
    vectors = {**POSES["observation_space"]["state"], **JOINTS["action_space"]}
    last = {name: [0.5] * entry["size"] for name, entry in vectors.items()}
    for value in PLAIN:
        for relative in (False, True):
            action = good | {"is_rel": relative, member: value}
            assert Chunk.of([action], ["/0"]).digest
            try:
                [found] = convert_actions(action, manifest=manifest, last=last)
            except Refused as error:
                [(pointer, _)] = error.errors
                if not pointer.startswith(f"/0/0/{member}"):
                    pytest.fail(f"{value!r} in {member}: {pointer} is refused")
            else:
                sizes = {name: len(numbers) for name, numbers in found.items()}
                spaces = manifest["action_space"].items()
                assert sizes == {name: space["size"] for name, space in spaces}


def test_other_benchmarks_take_plain_vectors() -> None:
    manifest = {"action_space": {"b": {"size": 2}, "a": {"size": 1}}}
    assert convert_actions({"action": [1, 2, 3]}, manifest=manifest) == [
        {"a": [1], "b": [2, 3]}
    ]
    assert refused_pointer({"action": [1, 2]}, manifest=manifest) == "/0/0/action"


# --- observations ---

EPISODE = {"instruction": "Go.", "step": 0, "task": "fetch", "episode_id": "e0007"}


def convert_observation(**parts: Any) -> Any:
    empty: Json = {"state": {}, "images": {}, "tensors": {}}
    turn = {"episode": EPISODE, "observation": empty | parts}
    return observation_view(turn, "run_1", "bench")


def values(array: Json) -> list[Any]:
    flat = np.frombuffer(b64decode(array["data"]), array["dtype"])
    return list(flat.reshape(array["shape"]).tolist())


def test_an_observation_states_episode_and_step() -> None:
    assert convert_observation() == {
        "instruction": "Go.",
        "timestep": 0,
        "reset": True,
        "episode_id": "bench/run_1/fetch/e0007",
        "robot_id": "bench",
    }


def test_the_robot_state_uses_the_names_of_ebench() -> None:
    spaces = JOINTS["observation_space"]
    state = {
        name: [index + k / 8 for k in range(space["size"])]
        for index, (name, space) in enumerate(spaces["state"].items())
    }
    found = convert_observation(state=state)
    assert found["robot_id"] == "manip/lift2/R5a"
    assert values(found["state.joints"]) == state["joint_position"]
    assert values(found["state.gripper"]) == state["gripper"]
    assert values(found["state.base"]) == state["base_pose"]
    hands = [[values(part) for part in hand] for hand in found["state.ee_pose"]]
    assert hands == [
        [state[name][:3], state[name][3:]] for name in ("left_ee_pose", "right_ee_pose")
    ]
    assert not [name for name in found if "pose" in name and name != "state.ee_pose"]


def test_every_camera_has_a_view() -> None:
    image = {"codec": "raw", "width": 2, "height": 1, "channels": 3, "data": b"abcdef"}
    cameras = JOINTS["observation_space"]["images"]
    found = convert_observation(images=dict.fromkeys(cameras, image))
    views = {name for name in found if name.startswith("video.")}
    assert views == {
        f"video.{view}_camera_view" for view in ("top", "left", "right", "overlook")
    }
    assert values(found["video.top_camera_view"]) == [[[97, 98, 99], [100, 101, 102]]]


def test_encoded_images_and_tensors_are_typed() -> None:
    image = {"codec": "png", "width": 2, "height": 1, "channels": 3, "data": b"png"}
    grey = image | {"channels": 1}
    tensor = {"dtype": "int16", "shape": [2], "data": b"\x01\x00\x02\x00"}
    found = convert_observation(images={"a": image, "b": grey}, tensors={"t": tensor})
    typed = {"type": "image", "data": b64encode(b"png")}
    assert found["video.a_view"] == typed | {"mode": "RGB"}
    assert found["video.b_view"] == typed | {"mode": "L"}
    assert values(found["tensor.t"]) == [1, 2]


def test_the_robot_of_every_track_is_known() -> None:
    for benchmark_id in BENCHMARKS:
        manifest = benchmark_registry.resolve(
            benchmark_id, None, None, max_chunk=8
        ).manifest
        poses = "ee" in benchmark_id
        good = {"action": [hand([0.0] * 7, (0, 0))] * 2 if poses else SIXTEEN}
        [action] = convert_actions(good, manifest=manifest)
        assert set(action) == set(manifest["action_space"])


@pytest.mark.parametrize(
    ("vector", "part", "member", "value"),
    [
        ("joint_position", "left_arm", "unit", "deg"),
        ("gripper", "left", "gripper_closed", 0.01),
        ("base_motion", "yaw", "unit", "deg"),
        ("base_motion", "position", "relative_to", "measured"),
    ],
)
def test_a_benchmark_of_other_conventions_is_another_robot(
    vector: str, part: str, member: str, value: Any
) -> None:
    """Its vectors are sent one after another, and are not converted."""
    other = deepcopy(JOINTS)
    other["action_space"][vector]["parts"][part][member] = value
    body = {"action": [0.0] * 16, "base_motion": [0.0, 0.0, 90.0]}
    assert convert_actions(body)[0]["base_motion"][2] == pytest.approx(math.pi / 2)
    assert refused_pointer(body, manifest=other) == "/0/0/action"
    (values,) = convert_actions({"action": [90.0] * 19}, manifest=other)
    assert values["base_motion"] == [90.0] * 3
