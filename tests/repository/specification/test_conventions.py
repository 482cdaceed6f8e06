"""The rotations of spec/conventions.md, computed by a library of other authors."""

from __future__ import annotations

import json
from typing import Any

import mujoco
import numpy as np
import pytest

from tests.support.paths import SPEC
from tests.support.repository.specification import DOCUMENT

CASES: list[dict[str, Any]] = json.loads(
    (SPEC / "vectors" / "conventions" / "rotations.json").read_text()
)["cases"]
ROTATIONS = DOCUMENT["components"]["schemas"]["Rotation"]["x-extensible-enum"]


def matrix_of(rotation: str, numbers: list[float]) -> np.ndarray:
    """Compute the matrix of a rotation with MuJoCo's functions."""
    quaternion, matrix = np.empty(4), np.empty(9)
    if rotation == "rot6d_columns":
        first, second = np.array(numbers[:3]), np.array(numbers[3:])
        return np.column_stack([first, second, np.cross(first, second)])
    if rotation == "quaternion_wxyz":
        quaternion[:] = numbers
    elif rotation == "quaternion_xyzw":
        quaternion[:] = [numbers[3], *numbers[:3]]
    elif rotation == "axis_angle":
        angle = float(np.linalg.norm(numbers))
        axis = np.array(numbers) / angle if angle else np.array([1.0, 0, 0])
        mujoco.mju_axisAngle2Quat(quaternion, axis, angle)
    else:  # capital letters are turns about fixed axes
        mujoco.mju_euler2Quat(quaternion, np.array(numbers), "XYZ")
    mujoco.mju_quat2Mat(matrix, quaternion)
    return matrix.reshape(3, 3)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["description"])
def test_all_representations_are_one_rotation(case: dict[str, Any]) -> None:
    for rotation in ROTATIONS:
        if rotation != "none":
            computed = matrix_of(rotation, case[rotation])
            np.testing.assert_allclose(computed, case["matrix"], atol=1e-9)


def test_the_document_defines_every_rotation() -> None:
    text = (SPEC / "conventions.md").read_text()
    assert [name for name in ROTATIONS if f"| `{name}` |" not in text] == []
