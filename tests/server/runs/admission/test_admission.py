"""When runs are let in: the timer that looks at the queue again. Real loops."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable

import pytest
import uvloop

from reference_server.rules.capacity import WaitingRun
from reference_server.runs import steady_clock
from reference_server.runs.admission.admission import Admission
from reference_server.runs.admission.places import Places
from tests.support.servers import TIMEOUT_S

HELD_S, UNUSED_S = 0.05, 3600.0
NewLoop = Callable[[], asyncio.AbstractEventLoop]
LOOPS = (asyncio.new_event_loop, uvloop.new_event_loop)
NAMES = ("asyncio", "uvloop")


class SlowPlaces(Places):
    """Places on a machine that stops the server before it sets its last timer."""

    def next_overdue(self, now: float) -> float | None:
        time.sleep(2 * HELD_S)
        return super().next_overdue(now)


def hold(admission: Admission, number: int, held_s: float) -> None:
    """Put a run into the queue that its submitter keeps there for a time."""
    until_wall = steady_clock.now_wall() + held_s
    held = WaitingRun(str(number), number, "alice", until_wall)
    admission.note_queued(held, is_queued=True)


def ignore_move(_number: int) -> None:
    """No request waits for a place in the queue here."""


@pytest.mark.parametrize("new_loop", LOOPS, ids=NAMES)
def test_a_hold_that_ends_during_a_look_is_not_forgotten(new_loop: NewLoop) -> None:
    """The hold ends between two timers of one look. Expect the run to be let in, and
    not only when the resting run has been unused for an hour."""

    async def run() -> str:
        found: asyncio.Future[str] = asyncio.get_running_loop().create_future()
        admission = Admission(
            SlowPlaces(2, UNUSED_S),
            lambda run_id, _new: found.set_result(run_id),
            ignore_move,
        )
        admission.places.play("resting", "alice")
        admission.places.rest("resting", time.monotonic())
        hold(admission, 2, HELD_S)
        admission.admit()
        let_in = await asyncio.wait_for(found, TIMEOUT_S)
        admission.close()
        return let_in

    with asyncio.Runner(loop_factory=new_loop) as runner:
        assert runner.run(run()) == "2"


@pytest.mark.parametrize("new_loop", LOOPS, ids=NAMES)
def test_looks_at_any_moment_never_fail(new_loop: NewLoop) -> None:
    """Looks without a pause while holds end, by a clock that counts milliseconds.
    Expect each run to be let in, and no error."""

    async def run() -> list[str]:
        let_in: list[str] = []
        admission = Admission(
            Places(1000, UNUSED_S),
            lambda run_id, _new: let_in.append(run_id),
            ignore_move,
        )
        started = time.monotonic()
        for number in range(1, 201):
            hold(admission, number, 0.002)
            while len(let_in) < number and time.monotonic() < started + TIMEOUT_S:
                admission.admit()
        admission.close()
        return let_in

    with asyncio.Runner(loop_factory=new_loop) as runner:
        assert runner.run(run()) == [str(number) for number in range(1, 201)]
