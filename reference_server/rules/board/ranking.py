"""Entries in, ranking out: `spec/profiles/board.md` in code. Pure.

All entries are of one manifest, so that their episodes pair by position. An entry is
its successes: a number whose bit i is set if episode i was one. It knows neither runs
nor accounts.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from string import ascii_lowercase

ALPHA = 0.05  # for all pairs of a ranking together
# Terms of a sum that are smaller than this part of it change no digit of it.
NEGLIGIBLE = 1e-18


@dataclass(frozen=True, slots=True)
class Contender:
    """An entry as the ranking reads it.

    number: grows with every entry. successes: None for an entry that gets no rank.
    """

    entry_id: str
    number: int
    score: float
    successes: int | None


@dataclass(frozen=True, slots=True)
class Row:
    """One entry in a ranking; rank: the best and the worst one, None without a rank."""

    entry_id: str
    rank: tuple[int, int] | None = None
    better: int = 0
    worse: int = 0
    letters: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Ranking:
    """rows: with a rank first, the highest score first."""

    ranked: int
    comparisons: int
    differing_min: int | None
    differing_enough: int | None
    rows: list[Row] = field(default_factory=list)


def rank(contenders: Sequence[Contender], episodes_total: int) -> Ranking:
    """The ranking of all entries of a manifest (BRD-008, BRD-009, BRD-010, BRD-011)."""
    in_order = sorted(contenders, key=_order)
    ranked = [contender for contender in in_order if contender.successes is not None]
    better, worse = _distinguish([contender.successes or 0 for contender in ranked])
    letters = _letters([b | w for b, w in zip(better, worse, strict=True)])
    n = len(ranked)
    rows = [
        Row(
            contender.entry_id,
            (1 + better[i].bit_count(), n - worse[i].bit_count()),
            better[i].bit_count(),
            worse[i].bit_count(),
            letters[i],
        )
        for i, contender in enumerate(ranked)
    ]
    rows += [
        Row(contender.entry_id) for contender in in_order if contender.successes is None
    ]
    pairs = n * (n - 1) // 2
    return Ranking(
        n,
        pairs,
        _within(1 + math.ceil(math.log2(1 / ALPHA)), episodes_total),
        _within(1 + math.ceil(math.log2(max(1, pairs) / ALPHA)), episodes_total),
        rows,
    )


def _order(contender: Contender) -> tuple[float, int, int]:
    """BRD-008: by score, then by successes, then the older one first."""
    return -contender.score, -(contender.successes or 0).bit_count(), contender.number


def _within(episodes: int, total: int) -> int | None:
    """BRD-011: null where a manifest has not so many episodes."""
    return episodes if episodes <= total else None


def _distinguish(successes: Sequence[int]) -> tuple[list[int], list[int]]:
    """BRD-009: for each entry the sets of those that are better, and worse, as bits.

    Holm's correction over all pairs: the smallest p is held against alpha divided by
    the number of pairs, the next one against alpha divided by one less, until one
    fails.
    """
    n = len(successes)
    left = n * (n - 1) // 2
    better, worse = [0] * n, [0] * n
    for p, winner, loser in sorted(_candidates(successes)):
        if p * left > ALPHA:
            break
        better[loser] |= 1 << winner
        worse[winner] |= 1 << loser
        left -= 1
    return better, worse


def _candidates(successes: Sequence[int]) -> Iterator[tuple[float, int, int]]:
    """(p, winner, loser) of each pair that some correction could distinguish.

    p is 0 where every correction does: of a long leaderboard that is nearly every
    pair, and a p takes longer than all else that is done for its pair. It falls as the
    lead grows, so that what is known of one pair holds for others that differ as much.
    """
    pairs = len(successes) * (len(successes) - 1) // 2
    counts = [wins.bit_count() for wins in successes]
    # Differing episodes → the largest lead that none does, the smallest that all do.
    bounds: dict[int, tuple[int, int]] = {}
    for i, wins in enumerate(successes):
        for j in range(i):
            n = (wins ^ successes[j]).bit_count()
            lead = abs(counts[i] - counts[j])
            none, all_ = bounds.get(n, (-1, n + 1))
            if lead <= none:
                continue
            p = mcnemar_p((n - lead) // 2, n) if lead < all_ else 0.0
            if p > ALPHA:
                bounds[n] = lead, all_
                continue
            if 0 < p * pairs <= ALPHA:
                bounds[n] = none, lead
                p = 0.0
            yield (p, i, j) if counts[i] > counts[j] else (p, j, i)


@lru_cache(maxsize=2**16)
def mcnemar_p(fewer: int, differing: int) -> float:
    """The two-sided p of McNemar's exact test, to twelve digits.

    fewer: episodes at which the one that won fewer alone succeeded, of those at which
    the two differ. Logarithms, for with whole numbers a long benchmark takes too long.
    """
    term = total = 1.0
    for k in range(fewer, 0, -1):
        term *= k / (differing - k + 1)
        total += term
        if term < total * NEGLIGIBLE:
            break
    log_ways = (
        math.lgamma(differing + 1)
        - math.lgamma(fewer + 1)
        - math.lgamma(differing - fewer + 1)
    )
    return min(1.0, 2 * total * math.exp(log_ways - differing * math.log(2)))


def _letters(apart: Sequence[int]) -> list[tuple[str, ...]]:
    """BRD-010: groups of entries none of which is distinguished from another.

    apart: for each entry those that it is distinguished from, as bits. Each pair that
    is not is in some group, in the order of the rows; a group takes all that fit,
    again in that order.
    """
    n = len(apart)
    like = [~apart[i] & ((1 << n) - 1) & ~(1 << i) for i in range(n)]
    groups: list[int] = []
    grouped = [0] * n
    for i in range(n):
        while (open_ := like[i] & ~grouped[i] & ~((1 << i) - 1)) or not grouped[i]:
            group = _grow(like, i, open_)
            groups.append(group)
            for member in _members(group):
                grouped[member] |= group
    letters: list[list[str]] = [[] for _ in apart]
    for place, group in enumerate(groups):
        for member in _members(group):
            letters[member].append(_letter(place))
    return [tuple(some) for some in letters]


def _grow(like: Sequence[int], first: int, others: int) -> int:
    """The group of an entry, the first of these others, and all that fit to both."""
    group, fitting = 1 << first, like[first]
    if others:
        second = (others & -others).bit_length() - 1
        group |= 1 << second
        fitting &= like[second]
    while fitting:
        next_ = (fitting & -fitting).bit_length() - 1
        group |= 1 << next_
        fitting &= like[next_]
    return group


def _members(group: int) -> Iterator[int]:
    while group:
        lowest = group & -group
        yield lowest.bit_length() - 1
        group ^= lowest


def _letter(place: int) -> str:
    """a to z, then aa, ab and so on."""
    text = ""
    place += 1
    while place:
        place, digit = divmod(place - 1, 26)
        text = ascii_lowercase[digit] + text
    return text
