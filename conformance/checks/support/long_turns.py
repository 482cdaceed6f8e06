"""Turns that last so long that a check sends other requests in the middle of them."""

import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from conformance.client.request_context import RequestContext
from conformance.client.run_client import WorkerClient

_LONGEST_STEP_S = 5.0


def long_turn_s(context: RequestContext) -> float:
    """Give the seconds of a turn in the middle of which another request arrives."""
    return min(_LONGEST_STEP_S, max(1.0, 4 * context.tolerance_s))


def during_turn(
    worker: WorkerClient,
    act: Callable[[], Any],
    *chunk: Mapping[str, Any],
    **values: float,
) -> list[Any]:
    """Act in the middle of a long turn; give the answer to that, and what `act` gives.

    chunk: the actions of the turn; without it one that takes long, with these values.
    """
    context = worker.run.context
    turn_s = long_turn_s(context)

    def act_later() -> Any:
        time.sleep(turn_s / 4)
        return act()

    actions = chunk or (context.action(delay_s=turn_s, **values),)
    return context.call_concurrently(partial(worker.try_predict, *actions), act_later)
