"""The cells of a server: one for each benchmark that a robot plays."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from reference_server.cells.act_log import ActLog
from reference_server.cells.judged_run import judged_run, second_judgements
from reference_server.cells.robot_cell import RobotCell
from reference_server.cells.second_judge import SecondJudge
from reference_server.rules.manifest import Manifest
from reference_server.rules.run import Run


class Cells:
    """A cell has the id of its benchmark."""

    def __init__(self, acts: ActLog) -> None:
        self.acts, self.second_judge = acts, SecondJudge(acts)
        self._cells: dict[str, RobotCell] = {}

    async def open(self) -> None:
        """Read the acts of earlier. Raises OSError and ValueError."""
        self.acts.open()

    def get(self, cell_id: str) -> RobotCell | None:
        """The cell, if a run has used it or it was shown: a stop looks no further."""
        return self._cells.get(cell_id)

    def judged(self, run_id: str) -> dict[str, Any] | None:
        """Schema JudgedRun; None of a run that no person has judged."""
        return judged_run(self.acts.of_run(run_id), self.acts.pseudonym)

    def second_judgements(self, run_id: str) -> list[dict[str, Any]]:
        """As the statement of the record of the run has them."""
        return second_judgements(self.acts.of_run(run_id), self.acts.pseudonym)

    def find(self, run: Run) -> RobotCell | None:
        """The cell that plays the run; None for one that a simulator plays."""
        return self.of_manifest(run.manifest)

    def all(self, manifests: Iterable[Manifest]) -> list[RobotCell]:
        """The cell of each benchmark that a robot plays."""
        cells = map(self.of_manifest, manifests)
        return [cell for cell in cells if cell is not None]

    def of_manifest(self, manifest: Manifest) -> RobotCell | None:
        physical = manifest.get("physical")
        if physical is None:
            return None
        cell_id = manifest["benchmark_id"]
        if cell_id not in self._cells:
            self._cells[cell_id] = RobotCell(
                cell_id,
                physical,
                self.acts,
                tuple(manifest["observation_space"].get("images", ())),
            )
        return self._cells[cell_id]
