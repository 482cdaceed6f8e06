"""Mutants of the profile `physical`, as far as a kit without an operator sees them."""

from __future__ import annotations

from typing import Any

from reference_server.http.dispatch import Operation
from reference_server.profiles.physical.cell_handlers import CellHandlers
from reference_sim.external.physical_cell import PhysicalCell
from tests.mutants import instead_of, mutant


@mutant("PHY-001", through=instead_of(PhysicalCell, "manifest"))
def leaves_out_who_judges_blind(right: Any, self: PhysicalCell) -> Any:
    """A reader cannot know whether judges knew the policy."""
    declared = right(self)
    del declared["blind"]
    return declared


@mutant("PHY-013", through=instead_of(CellHandlers, "table"))
def lets_every_reader_operate_a_robot(right: Any, self: CellHandlers) -> Any:
    """Every token that may read runs takes a robot over."""
    table: dict[str, dict[str, Operation]] = right(self)
    for operations in table.values():
        for operation in operations.values():
            object.__setattr__(operation, "scope", "read")
    return table
