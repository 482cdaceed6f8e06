"""When deletions by age are held back: the clock of the machine may be wrong."""

from __future__ import annotations

import logging
import time

import pytest

from reference_server.process.age_guard import ALL_AFTER_S, FIRST_AFTER_S, AgeGuard

NOW_WALL, DAY_S = 1_800_000_000.0, 86_400.0


class Clocks:
    """uptime_s: of this machine. wall: what its clock says."""

    uptime_s, wall = 50.0, NOW_WALL


@pytest.fixture
def clocks(monkeypatch: pytest.MonkeyPatch) -> Clocks:
    clocks = Clocks()
    monkeypatch.setattr(time, "monotonic", lambda: clocks.uptime_s)
    monkeypatch.setattr(time, "time", lambda: clocks.wall)
    return clocks


def guard_of(days: float) -> AgeGuard:
    return AgeGuard(days, "the recordings", logging.getLogger("proctor.app"))


def test_nothing_is_deleted_in_the_first_hour(clocks: Clocks) -> None:
    guard = guard_of(30)
    for uptime_s, is_allowed in ((0, False), (FIRST_AFTER_S - 1, False)):
        clocks.uptime_s = 50 + uptime_s
        assert guard.allows(NOW_WALL - DAY_S) is is_allowed
    clocks.uptime_s = 50 + FIRST_AFTER_S
    assert guard.allows(NOW_WALL - DAY_S)


@pytest.mark.parametrize("jumps_at_s", [0.0, 10 * DAY_S])
def test_a_clock_by_which_all_is_old_is_believed_after_a_day(
    clocks: Clocks, jumps_at_s: float, caplog: pytest.LogCaptureFixture
) -> None:
    """It jumped before the server started, or long after it."""
    guard = guard_of(365)
    clocks.uptime_s += jumps_at_s
    clocks.wall += 400 * DAY_S
    for since_s in (0, FIRST_AFTER_S, ALL_AFTER_S - 1):
        clocks.uptime_s = 50 + jumps_at_s + since_s
        caplog.clear()
        assert not guard.allows(NOW_WALL)
        assert "the recordings are not deleted by age yet" in caplog.text
        assert "the clock says 2028-02-19" in caplog.text
        assert "stored at 2027-01-15" in caplog.text
    clocks.uptime_s = 50 + jumps_at_s + ALL_AFTER_S
    assert guard.allows(NOW_WALL)


def test_a_clock_that_was_set_right_is_not_remembered(clocks: Clocks) -> None:
    guard = guard_of(365)
    for wall, uptime_s in ((400, 0), (0, DAY_S / 2), (400, DAY_S)):
        clocks.wall, clocks.uptime_s = NOW_WALL + wall * DAY_S, 50 + uptime_s
        assert guard.allows(NOW_WALL) is (wall == 0)


def test_what_was_deleted_is_a_warning_with_its_number(
    caplog: pytest.LogCaptureFixture,
) -> None:
    guard = guard_of(365)
    guard.report(0)
    assert not caplog.records
    guard.report(3)
    (record,) = caplog.records
    assert record.levelname == "WARNING"
    said = "the recordings of 3 runs that ended more than 365 days ago were deleted"
    assert record.message == said
