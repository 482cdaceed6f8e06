"""Decides the verdict of a rule from the way in which its check ended.

A check says by an exception what it saw: a violation, a prerequisite that was missing,
a result that nothing can decide. Any other exception is a defect of the kit.
"""

from __future__ import annotations

import traceback
from dataclasses import replace
from typing import TYPE_CHECKING

from conformance.exchanges.curl import select_exchanges_for
from conformance.specification.ledger import load_ledger
from conformance.verdicts import expect
from conformance.verdicts.verdict import Outcome, Verdict

if TYPE_CHECKING:
    from conformance.client.check_context import CheckContext


def find_invalid_answer(context: CheckContext | None) -> str | None:
    """Describe an answer that broke its schema: then a check may lack a value."""
    if context is None:
        return None
    for breach in context.tally.breaches:
        if breach.requirement_id in ("SVC-003", "ERR-001"):
            return f"{breach.observed}; see {breach.requirement_id}"
    return None


def is_violation(verdict: Verdict, context: CheckContext | None) -> bool:
    """Whether a MUST is violated, by the check or by an answer that it received."""
    is_must = load_ledger()[verdict.requirement_id].level == "MUST"
    is_failed = verdict.outcome == Outcome.FAILED and is_must
    return is_failed or (context is not None and context.tally.broken.total() > 0)


def _mark_judged(verdict: Verdict, number: int | None) -> None:
    """Mark the exchange that decided: the last one, where the check names none."""
    if verdict.exchanges and number is None:
        number = max(exchange.number for exchange in verdict.exchanges)
    verdict.exchanges = [
        replace(exchange, is_judged=exchange.number == number)
        for exchange in verdict.exchanges
    ]


def judge(
    requirement_id: str,
    error: BaseException | None,
    context: CheckContext | None = None,
) -> Verdict:
    """Derive the verdict from the exception of a check."""
    verdict = Verdict(requirement_id, Outcome.PASSED)
    if error is None:
        return verdict
    if context is not None:
        verdict.exchanges = list(context.exchange_log.exchanges)
        verdict.left_out = context.exchange_log.dropped
    match error:
        case expect.Violation():
            verdict.outcome = Outcome.FAILED
            verdict.expected, verdict.observed = error.expected, error.observed
            verdict.expected += _of_operation(error, context)
            if error.is_alone:
                verdict.exchanges = select_exchanges_for(
                    error.exchange, verdict.exchanges
                )
                verdict.left_out = 0
            _mark_judged(verdict, error.exchange)
        case expect.SetUpFailed():
            verdict.outcome = Outcome.NOT_VERIFIED
            verdict.reason, verdict.allowed = error.reason, error.allowed
            verdict.breaks = error.breaks or ""
        case expect.Inconclusive():
            verdict.outcome, verdict.reason = Outcome.INCONCLUSIVE, str(error)
        case expect.NotApplicable():
            verdict.outcome, verdict.reason = Outcome.NOT_APPLICABLE, str(error)
        case _ if (
            not isinstance(error, expect.KitError)
            and (invalid := find_invalid_answer(context)) is not None
        ):
            verdict.outcome = Outcome.NOT_VERIFIED
            verdict.reason = f"an answer was invalid: {invalid} ({error!r})"
        case _:
            verdict.outcome = Outcome.KIT_ERROR
            verdict.reason = "".join(traceback.format_exception(error)[-4:])
    if context is not None:
        verdict.waits_for = _operation_waited_for(error, context)
    return verdict


def _of_operation(error: expect.Violation, context: CheckContext | None) -> str:
    """Name the operation from which something else was expected, unless that does."""
    name = context.tally.served.operation_of(error.exchange) if context else ""
    return f" for `{name}`" if name and name not in error.expected else ""


def _operation_waited_for(error: BaseException, context: CheckContext) -> str:
    """Name the operation whose missing service may be why a check did not pass.

    Its answer is the one that decided, or the last one where the check names none.
    """
    number = getattr(error, "exchange", None)
    if number is None:
        exchanges = context.exchange_log.exchanges
        number = exchanges[-1].number if exchanges else 0
    return context.tally.served.operation_without_service(number)
