"""Expectations about the state of a run over time, as several checks have them."""

import contextlib
import time
from collections.abc import Iterator

from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive

# Clocks of two machines may run at slightly different speeds.
CLOCK_TOLERANCE = 0.95
_LOOKS_MIN = 100
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


def looks(until: float, pause_s: float = 0.005) -> Iterator[None]:
    """Look at something until a time; at least _LOOKS_MIN times.

    Seconds alone would be too few looks on a machine that is much too busy.
    """
    number = 0
    while number < _LOOKS_MIN or time.monotonic() < until:
        yield
        number += 1
        time.sleep(pause_s)


def expect_state_soon(run: RunClient, state: str, within_s: float = 5) -> None:
    """Expect the run to reach a state without a request, soon."""
    for _ in looks(time.monotonic() + within_s, within_s / 400):
        if run.get()["state"] == state:
            return
    expect.equal(run.body["state"], state, "state")


@contextlib.contextmanager
def expect_unchanged(*runs: RunClient) -> Iterator[None]:
    """Expect runs to be afterwards as they were before."""
    before = [run.snapshot() for run in runs]
    yield
    for run, shown in zip(runs, before, strict=True):
        expect.equal(run.snapshot(), shown, "the run afterwards")
