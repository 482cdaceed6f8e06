"""The action space of a benchmark: names, sizes and ranges, in the declared order.

Splits rows of numbers into named vectors, describes the expected shape in refusals, and
counts the numbers that the server clips. It sends nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from reference_record.contents.declared_parts import declared_parts
from reference_record.texts.counted_text import counted

# Rounding to float32 does not count as clipping; relative to the width of the range.
_ROUNDING = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class VectorLayout:
    """One named vector.

    low, high: the range outside which the server clips, if any, widened by rounding.
    declared: the lowest and the highest number of the range, as the benchmark has it.
    """

    name: str
    size: int
    unit: str = ""
    low: tuple[float, ...] | None = None
    high: tuple[float, ...] | None = None
    declared: tuple[float, float] | None = None


@dataclass(frozen=True, slots=True, eq=False)
class ActionLayout:
    """The vectors of an action of `benchmark_id`, in the order of a row of numbers."""

    benchmark_id: str
    vectors: tuple[VectorLayout, ...]
    names: frozenset[str] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "names", frozenset(v.name for v in self.vectors))

    @classmethod
    def of(
        cls, benchmark_id: str, action_space: Mapping[str, Mapping[str, Any]]
    ) -> ActionLayout | None:
        """From the member `action_space` of a benchmark, as JSON.

        None if a vector is of some tasks only: then an action has no fixed shape.
        """
        if any(space.get("tasks") is not None for space in action_space.values()):
            return None
        return cls(
            benchmark_id,
            tuple(_vector(name, space) for name, space in action_space.items()),
        )

    @property
    def size(self) -> int:
        return sum(vector.size for vector in self.vectors)

    def split(self, row: Sequence[float]) -> dict[str, list[float]]:
        """The named vectors of a row of `size` numbers."""
        values, first = {}, 0
        for vector in self.vectors:
            values[vector.name] = list(row[first : first + vector.size])
            first += vector.size
        return values

    def describe(self) -> str:
        """`joint_position 7, gripper 1, or an array of 8 in this order`."""
        sizes = ", ".join(f"{vector.name} {vector.size}" for vector in self.vectors)
        if len(self.vectors) == 1:
            return f"{sizes}, or an array of {self.size}"
        return f"{sizes}, or an array of {self.size} in this order"

    def clipped_names(self, values: Mapping[str, Sequence[float]]) -> dict[str, int]:
        """Name → how many of its numbers are outside the declared range."""
        counts = {}
        for vector in self.vectors:
            if vector.low is None or vector.high is None:
                continue
            count = sum(
                not low <= number <= high
                for number, low, high in zip(
                    values[vector.name], vector.low, vector.high, strict=False
                )
            )
            if count:
                counts[vector.name] = count
        return counts

    def range_of(self, name: str) -> str:
        """`[-2.9, 2.9] rad`, the widest range of the vector's numbers."""
        (vector,) = [v for v in self.vectors if v.name == name]
        assert vector.declared is not None
        low, high = vector.declared
        unit = vector.unit and f" {vector.unit}"
        return f"[{low:.4g}, {high:.4g}]{unit}"


def _vector(name: str, space: Mapping[str, Any]) -> VectorLayout:
    size, parts = space["size"], declared_parts(space).values()
    units = {"" if part.unit == "unspecified" else part.scaled_unit for part in parts}
    unit = units.pop() if len(units) == 1 else ""
    low, high = space.get("minimum"), space.get("maximum")
    if space.get("out_of_range") != "clip" or not low or not high:
        return VectorLayout(name, size, unit)
    slack = [_ROUNDING * (1.0 + b - a) for a, b in zip(low, high, strict=True)]
    return VectorLayout(
        name,
        size,
        unit,
        tuple(a - s for a, s in zip(low, slack, strict=True)),
        tuple(b + s for b, s in zip(high, slack, strict=True)),
        (min(low), max(high)),
    )


@dataclass(slots=True)
class ClipCount:
    """How many of the executed actions of an episode, or of a run, were clipped.

    numbers: name → how many of its numbers. An action counts once.
    """

    actions: int = 0
    clipped: int = 0
    numbers: dict[str, int] = field(default_factory=dict)

    def add_action(self, clipped: Mapping[str, int]) -> None:
        self.add(ClipCount(1, int(bool(clipped)), dict(clipped)))

    def add(self, other: ClipCount) -> None:
        self.actions += other.actions
        self.clipped += other.clipped
        for name, number in other.numbers.items():
            self.numbers[name] = self.numbers.get(name, 0) + number

    @property
    def is_most(self) -> bool:
        return self.clipped * 2 > self.actions

    def describe(self) -> str:
        """`45 of 50 actions were clipped …`, with how many numbers of each vector."""
        names = ", ".join(f"{name} {n}" for name, n in self.numbers.items())
        return (
            f"{self.clipped} of {counted(self.actions, 'action')} were clipped to the "
            f"declared range (numbers outside: {names})"
        )
