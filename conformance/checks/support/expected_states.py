"""Expectations about the state of a run over time, as several checks have them."""

import time

from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive

# Clocks of two machines may run at slightly different speeds.
CLOCK_TOLERANCE = 0.95
LOOKS_MIN = 100
# How long a long poll waits for a change.
WAIT_S = 5
# Timers of the server and of this machine may disagree by so much.
EARLY_S = 0.02


def expect_changed(
    polled: Answer, state: str, took_s: float, limit_s: float, what: str
) -> None:
    """Expect the answer of a long poll to a change in time, and the new state.

    took_s: from the change to the answer, which a request for WAIT_S seconds got.
    """
    expect.in_time(took_s, limit_s, what)
    if polled.status == 304 and polled.elapsed_s >= WAIT_S - EARLY_S:
        raise Inconclusive("the wait for a change was over before the kit made it")
    expect.equal(expect.ok(polled)["state"], state, "state")


def expect_state_soon(run: RunClient, state: str) -> None:
    """Expect the run to reach a state without a request, soon.

    What is seconds on a machine that is much too busy is measured in looks at the run.
    """
    deadline, looks = time.monotonic() + 5, 0
    while run.get()["state"] != state:
        looks += 1
        if looks >= LOOKS_MIN and time.monotonic() > deadline:
            break
        time.sleep(0.005)
    expect.equal(run.body["state"], state, "state")
