"""Expectations about the state of a run over time, as several checks have them."""

import time

from conformance.client.run_client import RunClient
from conformance.verdicts import expect

# Clocks of two machines may run at slightly different speeds.
CLOCK_TOLERANCE = 0.95


def expect_state_soon(run: RunClient, state: str) -> None:
    """Expect the run to reach a state without a request, soon."""
    deadline = time.monotonic() + 5
    while run.get()["state"] != state and time.monotonic() < deadline:
        time.sleep(0.005)
    expect.equal(run.body["state"], state, "state")
