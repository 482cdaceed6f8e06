"""Spaces of environments as those of the protocol, there and back."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces
from hypothesis import given, settings
from hypothesis import strategies as st

from reference_sim.gymnasium import entries
from reference_sim.gymnasium.entries import Entry, UnsupportedSpace
from reference_sim.gymnasium.environments import read_space
from tests.support.sim.gymnasium_envs import ALL_SPACES


def box(bounds: tuple[float, float], shape: Any, dtype: Any) -> spaces.Box[Any]:
    return spaces.Box(*bounds, shape, dtype)


SHAPES = st.lists(st.integers(1, 3), max_size=3).map(tuple)
FLOATS = st.sampled_from([np.float32, np.float64])
BOUNDS: st.SearchStrategy[tuple[float, float]] = st.sampled_from(
    [(-2, 3), (-np.inf, np.inf), (0, np.inf), (-np.inf, 5)]
)
LEAVES = st.one_of(
    st.builds(box, BOUNDS, SHAPES, FLOATS),
    st.builds(lambda shape: spaces.Box(0, 255, shape, np.uint8), SHAPES),
    st.builds(
        lambda n, start: spaces.Discrete(n, start=start),
        st.integers(1, 9),
        st.integers(-5, 5),
    ),
    st.builds(
        spaces.MultiDiscrete, st.lists(st.integers(1, 9), min_size=1, max_size=4)
    ),
    st.builds(spaces.MultiBinary, st.integers(1, 5)),
)
SPACES: st.SearchStrategy[spaces.Space[Any]] = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.dictionaries(st.text("abc", min_size=1), inner, min_size=1, max_size=3).map(
            spaces.Dict
        ),
        st.lists(inner, min_size=1, max_size=3).map(spaces.Tuple),
    ),
    max_leaves=5,
)


def read_single_entry(space: spaces.Space[Any]) -> Entry:
    (entry,), _ = read_space(space, "root")
    return entry


@settings(max_examples=100)
@given(SPACES, st.integers(0, 2**32 - 1))
def test_an_action_survives_encoding(space: spaces.Space[Any], seed: int) -> None:
    """Samples of the environment, sent as vectors of floats, come back equal."""
    space.seed(seed)
    sampled = space.sample()
    found, structure = read_space(space, "root")
    leaves = entries.take(structure, sampled)
    sent = {
        name: np.asarray(value, np.float64).ravel().tolist()
        for name, value in leaves.items()
    }
    declared = entries.action_space(found)
    assert {name: len(vector) for name, vector in sent.items()} == {
        name: entry["size"] for name, entry in declared.items()
    }
    arrived = entries.assemble(
        structure, {e.name: entries.to_environment(e, sent[e.name]) for e in found}
    )
    assert arrived in space
    for name, value in entries.take(structure, arrived).items():
        assert np.array_equal(value, leaves[name])


def test_entries_are_named_by_their_path() -> None:
    found, _ = read_space(ALL_SPACES, "root")
    names = {"arm.joints", "arm.gripper", "front", "grey", "small", "grid"}
    assert {entry.name for entry in found} == names | {"pair.0", "pair.1"}
    assert read_single_entry(spaces.Discrete(2)).name == "root"


def test_the_observation_space_lists_state_images_and_tensors() -> None:
    found, _ = read_space(ALL_SPACES, "root")
    space = entries.observation_space(found)
    assert list(space["state"]) == ["arm.gripper", "arm.joints", "pair.0", "pair.1"]
    assert space["state"]["arm.joints"]["minimum"] == [-3, -3]
    assert {k: v["channels"] for k, v in space["images"].items()} == {
        "front": 3,
        "grey": 1,
        "small": 3,
    }
    assert space["tensors"]["grid"] == {
        "dtype": "float32",
        "shape": [2, 3],
        "description": "Box (2, 3) of float32",
    }


def test_a_choice_is_bounded_described_and_rounded() -> None:
    entry = read_single_entry(spaces.Discrete(3, start=-1))
    space = entries.action_space([entry])["root"]
    assert (space["size"], space["minimum"], space["maximum"]) == (1, [-1.0], [1.0])
    assert space["out_of_range"] == "refuse"
    assert "from -1 to 1" in space["description"]
    assert "rounded to the nearest" in space["description"]
    assert entries.to_environment(entry, [0.6]) == 1
    assert isinstance(entries.to_environment(entry, [0.6]), np.int64)


def test_a_bounded_action_is_clipped_to_the_bounds_of_its_own_type() -> None:
    entry = read_single_entry(spaces.Box(-0.1, 0.1, (1,), np.float32))
    space = entries.action_space([entry])["root"]
    assert space["out_of_range"] == "clip"
    clipped = entries.to_environment(entry, [5.0])
    assert clipped.dtype == np.float32
    assert clipped[0] == np.float32(0.1) == space["maximum"][0]


def test_an_unbounded_action_stays_finite() -> None:
    entry = read_single_entry(spaces.Box(-np.inf, np.inf, (1,), np.float32))
    space = entries.action_space([entry])["root"]
    assert space["out_of_range"] == "unbounded"
    assert "minimum" not in space
    assert np.isfinite(entries.to_environment(entry, [1e300])[0])


def test_a_one_sided_bound_contains_no_infinity() -> None:
    entry = read_single_entry(spaces.Box(0, np.inf, (1,)))
    space = entries.action_space([entry])["root"]
    assert space["maximum"] == [np.finfo(np.float64).max]
    assert space["out_of_range"] == "clip"


@pytest.mark.parametrize(
    ("space", "text"),
    [
        (spaces.Text(5), "'root' is a Text"),
        (spaces.Dict({"a": spaces.Graph(spaces.Box(0, 1), None)}), "'a' is a Graph"),
        (
            spaces.Dict(
                {"a.b": spaces.Discrete(2), "a": spaces.Dict({"b": spaces.Discrete(2)})}
            ),
            "two of its entries are called 'a.b'",
        ),
    ],
)
def test_an_unsupported_space_is_an_error(space: spaces.Space[Any], text: str) -> None:
    with pytest.raises(UnsupportedSpace, match=text):
        read_space(space, "root")


def test_an_empty_action_is_refused_and_an_empty_observation_left_out() -> None:
    entry = read_single_entry(spaces.Box(-1, 1, (0,)))
    with pytest.raises(UnsupportedSpace, match="'root' is empty"):
        entries.action_space([entry])
    assert entries.observation_space([entry])["state"] == {}


def test_a_tensor_of_a_type_unknown_to_the_protocol_is_refused() -> None:
    entry = Entry("t", "t", (2, 2), np.dtype("c8"), np.zeros((2, 2)), np.ones((2, 2)))
    with pytest.raises(UnsupportedSpace, match="complex64"):
        entries.observation_space([entry])


@pytest.mark.parametrize(
    ("observation", "text"),
    [
        ({"a": 1}, "lacks some of a, b"),
        ([1, 2], "lacks some of a, b"),
        ({"a": 1, "b": (1,)}, "has not its 2 parts"),
    ],
)
def test_another_structure_is_an_error(observation: Any, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        entries.take({"a": "a", "b": ("b.0", "b.1")}, observation)


def test_a_grey_picture_has_one_channel() -> None:
    entry = read_single_entry(spaces.Box(0, 255, (12, 16), np.uint8))
    assert entries.as_array(entry, np.zeros((12, 16), np.uint8)).shape == (12, 16, 1)


def test_tasks_may_differ_only_in_observation_bounds() -> None:
    narrow, wide = (
        read_single_entry(spaces.Box(0, 1, (2,))),
        read_single_entry(spaces.Box(-5, 0.5, (2,))),
    )
    (joint,) = entries.joined([narrow], [wide])
    assert joint.low.tolist() == [-5, -5]
    assert joint.high.tolist() == [1, 1]
    assert entries.same([narrow], [narrow])
    assert not entries.same([narrow], [wide])
    with pytest.raises(UnsupportedSpace, match="differs from that of the first"):
        entries.joined([narrow], [read_single_entry(spaces.Box(0, 1, (3,)))])
