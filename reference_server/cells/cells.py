"""The cells of a server: one or several for each benchmark that robots play."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from reference_record.contents.statement import SecondJudgement
from reference_record.generated.answers import JudgedRun
from reference_server.cells.act_log import ActLog
from reference_server.cells.cell_queue import CellQueue
from reference_server.cells.judged_run import judged_run, second_judgements
from reference_server.cells.robot_cell import RobotCell
from reference_server.cells.second_judge import SecondJudge
from reference_server.rules.manifest import Manifest
from reference_server.rules.runs.run import Run
from reference_sim import benchmark_registry


class Cells:
    """A cell has the id of its benchmark, and a name behind it if that has several."""

    def __init__(self, acts: ActLog) -> None:
        self.acts, self.second_judge = acts, SecondJudge(acts)
        self._queues: dict[str, CellQueue] = {}
        self._cells: dict[str, RobotCell] = {}

    async def open(self) -> None:
        """Read the acts of earlier. Raises OSError and ValueError."""
        self.acts.open()

    def get(self, cell_id: str) -> RobotCell | None:
        """The cell, if a run has used it or it was shown: a stop looks no further."""
        return self._cells.get(cell_id)

    def judged(self, run_id: str) -> JudgedRun | None:
        """How people judged a run; None of a run that no person has judged."""
        return judged_run(self.acts.of_run(run_id), self.acts.pseudonym)

    def second_judgements(self, run_id: str) -> list[SecondJudgement]:
        """As the statement of the record of the run has them."""
        return second_judgements(self.acts.of_run(run_id), self.acts.pseudonym)

    def find(self, run: Run) -> CellQueue | None:
        """The queue for the cells that play the run; None if a simulator does."""
        return self.queue_of(run.manifest)

    def all(self, manifests: Iterable[Manifest]) -> list[RobotCell]:
        """The cells of each benchmark that robots play."""
        queues = {queue for queue in map(self.queue_of, manifests) if queue is not None}
        return [cell for cell in self._cells.values() if cell.queue in queues]

    def queue_of(self, manifest: Manifest) -> CellQueue | None:
        physical = manifest.get("physical")
        if physical is None:
            return None
        benchmark_id = manifest["benchmark_id"]
        queue = self._queues.get(benchmark_id)
        if queue is None:
            seed = physical["order_seed"]
            queue = CellQueue(benchmark_id, seed, self.acts.lines)
            self._queues[benchmark_id] = queue
            cameras = tuple(manifest["observation_space"].get("images", ()))
            for cell_id, command in _commands(benchmark_id).items():
                cell = RobotCell(
                    cell_id,
                    physical,
                    self.acts,
                    queue,
                    cameras=cameras,
                    command=command,
                )
                queue.cells.append(cell)
                self._cells[cell_id] = cell
        return queue


def _commands(benchmark_id: str) -> Mapping[str, Sequence[str]]:
    """The id of each cell, and how its robot is reached; empty: by the benchmark's."""
    if benchmark_id not in benchmark_registry.benchmark_ids():
        return {benchmark_id: ()}
    plan = benchmark_registry.resolve(benchmark_id).world.settings.get("plan", {})
    cells: Mapping[str, Sequence[str]] = plan.get("cells", {})
    return {f"{benchmark_id}_{name}": command for name, command in cells.items()} or {
        benchmark_id: ()
    }
