"""EBench's observations and actions, made of ours and back.

Its robot lift2 is that of our mobile bimanual benchmarks: the numbers are the same in
another order, and the base turns in degrees. Any other benchmark is spoken to plainly:
`action` holds the vectors of its action space one after another, by name. Pure: knows
messages and manifests, and neither runs nor requests.
"""

from __future__ import annotations

import math
from base64 import b64encode
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np

from reference_server.rules import action_space
from reference_server.rules.refusal import Refused

Values: TypeAlias = dict[str, list[float]]
ReadLastCommand: TypeAlias = Callable[[], Mapping[str, Sequence[float]]]

NUMBERS_MAX = 4096  # in one action; more fit no robot
LIFT2 = "lift2"
_JOINTS = {"joint_position": 12, "gripper": 4, "base_motion": 3}
_POSES = {"left_ee_pose": 7, "right_ee_pose": 7, "gripper": 4, "base_motion": 3}
_HANDS = ("left_ee_pose", "right_ee_pose")
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

    last: gives what was commanded last, or what is measured at an episode's start, by
    the same names; asked only for relative actions. at: JSON pointers to the actions.
    """
    sizes = {name: entry["size"] for name, entry in manifest["action_space"].items()}
    made: list[Values] = []
    for action, pointer in zip(chunk, at, strict=True):
        if not isinstance(action, dict) or "action" not in action:
            raise _invalid_action(pointer, "an action is a dict with a member `action`")
        before = _previous_command(made, last)
        if sizes in (_JOINTS, _POSES):
            made.append(_lift2_action(action, sizes == _POSES, before, pointer))
        else:
            made.append(_plain_action(action, sizes, pointer))
    return made


def check_length(
    chunk: Sequence[Any], manifest: Mapping[str, Any], at: Sequence[str]
) -> None:
    """Refuses a chunk that is too long before work goes into it."""
    if len(chunk) > manifest["max_chunk"]:
        [(_, text)] = action_space.action_errors(chunk, manifest)
        raise _invalid_action(at[0], text)


def _previous_command(made: list[Values], last: ReadLastCommand) -> ReadLastCommand:
    """Relative to the action before, which may stand in the same chunk."""
    return (lambda: made[-1]) if made else last


def _lift2_action(
    action: dict[str, Any], poses: bool, last: ReadLastCommand, at: str
) -> Values:
    wanted = "ee_pose" if poses else "joint_position"
    control = action.get("control_type", wanted)
    if type(control) is not str or control != wanted:
        raise _invalid_action(
            f"{at}/control_type",
            f"is {wanted} on this benchmark; the other one is a benchmark_set of its "
            "own (mobile_bimanual, mobile_bimanual_ee)",
        )
    if not _read_flag(action, "base_is_rel", True, at):
        raise _invalid_action(
            f"{at}/base_is_rel", "only steps of the base are executed here"
        )
    base = _numbers(action.get("base_motion", [0.0, 0.0, 0.0]), f"{at}/base_motion", 3)
    made: Values = {"base_motion": [base[0], base[1], math.radians(base[2])]}
    relative = _read_flag(action, "is_rel", False, at)
    if not poses:
        n = _numbers(action["action"], f"{at}/action", 16)
        joints, fingers = n[0:6] + n[8:14], n[6:8] + n[14:16]
        if relative:  # its arms; grippers are absolute
            joints = _sum(joints, last()["joint_position"])
        return made | {"joint_position": joints, "gripper": fingers}
    hands = action["action"]
    if not isinstance(hands, list) or len(hands) != 2:
        raise _invalid_action(
            f"{at}/action", "is (position, quaternion, gripper) of each hand"
        )
    made["gripper"] = []
    for index, (name, hand) in enumerate(zip(_HANDS, hands, strict=True)):
        n = _numbers(hand, f"{at}/action/{index}", 9)
        made[name] = _compose_pose(n[:7], last()[name]) if relative else n[:7]
        made["gripper"] += n[7:]
    return made


def _read_flag(action: dict[str, Any], name: str, absent: bool, at: str) -> bool:
    flag = action.get(name, absent)
    if type(flag) not in (bool, int):
        raise _invalid_action(f"{at}/{name}", "is a boolean")
    return bool(flag)


def _plain_action(action: dict[str, Any], sizes: Mapping[str, int], at: str) -> Values:
    left = iter(_numbers(action["action"], f"{at}/action", sum(sizes.values())))
    return {name: [next(left) for _ in range(sizes[name])] for name in sorted(sizes)}


def _numbers(value: Any, at: str, size: int) -> list[float]:
    """A vector, flat, however its numbers are put together."""
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
            raise _invalid_action(at, f"has {value.size} numbers")
        yield from value.ravel().tolist()
    elif type(value) in (int, float):
        yield value
    else:
        raise _invalid_action(at, "is made of numbers")


def _sum(one: Sequence[float], other: Sequence[float]) -> list[float]:
    return [a + b for a, b in zip(one, other, strict=True)]


def _compose_pose(delta: Sequence[float], pose: Sequence[float]) -> list[float]:
    """A pose (position, quaternion wxyz) after a motion in the frame it is told in."""
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
        return [math.nan] * 7  # no rotation: refused like any number that is none
    with np.errstate(all="ignore"):  # what is not finite any more is refused as well
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
    """What EBench calls obs, of a turn that has an observation."""
    episode, seen = turn["episode"], turn["observation"]
    state = dict(seen["state"])
    is_lift2 = {*_STATES, *_HANDS} <= set(state)
    found: dict[str, Any] = {
        "instruction": episode["instruction"],
        "timestep": episode["step"],
        "reset": episode["step"] == 0,
        "episode_id": _episode_id(episode, run_id, benchmark_id),
        "robot_id": LIFT2 if is_lift2 else benchmark_id,
    }
    if is_lift2:
        hands = [state.pop(hand) for hand in _HANDS]
        found["state.ee_pose"] = [[_vector(h[:3]), _vector(h[3:])] for h in hands]
        state = {_STATES.get(name, name): vector for name, vector in state.items()}
    found |= {f"state.{name}": _vector(vector) for name, vector in state.items()}
    for name, image in seen["images"].items():
        found[f"video.{_CAMERAS.get(name, name)}_view"] = _image(image)
    for name, tensor in seen["tensors"].items():
        found[f"tensor.{name}"] = _array(
            tensor["dtype"], tensor["shape"], tensor["data"]
        )
    return found


def episode_result_view(
    result: Mapping[str, Any], run_id: str, benchmark_id: str
) -> dict[str, Any]:
    return {
        "episode_id": _episode_id(result, run_id, benchmark_id),
        "task_name": result["task"],
        "seed": result["seed"],
        "sr": result["score"],
    }


def _episode_id(episode: Mapping[str, Any], run_id: str, benchmark_id: str) -> str:
    """A path, for its client keeps a folder of each."""
    return f"{benchmark_id}/{run_id}/{episode['task']}/{episode['episode_id']}"


def _vector(numbers: Sequence[float]) -> dict[str, Any]:
    data = np.asarray(numbers, dtype="<f8").tobytes()
    return _array("float64", [len(numbers)], data)


def _image(image: Mapping[str, Any]) -> dict[str, Any]:
    if image["codec"] != "raw":
        mode = "RGB" if image["channels"] == 3 else "L"
        return {"type": "image", "data": b64encode(image["data"]), "mode": mode}
    shape = [image["height"], image["width"], image["channels"]]
    return _array("uint8", shape, image["data"])


def _array(dtype: str, shape: Sequence[int], data: Any) -> dict[str, Any]:
    return {
        "type": "numpy_array",
        "data": b64encode(data),  # written as text, as it is
        "dtype": dtype,
        "shape": list(shape),
    }
