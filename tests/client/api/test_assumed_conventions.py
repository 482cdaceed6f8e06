"""Assumptions of a policy, compared by the client before there is a run."""

import json
import re
import tomllib
from typing import Any

import pytest
from proctor_client import Assumptions

from reference_client.api.assumed_conventions import check_assumptions
from reference_client.errors import ProctorError
from reference_client.evaluation.parameters import parse_strictly
from reference_client.policies.mapping import PolicyMapping
from reference_sim import benchmark_registry
from tests.support.paths import ROOT, SPEC

FILE = SPEC / "vectors" / "conventions" / "parts.json"
VECTORS: dict[str, Any] = json.loads(FILE.read_text())
PAGES = (ROOT / "docs" / "evaluate" / "policies").glob("polic*.md")
FILES = [
    text
    for page in PAGES
    for text in re.findall(r"```toml\n(.*?)```", page.read_text(), re.DOTALL)
]
BENCHMARK = VECTORS["benchmark"] | {"benchmark_id": "b"}


def test_a_contradiction_is_an_error_with_the_part() -> None:
    parts = {"orientation": {"rotation": "quaternion_xyzw"}}
    assumes = {"action": {"left_ee_pose": {"parts": parts}}}
    with pytest.raises(ProctorError) as raised:
        check_assumptions(assumes, BENCHMARK)
    assert raised.value.code == "convention_mismatch"
    ((pointer, said),) = raised.value.errors
    assert pointer == "/assumes/action/left_ee_pose/parts/orientation/rotation"
    assert said == (
        'assumed "quaternion_xyzw", declared "quaternion_wxyz" in the part orientation'
    )
    check_assumptions(None, BENCHMARK)


@pytest.mark.parametrize(
    ("assumes", "fault"),
    [
        ({"action": {"a": {"relative": True}}}, "x.action.a has no member 'relative'"),
        ({"state": {"a": {"parts": {"b": {"units": "m"}}}}}, "did you mean unit"),
        ({"actoin": {}}, "x has no member 'actoin'"),
        ({"action": {"a": {"parts": {"b": {"start": -1}}}}}, "at least 0"),
    ],
)
def test_members_of_no_schema_are_refused(assumes: dict[str, Any], fault: str) -> None:
    with pytest.raises(ValueError, match=fault):
        parse_strictly(Assumptions, "x", assumes)


@pytest.mark.parametrize("text", FILES, ids=lambda text: text.split()[1])
def test_the_mappings_of_the_manual_say_what_they_assume(text: str) -> None:
    """Each is right for its benchmark, and wrong for one with another gripper."""
    mapping = PolicyMapping.of(tomllib.loads(text), is_partial=True)
    assumed = parse_strictly(Assumptions, "assumes", mapping.assumes)
    assert assumed is not None
    if "ee_delta" in mapping.vectors:
        return  # of a benchmark that the reader has
    is_ebench = "base_motion" in mapping.vectors
    benchmark_id = "mobile_bimanual" if is_ebench else "tabletop"
    manifest = benchmark_registry.resolve(benchmark_id).manifest
    check_assumptions(assumed.to_dict(), manifest)
    inverted = json.loads(json.dumps(manifest))
    for part in inverted["action_space"]["gripper"]["parts"].values():
        ends = part["gripper_open"], part["gripper_closed"]
        part["gripper_closed"], part["gripper_open"] = ends
    with pytest.raises(ProctorError, match="gripper_open: assumed"):
        check_assumptions(assumed.to_dict(), inverted)
