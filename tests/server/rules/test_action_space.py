"""What a benchmark's spaces say of actions and assumptions: breach by breach."""

import json
import math
from typing import Any

import pytest

from reference_server.rules import action_space
from tests.support.paths import SPEC
from tests.support.server.runs import ACTION, make_run

MANIFEST = make_run().manifest
VECTORS = json.loads((SPEC / "vectors" / "conventions" / "parts.json").read_text())
CASES: list[dict[str, Any]] = VECTORS["assumptions"]


def pointers(breaches: action_space.SpaceErrors) -> list[str]:
    assert all(text for _, text in breaches)
    return [pointer for pointer, _ in breaches]


def action_errors(*actions: dict[str, list[float]]) -> list[str]:
    return pointers(action_space.action_errors(actions, MANIFEST))


def without(name: str) -> dict[str, list[float]]:
    return {key: vector for key, vector in ACTION.items() if key != name}


# --- actions ---


@pytest.mark.parametrize(
    ("action", "pointer"),
    [
        (ACTION | {"arm": [0.0]}, "arm"),
        (ACTION | {"arm": [0.0, 0.0, 0.0]}, "arm"),
        (ACTION | {"grip": []}, "grip"),
        (without("grip"), "grip"),
        (ACTION | {"a/b~c": [0.0]}, "a~1b~0c"),
        (ACTION | {"arm": [0.0, math.nan]}, "arm"),
        (ACTION | {"arm": [math.inf, 0.0]}, "arm"),
        (ACTION | {"head": [-math.inf]}, "head"),
        (ACTION | {"grip": [1.0000001]}, "grip/0"),
        (ACTION | {"grip": [-5e-324]}, "grip/0"),
    ],
)
def test_an_action_must_fit(action: dict[str, list[float]], pointer: str) -> None:
    assert action_errors(action) == [f"/actions/0/values/{pointer}"]
    # PRED-019: where it stands does not help it.
    assert action_errors(ACTION, action) == [f"/actions/1/values/{pointer}"]


def test_every_mismatch_is_named() -> None:
    first = {"z": [0.0], "grip": [2.0], "a": [0.0]}
    assert action_errors(first, ACTION, {"arm": [], "grip": [0.0], "head": [0.0]}) == [
        "/actions/0/values/z",
        "/actions/0/values/a",
        "/actions/0/values/arm",
        "/actions/0/values/grip/0",
        "/actions/0/values/head",
        "/actions/2/values/arm",
    ]


@pytest.mark.parametrize("value", [0.0, 1.0, -0.0, 5e-324])
def test_range_bounds_are_inclusive(value: float) -> None:
    assert action_errors(ACTION | {"grip": [value]}) == []


@pytest.mark.parametrize(("arm", "places"), [([0.0, 1.5], [1]), ([-2.0, 2.0], [0, 1])])
def test_a_vector_of_several_numbers_may_have_a_range(
    arm: list[float], places: list[int]
) -> None:
    space: dict[str, Any] = {**MANIFEST["action_space"]}
    bounds = {"minimum": [-1.0, -1.0], "maximum": [1.0, 1.0], "out_of_range": "refuse"}
    space["arm"] = {**space["arm"], **bounds}
    manifest = {**MANIFEST, "action_space": space}
    actions = [ACTION | {"arm": [1.0, -1.0]}, ACTION | {"arm": arm}]
    errors = pointers(action_space.action_errors(actions, manifest))
    assert errors == [f"/actions/1/values/arm/{place}" for place in places]


def test_only_range_refuse_refuses_values() -> None:
    assert action_errors(ACTION | {"head": [-1e300]}) == []
    assert action_errors(ACTION | {"arm": [1e300, -1e300]}) == []


def test_a_chunk_has_a_longest_length() -> None:
    assert action_errors(*[ACTION] * 4) == []
    assert action_errors(*[ACTION] * 5) == ["/actions"]
    assert action_errors(*[without("arm")] * 5) == ["/actions"]


# --- clipping ---


def test_values_are_clipped_only_where_that_is_declared() -> None:
    action = {"arm": [9.0, -9.0], "grip": [0.5], "head": [1.5]}
    clipped = action_space.clip_actions([action, ACTION | {"head": [-1e300]}], MANIFEST)
    assert clipped[0] == {"arm": [9.0, -9.0], "grip": [0.5], "head": [1.0]}
    assert clipped[1] == ACTION | {"head": [0.0]}


def test_actions_are_not_copied_where_nothing_is_clipped() -> None:
    space = {"arm": MANIFEST["action_space"]["arm"]}
    actions = [{"arm": [9.0, -9.0]}]
    clipped = action_space.clip_actions(actions, {"action_space": space})
    assert clipped is actions


@pytest.mark.parametrize("value", [0.0, -0.0, 5e-324, 0.1, 1.0])
def test_values_inside_the_range_are_unchanged(value: float) -> None:
    (clipped,) = action_space.clip_actions([ACTION | {"head": [value]}], MANIFEST)
    assert math.copysign(1.0, clipped["head"][0]) == math.copysign(1.0, value)
    assert clipped["head"] == [value]


def test_actions_with_a_clipped_number_are_counted_as_far_as_executed() -> None:
    sent = [
        ACTION | {"head": [1.5]},
        ACTION | {"head": [1.0]},
        ACTION | {"head": [-1.0]},
    ]
    clipped = action_space.clip_actions(sent, MANIFEST)
    counts = [action_space.count_clipped(sent, clipped, n) for n in range(4)]
    assert counts == [0, 1, 1, 2]
    assert action_space.count_clipped(sent, sent, 3) == 0


# --- conventions ---


def test_can_confirm_conventions() -> None:
    nothing: dict[str, Any] = {"control_rate_hz": None, "action": None, "state": {}}
    assert action_space.convention_errors(nothing, MANIFEST) == []
    parts = {"arm": {"size": 2, "parts": None}}
    assert action_space.convention_errors({"action": parts}, MANIFEST) == []


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["description"])
def test_assumptions_are_compared_part_by_part(case: dict[str, Any]) -> None:
    errors = action_space.convention_errors(case["assumes"], VECTORS["benchmark"])
    assert sorted(pointers(errors)) == case["refused"]


def test_a_contradiction_says_both_values_and_the_part() -> None:
    """CONV-006: also where the assumption names no part."""
    assumes = {
        "control_rate_hz": 20,
        "action": {"arm": {"unit": "deg", "parts": {"joints": {"gripper_open": 1}}}},
        "state": {"joints": {"parts": {"left": {}}}, "legs": {}},
    }
    assert [text for _, text in action_space.convention_errors(assumes, MANIFEST)] == [
        "assumed 20, declared 10.0",
        'assumed "deg", declared "rad" in the part joints',
        "assumed 1, declared null in the part joints",
        "the vector has no such part, but joints",
        "the benchmark has no such vector, but joints",
    ]
