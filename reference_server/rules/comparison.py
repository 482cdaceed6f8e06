"""Runs compared with a baseline: the second half of `spec/scoring.md` in code. Pure.

Both runs are of one manifest, so that their episodes pair by position. It knows neither
runs nor accounts: it takes episodes and returns numbers.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from reference_record.comparison.difference_evidence import sign_test
from reference_record.generated.answers import ComparedTask, ComputedComparison
from reference_server.rules.runs.lifecycle import Refuse
from reference_server.rules.scoring import ScoredEpisode

TOLERANCE = 0.05  # CMP-008: when none is given
DIFFERENCES_MAX = 5  # of manifests; more are counted
# The members that differ between two parts of one benchmark.
_OF_A_SELECTION = {"episodes", "episodes_total"}
ROUNDING = 1e-9  # CMP-008: so that no rounding decides

Pair = tuple[ScoredEpisode, ScoredEpisode]


def manifest_mismatch(
    runs: Sequence[tuple[str, str, Mapping[str, Any]]],
) -> Refuse | None:
    """CMP-009: run_id, manifest_sha256 and manifest, first of the baseline."""
    (baseline, manifest_sha256, manifest), *others = runs
    mismatched = {
        run_id: differing_members(manifest, other)
        for run_id, sha256, other in others
        if sha256 != manifest_sha256
    }
    if not mismatched:
        return None
    names = list(dict.fromkeys(name for found in mismatched.values() for name in found))
    more = len(names) - DIFFERENCES_MAX
    differing = ", ".join(names[:DIFFERENCES_MAX]) + (f" and {more} more" * (more > 0))
    detail, act = f"These differ in {differing}.", None
    parts = {}
    if set(names) <= _OF_A_SELECTION:
        parts = {run_id: selected_part(of_run) for run_id, _, of_run in runs}
    if len(set(parts.values())) > 1:
        each = [f"{run_id} is of {part}" for run_id, part in parts.items()]
        detail = f"Here {', '.join(each[: DIFFERENCES_MAX + 1])}."
        act = "Compare runs of the same tasks and splits."
    text = f"{', '.join(mismatched)}: another manifest than {baseline}"
    return Refuse(
        "not_comparable",
        f"Episodes pair only within one manifest. {detail}",
        "CMP-009",
        (("query:runs", text),),
        act=act,
    )


def selected_part(manifest: Mapping[str, Any]) -> str:
    """`a part (tasks lift, push)` of a benchmark, or the whole of it."""
    parts = []
    for names, of_episode in (("tasks", "task"), ("splits", "split")):
        selected = {episode[of_episode] for episode in manifest["episodes"]}
        if selected < set(manifest[names]):
            listed = [name for name in manifest[names] if name in selected]
            parts.append(f"{names} {', '.join(listed)}")
    return f"a part ({'; '.join(parts)})" if parts else "the whole benchmark"


def differing_members(
    one: Mapping[str, Any], other: Mapping[str, Any], before: str = ""
) -> list[str]:
    """The members in which two manifests differ, such as `simulator.sources.lab.py`.

    Two benchmarks differ in `benchmark_id` alone, whatever else they have.
    """
    if one.get("benchmark_id") != other.get("benchmark_id"):
        return ["benchmark_id"]
    names = []
    for name in dict.fromkeys([*one, *other]):
        mine, theirs = one.get(name), other.get(name)
        if isinstance(mine, Mapping) and isinstance(theirs, Mapping):
            names += differing_members(mine, theirs, f"{before}{name}.")
        elif mine != theirs:
            names.append(before + name)
    return names


def compare(
    baseline: Sequence[ScoredEpisode], run: Sequence[ScoredEpisode], tolerance: float
) -> ComputedComparison:
    """Compare two runs of one manifest."""
    by_task: dict[str, list[Pair]] = {episode.task: [] for episode in run}
    pairs = list(_pairs(baseline, run))
    for pair in pairs:
        by_task[pair[1].task].append(pair)
    whole = _group(pairs)
    tasks = {task: _group(members) for task, members in by_task.items()}
    complete = len(pairs) == len(run)  # CMP-003
    wins = sum(_succeeds(run) > _succeeds(base) for base, run in pairs)
    losses = sum(_succeeds(run) < _succeeds(base) for base, run in pairs)
    return {
        "complete": complete,
        "release": complete and is_within([whole, *tasks.values()], tolerance),
        **whole,
        "wins": wins,  # CMP-006
        "losses": losses,
        "ties": len(pairs) - wins - losses,
        "p_value": sign_test(wins, losses),  # CMP-007
        "by_task": tasks,  # CMP-005
    }


def is_within(groups: Sequence[ComparedTask], tolerance: float) -> bool:
    """Whether each difference is a number that is not beyond the tolerance."""
    differences = [group["difference"] for group in groups]
    return all(d is not None and abs(d) <= tolerance + ROUNDING for d in differences)


def _pairs(
    baseline: Sequence[ScoredEpisode], run: Sequence[ScoredEpisode]
) -> Iterator[Pair]:
    """CMP-002: the episodes that both runs have scored, by place in the manifest."""
    for pair in zip(baseline, run, strict=True):
        if all(episode.outcome is not None for episode in pair):
            yield pair


def _succeeds(episode: ScoredEpisode) -> bool:
    return episode.outcome == "success"


def _group(pairs: Sequence[Pair]) -> ComparedTask:
    """Schema ComparedTask (CMP-002, CMP-004)."""
    means = [_mean([pair[side] for pair in pairs]) for side in (0, 1)]
    base, run = means
    return {
        "paired": len(pairs),
        "baseline_mean": base,
        "mean": run,
        "difference": None if base is None or run is None else base - run,
    }


def _mean(episodes: Sequence[ScoredEpisode]) -> float | None:
    # SCORE-004: abandoned is 0, whatever was reached. fsum rounds once.
    earned = (0.0 if e.outcome == "abandoned" else e.score for e in episodes)
    return math.fsum(earned) / len(episodes) if episodes else None
