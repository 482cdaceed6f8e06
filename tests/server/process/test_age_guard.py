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


def pass_time(clocks: Clocks, uptime_s: float) -> None:
    clocks.wall += uptime_s - clocks.uptime_s
    clocks.uptime_s = uptime_s


def guard_of(days: float) -> AgeGuard:
    return AgeGuard(days, "the recordings", logging.getLogger("proctor.app"))


def test_nothing_is_deleted_in_the_first_hour(clocks: Clocks) -> None:
    guard = guard_of(30)
    for uptime_s in (0, FIRST_AFTER_S - 1):
        pass_time(clocks, 50 + uptime_s)
        assert not guard.allows(NOW_WALL - DAY_S)
    pass_time(clocks, 50 + FIRST_AFTER_S)
    assert guard.allows(NOW_WALL - DAY_S)


@pytest.mark.parametrize("jumps_at_s", [0.0, 10 * DAY_S])
@pytest.mark.parametrize("is_touched", [False, True])
def test_a_clock_by_which_all_is_old_is_believed_after_a_day(
    clocks: Clocks,
    jumps_at_s: float,
    is_touched: bool,
    caplog: pytest.LogCaptureFixture,
) -> None:
    """It jumped before the server started, or long after it.

    is_touched: a run is stored with the time of that clock.
    """
    guard = guard_of(365)
    if jumps_at_s:
        assert not guard.allows(NOW_WALL)
    clocks.uptime_s += jumps_at_s
    clocks.wall += 400 * DAY_S
    for since_s in (0, FIRST_AFTER_S, ALL_AFTER_S - 1):
        pass_time(clocks, 50 + jumps_at_s + since_s)
        caplog.clear()
        assert not guard.allows(clocks.wall if is_touched and since_s else NOW_WALL)
        assert "the recordings are not deleted by age yet" in caplog.text
        assert "the clock says 2028-02-" in caplog.text
        assert "stored at 2027-01-15" in caplog.text
    pass_time(clocks, 50 + jumps_at_s + ALL_AFTER_S)
    assert guard.allows(NOW_WALL)


def test_a_clock_that_was_set_right_is_not_remembered(clocks: Clocks) -> None:
    guard = guard_of(365)
    clocks.wall += 400 * DAY_S
    assert not guard.allows(NOW_WALL)
    clocks.wall -= 400 * DAY_S
    assert not guard.allows(NOW_WALL)
    pass_time(clocks, 50 + FIRST_AFTER_S)
    assert guard.allows(NOW_WALL)


def test_a_server_that_runs_for_years_deletes_each_day(clocks: Clocks) -> None:
    guard = guard_of(30)
    assert not guard.allows(NOW_WALL)
    for days in range(1, 800):
        pass_time(clocks, 50 + days * DAY_S)
        assert guard.allows(NOW_WALL)


async def test_what_was_deleted_is_a_warning_with_its_number(
    clocks: Clocks, caplog: pytest.LogCaptureFixture
) -> None:
    """Expect none where nothing is stored, and none before deletions are allowed."""
    guard, newest = guard_of(365), NOW_WALL
    counts = iter((0, 3))

    async def newest_change() -> float | None:
        return newest

    async def delete_old() -> int:
        return next(counts)

    await guard.delete(newest_change, delete_old)
    pass_time(clocks, 50 + FIRST_AFTER_S)
    await guard.delete(newest_change, delete_old)
    assert not caplog.records
    await guard.delete(newest_change, delete_old)
    (record,) = caplog.records
    assert record.levelname == "WARNING"
    said = "the recordings of 3 runs that ended more than 365 days ago were deleted"
    assert record.message == said
