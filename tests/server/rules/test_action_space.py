"""What a benchmark's spaces say of actions and assumptions: breach by breach."""

import json
import math
from typing import Any

import pytest

from reference_record.contents.contradicted_assumptions import contradictions
from reference_server.rules.runs import action_space
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


def test_a_chunk_has_a_longest_length() -> None:
    assert action_errors(*[ACTION] * 4) == []
    assert action_errors(*[ACTION] * 5) == ["/actions"]
    assert action_errors(*[without("arm")] * 5) == ["/actions"]


# --- clipping ---


def test_actions_are_not_copied_where_nothing_is_clipped() -> None:
    space = {"arm": MANIFEST["action_space"]["arm"]}
    actions = [{"arm": [9.0, -9.0]}]
    clipped = action_space.clip_actions(actions, {"action_space": space})
    assert clipped is actions


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


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["description"])
def test_assumptions_are_compared_part_by_part(case: dict[str, Any]) -> None:
    errors = list(contradictions(case["assumes"], VECTORS["benchmark"]))
    assert sorted(pointers(errors)) == case["refused"]
