"""Declarations of vectors: their parts, and the conventions of each.

The members are those of the specification's schemas VectorSpace and VectorPart;
spec/conventions.md defines their values. Pure.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, Final

Json = dict[str, Any]
# The registries of spec/registry/, in their order.
QUANTITIES: Final = (
    *("position", "orientation", "joint_position", "gripper", "linear_velocity"),
    *("angular_velocity", "joint_velocity", "joint_torque", "force", "torque"),
    *("length", "time", "number", "choice", "unspecified"),
)
UNITS: Final = (
    *("1", "m", "mm", "rad", "deg", "s", "m/s", "rad/s", "N", "N*m", "kg", "px"),
    "unspecified",
)
FRAMES: Final = (
    *("world", "base", "arm_base", "tool", "joint", "image", "none", "unspecified"),
)
# Name → how many numbers it has; None where it says nothing about them.
ROTATIONS: Final = {
    "none": None,
    "quaternion_wxyz": 4,
    "quaternion_xyzw": 4,
    "axis_angle": 3,
    "euler_xyz": 3,
    "rot6d_columns": 6,
    "rot6d_interleaved": 6,
    "yaw": 1,
    "unspecified": None,
}
RELATIVE_MODES: Final = ("none", "measured", "commanded", "unspecified")
_REGISTRIES: Final = {
    "quantity": QUANTITIES,
    "unit": UNITS,
    "frame": FRAMES,
    "rotation": tuple(ROTATIONS),
    "relative_to": RELATIVE_MODES,
}
# An extension begins with a domain in reverse; underscores stand for its dots.
_EXTENSION: Final = re.compile(
    r"(?:[a-z]{2}|com|dev|edu|gov|info|net|org)_[a-z0-9]\w*_\w+", re.ASCII
)


def is_extension(name: str) -> bool:
    """Whether others have made the name; see spec/extensions.md."""
    return _EXTENSION.fullmatch(name) is not None


def registered(member: str, value: str) -> str:
    """The value, if it is a name for that member of a part.

    Raises ValueError, with the names, if it is neither registered nor an extension.
    """
    names = _REGISTRIES[member]
    if value in names or is_extension(value):
        return value
    raise ValueError(f"unknown value {value}; there is {', '.join(names)}")


@dataclass(frozen=True, slots=True)
class VectorPart:
    """Adjacent numbers of a vector that have one meaning, without their place.

    Members are those of the schema VectorPart; None is not declared. Raises ValueError
    for a part that CONV-002 or CONV-003 forbids.
    """

    name: str
    size: int
    quantity: str
    unit: str
    frame: str = "none"
    rotation: str = "none"
    relative_to: str = "none"
    scale: float | None = None
    gripper_open: float | None = None
    gripper_closed: float | None = None
    description: str | None = None

    def __post_init__(self) -> None:
        for member in _REGISTRIES:
            registered(member, getattr(self, member))
        numbers_of_rotation = ROTATIONS.get(self.rotation)
        if numbers_of_rotation not in (None, self.size):
            raise ValueError(  # CONV-002
                f"{self.rotation} has {numbers_of_rotation} numbers, the part has "
                f"{self.size}"
            )
        if self.quantity == "gripper" and (  # CONV-003
            None in (self.gripper_open, self.gripper_closed)
            or self.gripper_open == self.gripper_closed
        ):
            raise ValueError(
                "a gripper has two values, gripper_open and gripper_closed"
            )

    def declare(self, start: int) -> Json:
        """The VectorPart of the numbers from index `start`."""
        declared = {
            "start": start,
            "size": self.size,
            "quantity": self.quantity,
            "unit": self.unit,
            "scale": self.scale,
            "frame": self.frame,
            "rotation": self.rotation,
            "relative_to": self.relative_to,
            "gripper_open": self.gripper_open,
            "gripper_closed": self.gripper_closed,
            "description": self.description,
        }
        return {name: value for name, value in declared.items() if value is not None}


def pose_parts(frame: str) -> tuple[VectorPart, VectorPart]:
    """A position in metres, and an orientation as a quaternion w, x, y, z."""
    return (
        VectorPart("position", 3, "position", "m", frame),
        VectorPart("orientation", 4, "orientation", "1", frame, "quaternion_wxyz"),
    )


def vector(*parts: VectorPart, **members: Any) -> Json:
    """CONV-001: the VectorSpace of parts that follow one another; unbounded if no
    other `members` say so.
    """
    declared, size = {}, 0
    for part in parts:
        declared[part.name] = part.declare(size)
        size += part.size
    return {"size": size, "parts": declared, "out_of_range": "unbounded", **members}


def numbers(size: int, **members: Any) -> Json:
    """The VectorSpace of numbers that measure nothing."""
    return vector(VectorPart("all", size, "number", "1"), **members)


def unspecified_part(size: int) -> VectorPart:
    """The numbers of a vector of which only the size is known."""
    nothing = "unspecified"
    return VectorPart("all", size, nothing, nothing, nothing, nothing, nothing)


def bounds(size: int, low: float, high: float, out_of_range: str) -> Json:
    """The members of a VectorSpace whose numbers have one range."""
    return {
        "minimum": [low] * size,
        "maximum": [high] * size,
        "out_of_range": out_of_range,
    }


@dataclass(frozen=True, slots=True)
class Channel:
    """One named vector of an action or of an observation's state.

    low, high: bounds per element, inclusive; None means unbounded. An action beyond its
    bounds is executed as the nearest allowed one.
    """

    name: str
    parts: tuple[VectorPart, ...]
    meaning: str
    low: tuple[float, ...] | None = None
    high: tuple[float, ...] | None = None

    @property
    def size(self) -> int:
        return sum(part.size for part in self.parts)

    def space(self) -> Json:
        """The VectorSpace, with all conventions."""
        space = vector(*self.parts, description=self.meaning)
        if self.low is not None and self.high is not None:
            space |= {"minimum": list(self.low), "maximum": list(self.high)}
            space["out_of_range"] = "clip"
        return space
