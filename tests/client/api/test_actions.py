"""Actions of a policy become the chunk of a predict."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from reference_client import ProctorError
from reference_client.api.action_layout import ActionLayout, ClipCount
from reference_client.api.policy import chunk_of

ARM = ActionLayout.of(
    "arm",
    {
        "joint_position": {
            "size": 3,
            "unit": "rad",
            "out_of_range": "clip",
            "minimum": [-1.0, -1.0, -1.0],
            "maximum": [1.0, 1.0, 2.0],
        },
        "gripper": {"size": 1, "unit": "1", "out_of_range": "refuse"},
    },
)
EXPECTED = "joint_position 3, gripper 1, or an array of 4 in this order"
ROW = [0.5, 1.0, 1.5, 0.0]
VALUES = {"joint_position": [0.5, 1.0, 1.5], "gripper": [0.0]}


@pytest.mark.parametrize(
    ("actions", "pointer", "text"),
    [
        (1.0, "/actions", "a float, not an action or a list of actions"),
        ("one", "/actions", "a str, not an action or a list of actions"),
        (None, "/actions", "a NoneType, not an action or a list of actions"),
        ([], "/actions", "is empty"),
        ([[1.0]], "/actions/0/values", "not a dict of vectors"),
        ([{"a": ["one"]}], "/actions/0/values/a", "no number"),
        ([{"a": [1.0, np.nan]}], "/actions/0/values/a/1", "not finite"),
        ([{"a/b~": [np.inf]}], "/actions/0/values/a~1b~0/0", "not finite"),
    ],
)
def test_an_invalid_action_is_refused_with_its_pointer(
    actions: Any, pointer: str, text: str
) -> None:
    with pytest.raises(ProctorError, match=text) as caught:
        chunk_of(actions)
    assert (caught.value.code, caught.value.side_effects) == ("invalid_request", "none")
    assert [at for at, _ in caught.value.errors] == [pointer]


@pytest.mark.parametrize(
    ("actions", "length"),
    [
        (VALUES, 1),
        ([VALUES, VALUES], 2),
        ((VALUES,), 1),
        (ROW, 1),
        (tuple(ROW), 1),
        ([np.float32(n) for n in ROW], 1),
        (np.array(ROW, np.float32), 1),
        (np.array([ROW, ROW, ROW]), 3),
        ([ROW, ROW], 2),
        ([np.array(ROW), VALUES], 2),
    ],
)
def test_one_action_rows_and_chunks_are_accepted(actions: Any, length: int) -> None:
    """As README promises: a dict, a list, a row (n,) or a chunk (k, n)."""
    assert chunk_of(actions, ARM) == [{"values": VALUES}] * length


@pytest.mark.parametrize(
    ("actions", "pointer", "text"),
    [
        (np.zeros(3), "/actions/0/values", "is an array of 3"),
        (np.zeros((2, 5)), "/actions/0/values", "is an array of 5"),
        (np.zeros((2, 2, 4)), "/actions/0/values", r"has shape \(2, 4\)"),
        (
            VALUES | {"joint_position": np.zeros((2, 3))},
            "/actions/0/values/joint_position",
            r"has shape \(2, 3\); .* a chunk is a list of actions",
        ),
        ([], "/actions", "is empty"),
        (np.zeros((0, 4)), "/actions", "is empty"),
        (None, "/actions", "a NoneType, not an action"),
        ({"gripper": [0.0]}, "/actions/0/values", "lacks joint_position"),
        (
            VALUES | {"griper": [0.0]},
            "/actions/0/values",
            "has griper, which is no name; did you mean gripper",
        ),
        (
            VALUES | {"joint_position": [0.0]},
            "/actions/0/values/joint_position",
            "has 1 numbers; joint_position has 3",
        ),
        (VALUES | {"joint_position": 1.0}, "/actions/0/values/joint_position", "has 1"),
        (VALUES | {"gripper": ["x"]}, "/actions/0/values/gripper", "no number"),
        ([*ROW[:3], np.nan], "/actions/0/values/3", "not finite"),
        (["open", "close"], "/actions/0/values", "holds the text 'open'; numbers are"),
        (np.zeros(4, dtype=[("a", "f4")]), "/actions", "no number"),
        ({"gripper": np.zeros(1, "f4,f4")}, "/actions/0/values/gripper", "no number"),
    ],
)
def test_refusals_name_the_due_shape(actions: Any, pointer: str, text: str) -> None:
    with pytest.raises(ProctorError, match=text) as caught:
        chunk_of(actions, ARM)
    assert [at for at, _ in caught.value.errors] == [pointer]
    assert f"An action of arm is: {EXPECTED}." in caught.value.detail
    assert "could not convert" not in str(caught.value)


class Tensor:
    """A tensor of torch: numpy cannot read it before `detach`, `cpu` and `double`."""

    layout = "torch.sparse_coo"
    is_quantized = False

    def __init__(self, numbers: Any, reason: str = "", *steps: str) -> None:
        self.numbers, self.reason, self.steps = numbers, reason, steps

    @property
    def ndim(self) -> int:
        return np.ndim(self.numbers)

    def then(self, step: str) -> Tensor:
        return Tensor(self.numbers, self.reason, *self.steps, step)

    def detach(self) -> Tensor:
        return self.then("detach")

    def to_dense(self) -> Tensor:
        return self.then("to_dense")

    def is_complex(self) -> bool:
        return False

    def cpu(self) -> Tensor:
        if self.reason:
            raise NotImplementedError(self.reason)
        return self.then("cpu")

    def double(self) -> Tensor:
        return self.then("double")

    def numpy(self) -> Any:
        assert self.steps == ("detach", "to_dense", "cpu", "double")
        return np.array(self.numbers, np.float64)

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        raise TypeError("Got unsupported ScalarType BFloat16")


Tensor.__module__ = "torch"


class JaxArray:
    """An array that numpy can read, as jax and tensorflow have."""

    def __init__(self, numbers: Any, reason: str = "") -> None:
        self.numbers, self.reason = numbers, reason

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        if self.reason:
            raise RuntimeError(self.reason)
        return np.array(self.numbers, dtype)


JaxArray.__module__ = "jaxlib.xla_extension"
ARM_ROW = ROW[:3]


@pytest.mark.parametrize(
    "actions",
    [
        *(kind(ROW) for kind in (Tensor, JaxArray)),
        *(kind([ROW]) for kind in (Tensor, JaxArray)),
        *(kind([[ROW]]) for kind in (Tensor, JaxArray)),
        *([kind(number) for number in ROW] for kind in (Tensor, JaxArray)),
        {"joint_position": Tensor(ARM_ROW), "gripper": JaxArray(0.0)},
        {"joint_position": Tensor([ARM_ROW]), "gripper": Tensor([[0.0]])},
        {"joint_position": [JaxArray(n) for n in ARM_ROW], "gripper": 0},
        [[Tensor(number) for number in ROW]],
    ],
)
def test_arrays_of_other_libraries_are_read(actions: Any) -> None:
    """Also a batch of one, and a single number for a vector of one."""
    assert chunk_of(actions, ARM) == [{"values": VALUES}]


@pytest.mark.parametrize(
    ("vector", "texts"),
    [
        (
            Tensor([0.0], "Cannot copy out of meta tensor; no data!"),
            ["a torch.Tensor: Cannot copy out of meta", "`x.detach().float().cpu()`"],
        ),
        ([JaxArray(0, "deleted")], ["jaxlib.JaxArray: deleted", "`jax.device_get(x)`"]),
        (np.array([1j]), ["complex128", "a numpy array of real numbers"]),
        (np.ma.array([1.0], mask=[True]), ["masked"]),
        (np.array(["2026"], "M8[s]"), ["datetime64"]),
        (["1.0"], ["<U3"]),
        ([None], ["it has None"]),
    ],
)
def test_an_unreadable_array_is_refused_with_the_reason_and_the_cure(
    vector: Any, texts: list[str]
) -> None:
    with pytest.raises(ProctorError) as caught:
        chunk_of({"joint_position": ARM_ROW, "gripper": vector}, ARM)
    ((pointer, text),) = caught.value.errors
    assert pointer == "/actions/0/values/gripper"
    assert all(part in text for part in texts), text


def test_numbers_outside_a_range_that_clips_are_counted() -> None:
    """Not those of a range that refuses, and not the rounding to float32."""
    assert ARM is not None
    count = ClipCount()
    for joints in ([1.5, -2.0, 0.0], [1.0000001, 0.0, 2.0], [0.0, 0.0, 2.5]):
        actions = {"joint_position": joints, "gripper": [9.0]}
        count.add_action(ARM.clipped_names(actions))
    assert (count.actions, count.clipped) == (3, 2)
    assert count.numbers == {"joint_position": 3}
    assert count.is_most
    assert ARM.range_of("joint_position") == "[-1, 2] rad"
    grip = {"size": 1, "unit": "1", "out_of_range": "clip"}
    layout = ActionLayout.of("b", {"grip": grip | {"minimum": [0.0], "maximum": [1.0]}})
    assert layout is not None
    assert layout.range_of("grip") == "[0, 1]"


def test_a_space_of_some_tasks_has_no_fixed_shape() -> None:
    assert ActionLayout.of("many", {"a": {"size": 1, "tasks": ["x"]}}) is None
