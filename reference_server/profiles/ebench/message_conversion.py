"""Converts EBench's actions into ours, and our observations into EBench's.

EBench's robot lift2 is that of our mobile bimanual benchmarks: the same numbers in
another order, with the rotation of the base in degrees. For any other benchmark
`action` holds the vectors of the action space one after another, sorted by name. Pure:
must not know runs or requests, only messages and manifests.
"""

from __future__ import annotations

import math
from base64 import b64encode
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Literal, TypeAlias, TypedDict

import numpy as np

from reference_record.contents.contradicted_assumptions import contradictions
from reference_record.generated.answers import EpisodeResult, Image
from reference_server.rules.refusal import Refused
from reference_server.rules.runs import action_space

Values: TypeAlias = dict[str, list[float]]
ReadLastCommand: TypeAlias = Callable[[], Mapping[str, Sequence[float]]]


class EncodedArray(TypedDict):
    """An array as EBench's client reads it. data: Base64."""

    type: Literal["numpy_array"]
    data: bytes
    dtype: str
    shape: list[int]


class EncodedPicture(TypedDict):
    """A picture in its codec. data: Base64."""

    type: Literal["image"]
    data: bytes
    mode: str


class EndedEpisode(TypedDict):
    """EBench's `episode_result`. sr: the success rate."""

    episode_id: str
    task_name: str
    seed: int
    score: float
    sr: float


NUMBERS_MAX = 4096  # in one action; no robot has more
LIFT2 = "manip/lift2/R5a"  # as EBench's client finds it in its table of robots
_HANDS = ("left_ee_pose", "right_ee_pose")
_ABSOLUTE_POSE = {
    "size": 7,
    "frame": "base",
    "relative_to": "none",
    "parts": {
        "position": {"start": 0, "size": 3, "unit": "m"},
        "orientation": {"start": 3, "size": 4, "rotation": "quaternion_wxyz"},
    },
}
_BOTH_MODES = {
    "gripper": {"size": 4, "quantity": "gripper", "unit": "m", "gripper_closed": 0.0},
    "base_motion": {
        "size": 3,
        "frame": "base",
        "relative_to": "commanded",
        "parts": {
            "position": {"start": 0, "size": 2, "unit": "m"},
            "yaw": {"start": 2, "size": 1, "unit": "rad", "rotation": "yaw"},
        },
    },
}
# The conventions for which actions of lift2 are converted (schema Assumptions).
_JOINTS = _BOTH_MODES | {
    "joint_position": {"size": 12, "unit": "rad", "relative_to": "none"}
}
_POSES = _BOTH_MODES | dict.fromkeys(_HANDS, _ABSOLUTE_POSE)
_SEALED_SEED = -1  # a number, as EBench's client wants; no episode has it
_STATES = {"joint_position": "joints", "gripper": "gripper", "base_pose": "base"}
_CAMERAS = {
    "head": "top_camera",
    "front": "overlook_camera",
    "left_wrist": "left_camera",
    "right_wrist": "right_camera",
}


# --- actions ---


def read_actions(
    chunk: Sequence[Any],
    manifest: Mapping[str, Any],
    last: ReadLastCommand,
    at: Sequence[str],
) -> list[Values]:
    """A worker's actions in the names of its benchmark's action space.

    last: returns the last command, or the initial state of the episode, by the same
    names; called only for relative actions. at: JSON pointers to the actions. Raises
    Refused.
    """
    sizes = {name: entry["size"] for name, entry in manifest["action_space"].items()}
    is_joints, is_poses = _is_lift2(manifest, _JOINTS), _is_lift2(manifest, _POSES)
    made: list[Values] = []
    for action, pointer in zip(chunk, at, strict=True):
        if not isinstance(action, dict) or "action" not in action:
            raise _invalid_action(pointer, "must be a dict with a member `action`")
        before = _previous_command(made, last)
        if is_joints or is_poses:
            made.append(_lift2_action(action, is_poses, before, pointer))
        else:
            made.append(_plain_action(action, sizes, pointer))
    return made


def _is_lift2(manifest: Mapping[str, Any], assumed: Mapping[str, Any]) -> bool:
    """Whether these vectors, of these conventions, are the action space."""
    return manifest["action_space"].keys() == assumed.keys() and not any(
        contradictions({"action": assumed}, manifest)
    )


def check_length(chunk: Sequence[Any], max_chunk: int, at: Sequence[str]) -> None:
    """Refuse a chunk that is too long, before it is converted (EBE-028)."""
    if len(chunk) > max_chunk:
        raise _invalid_action(at[0], f"a chunk holds at most {max_chunk} actions")


def whole_chunk_errors(
    actions: Sequence[action_space.Values], manifest: Mapping[str, Any]
) -> action_space.SpaceErrors:
    """The errors in the actions of a chunk that is played in several turns."""
    return action_space.action_errors(actions, {**manifest, "max_chunk": len(actions)})


def _previous_command(made: list[Values], last: ReadLastCommand) -> ReadLastCommand:
    """The base of a relative action: the action before it, also one of this chunk."""
    return (lambda: made[-1]) if made else last


def _lift2_action(
    action: Mapping[str, Any], poses: bool, last: ReadLastCommand, at: str
) -> Values:
    wanted = "ee_pose" if poses else "joint_position"
    control = action.get("control_type", wanted)
    if type(control) is not str or control != wanted:
        raise _invalid_action(
            f"{at}/control_type",
            f"must be {wanted} on this benchmark; the other control type has its own "
            "benchmark_set (mobile_bimanual, mobile_bimanual_ee)",
        )
    if not _read_flag(action, "base_is_rel", True, at):
        raise _invalid_action(
            f"{at}/base_is_rel", "must be true: only relative base motion is supported"
        )
    base = _numbers(action.get("base_motion", [0.0, 0.0, 0.0]), f"{at}/base_motion", 3)
    made: Values = {"base_motion": [base[0], base[1], math.radians(base[2])]}
    relative = _read_flag(action, "is_rel", False, at)
    if not poses:
        n = _numbers(action["action"], f"{at}/action", 16)
        joints, fingers = n[0:6] + n[8:14], n[6:8] + n[14:16]
        if relative:  # the arms; grippers are always absolute
            joints = _sum(joints, last()["joint_position"])
        return made | {"joint_position": joints, "gripper": fingers}
    hands = action["action"]
    if not isinstance(hands, list) or len(hands) != 2:
        raise _invalid_action(
            f"{at}/action", "must be (position, quaternion, gripper) of each hand"
        )
    made["gripper"] = []
    for index, (name, hand) in enumerate(zip(_HANDS, hands, strict=True)):
        n = _numbers(hand, f"{at}/action/{index}", 9)
        made[name] = _compose_pose(n[:7], last()[name]) if relative else n[:7]
        made["gripper"] += n[7:]
    return made


def _read_flag(action: Mapping[str, Any], name: str, absent: bool, at: str) -> bool:
    flag = action.get(name, absent)
    if type(flag) not in (bool, int):
        raise _invalid_action(f"{at}/{name}", "must be a boolean")
    return bool(flag)


def _plain_action(
    action: Mapping[str, Any], sizes: Mapping[str, int], at: str
) -> Values:
    left = iter(_numbers(action["action"], f"{at}/action", sum(sizes.values())))
    return {name: [next(left) for _ in range(sizes[name])] for name in sorted(sizes)}


def _numbers(value: Any, at: str, size: int) -> list[float]:
    """EBE-011: a flat vector, from numbers, lists and arrays nested in any way."""
    numbers = [float(number) for number in _flat(value, at)]
    if len(numbers) != size:
        raise _invalid_action(at, f"has {len(numbers)} numbers, must have {size}")
    return numbers


def _flat(value: Any, at: str) -> Iterable[float]:
    if isinstance(value, list):
        for item in value:
            yield from _flat(item, at)
    elif isinstance(value, np.ndarray) and value.dtype.kind in "iuf":
        if value.size > NUMBERS_MAX:
            raise _invalid_action(
                at, f"has {value.size} numbers, must have at most {NUMBERS_MAX}"
            )
        yield from value.ravel().tolist()
    elif type(value) in (int, float):
        yield value
    else:
        raise _invalid_action(at, "must contain numbers only")


def _sum(left: Sequence[float], right: Sequence[float]) -> list[float]:
    return [a + b for a, b in zip(left, right, strict=True)]


def _compose_pose(delta: Sequence[float], pose: Sequence[float]) -> list[float]:
    """A pose (position, quaternion wxyz) after a motion `delta` in the same frame."""
    dw, (dx, dy, dz) = delta[3], delta[4:7]
    w, (x, y, z) = pose[3], pose[4:7]
    turned = [
        dw * w - dx * x - dy * y - dz * z,
        dw * x + dx * w + dy * z - dz * y,
        dw * y - dx * z + dy * w + dz * x,
        dw * z + dx * y - dy * x + dz * w,
    ]
    axis, point = np.array([dx, dy, dz]), np.array(pose[:3])
    norm = dw * dw + dx * dx + dy * dy + dz * dz
    if norm == 0:
        return [math.nan] * 7  # no rotation: refused by the rules as not finite
    with np.errstate(all="ignore"):  # overflow is refused by the rules as not finite
        twice = 2 / norm * np.cross(axis, np.cross(axis, point) + dw * point)
    return [*(point + twice + np.array(delta[:3])).tolist(), *turned]


def _invalid_action(at: str, text: str) -> Refused:
    return Refused(
        "invalid_request",
        "The actions do not fit this benchmark; none was executed.",
        errors=[(at, text)],
    )


# --- observations ---


def observation_view(turn: Mapping[str, Any], run_id: str, benchmark_id: str) -> Any:
    """EBench's `obs`, of a turn that has an observation."""
    episode, observation = turn["episode"], turn["observation"]
    state = dict(observation["state"])
    is_lift2 = {*_STATES, *_HANDS} <= set(state)
    message: dict[str, object] = {
        "instruction": episode["instruction"],
        "timestep": episode["step"],
        "reset": episode["step"] == 0,
        "episode_id": _episode_id(episode, run_id, benchmark_id),
        "robot_id": LIFT2 if is_lift2 else benchmark_id,
    }
    if is_lift2:
        hands = [state.pop(hand) for hand in _HANDS]
        message["state.ee_pose"] = [[_vector(h[:3]), _vector(h[3:])] for h in hands]
        state = {_STATES.get(name, name): vector for name, vector in state.items()}
    message |= {f"state.{name}": _vector(vector) for name, vector in state.items()}
    for name, image in observation["images"].items():
        message[f"video.{_CAMERAS.get(name, name)}_view"] = _image(image)
    for name, tensor in observation["tensors"].items():
        message[f"tensor.{name}"] = _array(
            tensor["dtype"], tensor["shape"], tensor["data"]
        )
    return message


def episode_result_view(
    result: EpisodeResult, run_id: str, benchmark_id: str, *, current: bool
) -> EndedEpisode:
    """EBench's `episode_result`; current: for the current client (EBE-026)."""
    return {
        "episode_id": _episode_id(result, run_id, benchmark_id),
        "task_name": result["task"],
        "seed": result.get("seed", _SEALED_SEED),
        "score": result["score"],
        "sr": success_rate(result["score"]) if current else result["score"],
    }


def success_rate(score: float) -> float:
    """EBE-025, EBE-026: a success is a full score."""
    return 1.0 if score >= 1.0 else 0.0


def _episode_id(episode: Mapping[str, Any], run_id: str, benchmark_id: str) -> str:
    """A path: EBench's client has a folder for each episode."""
    return f"{benchmark_id}/{run_id}/{episode['task']}/{episode['episode_id']}"


def _vector(numbers: Sequence[float]) -> EncodedArray:
    data = np.asarray(numbers, dtype="<f8").tobytes()
    return _array("float64", [len(numbers)], data)


def _image(image: Image) -> EncodedArray | EncodedPicture:
    if image["codec"] != "raw":
        mode = "RGB" if image["channels"] == 3 else "L"
        return {"type": "image", "data": b64encode(image["data"]), "mode": mode}
    shape = [image["height"], image["width"], image["channels"]]
    return _array("uint8", shape, image["data"])


def _array(dtype: str, shape: Sequence[int], data: bytes) -> EncodedArray:
    return {
        "type": "numpy_array",
        "data": b64encode(data),  # bytes are written as text
        "dtype": dtype,
        "shape": list(shape),
    }
