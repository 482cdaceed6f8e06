"""Two runs of one manifest, episode by episode.

The numbers are those that `compare_runs` answered; without a server they are computed
from the same episodes as spec/scoring.md defines them.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Final

from reference_record.comparison.difference_evidence import (
    sign_test,
    weigh_differences,
)
from reference_record.comparison.release import (
    TOLERANCE,
    explain_release,
    stays_the_same,
)
from reference_record.comparison.sequential_comparison import (
    SequentialComparison,
    compare_sequentially,
)
from reference_record.pages.run_page import (
    Document,
    TaskCell,
    sum_cells,
    task_table,
)

# The names of several runs on one page; there are no more than these.
LETTERS: Final = "ABCDEFGH"
# The order of the kinds on the page: changed pairs stand first.
KINDS: Final = {
    "lost": "only the baseline succeeds",
    "won": "only this run succeeds",
    "neither": "neither succeeds",
    "both": "both succeed",
    "open": "one has no result yet",
}


@dataclass(frozen=True, slots=True)
class Pair:
    """One episode in the baseline and in the run."""

    kind: str
    baseline: Document
    run: Document


def pair_episodes(baseline: Sequence[Document], run: Sequence[Document]) -> list[Pair]:
    """The episodes of both, by their index; what changed stands first."""
    others = {episode["index"]: episode for episode in run}
    pairs = [
        Pair(
            _kind(episode, others[episode["index"]]), episode, others[episode["index"]]
        )
        for episode in baseline
        if episode["index"] in others
    ]
    order = list(KINDS)
    return sorted(pairs, key=lambda p: (order.index(p.kind), p.baseline["index"]))


def _kind(baseline: Document, run: Document) -> str:
    before, now = _succeeded(baseline), _succeeded(run)
    if before is None or now is None:
        return "open"
    return {(True, False): "lost", (False, True): "won", (True, True): "both"}.get(
        (before, now), "neither"
    )


def count_kinds(pairs: Sequence[Pair]) -> Mapping[str, int]:
    counted = Counter(pair.kind for pair in pairs)
    return {kind: counted[kind] for kind in KINDS}


@dataclass(frozen=True, slots=True)
class GroupDifference:
    """The pairs of a task or of a split in which both have a result."""

    name: str
    paired: int
    counts: Mapping[str, int]
    baseline_mean: float | None
    mean: float | None


def differences_by(member: str, pairs: Sequence[Pair]) -> list[GroupDifference]:
    """By `task` or by `split`, in the order of the manifest."""
    groups: dict[str, list[Pair]] = {}
    for pair in sorted(pairs, key=lambda pair: int(pair.run["index"])):
        closed = groups.setdefault(pair.run[member], [])
        if pair.kind != "open":
            closed.append(pair)
    return [
        GroupDifference(name, len(closed), count_kinds(closed), *_means_of_both(closed))
        for name, closed in groups.items()
    ]


def _means_of_both(closed: Sequence[Pair]) -> list[float | None]:
    """The mean score of the baseline and that of the run."""
    return [
        math.fsum(map(_score, sides)) / len(closed) if closed else None
        for sides in ([p.baseline for p in closed], [p.run for p in closed])
    ]


def _score(episode: Document) -> float:
    """The score that counts: 0 for an abandoned episode, whatever was reached."""
    result = episode["result"]
    return 0.0 if result["outcome"] == "abandoned" else float(result["score"])


@dataclass(frozen=True, slots=True)
class ComparedRun:
    """One of several runs of a manifest. against: its pairs with the first run."""

    letter: str
    run: Document
    cell: TaskCell
    tasks: Mapping[str, TaskCell]
    splits: Mapping[str, TaskCell]
    against: Mapping[str, Any] | None


def compare_several(
    runs: Sequence[tuple[Document, Sequence[Document]]],
) -> list[ComparedRun]:
    """Each run with its episodes; the first is what the others are compared with."""
    compared: list[ComparedRun] = []
    for letter, (run, episodes) in zip(LETTERS, runs, strict=False):
        table = task_table(episodes)
        rows = table.rows
        pairs = pair_episodes(runs[0][1], episodes) if compared else []
        compared.append(
            ComparedRun(
                letter,
                run,
                sum_cells([whole for _, _, whole in rows]),
                {task: whole for task, _, whole in rows},
                table.by_split,
                compare_pairs(pairs) if compared else None,
            )
        )
    return compared


def compare_pairs(pairs: Sequence[Pair]) -> dict[str, Any]:
    """The members of schema ComparedRun that the page shows, of pairs with results."""
    closed = [pair for pair in pairs if pair.kind != "open"]
    counts = count_kinds(closed)
    means = _means_of_both(closed)
    return {
        "paired": len(closed),
        "baseline_mean": means[0],
        "mean": means[1],
        "wins": counts["won"],
        "losses": counts["lost"],
        "p_value": sign_test(counts["won"], counts["lost"]),
    }


def compare_while_played(pairs: Sequence[Pair]) -> SequentialComparison:
    """pairs: of all episodes of the manifest, in any order."""
    ordered = sorted(pairs, key=lambda pair: int(pair.run["index"]))
    return compare_sequentially(
        ((_succeeded(pair.baseline), _succeeded(pair.run)) for pair in ordered),
        [(f"split {p.run['split']}", f"task {p.run['task']}") for p in ordered],
    )


@dataclass(frozen=True, slots=True)
class _Scores:
    """Schema ComparedRun, without its id and the decision of the protocol."""

    complete: bool
    paired: int
    baseline_mean: float | None
    mean: float | None
    difference: float | None
    wins: int
    losses: int
    ties: int
    p_value: float
    by_task: Mapping[str, _Group]


@dataclass(frozen=True, slots=True)
class _Group:
    """Schema ComparedTask."""

    paired: int
    baseline_mean: float | None
    mean: float | None
    difference: float | None


def _scores_of(pairs: Sequence[Pair]) -> _Scores:
    tasks: dict[str, list[Pair]] = {}
    for pair in sorted(pairs, key=lambda pair: int(pair.run["index"])):
        tasks.setdefault(pair.run["task"], []).append(pair)
    by_task = {task: _group_of(compare_pairs(some)) for task, some in tasks.items()}
    numbers = compare_pairs(pairs)
    counts = numbers["wins"], numbers["losses"]
    return _Scores(
        complete=numbers["paired"] == len(pairs),
        **asdict(_group_of(numbers)),
        wins=counts[0],
        losses=counts[1],
        ties=numbers["paired"] - sum(counts),
        p_value=numbers["p_value"],
        by_task=by_task,
    )


def _group_of(numbers: Mapping[str, Any]) -> _Group:
    baseline_mean, mean = numbers["baseline_mean"], numbers["mean"]
    difference = baseline_mean - mean if numbers["paired"] else None
    return _Group(numbers["paired"], baseline_mean, mean, difference)


def comparison_document(
    runs: Sequence[tuple[Document, Sequence[Document]]], tolerance: float
) -> dict[str, Any]:
    """Schema Comparison of runs of one manifest, each with its episodes.

    The first one is the baseline. It is what `compare_runs` would answer.
    """
    (baseline, before), *others = runs
    compared = []
    for run, episodes in others:
        scores = _scores_of(pair_episodes(before, episodes))
        compared.append(
            {
                "run_id": run["run_id"],
                "release": stays_the_same(scores, tolerance),
                **asdict(scores),
            }
        )
    names = ("benchmark_id", "manifest_sha256")
    return {
        "baseline": baseline["run_id"],
        **{name: baseline[name] for name in names},
        "tolerance": tolerance,
        "runs": compared,
    }


def release_of(pairs: Sequence[Pair], watched: SequentialComparison) -> str:
    """Whether the run may be released in place of the baseline, with the reason."""
    evidence = weigh_differences(
        (pair.run["task"], _score(pair.baseline), _score(pair.run))
        for pair in pairs
        if pair.kind != "open"
    )
    return explain_release(_scores_of(pairs), TOLERANCE, evidence, watched)


def _succeeded(episode: Document) -> bool | None:
    result = episode.get("result")
    return None if result is None else result["outcome"] == "success"
