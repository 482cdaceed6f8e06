"""The output of the command: tables at 80 columns, or one JSON value for scripts.

Texts of a server pass `printable` here, and JSON has escapes of its own.

Results go to stdout; progress, notes and errors go to stderr.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Mapping, Sequence
from typing import Any, Self

from proctor_client import (
    Benchmark,
    BenchmarkSummary,
    ComparedRun,
    Comparison,
    Episode,
    GroupScore,
    Run,
    Score,
)
from pydantic_core import to_jsonable_python
from rich.console import Console
from rich.progress import BarColumn, TaskID, TextColumn, TimeElapsedColumn
from rich.progress import Progress as Bars
from rich.table import Table

from reference_client.command.exit_codes import with_flag_names
from reference_client.evaluation.status_board import Progress
from reference_client.printable_text import printable

LOG_S = 10.0  # between two lines of progress where stderr is no terminal


class Printer:
    """Prints results and messages; as_json: results are one JSON value on stdout."""

    def __init__(self, *, as_json: bool) -> None:
        self.as_json = as_json
        # Kept from now: during an evaluation, sys.stdout is redirected to stderr.
        self._stdout = sys.stdout
        self._out = Console(
            file=self._stdout, highlight=False, markup=False, emoji=False
        )
        self.err = Console(stderr=True, highlight=False, markup=False, emoji=False)

    def say(self, line: str) -> None:
        """Print a message to stderr."""
        self.err.print(printable(line), soft_wrap=True)

    def answer(self, value: Any, *tables: Table | str) -> None:
        """Print the result to stdout: `value` as JSON, or the tables."""
        if self.as_json:
            self._stdout.write(json.dumps(to_jsonable_python(value)) + "\n")
            self._stdout.flush()
            return
        for number, table in enumerate(tables):
            if number:
                self._out.print()
            if isinstance(table, str):
                self._out.print(printable(table), soft_wrap=True)
            else:
                self._out.print(table)


class ProgressDisplay:
    """Shows progress: a bar on a terminal, otherwise a line every LOG_S seconds.

    A context manager that ends the bar.
    """

    def __init__(self, printer: Printer) -> None:
        self._printer = printer
        self._waiting: str | None = None
        self._logged_at = time.monotonic()
        self._logged = -1
        self._bars: Bars | None = None
        self._task: TaskID | None = None
        self.latest: Progress | None = None
        if printer.err.is_terminal:
            self._bars = Bars(
                TextColumn("{task.fields[done]}"),
                BarColumn(bar_width=None),
                TextColumn("{task.fields[mean]}"),
                TimeElapsedColumn(),
                console=printer.err,
                refresh_per_second=4,
            )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.end()

    def end(self) -> None:
        if self._bars is not None:
            self._bars.stop()

    def __call__(self, progress: Progress) -> None:
        self.latest = progress
        if progress.waiting != self._waiting:
            self._waiting = progress.waiting
            if progress.waiting is not None:
                self._printer.say(with_flag_names(progress.waiting))
        if self._bars is None:
            self._log(progress)
            return
        fields: dict[str, Any] = {
            "done": episodes_text(progress),
            "mean": mean_of(progress),
        }
        if self._task is None:
            self._bars.start()
            self._task = self._bars.add_task("", total=None, **fields)
        self._bars.update(
            self._task,
            total=progress.episodes_total,
            completed=progress.episodes_scored,
            **fields,
        )

    def _log(self, progress: Progress) -> None:
        now = time.monotonic()
        if progress.episodes_scored == self._logged or now < self._logged_at + LOG_S:
            return
        self._logged_at, self._logged = now, progress.episodes_scored
        self._printer.say(f"{episodes_text(progress)}  {mean_of(progress)}")


def episodes_text(progress: Progress) -> str:
    return f"{progress.episodes_scored}/{progress.episodes_total} episodes"


def mean_of(progress: Progress) -> str:
    return "no score yet" if progress.mean is None else f"mean {progress.mean:.3f}"


class PrintableTable(Table):
    """A table whose cells are texts of a server."""

    def add_row(self, *cells: Any, **options: Any) -> None:
        super().add_row(*(printable(str(cell)) for cell in cells), **options)


def fact_table(rows: Mapping[str, object]) -> Table:
    """A table of names and values, without borders; None values are omitted."""
    table = PrintableTable(box=None, show_header=False, pad_edge=False)
    table.add_column(no_wrap=True)
    table.add_column(overflow="fold")
    for name, value in rows.items():
        if value is not None:
            table.add_row(name, str(value))
    return table


def run_facts(run: Run) -> Table:
    progress = run.progress
    return fact_table(
        {
            "run": run.run_id,
            "state": run.state.value,
            "reason": run.reason,
            "benchmark": f"{run.benchmark_id}, version {run.benchmark_version}",
            "policy": run.policy.name,
            "episodes": f"{progress.episodes_scored} of {progress.episodes_total} "
            f"scored, {progress.episodes_in_progress} in progress",
            "workers": f"{run.live_workers} live, at most {run.max_workers}",
            "queue": run.queue_position,
            "endpoint": run.endpoint,
            "submitted": f"{run.created_at:%Y-%m-%d %H:%M:%S %Z}",
        }
    )


def run_list(runs: Sequence[Run]) -> Table | str:
    if not runs:
        return "No runs."
    table = _table("run", "state", "benchmark", "policy", "scored")
    for run in runs:
        scored, total = run.progress.episodes_scored, run.progress.episodes_total
        table.add_row(
            run.run_id,
            run.state.value,
            run.benchmark_id,
            run.policy.name,
            f"{scored}/{total}",
        )
    return table


def score_facts(score: Score) -> Table:
    counts = score.counts
    mean, rate = score.mean_interval, score.success_interval
    scored = counts.total - counts.unscored
    return fact_table(
        {
            "run": score.run_id,
            "state": score.state.value,
            "benchmark": score.benchmark_id,
            "score": f"{score.score:.4f}"
            if score.score is not None
            else f"not complete: between {score.score_low:.4f} and "
            f"{score.score_high:.4f}",
            "mean": f"{score.mean:.4f}, 95 % interval {mean.low:.4f} to {mean.high:.4f}"
            if score.mean is not None
            else None,
            "success": f"{counts.success} of {scored} scored, 95 % interval "
            f"{rate.low:.4f} to {rate.high:.4f}",
            "episodes": f"{counts.total}: {counts.success} success, "
            f"{counts.failure} failure, {counts.abandoned} abandoned, "
            f"{counts.unscored} unscored",
            "manifest": score.manifest_sha256,
        }
    )


def group_table(title: str, by_name: Mapping[str, GroupScore]) -> Table:
    table = _table(title, ">scored", ">success", ">mean")
    for name, group in by_name.items():
        counts = group.counts
        table.add_row(
            name,
            f"{counts.total - counts.unscored}/{counts.total}",
            str(counts.success),
            "–" if group.mean is None else f"{group.mean:.3f}",
        )
    return table


def comparison_tables(comparison: Comparison, run: ComparedRun) -> list[Table]:
    """One run compared with the baseline: a summary, and a row for each task."""
    alone = f"{run.wins} wins, {run.losses} losses, {run.ties} ties"
    head = fact_table(
        {
            "run": run.run_id,
            "baseline": comparison.baseline,
            "benchmark": comparison.benchmark_id,
            "pairs": f"{run.paired} episodes are scored in both"
            + ("" if run.complete else "; incomplete"),
            "difference": None
            if run.difference is None
            else f"{run.difference:+.4f}: baseline {run.baseline_mean:.4f}, run "
            f"{run.mean:.4f}",
            "successes": f"{alone}; p = {run.p_value:.4f} (exact McNemar)",
            "release": _release(comparison, run),
        }
    )
    table = _table("task", ">pairs", ">baseline", ">run", ">difference")
    for task, group in run.by_task.items():
        numbers = (group.baseline_mean, group.mean)
        table.add_row(
            task,
            str(group.paired),
            *("–" if number is None else f"{number:.3f}" for number in numbers),
            "–" if group.difference is None else f"{group.difference:+.3f}",
        )
    return [head, table]


def _release(comparison: Comparison, run: ComparedRun) -> str:
    if run.release:
        return f"yes: no difference exceeds {comparison.tolerance:g}"
    if not run.complete:
        return "no: not every episode is scored in both"
    groups = {"overall": run.difference}
    groups |= {task: group.difference for task, group in run.by_task.items()}
    # The server decides; this only names the groups that exceed the tolerance.
    far = [
        n for n, d in groups.items() if d is not None and abs(d) > comparison.tolerance
    ]
    return f"no: difference exceeds {comparison.tolerance:g} in {', '.join(far)}"


def episode_list(episodes: Sequence[Episode]) -> Table:
    table = _table("episode", "task", "split", "status", ">score", ">steps", ">attempt")
    for episode in episodes:
        result = episode.result
        table.add_row(
            episode.episode_id,
            episode.task,
            episode.split,
            result.outcome.value if result else episode.status.value,
            f"{result.score:.3f}" if result else "–",
            str(result.steps) if result else "–",
            str(episode.attempt),
        )
    return table


def benchmark_list(benchmarks: Sequence[BenchmarkSummary]) -> Table:
    table = _table("benchmark", "version", ">episodes", "title")
    for one in benchmarks:
        table.add_row(one.benchmark_id, one.version, str(one.episodes_total), one.title)
    return table


def benchmark_tables(benchmark: Benchmark) -> list[Table]:
    sizes = ", ".join(f"{s.width}x{s.height}" for s in benchmark.image_sizes)
    codecs = ", ".join(benchmark.image_codecs)
    head = fact_table(
        {
            "benchmark": f"{benchmark.benchmark_id}, version {benchmark.version}",
            "title": benchmark.title,
            "description": benchmark.description,
            "unavailable": benchmark.unavailable_reason,
            "episodes": f"{benchmark.episodes_total}, at most {benchmark.max_steps} "
            f"steps each, {benchmark.control_rate_hz:g} steps per second",
            "tasks": ", ".join(benchmark.tasks),
            "splits": ", ".join(benchmark.splits),
            "chunk": f"at most {benchmark.max_chunk} actions",
            "images": f"{codecs}; {sizes}",
            "manifest": benchmark.manifest_sha256,
        }
    )
    space = benchmark.observation_space
    spaces = _table("name", ">size", "unit", "description")
    for group, vectors in (("action", benchmark.action_space), ("state", space.state)):
        for name, vector in vectors.items():
            spaces.add_row(
                f"{group}.{name}", str(vector.size), vector.unit, vector.description
            )
    for name, image in space.images.items():
        spaces.add_row(f"images.{name}", str(image.channels), "", image.description)
    for name, tensor in space.tensors.items():
        spaces.add_row(
            f"tensors.{name}",
            "x".join(map(str, tensor.shape)),
            tensor.dtype,
            tensor.description,
        )
    return [head, spaces]


def _table(*columns: str) -> Table:
    """A table; columns whose name begins with > are right-aligned."""
    table = PrintableTable(box=None, pad_edge=False)
    for number, name in enumerate(columns):
        table.add_column(
            name.lstrip(">"),
            no_wrap=number == 0,  # an id or a name, to be copied
            justify="right" if name.startswith(">") else "left",
            overflow="fold",
        )
    return table
