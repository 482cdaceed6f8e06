"""The parts of a vector, as a benchmark declares them (schema VectorPart).

Descriptions of earlier drafts, in records and on servers, have conventions of whole
vectors; spec/conventions.md says as which parts they are read. Pure.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

import msgspec
from msgspec import Struct

# Rotation → the names of its numbers.
ROTATION_NUMBERS: Final[Mapping[str, tuple[str, ...]]] = {
    "quaternion_wxyz": ("qw", "qx", "qy", "qz"),
    "quaternion_xyzw": ("qx", "qy", "qz", "qw"),
    "axis_angle": ("rx", "ry", "rz"),
    "euler_xyz": ("roll", "pitch", "yaw"),
    "rot6d_columns": ("r11", "r21", "r31", "r12", "r22", "r32"),
    "rot6d_interleaved": ("r11", "r12", "r21", "r22", "r31", "r32"),
    "yaw": ("yaw",),
}
_UNSPECIFIED: Final = "unspecified"


class DeclaredPart(Struct, frozen=True):
    """Adjacent numbers of a vector that have one meaning."""

    start: int
    size: int
    quantity: str = _UNSPECIFIED
    unit: str = _UNSPECIFIED
    frame: str = _UNSPECIFIED
    rotation: str = _UNSPECIFIED
    relative_to: str = _UNSPECIFIED
    scale: float = 1.0
    gripper_open: float | None = None
    gripper_closed: float | None = None
    description: str | None = None

    @property
    def scaled_unit(self) -> str:
        """`m`, or `0.05 m` where a number is a multiple; empty without a unit."""
        unit = "" if self.unit == "1" else self.unit
        return unit if self.scale == 1 else f"{self.scale:g} {unit}".rstrip()


class _EarlierSpace(Struct):
    """A VectorSpace of earlier drafts."""

    unit: str = _UNSPECIFIED
    rotation: str = _UNSPECIFIED
    frame: str = _UNSPECIFIED
    relative: bool = True
    gripper_open: float | None = None


def declared_parts(space: Mapping[str, Any]) -> dict[str, DeclaredPart]:
    """The parts of a VectorSpace by name, in the order of their numbers.

    One part `all`, of which nothing is known, where parts leave numbers out or overlap,
    or are declared otherwise than the schema has it.
    """
    size: int = space["size"]
    try:
        declared = space.get("parts")
        if declared is None:
            return _earlier_parts(size, msgspec.convert(_given(space), _EarlierSpace))
        unsorted = {
            name: msgspec.convert(_given(part), DeclaredPart)
            for name, part in declared.items()
        }
    except (msgspec.ValidationError, AttributeError):
        return {"all": DeclaredPart(0, size)}
    parts = dict(sorted(unsorted.items(), key=lambda item: item[1].start))
    reached = 0
    for part in parts.values():
        if part.start != reached or part.size < 1:
            return {"all": DeclaredPart(0, size)}
        reached += part.size
    return parts if reached == size else {"all": DeclaredPart(0, size)}


def _given(members: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in members.items() if value is not None}


def _earlier_parts(size: int, space: _EarlierSpace) -> dict[str, DeclaredPart]:
    numbers = len(ROTATION_NUMBERS.get(space.rotation, ()))
    units = _units_of_numbers(space.unit, size, numbers)
    rest = size - numbers

    def part(start: int, end: int, rotation: str) -> DeclaredPart:
        unit, *others = dict.fromkeys(units[start:end])
        return DeclaredPart(
            start,
            end - start,
            unit=_UNSPECIFIED if others else unit,
            frame=space.frame,
            rotation=rotation,
            relative_to=_UNSPECIFIED if space.relative else "none",
            gripper_open=space.gripper_open,
        )

    if numbers and rest > 0:
        return {
            "position": part(0, rest, "none"),
            "orientation": part(rest, size, space.rotation),
        }
    return {"all": part(0, size, space.rotation)}


def _units_of_numbers(unit: str, size: int, rotation_size: int) -> list[str]:
    units = [name.strip() for name in unit.split(",")]
    if len(units) == size:
        return units
    if len(units) == 2 and 0 < rotation_size < size:
        position, rotation = units
        return [position] * (size - rotation_size) + [rotation] * rotation_size
    return [units[0] if len(units) == 1 else _UNSPECIFIED] * size
