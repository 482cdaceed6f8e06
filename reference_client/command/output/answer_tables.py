"""Tables of what a server answers: runs, scores, comparisons, episodes, benchmarks."""

from __future__ import annotations

import statistics
from collections import defaultdict
from collections.abc import Mapping, Sequence, Sized
from datetime import UTC

from proctor_client import (
    Benchmark,
    BenchmarkSummary,
    ComparedRun,
    Comparison,
    Episode,
    EpisodeResult,
    GroupScore,
    Run,
    Score,
)

from reference_client.command.command_line.chosen_server import command_text
from reference_client.command.output.episode_facts import (
    episode_facts,
    label_of,
    played_by,
    player_facts,
)
from reference_client.command.output.text_tables import Prose, TextTable, fact_table
from reference_record.command_line.click_commands import Options
from reference_record.comparison.difference_evidence import Evidence, p_text
from reference_record.comparison.judge_agreement import agreement_text
from reference_record.comparison.release import explain_release
from reference_record.comparison.sequential_comparison import (
    SequentialComparison,
    describe,
)
from reference_record.contents.declared_parts import declared_parts
from reference_record.contents.score import ScoredLine, compute_score, wilson_interval
from reference_record.generated import answers
from reference_record.texts.benchmark_part import part_text
from reference_record.texts.counted_text import counted
from reference_record.texts.figures import difference_figure, figure
from reference_record.texts.score_headline import (
    mix_of,
    notes_on,
    score_cell,
    score_headline,
)


def run_facts(
    args: Options,
    run: Run,
    score: Score | None = None,
    episodes: Sequence[Episode] = (),
) -> TextTable:
    """args: of the command, which name the server."""
    progress = run.progress
    return fact_table(
        {
            "run": run.run_id,
            "state": run.state.value,
            "reason": run.reason,
            "to go on": command_text(args, "resume", run.run_id)
            if run.retryable
            else None,
            "benchmark": f"{run.benchmark_id}, version {run.benchmark_version}",
            "part": part_of(run),
            "policy": run.policy.name
            + (f", version {run.policy.version}" if run.policy.version else "")
            + ("; others may play, too" if run.any_policy else ""),
            **player_facts(episodes, run),
            "score": None if score is None else score_headline(score.to_dict()),
            "episodes": f"{progress.episodes_scored} of {progress.episodes_total} "
            f"scored, {progress.episodes_in_progress} in progress",
            "workers": f"{run.live_workers} live, at most {run.max_workers}",
            "earlier runs": earlier_runs_text(run),
            "queue": run.queue_position,
            "endpoint": run.endpoint,
            "submitted": f"{run.created_at.astimezone(UTC):%Y-%m-%d %H:%M:%S %Z}",
        }
    )


def earlier_runs_text(run: Run) -> str | None:
    """The number of runs before this one: a score may be the best of many tries.

    None where the server does not count them.
    """
    number = run.runs_played_before
    if number is None:
        return None
    played = f"{number or 'no'} run{'s' * (number != 1)} of this benchmark"
    return f"{played} played by its account before this one"


def run_list(
    runs: Sequence[Run], scores: Mapping[str, Score], next_page: str | None = None
) -> list[TextTable | str]:
    """scores: by run id, of those that have one. next_page: how to read on."""
    if not runs:
        return [Prose("No runs.")]
    # A host sees the runs of all: whose they are, and who holds simulators.
    is_of_host = len({run.account for run in runs}) > 1
    of_host = ("account", ">live workers") if is_of_host else ()
    names = ("benchmark", "policy", ">scored", ">score", "submitted")
    table = TextTable(
        ("run", "state", *of_host, *names),
        dispensable=("submitted", "scored", "benchmark"),
    )
    for run in runs:
        scored, total = run.progress.episodes_scored, run.progress.episodes_total
        table.add(
            run.run_id,
            run.state.value,
            *((run.account or "", str(run.live_workers)) if is_of_host else ()),
            run.benchmark_id + ("" if run.select is None else " (a part)"),
            run.policy.name,
            f"{scored}/{total}",
            _cell_of(scores.get(run.run_id)),
            f"{run.created_at.astimezone(UTC):%Y-%m-%d %H:%M %Z}",
        )
    notes = notes_on(map(_cell_of, scores.values()))
    return [table, *map(Prose, filter(None, [notes, next_page]))]


def _cell_of(score: Score | None) -> str:
    return score_cell(None if score is None else score.to_dict())


def _score_facts(
    score: Score,
    facts: Mapping[str, str | None],
    run: Run | None = None,
) -> TextTable:
    """facts: what is known of the episodes."""
    counts = score.counts
    mean, rate = score.mean_interval, score.success_interval
    scored = counts.total - counts.unscored
    mixed = f"; {mix}" if (mix := mix_of(score.to_dict())) else ""
    return fact_table(
        {
            "run": score.run_id,
            "state": score.state.value,
            "benchmark": score.benchmark_id,
            "part": part_of(score),
            "score": score_headline(score.to_dict()),
            "mean": f"{figure(score.mean, 4)}, 95 % Wilson interval "
            f"{figure(mean.low, 4)} to {figure(mean.high, 4)}{mixed}"
            if score.mean is not None
            else None,
            "success": f"{counts.success} of {scored} scored, 95 % Wilson interval "
            f"{figure(rate.low, 4)} to {figure(rate.high, 4)}{mixed}",
            "episodes": f"{counts.total}: {counts.success} success, "
            f"{counts.failure} failure, {counts.abandoned} abandoned, "
            f"{counts.unscored} unscored",
            **facts,
            **_judgement_facts(run),
            "earlier runs": None if run is None else earlier_runs_text(run),
            "manifest": score.manifest_sha256,
        }
    )


def _judgement_facts(run: Run | None) -> dict[str, str | None]:
    """Rows for a run on a robot: who judged it, what did not count, what they wrote."""
    judged = None if run is None else run.judged
    if judged is None:
        return {}
    blind = "blind" if judged.blind else "who knew the policy"
    people = f"{', '.join(judged.judges)}, {blind}" if judged.judges else None
    voids = [f"{number}: {reason}" for reason, number in judged.voids.items()]
    notes = [f"{episode}: {note}" for episode, note in judged.notes.items()]
    second = judged.second
    return {
        "judged by": people,
        "second judge": None if second is None else agreement_text(second.model_dump()),
        "cells": _cells_text(judged.cells or {}),
        "void trials": "; ".join(voids) or "none",
        "notes": "; ".join(notes) or None,
    }


def _cells_text(cells: Mapping[str, str]) -> str | None:
    """Which cell has played which episodes, where there are several."""
    episodes: defaultdict[str, list[str]] = defaultdict(list)
    for episode, cell in sorted(cells.items()):
        episodes[cell].append(episode)
    texts = [f"{cell}: {', '.join(some)}" for cell, some in sorted(episodes.items())]
    return "; ".join(texts) or None


def part_of(selected: Run | Score) -> str | None:
    """The part of the benchmark that it is of; None is the whole."""
    select = selected.select
    return None if select is None else part_text(select.to_dict())


def score_tables(
    score: Score,
    episodes: Sequence[Episode] = (),
    run: Run | None = None,
    *,
    is_record: bool = False,
) -> list[TextTable]:
    """The facts, then splits before tasks.

    is_record: the episodes are of a record, which says nothing of faults and leases.
    """
    if is_record:
        facts = {"played by": played_by(episodes, run)}
    else:
        facts = episode_facts(episodes, run)
    return [
        _score_facts(score, facts, run),
        group_table("split", score.by_split),
        group_table(_task_title(score.by_split), score.by_task),
    ]


def _task_title(splits: Sized) -> str:
    """The head of rows of tasks, whose numbers are over all splits."""
    return "task" if len(splits) < 2 else "task, splits mixed"


def repeat_tables(scores: Sequence[Score]) -> list[TextTable]:
    """A row for each run, then mean and spread over the runs."""
    table = TextTable(("run", ">score", ">success", ">scored"))
    for score in scores:
        counts = score.counts
        scored = f"{counts.total - counts.unscored}/{counts.total}"
        table.add(score.run_id, _cell_of(score), str(counts.success), scored)
    mean, spread = mean_and_spread(scores)
    mixed = [mix_of(score.to_dict()) for score in scores]
    over = f"over {counted(len(scores), 'run')}"
    if notes := notes_on(map(_cell_of, scores)):
        over += f". {notes.removesuffix('.')}"
    return [
        table,
        fact_table(
            {
                "mean": f"{'mix ' * any(mixed)}{figure(mean, 4)} {over}",
                "spread": f"{figure(spread, 4)}, the standard deviation {over}",
            }
        ),
    ]


def mean_and_spread(scores: Sequence[Score]) -> tuple[float, float]:
    """Mean of the runs' means, and their sample standard deviation, 0 for one run."""
    means = [score.mean for score in scores if score.mean is not None]
    if not means:
        return 0.0, 0.0
    return statistics.mean(means), statistics.stdev(means) if len(means) > 1 else 0.0


def group_table(title: str, by_name: Mapping[str, GroupScore]) -> TextTable:
    table = TextTable((title, ">scored", ">success", ">mean"))
    for name, group in by_name.items():
        counts = group.counts
        table.add(
            name,
            f"{counts.total - counts.unscored}/{counts.total}",
            str(counts.success),
            "–" if group.mean is None else figure(group.mean, 3),
        )
    return table


def comparison_tables(
    comparison: Comparison,
    run: ComparedRun,
    players: Mapping[str, str | None],
    watched: SequentialComparison,
    *,
    evidence: Evidence,
    earlier: Mapping[str, int | None],
    part: str | None,
    by_split: Mapping[str, tuple[float, float]],
) -> list[TextTable]:
    """One run compared with the baseline: a summary, and a row for each task.

    Plus is better: a difference is run minus baseline, although the protocol's member
    `difference` is baseline minus run. players: who played, by run id. watched: what
    may be looked at while the run is played. evidence: of this run.
    earlier: runs played before, by run id. part: of the benchmark, if it is not the
    whole. by_split: means of the baseline and run.
    """
    alone = f"{run.wins} of the run alone, {run.losses} of the baseline alone"
    whole = evidence.overall
    head = fact_table(
        {
            "run": run.run_id,
            "played by": players.get(run.run_id),
            "baseline": comparison.baseline,
            "baseline played by": players.get(comparison.baseline),
            "benchmark": comparison.benchmark_id,
            "part": part,
            "earlier runs": _earlier_of_both(
                earlier.get(comparison.baseline), earlier.get(run.run_id)
            ),
            "pairs": counted(run.paired, "episode is", "episodes are")
            + " scored in both"
            + ("" if run.complete else "; incomplete"),
            "difference": _difference_text(run, by_split),
            "scores": f"{counted(whole.better, 'episode')} better, {whole.worse} worse",
            "successes": f"{alone}; p {p_text(run.p_value)} (exact McNemar)",
            "may stop": describe(watched),
            "release": explain_release(run, comparison.tolerance, evidence, watched),
        }
    )
    title = _task_title(by_split)
    table = TextTable((title, ">pairs", ">baseline", ">run", ">difference"))
    for task, group in run.by_task.items():
        before, now = group.baseline_mean, group.mean
        table.add(
            task,
            str(group.paired),
            *("–" if mean is None else figure(mean, 3) for mean in (before, now)),
            "–" if before is None or now is None else difference_figure(now, before, 3),
        )
    return [head, table]


def _difference_text(
    run: ComparedRun, by_split: Mapping[str, tuple[float, float]]
) -> str | None:
    """The difference; over several splits, each of theirs stands before their mix.

    Where not all episodes are scored, it says of which episodes and splits it is.
    """
    if run.baseline_mean is None or run.mean is None:
        return None
    baseline, mean = figure(run.baseline_mean, 4), figure(run.mean, 4)
    text = difference_figure(run.mean, run.baseline_mean, 4)
    if not run.complete:
        text += f" of the {counted(run.paired, 'episode')} scored in both"
    text += f": baseline {baseline}, run {mean} (plus is better; it has no interval)"
    if len(by_split) < 2:
        return text if run.complete else f"{' '.join(by_split)} {text}"
    splits = (
        f"{split} {difference_figure(mean, baseline_mean, 4)}"
        for split, (baseline_mean, mean) in by_split.items()
    )
    return f"{', '.join(splits)}; all splits mixed {text}"


def paper_table(
    names: Sequence[str], episodes: Sequence[Sequence[Episode]]
) -> TextTable:
    """Splits and tasks × policies, each mean with its interval, for a publication.

    Each row is of one split: all of it, and then its tasks.
    names, episodes: of the policies, one for each.
    """
    table = TextTable(("", ">episodes", *(f">{name}" for name in names)))
    splits = list(dict.fromkeys(episode.split for episode in episodes[0]))
    for split in splits:
        scores = [_score_of(split, some) for some in episodes]
        tasks = scores[0]["by_task"]
        rows = {task: [s["by_task"][task] for s in scores] for task in tasks}
        if len(splits) > 1:
            rows = {f"{split}: {task}": cells for task, cells in rows.items()}
        rows = {f"split {split}": [s["by_split"][split] for s in scores]} | rows
        for name, groups in rows.items():
            total = groups[0]["counts"]["total"]
            table.add(name, str(total), *map(_mean_text, groups))
    return table


def _score_of(split: str, episodes: Sequence[Episode]) -> answers.ComputedScore:
    return compute_score(
        [
            ScoredLine(
                episode.task,
                episode.split,
                episode.result.outcome.value if episode.result else None,
                episode.result.score if episode.result else None,
            )
            for episode in episodes
            if episode.split == split
        ]
    )


def paper_note(runs: Sequence[Run], splits: Sized) -> Prose:
    """Explain the numbers of `paper_table` to readers of the table alone."""
    first = runs[0]
    of_split = " of one split" if len(splits) > 1 else ""
    part = f", {text}" if (text := part_of(first)) else ""
    return Prose(
        f"Benchmark {first.benchmark_id}, version {first.benchmark_version}{part}. "
        f"Each number is a mean score{of_split}, with its 95 % Wilson interval in "
        "brackets; episodes is how many there are, and (n of m) is behind a mean of "
        "the n scored so far."
    )


def _mean_text(group: answers.GroupScore) -> str:
    """`0.750 [0.41, 0.93]`, with the 95 % Wilson interval; ` (3 of 8)` so far."""
    if group["mean"] is None:
        return "–"
    total = group["counts"]["total"]
    scored = total - group["counts"]["unscored"]
    interval = wilson_interval(group["mean"], scored)
    of = "" if scored == total else f" ({scored} of {total})"
    low, high = figure(interval["low"], 2), figure(interval["high"], 2)
    return f"{figure(group['mean'], 3)} [{low}, {high}]{of}"


def _earlier_of_both(baseline: int | None, run: int | None) -> str | None:
    if baseline is None or run is None:
        return None
    return f"before the baseline {baseline}, before the run {run}, each by its account"


def episode_list(episodes: Sequence[Episode], run: Run) -> TextTable:
    table = TextTable(
        (
            *("episode", "task", "split", "status", ">score", ">steps", ">attempt"),
            *(">clipped", ">return", "played by"),
        ),
        dispensable=("return", "attempt", "clipped", "played by", "steps", "split"),
    )
    for episode in episodes:
        result = episode.result
        table.add(
            episode.episode_id,
            episode.task,
            episode.split,
            result.outcome.value if result else episode.status.value,
            figure(result.score, 3) if result else "–",
            str(result.steps) if result else "–",
            str(episode.attempt),
            *_of_attempt(result),
        )
    if run.mode == "push":  # the server calls one policy, which the facts name
        table = table.without("played by")
    # Facts that the server does not send.
    for name in {"clipped", "return", "played by"} & set(table.names):
        if {row[table.names.index(name)] for row in table.rows} <= {"–"}:
            table = table.without(name)
    return table


def _of_attempt(result: EpisodeResult | None) -> tuple[str, str, str]:
    if result is None or result.clipped_actions is None:
        return "–", "–", "–"
    total = result.total_reward
    return (
        str(result.clipped_actions),
        "–" if total is None else figure(total, 3),
        label_of(result.player),
    )


def benchmark_list(benchmarks: Sequence[BenchmarkSummary]) -> TextTable:
    table = TextTable(("benchmark", "version", ">episodes", "title"))
    for benchmark in benchmarks:
        table.add(
            benchmark.benchmark_id,
            benchmark.version,
            str(benchmark.episodes_total),
            benchmark.title,
        )
    return table


def benchmark_tables(benchmark: Benchmark) -> list[TextTable]:
    sizes = ", ".join(f"{s.width}x{s.height}" for s in benchmark.image_sizes)
    codecs = ", ".join(benchmark.image_codecs)
    space = benchmark.observation_space
    head = fact_table(
        {
            "benchmark": f"{benchmark.benchmark_id}, version {benchmark.version}",
            "title": benchmark.title,
            "description": benchmark.description,
            "unavailable": benchmark.unavailable_reason,
            "episodes": f"{benchmark.episodes_total}, at most "
            f"{counted(benchmark.max_steps, 'step')} each, "
            f"{benchmark.control_rate_hz:g} per second",
            "tasks": ", ".join(benchmark.tasks),
            "splits": ", ".join(benchmark.splits),
            "chunk": f"at most {counted(benchmark.max_chunk, 'action')}",
            "images": f"{codecs}; {sizes}" if space.images else None,
            "manifest": benchmark.manifest_sha256,
        }
    )
    spaces = TextTable(("name", ">size", "unit", "description"))
    for group, vectors in (("action", benchmark.action_space), ("state", space.state)):
        for name, vector in vectors.items():
            parts = declared_parts(vector.to_dict()).values()
            spaces.add(
                f"{group}.{name}",
                str(vector.size),
                ", ".join(dict.fromkeys(part.scaled_unit or "1" for part in parts)),
                vector.description or "",
            )
    for name, image in space.images.items():
        spaces.add(f"images.{name}", str(image.channels), "", image.description)
    for name, tensor in space.tensors.items():
        spaces.add(
            f"tensors.{name}",
            "x".join(map(str, tensor.shape)),
            tensor.dtype,
            tensor.description,
        )
    goals = TextTable(("task", "goal"))
    for task, goal in (benchmark.task_goals or {}).items():
        goals.add(task, goal)
    return [head, *([goals] if benchmark.task_goals else []), spaces]
