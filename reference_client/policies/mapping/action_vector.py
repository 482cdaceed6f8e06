"""One vector of an action, and the part of the policy's answer that it is made of."""

from __future__ import annotations

from typing import Annotated, Any

import msgspec
import numpy as np
from msgspec import Meta

from reference_client.api.observation import Observation
from reference_client.policies.mapping.members import (
    Array,
    BadMapping,
    Bounds,
    Columns,
    Factors,
    Flag,
    Number,
    SizeMismatch,
    Text,
    check_factors,
    indices_of,
    read_members,
    width_of_columns,
    wrong_member,
)
from reference_client.policies.mapping.request_entry import part_of
from reference_record.texts.counted_text import counted


class ActionVector(msgspec.Struct, frozen=True):
    """One vector of the action, in the order of conversion.

    source: place in the answer, if different from the table's; the numbers of several
    are joined. Then: columns, threshold, scale, offset, cumulate, relative_to, clip; or
    `value`, a constant. cumulate: cumulative sum of the rows, as for velocities.
    relative_to: `state.NAME`, whose value before the chunk is added to every row.
    """

    source: Annotated[
        tuple[str, ...],
        Meta(description="a place in the answer as text, or a list of places"),
    ] = msgspec.field(default=(), name="from")
    columns: Columns | None = None
    threshold: Number | None = None
    scale: Factors = 1.0
    offset: Factors = 0.0
    cumulate: Flag = False
    relative_to: Annotated[Text | None, Meta(description="state.NAME")] = None
    clip: Bounds | None = None
    value: Factors | None = None

    def width(self, answered: int | None = None) -> int | None:
        """How many numbers the vector has; None if the answer alone decides.

        answered: how many the answer has, if it is there. Raises SizeMismatch.
        """
        if self.value is not None:
            return int(np.size(self.value))
        width = answered
        if self.columns is not None:
            width = width_of_columns("columns", self.columns, answered)
        width = check_factors("scale", self.scale, width)
        return check_factors("offset", self.offset, width)

    def deciding_member(self) -> str:
        """The member that decides how many numbers the vector has."""
        decides = {
            "value": self.value is not None,
            "columns": self.columns is not None,
            "scale": isinstance(self.scale, tuple),
        }
        return next((member for member, does in decides.items() if does), "offset")

    def check_start(self, start: int, width: int | None) -> None:
        """start: the width of relative_to; width: of the rows. Raises SizeMismatch."""
        if start != width:
            raise SizeMismatch(
                f"relative_to is {self.relative_to}, of {counted(start, 'number')}, "
                f"for {width}"
            )

    def of(self, rows: Array, observation: Observation) -> Array:
        """rows: (actions, numbers) of the answer. Returns (actions, size).

        Raises SizeMismatch.
        """
        width = self.width(rows.shape[1])
        chosen = rows
        if self.columns is not None:
            chosen = rows[:, list(indices_of(self.columns))]
        if self.threshold is not None:
            chosen = (chosen > self.threshold).astype(np.float64)
        chosen = chosen * np.asarray(self.scale) + np.asarray(self.offset)
        if self.cumulate:
            chosen = np.cumsum(chosen, axis=0)
        if self.relative_to is not None:
            start = part_of(observation, self.relative_to)
            self.check_start(len(start), width)
            chosen = chosen + start
        return chosen if self.clip is None else np.clip(chosen, *self.clip)


def read_vector(at: str, table: Any) -> ActionVector:
    """The vector of a table of the file. Raises BadMapping."""
    vector = read_members(ActionVector, at, table)
    if vector.value is not None and len(table) > 1:
        (first, *_) = sorted(set(table) - {"value"})
        raise BadMapping(f"{at}: {first} is not for an entry with `value`")
    if vector.columns is not None and not indices_of(vector.columns):
        raise wrong_member(ActionVector, at, "columns", table["columns"])
    if vector.relative_to is not None and not vector.relative_to.startswith("state."):
        raise wrong_member(ActionVector, at, "relative_to", vector.relative_to)
    if vector.clip is not None and not vector.clip[0] < vector.clip[1]:
        raise wrong_member(ActionVector, at, "clip", table["clip"])
    return vector
