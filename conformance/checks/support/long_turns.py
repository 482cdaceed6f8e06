"""How long a turn lasts in the middle of which a check sends another request."""

from conformance.client.request_context import RequestContext

_LONGEST_STEP_S = 5.0


def long_turn_s(context: RequestContext) -> float:
    """Give the seconds of a turn in the middle of which another request arrives."""
    return min(_LONGEST_STEP_S, max(1.0, 4 * context.tolerance_s))
