"""Properties checked on generated examples, seeded and shrunk."""

import itertools
import math
import time
from collections.abc import Callable, Sequence
from typing import TypeVar

import hypothesis
from hypothesis.errors import Flaky
from hypothesis.strategies import SearchStrategy

from conformance.client.check_context import CheckContext
from conformance.exchanges.exchange import Exchange
from conformance.verdicts.expect import (
    Inconclusive,
    NotApplicable,
    SetUpFailed,
    TooLate,
    Violation,
)

Example = TypeVar("Example")
_SHRINK_S = 10.0
_NEXT_SEED = 1_000_003  # no seed of a run is that of another run's next round
_NOT_VIOLATIONS = (SetUpFailed, Inconclusive, NotApplicable, TooLate)  # not yet


def for_all(
    context: CheckContext,
    examples: SearchStrategy[Example],
    check_property: Callable[[Example], None],
    times: int,
    shrink_s: float = _SHRINK_S,
    *,
    known: Sequence[Example] = (),
    share: float = 0.0,
    first_round: int = 0,
    is_history: bool = False,
) -> None:
    """Check a property on examples; raise the violation of the smallest one.

    times: how many examples, a quarter of them with `--quick`. known: played before
    them, with every seed: what found a broken server once finds the next one as well;
    with `--quick` a third of them, by the seed.
    share: of `--minutes`, for which as many are tried again and again, always others.
    first_round: which others a caller tries that repeats itself. A further round of a
    check tries others, too, and none of the known ones again.
    is_history: the requests of an example say what it is, and the sentence of the
    violation leaves it out.
    The log then holds the exchanges before the examples, and those of that example.
    The first example that could not be decided ends the search, and is raised.
    """
    exchange_log = context.exchange_log
    before = list(exchange_log.exchanges)
    until = time.monotonic() + 60 * context.shared.settings.minutes * share
    if not context.round_number:
        _check_known(context, known, check_property, is_history=is_history)
    ended: list[Exception] = []
    broken: list[tuple[Violation, list[Exchange]]] = []
    shrink_until = math.inf

    def judge_example(example: Example) -> None:
        nonlocal shrink_until
        if ended or time.monotonic() > shrink_until:
            return
        exchange_log.exchanges[:] = before
        exchange_log.allow_more()
        try:
            check_property(example)
        except _NOT_VIOLATIONS as error:
            ended.append(error)
        except Violation as error:
            smaller = error if is_history else _with_example(error, example)
            broken.append((smaller, list(exchange_log.exchanges)))
            context.tidy_up()  # there may be many examples before the smallest
            shrink_until = min(shrink_until, time.monotonic() + shrink_s)
            raise smaller from None

    search = _search(-(-times // 4) if context.shared.settings.quick else times)
    for rounds in itertools.count(first_round + context.round_number):
        seeded = hypothesis.seed(context.shared.settings.seed + rounds * _NEXT_SEED)
        try:
            seeded(search(hypothesis.given(examples)(judge_example)))()
        except (Violation, Flaky):
            # Flaky: it broke, and then it did not: a race, or no time was left to
            # shrink.
            violation, exchange_log.exchanges[:] = broken[-1]
            raise violation from None
        if ended:
            raise ended[0]
        if time.monotonic() > until or context.shared.settings.is_time_up:
            return
        context.tidy_up()


def _search(times: int) -> hypothesis.settings:
    return hypothesis.settings(
        max_examples=times,
        deadline=None,
        database=None,
        phases=(hypothesis.Phase.generate, hypothesis.Phase.shrink),
        report_multiple_bugs=False,
        suppress_health_check=list(hypothesis.HealthCheck),
    )


def _check_known(
    context: CheckContext,
    known: Sequence[Example],
    check_property: Callable[[Example], None],
    *,
    is_history: bool,
) -> None:
    before = list(context.exchange_log.exchanges)
    if context.shared.settings.quick:
        known = context.random.sample(known, -(-len(known) // 3))
    for example in known:
        # The report of a failure has the requests of its own example alone.
        context.exchange_log.exchanges[:] = before
        try:
            check_property(example)
        except Violation as error:
            if is_history:
                raise
            raise _with_example(error, example) from error


def _with_example(error: Violation, example: object) -> Violation:
    text = f"{error.expected}, for the example {example}"
    return Violation(text, error.observed, error.exchange, is_alone=error.is_alone)
