"""Times several libraries with the same work in one process, alternately; medians.

In every round each contender works for some milliseconds, the fast ones many times; the
next round begins with another contender. The result of a contender is compared with the
expected one before it is measured; a wrong result is an error.
"""

from __future__ import annotations

import gc
import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import perf_counter_ns
from typing import Any

UNITS_NS = {"us": 1e3, "ms": 1e6}
SHARE_NS = 3_000_000  # of a round, for each contender
_CALLS_MAX = 500


def _nothing() -> None:
    return None


def _itself(made: Any) -> Any:
    return made


@dataclass(frozen=True, slots=True)
class Contender:
    """work: what is timed; its argument is what `prepare` made before, off the clock.

    plain: what work made, in a form that is the same for all contenders.
    """

    name: str
    work: Callable[[Any], Any]
    prepare: Callable[[], Any] = _nothing
    plain: Callable[[Any], Any] = _itself


class WrongResult(AssertionError):
    """A contender made something else than the others."""


def medians_ns(
    contenders: Sequence[Contender], expected: Any, rounds: int
) -> dict[str, float]:
    """Nanoseconds of one call by name, the median of all rounds. Raises WrongResult."""
    for one in contenders:
        _check(one, expected)
    calls = {one.name: _calls(one) for one in contenders}
    took: dict[str, list[float]] = {one.name: [] for one in contenders}
    gc.collect()
    for number in range(rounds):
        first = number % len(contenders)
        for one in (*contenders[first:], *contenders[:first]):
            took[one.name].append(_mean_ns(one, calls[one.name]))
    return {name: statistics.median(all_ns) for name, all_ns in took.items()}


def _check(one: Contender, expected: Any) -> None:
    made = one.plain(one.work(one.prepare()))
    if made != expected:
        what = f"{str(made)[:300]} where {str(expected)[:300]} was expected"
        raise WrongResult(f"{one.name} made {what}")


def _calls(one: Contender) -> int:
    """How often it shall work in a round."""
    _mean_ns(one, 3)  # the first call of all may load something
    return max(1, min(_CALLS_MAX, int(SHARE_NS / _mean_ns(one, 3))))


def _mean_ns(one: Contender, calls: int) -> float:
    work = one.work
    prepared = [one.prepare() for _ in range(calls)]
    started = perf_counter_ns()
    for argument in prepared:
        work(argument)
    return (perf_counter_ns() - started) / calls
