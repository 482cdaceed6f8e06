"""Whether a run may be released in place of its baseline, and the reason for people.

The difference of the protocol is baseline minus run: it is positive where the run is
worse. Only what is worse is a reason against a release.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from proctor_client import ComparedRun, Comparison

from reference_record.comparison.difference_evidence import Evidence

ROUNDING: Final = 1e-9  # CMP-008 has the same: no rounding decides


@dataclass(frozen=True, slots=True)
class _Group:
    """Episodes that are compared together. task: None for all of them."""

    task: str | None
    difference: float
    is_shown: bool = False


def may_release(comparison: Comparison, run: ComparedRun) -> bool:
    """Whether all episodes are paired and nothing is worse beyond the tolerance.

    The protocol's `release` is false, too, where a run is better beyond the tolerance:
    it is the gate for a policy that has to stay the same on another chip.
    """
    limit = comparison.tolerance + ROUNDING
    return run.complete and all(group.difference <= limit for group in _groups(run))


def _groups(run: ComparedRun, evidence: Evidence | None = None) -> list[_Group]:
    """All episodes, then those of each task, with the evidence of a difference."""
    whole = evidence is not None and evidence.overall.is_shown
    groups = [_Group(None, run.difference or 0.0, whole)]
    for task, compared in run.by_task.items():
        of_task = evidence.by_task.get(task) if evidence is not None else None
        is_shown = of_task is not None and of_task.is_shown
        groups.append(_Group(task, compared.difference or 0.0, is_shown))
    return groups


def _names(groups: Sequence[_Group]) -> str:
    """Where something differs: `overall and in push`; a task may have any name."""
    tasks = ", ".join(group.task for group in groups if group.task is not None)
    overall = ["overall"] if any(group.task is None for group in groups) else []
    return " and ".join([*overall, *([f"in {tasks}"] if tasks else [])])


def explain_release(
    comparison: Comparison, run: ComparedRun, evidence: Evidence
) -> str:
    """Only what is worse is a reason against it, unless chance explains it."""
    tolerance = f"{comparison.tolerance:g}"
    if not run.complete:
        return "no: not every episode is scored in both"
    groups, limit = _groups(run, evidence), comparison.tolerance + ROUNDING
    worse = [group for group in groups if group.difference > limit]
    better = [group for group in groups if group.difference < -limit]
    if not worse and not better:
        return f"yes: no difference exceeds {tolerance}"
    if not worse:
        return (
            f"yes: nothing is worse by more than {tolerance}; "
            f"better by more {_names(better)}"
        )
    if shown := [group for group in worse if group.is_shown]:
        return f"no: worse by more than {tolerance} {_names(shown)}"
    return (
        f"not decided: worse by more than {tolerance} {_names(worse)}, "
        "but chance alone may explain it; more episodes decide"
    )
