"""Expectations about the state of a run over time, as several checks have them."""

import time

from conformance.client.run_client import RunClient
from conformance.verdicts import expect

# Clocks of two machines may run at slightly different speeds.
CLOCK_TOLERANCE = 0.95
LOOKS_MIN = 100


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
