"""Effects that a check causes itself, as by a set-up that is too slow for a lease."""

import time
from typing import Any

import httpx
import pytest

from conformance.client.own_causes import OwnCauses
from conformance.exchanges.answer import Answer
from conformance.verdicts.expect import Inconclusive, SetUpFailed, Violation

STEP = SetUpFailed("predict: unexpected response")


def answer(status: int, ended_at: float, **body: Any) -> Answer:
    return Answer(
        status=status,
        headers=httpx.Headers(),
        body=b"",
        started_at=ended_at,
        ended_at=ended_at,
        json=body,
        exchange=1,
    )


def causes_of_a_refusal(after_s: float, **submitted: Any) -> OwnCauses:
    """A session with a lease of 2 s, and a turn that is refused some time later."""
    causes, now = OwnCauses(), time.monotonic()
    causes.note("submit_run", submitted, None, answer(201, now, run_id="run_1"))
    lease = {"idle_timeout_s": 2.0}
    turn = answer(200, now, session_id="one", lease=lease)
    causes.note("attach_worker", {"attach_key": "key"}, "run_1", turn)
    refused = answer(409, now + after_s, code="session_ended")
    causes.note("predict", {"session_id": "one", "seq": 1}, "run_1", refused)
    return causes


def test_step_after_a_lease_that_the_check_chose_proves_nothing() -> None:
    causes = causes_of_a_refusal(2.1, idle_timeout_s=2.0)
    excuse = causes.excuse("EPI-009", STEP)
    assert isinstance(excuse, Inconclusive)
    assert "a lease of 2 s" in str(excuse)
    causes.begin()
    assert causes.excuse("EPI-009", STEP) is None


@pytest.mark.parametrize(
    "error",
    [SetUpFailed("a step", breaks="LIFE-303"), Violation("status 200", "status 409")],
)
def test_what_the_check_judges_is_not_excused(error: SetUpFailed | Violation) -> None:
    causes = causes_of_a_refusal(2.1, idle_timeout_s=2.0)
    assert causes.excuse("EPI-009", error) is None


def test_refusal_inside_the_lease_is_not_excused() -> None:
    causes = causes_of_a_refusal(1.9, idle_timeout_s=2.0)
    assert causes.excuse("EPI-009", STEP) is None


def test_repeats_and_heartbeats_keep_no_session_longer_than_the_limit() -> None:
    """Leases of 2 s, and a limit of 3 s without a new turn. A turn, then a heartbeat 2
    s after it. Expect an excuse 3.1 s after the turn, and none with a limit of 30 s."""
    for heartbeat_s_max, is_excused in ((3.0, True), (30.0, False)):
        causes, began = OwnCauses(heartbeat_s_max), time.monotonic() - 3.1
        causes.note("submit_run", {}, None, answer(201, began, run_id="run_1"))
        turn = answer(200, began, session_id="one", lease={"idle_timeout_s": 2.0})
        causes.note("attach_worker", {"attach_key": "key"}, "run_1", turn)
        renewed = answer(200, began + 2.0, idle_timeout_s=2.0)
        causes.note("heartbeat", {"session_id": "one"}, "run_1", renewed)
        assert isinstance(causes.excuse("EVT-008", STEP), Inconclusive) is is_excused
