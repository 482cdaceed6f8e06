"""Two policies compared while they are played: when a comparison may stop. Pure.

McNemar's exact test holds for a number of episodes that was fixed before. Looked at
after every episode, until it says what one hopes for, it is wrong far more often than
its p says. This test may be looked at as often as one likes.

Only episodes count in which one of both succeeded and the other did not. The
hypothesis: the policies are equally good on each episode, so that each of these is a
win or a loss with probability 1/2, whatever came before. It is more than "equally good
in total": of policies that are better on one split each, the order of the manifest may
show the one before the other. So a decision is about the episodes compared, and those
left are needed while a task or split is not among them. After w wins and l losses the
e-value is the likelihood of what was seen, averaged over all other probabilities of a
win with the weights of Beta(1/2, 1/2), divided by that of 1/2:

    E = 2^(w + l) · B(w + 1/2, l + 1/2) / B(1/2, 1/2)

Under the hypothesis its mean stays 1 whatever was seen before, so that the probability
that it ever reaches 1/α is at most α (Ville 1939; the average is that of Krichevsky and
Trofimov, IEEE Trans. Inf. Theory 27, 1981; e-values: Ramdas et al., Statistical Science
38, 2023).

Episodes are taken in the order of the manifest, up to the first that is not scored in
both: those that end early are not a fair sample of all, as a success ends an episode.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final, Literal

from reference_record.texts.counted_text import counted

ALPHA: Final = 0.05
THRESHOLD: Final = 1 / ALPHA
_DECIDES: Final = f"decided at e ≥ {THRESHOLD:g}"
# Logarithm of the largest e-value that is given: JSON has no infinity.
_LOG_MAX: Final = math.log(1e300)

# Whether baseline and run succeeded; None without a result.
Outcomes = tuple[bool | None, bool | None]


@dataclass(frozen=True, slots=True)
class Decision:
    """The evidence at the moment of the decision; the run has the wins and losses."""

    e_value: float
    wins: int
    losses: int


@dataclass(frozen=True, slots=True)
class SequentialComparison:
    """The evidence from the first `compared` episodes of the manifest.

    left: episodes behind them. wins, losses: of the run, among those compared.
    e_value: now. largest_e_value: after any of them; 1 before the first.
    better: which succeeds more often on the first `decided_after` episodes; None while
    that is not decided. at_decision: what was counted then.
    may_decide: whether it is decided, or the episodes left may still decide it.
    not_compared: tasks and splits of which no episode is compared yet.
    """

    compared: int
    left: int
    wins: int
    losses: int
    e_value: float
    largest_e_value: float
    better: Literal["run", "baseline"] | None
    decided_after: int | None
    at_decision: Decision | None
    may_decide: bool
    not_compared: tuple[str, ...]


def compare_sequentially(
    episodes: Iterable[Outcomes], groups: Iterable[Iterable[str]] = ()
) -> SequentialComparison:
    """episodes: of baseline and run, all of the manifest in its order.

    groups: for each of them what it is one of, such as `task lift` and `split test`.
    """
    pairs = list(episodes)
    wins = losses = compared = 0
    log_e = largest = 0.0
    better: Literal["run", "baseline"] | None = None
    decided_after: int | None = None
    at_decision: Decision | None = None
    for baseline, run in pairs:
        if baseline is None or run is None:
            break
        compared += 1
        if baseline != run:
            log_e += _log_factor(wins if run else losses, wins + losses)
            wins, losses = wins + run, losses + baseline
            largest = max(largest, log_e)
        if better is None and log_e >= math.log(THRESHOLD):
            better, decided_after = "run" if wins > losses else "baseline", compared
            at_decision = Decision(math.exp(log_e), wins, losses)
    left = len(pairs) - compared
    best = max(log_e_value(wins + left, losses), log_e_value(wins, losses + left))
    return SequentialComparison(
        compared=compared,
        left=left,
        wins=wins,
        losses=losses,
        e_value=math.exp(min(log_e, _LOG_MAX)),
        largest_e_value=math.exp(min(largest, _LOG_MAX)),
        better=better,
        decided_after=decided_after,
        at_decision=at_decision,
        may_decide=better is not None or best >= math.log(THRESHOLD),
        not_compared=_not_compared(list(groups), compared),
    )


def log_e_value(wins: int, losses: int) -> float:
    """The natural logarithm of E, by its closed form."""
    n = wins + losses
    beta = math.lgamma(wins + 0.5) + math.lgamma(losses + 0.5) - math.lgamma(n + 1)
    return n * math.log(2) + beta - math.log(math.pi)  # B(1/2, 1/2) = π


def _not_compared(groups: Sequence[Iterable[str]], compared: int) -> tuple[str, ...]:
    """Names of groups of which no episode is among the first `compared`."""
    compared_names = {name for of_episode in groups[:compared] for name in of_episode}
    left = (name for of_episode in groups[compared:] for name in of_episode)
    return tuple(dict.fromkeys(name for name in left if name not in compared_names))


def _log_factor(same: int, n: int) -> float:
    """The log of E's factor for one more of a kind, which `same` of n had before."""
    return math.log(2 * (same + 0.5) / (n + 1))


def describe(comparison: SequentialComparison) -> str:
    """One sentence for people: what is decided, whether more episodes are needed."""
    if comparison.at_decision is not None:
        return _describe_decision(comparison, comparison.at_decision)
    evidence = (
        f"e = {comparison.e_value:.3g} after {counted(comparison.compared, 'episode')}"
    )
    if not comparison.left:
        return f"all episodes are compared, so that p decides ({evidence})"
    if not comparison.may_decide:
        return f"{evidence}; the {comparison.left} left can no longer show a difference"
    return f"not decided: {evidence}, {_DECIDES}; {comparison.left} left"


def _describe_decision(whole: SequentialComparison, then: Decision) -> str:
    text = (
        f"{_DECIDES} (e = {then.e_value:.3g}): on the first {whole.decided_after} of "
        f"{whole.compared + whole.left} episodes the {whole.better} succeeds more often"
    )
    lead = whole.wins - whole.losses
    if lead <= 0 if whole.better == "run" else lead >= 0:
        wins, losses = whole.wins - then.wins, whole.losses - then.losses
        return f"{text}; since then {wins} wins, {losses} losses"
    if whole.not_compared:
        names = [*whole.not_compared[:3], *["…"] * (len(whole.not_compared) > 3)]
        return f"{text}; nothing is compared yet of {', '.join(names)}"
    return f"{text}; the {whole.left} left need not be played" if whole.left else text
