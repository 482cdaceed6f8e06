"""Checks of what happens while time passes: their retries, and the length of a turn.

A kit that was late proves nothing: such a check raises Inconclusive and is repeated, at
most three times. Knows nothing of leases.
"""

import functools
from collections.abc import Callable

from conformance.client.check_context import CheckContext
from conformance.client.request_context import RequestContext
from conformance.verdicts.expect import Inconclusive

Check = Callable[[CheckContext], None]
TRIES = 3
_LONGEST_STEP_S = 5.0


def retry_when_late(check: Check) -> Check:
    """Repeat a check when the kit was late."""

    @functools.wraps(check)
    def retried(context: CheckContext) -> None:
        for _ in range(TRIES - 1):
            try:
                return check(context)
            except Inconclusive:
                continue
        return check(context)

    return retried


def long_turn_s(context: RequestContext) -> float:
    """Give the seconds of a turn in the middle of which another request arrives."""
    return min(_LONGEST_STEP_S, max(1.0, 4 * context.tolerance_s))
