"""A promise, and its verdict over everything that a campaign has measured.

A promise has a bound that is the same in every form of a command; what was measured
stands beside it. A campaign states its own promises about its own cases: an attack, or
all rounds of faults.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

Case = TypeVar("Case")


def percentile(values: Sequence[float], part: float) -> float:
    """The value that this part of all does not exceed; NaN of none."""
    if not values:
        return math.nan
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, math.ceil(part * len(ordered)) - 1)]


@dataclass(frozen=True)
class Promise(Generic[Case]):
    """text: as it is stated. measure: a value of each case. is_broken: its verdict;
    without one a value above 0 breaks the promise.

    covers: whether it is about this case. promised: how many requests, kills or
    seconds the promise is about, where the text names a number; count: how many a case
    had of them. detail: what else is shown of the worst case.
    """

    text: str
    unit: str
    measure: Callable[[Case], float]
    is_broken: Callable[[Case], bool] | None = None
    covers: Callable[[Case], bool] = lambda _: True
    promised: int = 0
    count: Callable[[Case], int] = lambda _: 0
    detail: Callable[[Case], str] = lambda _: ""

    def breaks(self, case: Case) -> bool:
        if self.is_broken is None:
            return self.measure(case) > 0
        return self.is_broken(case)


@dataclass(frozen=True)
class Verdict:
    """state: kept, kept in part, broken, or not measured. worst: what was measured."""

    text: str
    state: str
    worst: str

    def __str__(self) -> str:
        return f"{self.state:<12} {self.text}: {self.worst}"


def judge(
    promises: Iterable[Promise[Case]],
    cases: Sequence[Case],
    name_of: Callable[[Case], str],
) -> list[Verdict]:
    """A verdict for each promise, over all cases."""
    return [_judge_one(promise, cases, name_of) for promise in promises]


def _judge_one(
    promise: Promise[Case], cases: Sequence[Case], name_of: Callable[[Case], str]
) -> Verdict:
    covered = [case for case in cases if promise.covers(case)]
    if not covered:
        return Verdict(promise.text, "not measured", "–")
    broken = [name_of(case) for case in covered if promise.breaks(case)]
    worst = max(covered, key=lambda case: _order(promise.measure(case)))
    value = promise.measure(worst)
    shown = f"{_number(value)} {promise.unit}"
    counted = sum(promise.count(case) for case in covered)
    if promise.promised:
        shown += f" in {counted:,} of {promise.promised:,}"
    elif (value or broken) and name_of(worst):
        shown += f" ({name_of(worst)})"
    shown += promise.detail(worst)
    if broken:
        by = f"; by {', '.join(broken)}" if any(broken) else ""
        return Verdict(promise.text, "broken", shown + by)
    state = "kept in part" if counted < promise.promised else "kept"
    return Verdict(promise.text, state, shown)


def _order(value: float) -> float:
    return math.inf if math.isnan(value) else value


def _number(value: float) -> str:
    if math.isnan(value):
        return "never"
    return f"{value:.1f}" if value % 1 and value < 100 else f"{value:.0f}"
