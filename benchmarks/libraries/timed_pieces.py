"""A piece of work that several libraries do, timed in one process, alternately.

In every round each library works for some milliseconds; the next round begins with
another. The result of a library is compared with the expected one before it is
measured; a wrong result is an error.
"""

import gc
import statistics
from collections.abc import Callable
from time import perf_counter_ns
from typing import Any, NamedTuple

from benchmarks.measuring import digits, in_turn

Work = Callable[[Any], Any]
SHARE_NS = 3_000_000  # of a round, for each library
_CALLS_MAX = 500


class Piece(NamedTuple):
    """A piece of work: `libraries` do it, the chosen one first, with `argument`.

    plain: the result of the work, in a form that is the same for all libraries.
    """

    name: str
    libraries: dict[str, Work]
    argument: Any
    plain: Work
    expected: Any


class WrongResult(AssertionError):
    """A library made something else than the others."""


def rows(piece: Piece, rounds: int) -> list[list[str]]:
    """A row for each library: microseconds of a call, and the ratio to the chosen."""
    for name, work in piece.libraries.items():
        made = piece.plain(work(piece.argument))
        if made != piece.expected:
            raise WrongResult(f"{piece.name}: {name} made {str(made)[:300]}")
    calls = {name: _calls(work, piece) for name, work in piece.libraries.items()}
    took: dict[str, list[float]] = {name: [] for name in piece.libraries}
    gc.collect()
    for name in in_turn(list(took), rounds):
        took[name].append(_mean_ns(piece.libraries[name], piece, calls[name]))
    medians = {name: statistics.median(each) / 1e3 for name, each in took.items()}
    chosen = next(iter(medians))
    return [
        [piece.name, name, digits(us), f"{us / medians[chosen]:.2f}"]
        for name, us in sorted(medians.items(), key=lambda row: row[0] != chosen)
    ]


def _calls(work: Work, piece: Piece) -> int:
    """How often a library shall work in a round."""
    _mean_ns(work, piece, 3)  # the first call of all may load something
    return max(1, min(_CALLS_MAX, int(SHARE_NS / _mean_ns(work, piece, 3))))


def _mean_ns(work: Work, piece: Piece, calls: int) -> float:
    started = perf_counter_ns()
    for _ in range(calls):
        work(piece.argument)
    return (perf_counter_ns() - started) / calls
