"""Finds the differences between a run and its baseline that chance does not explain.

A difference of mean scores may come from one episode of eight. Over all episodes, and
over those of each task, those that the run scored better are set against those that it
scored worse: two policies that are equally good on each episode win either with
probability 1/2 (the exact sign test; of scores 0 and 1 it is McNemar's). The whole is
one question, whose p stands as it is. Among many tasks some differ by chance, so their
p are corrected together (Holm 1979). The functions are pure.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

from reference_record.texts.figures import figure

ALPHA: Final = 0.05


@dataclass(frozen=True, slots=True)
class GroupEvidence:
    """better, worse: episodes that the run scored so. p_value: two-sided.

    That of a task is corrected for the number of tasks. can_decide: whether there are
    enough episodes, so that the most uneven result would be shown.
    """

    better: int
    worse: int
    p_value: float
    can_decide: bool = True

    @property
    def is_shown(self) -> bool:
        """Whether chance alone would rarely make so large a difference."""
        return self.p_value <= ALPHA


@dataclass(frozen=True, slots=True)
class Evidence:
    """overall: over all episodes. A single task has the same."""

    overall: GroupEvidence
    by_task: dict[str, GroupEvidence]


def weigh_differences(pairs: Iterable[tuple[str, float, float]]) -> Evidence:
    """pairs: task, scores of the baseline and of the run."""
    total = [0, 0, 0]
    by_task: dict[str, list[int]] = {}
    for task, baseline, run in pairs:
        for group in (total, by_task.setdefault(task, [0, 0, 0])):
            group[0] += run > baseline
            group[1] += run < baseline
            group[2] += 1
    p_values = _correct([sign_test(*counts[:2]) for counts in by_task.values()])
    smallest = _correct([sign_test(0, episodes) for *_, episodes in by_task.values()])
    of_tasks = {
        task: GroupEvidence(better, worse, p_value, least <= ALPHA)
        for (task, (better, worse, _)), p_value, least in zip(
            by_task.items(), p_values, smallest, strict=True
        )
    }
    better, worse, episodes = total
    can_decide = sign_test(0, episodes) <= ALPHA
    overall = GroupEvidence(better, worse, sign_test(better, worse), can_decide)
    return Evidence(overall, of_tasks)


def p_text(p_value: float) -> str:
    """`< 0.0001` or `= 0.0312`; a p is never 0, so a small one is shown as a bound."""
    return "< 0.0001" if p_value < 0.0001 else f"= {figure(p_value, 4)}"


def _correct(p_values: Sequence[float]) -> list[float]:
    """Holm's, in the order that was given."""
    corrected, largest = [1.0] * len(p_values), 0.0
    order = sorted(range(len(p_values)), key=lambda number: p_values[number])
    for place, number in enumerate(order):
        largest = max(largest, min(1.0, (len(order) - place) * p_values[number]))
        corrected[number] = largest
    return corrected


def sign_test(wins: int, losses: int) -> float:
    """Exact, two-sided, rounded once; McNemar's test, as spec/scoring.md has it."""
    n = wins + losses
    tail, ways = 0, 1
    for k in range(min(wins, losses) + 1):
        tail += ways
        ways = ways * (n - k) // (k + 1)  # C(n, k + 1)
    # Whole numbers until the one division: no sum of small terms loses anything.
    return min(1.0, 2 * tail / (1 << n))
