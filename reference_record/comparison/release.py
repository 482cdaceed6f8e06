"""Whether a run may be released in place of its baseline, and the reason for people.

The difference of the protocol is baseline minus run: it is positive where the run is
worse. Only what is worse is a reason against a release.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final, Protocol

from reference_record.comparison.difference_evidence import ALPHA, Evidence
from reference_record.comparison.sequential_comparison import SequentialComparison

TOLERANCE: Final = 0.05  # CMP-008 has the same where none is given
ROUNDING: Final = 1e-9  # CMP-008 has the same: no rounding decides


class ComparedGroup(Protocol):
    """difference: of the means, baseline minus run; None without a pair."""

    @property
    def difference(self) -> float | None: ...


class ComparedScores(ComparedGroup, Protocol):
    """A run compared with a baseline, as schema ComparedRun has it."""

    @property
    def complete(self) -> bool: ...
    @property
    def by_task(self) -> Mapping[str, ComparedGroup]: ...
    @property
    def wins(self) -> int: ...
    @property
    def losses(self) -> int: ...
    @property
    def p_value(self) -> float: ...


@dataclass(frozen=True, slots=True)
class _Group:
    """Episodes that are compared together. task: None for all of them."""

    task: str | None
    difference: float
    is_shown: bool = False


def may_release(run: ComparedScores, tolerance: float) -> bool:
    """Whether all episodes are paired and nothing is worse beyond the tolerance.

    The protocol's `release` is false, too, where a run is better beyond the tolerance:
    it is the gate for a policy that has to stay the same on another chip.
    """
    limit = tolerance + ROUNDING
    return run.complete and all(group.difference <= limit for group in _groups(run))


def stays_the_same(run: ComparedScores, tolerance: float) -> bool:
    """The protocol's `release`: nothing differs beyond the tolerance (CMP-008)."""
    groups = [run, *run.by_task.values()]
    differences = [group.difference for group in groups]
    limit = tolerance + ROUNDING
    return run.complete and all(d is not None and abs(d) <= limit for d in differences)


def _groups(
    run: ComparedScores, shown: frozenset[str | None] = frozenset()
) -> list[_Group]:
    """All episodes, then those of each task. shown: see `_shown_worse`."""
    groups = [_Group(None, run.difference or 0.0, None in shown)]
    for task, compared in run.by_task.items():
        groups.append(_Group(task, compared.difference or 0.0, task in shown))
    return groups


def _shown_worse(
    run: ComparedScores, evidence: Evidence, watched: SequentialComparison
) -> frozenset[str | None]:
    """The groups in which chance does not explain that the run is worse.

    Three lines of the table have a test over all episodes: of the scores, of the
    successes, and the sequential one. None of them may contradict the verdict.
    """
    is_whole = (
        evidence.overall.is_shown
        or (run.losses > run.wins and run.p_value <= ALPHA)
        or watched.better == "baseline"
    )
    tasks = {task for task, of_task in evidence.by_task.items() if of_task.is_shown}
    return frozenset({*tasks, *([None] if is_whole else [])})


def _names(groups: Sequence[_Group]) -> str:
    """Where something differs: `overall and in push`; a task may have any name."""
    tasks = ", ".join(group.task for group in groups if group.task is not None)
    overall = ["overall"] if any(group.task is None for group in groups) else []
    return " and ".join([*overall, *([f"in {tasks}"] if tasks else [])])


def explain_release(
    run: ComparedScores,
    tolerance: float,
    evidence: Evidence,
    watched: SequentialComparison,
) -> str:
    """Only what is worse is a reason against it, unless chance explains it."""
    shown_tolerance = f"{tolerance:g}"
    if not run.complete:
        return "no: not every episode is scored in both"
    groups = _groups(run, _shown_worse(run, evidence, watched))
    limit = tolerance + ROUNDING
    worse = [group for group in groups if group.difference > limit]
    better = [group for group in groups if group.difference < -limit]
    if not worse and not better:
        return f"yes: no difference exceeds {shown_tolerance}"
    if not worse:
        return (
            f"yes: nothing is worse by more than {shown_tolerance}; "
            f"better by more {_names(better)}"
        )
    if shown := [group for group in worse if group.is_shown]:
        rest = [group for group in worse if not group.is_shown]
        also = f"; also worse {_by_chance(rest, evidence, 'where')}" if rest else ""
        return f"no: worse by more than {shown_tolerance} {_names(shown)}{also}"
    text = _by_chance(worse, evidence, "but")
    return f"not decided: worse by more than {shown_tolerance} {text}"


def _by_chance(groups: Sequence[_Group], evidence: Evidence, word: str) -> str:
    """Where chance may explain that a run is worse, and whether that can be decided."""
    hopeless = [group for group in groups if not _can_decide(group, evidence)]
    text = f"{_names(groups)}, {word} chance alone may explain it"
    if not hopeless:
        return f"{text}; more episodes decide"
    if len(hopeless) == len(groups):
        return f"{text}; the benchmark has too few episodes ever to decide it"
    names = _names(hopeless)
    return f"{text}; {names} the benchmark has too few episodes ever to decide it"


def _can_decide(group: _Group, evidence: Evidence) -> bool:
    if group.task is None:
        return evidence.overall.can_decide
    found = evidence.by_task.get(group.task)
    return found is None or found.can_decide
