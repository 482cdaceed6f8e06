"""The members of a description, which a program says about itself (SIM-008)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import (
    Field,
    ValidationError,
    ValidationInfo,
    field_validator,
    model_validator,
)

from reference_sim.external.described_map import DescribedMap
from reference_sim.external.external_simulator import DTYPES
from reference_sim.external.physical_cell import PhysicalCell
from reference_sim.gymnasium.benchmark_file import faults_of
from reference_sim.gymnasium.own_sources import FILES_MAX
from reference_sim.interface import ProgramFault
from reference_sim.vector_spaces import VectorPart, registered

# Members that the host's file may replace; they are checked with that file.
COMPLETED = (
    *("benchmark_id", "version", "title", "description", "splits", "max_steps"),
    *("control_rate_hz", "success_rule", "image_sizes", "image_codecs"),
)

Count = Annotated[int, Field(ge=1)]
Names = Annotated[list[str], Field(min_length=1)]
_Sha256 = Annotated[str, Field(pattern="^[0-9a-f]{64}$")]


class _Part(DescribedMap):
    start: Annotated[int, Field(ge=0)]
    size: Count
    quantity: str
    unit: str
    frame: str
    rotation: str
    relative_to: str
    scale: float | None = None
    gripper_open: float | None = None
    gripper_closed: float | None = None

    @field_validator("unit", "quantity", "frame", "rotation", "relative_to")
    @classmethod
    def _is_registered(cls, value: str, info: ValidationInfo) -> str:
        assert info.field_name is not None
        return registered(info.field_name, value)

    @model_validator(mode="after")
    def _can_be(self) -> Self:
        members = self.model_dump(include={*_Part.model_fields} - {"start"})
        VectorPart("", **members)  # raises ValueError for what cannot be
        return self


class _Vector(DescribedMap):
    size: Count
    parts: dict[str, _Part]
    out_of_range: Literal["refuse", "clip", "unbounded"]
    minimum: list[float] | None = None
    maximum: list[float] | None = None
    tasks: Names | None = None

    @model_validator(mode="after")
    def _is_whole(self) -> Self:
        reached = 0
        for name, part in sorted(self.parts.items(), key=lambda item: item[1].start):
            if part.start != reached:
                raise ValueError(f"part {name} starts at {part.start}, not {reached}")
            reached += part.size
        if reached != self.size:
            raise ValueError(f"the parts have {reached} numbers, not {self.size}")
        for bounds in (self.minimum, self.maximum):
            if bounds is not None and len(bounds) != self.size:
                raise ValueError(f"{len(bounds)} bounds for size {self.size}")
        if self.out_of_range != "unbounded" and None in (self.minimum, self.maximum):
            raise ValueError(f"out_of_range {self.out_of_range} needs both bounds")
        return self


class _Image(DescribedMap):
    channels: Annotated[int, Field(ge=1, le=4)]
    description: str
    tasks: Names | None = None


class _Tensor(DescribedMap):
    dtype: str
    shape: list[Annotated[int, Field(ge=0)]]
    description: str
    tasks: Names | None = None

    @field_validator("dtype")
    @classmethod
    def _is_known(cls, dtype: str) -> str:
        if dtype not in DTYPES:
            raise ValueError(f"dtype {dtype} is not one of {', '.join(DTYPES)}")
        return dtype


class _Observations(DescribedMap):
    others = ()
    state: Mapping[str, _Vector] = {}
    images: Mapping[str, _Image] = {}
    tensors: Mapping[str, _Tensor] = {}


class _Engine(DescribedMap):
    others = None
    name: str
    version: str


class ProgramDescription(DescribedMap):
    """The whole of it. Raises ValueError unless a robot has bounds and setups."""

    others = COMPLETED
    simulator: _Engine
    tasks: Names
    action_space: Annotated[dict[str, _Vector], Field(min_length=1)]
    observation_space: _Observations
    max_steps: Count
    graded: bool = False
    deterministic: bool = True
    digest: bool = False
    shared_memory: bool = False
    sources: Annotated[Mapping[str, _Sha256], Field(max_length=FILES_MAX)] = {}
    physical: PhysicalCell | None = None

    @model_validator(mode="after")
    def _is_safe(self) -> Self:
        if self.physical is None:
            return self
        for name, vector in self.action_space.items():  # SIM-034
            if vector.out_of_range == "unbounded":
                raise ValueError(f"action {name} of a robot needs bounds")
        self.physical.require_setups(self.tasks)
        return self


def read_description(described: Mapping[str, Any]) -> ProgramDescription:
    """Raises ProgramFault, with the place of each member that cannot be."""
    try:
        return ProgramDescription.model_validate(described)
    except ValidationError as error:
        raise ProgramFault(f"its description: {faults_of(error)}") from error
