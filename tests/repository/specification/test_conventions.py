"""The conventions of spec/conventions.md: formulas, registries and vectors.

Rotations are computed by a library of other authors.
"""

import json
from typing import Any

import mujoco
import numpy as np
import pytest
import yaml
from msgspec.structs import asdict

from conformance.oracle.vector_declarations import declaration_faults
from reference_record.contents.declared_parts import ROTATION_NUMBERS, declared_parts
from reference_sim import benchmark_registry, vector_spaces
from tests.support.paths import SPEC
from tests.support.repository.specification import DOCUMENT

FILES = SPEC / "vectors" / "conventions"
CASES = json.loads((FILES / "rotations.json").read_text())["cases"]
PARTS: dict[str, list[dict[str, Any]]] = json.loads((FILES / "parts.json").read_text())
REGISTRIES: dict[str, list[dict[str, Any]]] = {
    path.stem: yaml.safe_load(path.read_text())
    for path in (SPEC / "registry").glob("*.yaml")
}
NAMES = {stem: [one["name"] for one in listed] for stem, listed in REGISTRIES.items()}
SIZES = {entry["name"]: entry.get("size") for entry in REGISTRIES["rotations"]}


def matrix_of(rotation: str, numbers: list[float]) -> np.ndarray:
    """Compute the matrix of a rotation with MuJoCo's functions."""
    quaternion, matrix = np.empty(4), np.empty(9)
    if rotation.startswith("rot6d"):
        by_column = np.array(numbers).reshape(2, 3).T
        by_row = np.array(numbers).reshape(3, 2)
        columns = by_column if rotation == "rot6d_columns" else by_row
        return np.column_stack([columns, np.cross(columns[:, 0], columns[:, 1])])
    if rotation == "quaternion_wxyz":
        quaternion[:] = numbers
    elif rotation == "quaternion_xyzw":
        quaternion[:] = [numbers[3], *numbers[:3]]
    elif rotation == "axis_angle":
        angle = float(np.linalg.norm(numbers))
        axis = np.array(numbers) / angle if angle else np.array([1.0, 0, 0])
        mujoco.mju_axisAngle2Quat(quaternion, axis, angle)
    else:  # capital letters are turns about fixed axes
        angles = [0.0] * (3 - len(numbers)) + numbers  # yaw is the last of them
        mujoco.mju_euler2Quat(quaternion, np.array(angles), "XYZ")
    mujoco.mju_quat2Mat(matrix, quaternion)
    return matrix.reshape(3, 3)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["description"])
def test_all_representations_are_one_rotation(case: dict[str, Any]) -> None:
    rotations = set(case) - {"description", "matrix"}
    assert rotations >= {name for name, size in SIZES.items() if size} - {"yaw"}
    for rotation in rotations:
        assert len(case[rotation]) == SIZES[rotation]
        computed = matrix_of(rotation, case[rotation])
        np.testing.assert_allclose(computed, case["matrix"], atol=1e-9)


@pytest.mark.parametrize(
    ("stem", "schema", "names"),
    [
        ("quantities", "Quantity", vector_spaces.QUANTITIES),
        ("units", "Unit", vector_spaces.UNITS),
        ("frames", "Frame", vector_spaces.FRAMES),
        ("rotations", "Rotation", vector_spaces.ROTATIONS),
        ("relative_modes", "RelativeTo", vector_spaces.RELATIVE_MODES),
    ],
)
def test_a_registry_is_the_enumeration(stem: str, schema: str, names: Any) -> None:
    """In the schema, in the reference server, and in the tables of the document."""
    listed = DOCUMENT["components"]["schemas"][schema]["x-extensible-enum"]
    assert listed == NAMES[stem] == [*names]
    assert all(entry["meaning"] for entry in REGISTRIES[stem])
    text = (SPEC / "conventions.md").read_text()
    assert [name for name in listed if f"`{name}`" not in text] == []


def test_rotations_have_their_sizes_everywhere() -> None:
    assert vector_spaces.ROTATIONS == SIZES
    numbers = {name: len(labels) for name, labels in ROTATION_NUMBERS.items()}
    assert numbers == {name: size for name, size in SIZES.items() if size}


@pytest.mark.parametrize("benchmark_id", benchmark_registry.benchmark_ids())
def test_our_benchmarks_declare_what_is_registered(benchmark_id: str) -> None:
    manifest = benchmark_registry.resolve(benchmark_id).manifest
    spaces = [manifest["action_space"], manifest["observation_space"]["state"]]
    grippers = [(g.get("open"), g["closed"]) for g in REGISTRIES["grippers"]]
    for name, vector in ((n, v) for space in spaces for n, v in space.items()):
        assert not [*declaration_faults(vector)], name
        for part in vector["parts"].values():
            assert "unspecified" not in part.values()
            if part["quantity"] == "gripper":
                ends = part["gripper_open"], part["gripper_closed"]
                assert ends in grippers or (None, ends[1]) in grippers


@pytest.mark.parametrize("case", PARTS["declarations"], ids=lambda c: c["description"])
def test_the_kit_finds_what_a_declaration_breaks(case: dict[str, Any]) -> None:
    broken = {rule for rule, _ in declaration_faults(case["vector"])}
    assert broken == set(case["breaks"])
    if "parts" in case["vector"]:
        read = declared_parts(case["vector"])
        is_whole = "CONV-001" not in case["breaks"]
        assert (set(read) == set(case["vector"]["parts"])) == is_whole


@pytest.mark.parametrize("case", PARTS["earlier"], ids=lambda c: c["description"])
def test_earlier_declarations_are_read_as_parts(case: dict[str, Any]) -> None:
    read = {
        name: {k: v for k, v in asdict(part).items() if v is not None}
        for name, part in declared_parts(case["vector"]).items()
    }
    due = {name: {"scale": 1.0} | part for name, part in case["parts"].items()}
    assert read == due
    assert list(read) == list(due)


ODD = [{"a": 1}, {"a": {}}, {"a": {"start": "0", "size": 2}}, [], "x"]


@pytest.mark.parametrize("parts", ODD)
def test_a_declaration_that_is_none_says_nothing(parts: Any) -> None:
    (part,) = declared_parts({"size": 2, "parts": parts}).values()
    assert (part.size, part.unit) == (2, "unspecified")
